#include "ui/properties/named_number_group.h"

#include "core/interaction/value_editing.h"
#include "core/model/named_numbers.h"
#include "core/session/measure_commands.h"
#include "ui/base/expression_text.h"
#include "ui/bench/workbench.h"
#include "ui/properties/driven_field.h"

#include <QCoreApplication>
#include <QLineEdit>
#include <QLocale>
#include <QToolTip>

namespace fff::ui {

namespace {

struct NamedNumberGroupTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::NamedNumberGroup)
};

constexpr int kRefusalTime = 6000; // ms that a reason is said

/// Of the kind that it comes to; a plain number stands for one of whatever field takes it.
Value newValue(const QString &name, const QString &typed, const Document &document,
               const Reading &reading)
{
    Value value;
    value.name = name.toStdString();
    value.typed = typed.toStdString();
    value.reading = reading;
    value.isShown = true;
    const Understood<Formula> formula = Formula::read(value.typed, reading);
    const Understood<Worth> worth =
        formula ? formula->worth(EvaluatedValues::of(document.values).names())
                : tl::unexpected(formula.error());
    if (!worth)
        return value;
    if (worth->type == Worth::Type::Truth)
        value.kind = ValueKind::Switch;
    else if (worth->powers == kAnglePowers)
        value.kind = ValueKind::Angle;
    else if (worth->powers == kMassPowers)
        value.kind = ValueKind::Mass;
    else if (worth->powers.isNone() && worth->type == Worth::Type::Number)
        value.kind = ValueKind::Number;
    return value;
}

void refuse(QWidget *field, const QString &reason)
{
    QToolTip::showText(field->mapToGlobal(QPoint(0, field->height())), reason, field, {},
                       kRefusalTime);
    field->setAccessibleDescription(reason);
}

} // namespace

NamedNumberGroup::NamedNumberGroup(Workbench &bench, QWidget *parent)
    : PropertyGroup(NamedNumberGroupTexts::tr("Named values"), parent), m_bench(bench),
      m_rows(*this)
{
}

bool NamedNumberGroup::set(const QString &name, const QString &expression, QWidget *field)
{
    if (!isNumberName(name.toStdString())) {
        refuse(field, NamedNumberGroupTexts::tr(
                          "A name is a word of letters and digits, other than “t” and the "
                          "units."));
        return false;
    }
    tl::expected<Document, Expression> next =
        setExpression(m_bench.session().committed().document, name.toStdString(),
                      expression.trimmed().toStdString(), commasOf(field->locale()));
    if (!next) {
        refuse(field, refusalText(next.error()));
        return false;
    }
    m_bench.commit(Step{steps::kSetNumber, {Named{name.toStdString()}}}, *std::move(next));
    return true;
}

void NamedNumberGroup::add(std::size_t index)
{
    const NamedNumber &number = m_bench.session().model().document.numbers[index];
    const QString name = QString::fromStdString(number.name);
    auto *edit = new QLineEdit(this);
    const auto read = [this, index]() -> QString {
        const auto &numbers = m_bench.session().model().document.numbers;
        return index < numbers.size() ? QString::fromStdString(numbers[index].expression)
                                      : QString();
    };
    connect(edit, &QLineEdit::editingFinished, this, [this, edit, name, read] {
        if (edit->isModified() && edit->text() != read() && !set(name, edit->text(), edit))
            edit->setText(read());
        edit->setModified(false);
    });
    const QString id = QStringLiteral("number.%1").arg(name);
    auto *row = new EditorRow(
        name, id.toLatin1().constData(), edit,
        [edit, read] {
            if (!(edit->hasFocus() && edit->isModified()) && edit->text() != read())
                edit->setText(read());
        },
        this);
    row->addButton(
        QStringLiteral("trash"), (id + QStringLiteral(".delete")).toLatin1().constData(),
        NamedNumberGroupTexts::tr("Delete this value"), [this, name] {
            m_bench.run(QStringLiteral("numbers.remove"), {{"name", name.toStdString()}});
        });
    m_rows.add(row);
}

/// "gap = 12 mm"
void NamedNumberGroup::addNew()
{
    auto *edit = new QLineEdit(this);
    edit->setPlaceholderText(
        NamedNumberGroupTexts::tr("gap = 12 mm", "an example of a number with a name"));
    edit->setToolTip(NamedNumberGroupTexts::tr(
        "A name and its value; number fields take the name, also in sums: 2*gap"));
    connect(edit, &QLineEdit::returnPressed, this, [this, edit] {
        const QString text = edit->text();
        const qsizetype equals = text.indexOf(u'=');
        if (equals < 0) {
            refuse(edit, NamedNumberGroupTexts::tr("Type a name, “=” and a number."));
            return;
        }
        const QString name = text.left(equals).trimmed();
        const Document &document = m_bench.session().committed().document;
        if (findNumber(document, name.toStdString())) {
            refuse(edit, NamedNumberGroupTexts::tr("There is already a value with this name."));
            return;
        }
        const QString why = tryEdit(
            m_bench, valueAdded(document, newValue(name, text.mid(equals + 1).trimmed(), document,
                                                   windowReading(edit->locale()))));
        if (!why.isEmpty()) {
            refuse(edit, why);
            return;
        }
        edit->clear();
        if (m_bench.session().committed().document.values.list.size() == 1)
            m_bench.run(QStringLiteral("view.values")); // where they are adjusted
    });
    m_rows.add(new EditorRow(
        NamedNumberGroupTexts::tr("Add"), "number.new", edit, [] {}, this));
}

void NamedNumberGroup::refresh()
{
    QString names;
    // Those of files from before there were values, beside which they go on.
    for (const NamedNumber &number : m_bench.session().model().document.numbers)
        names += QString::fromStdString(number.name) + u' ';
    if (m_rows.become(names + u'.')) {
        for (std::size_t i = 0; i < m_bench.session().model().document.numbers.size(); ++i)
            add(i);
        addNew();
    }
    m_rows.refresh();
}

} // namespace fff::ui
