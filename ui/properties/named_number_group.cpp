#include "ui/properties/named_number_group.h"

#include "core/model/named_numbers.h"
#include "core/session/measure_commands.h"
#include "ui/base/expression_text.h"
#include "ui/bench/workbench.h"

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

void NamedNumberGroup::refresh()
{
    QString names;
    for (const NamedNumber &number : m_bench.session().model().document.numbers)
        names += QString::fromStdString(number.name) + u' ';
    setVisible(!names.isEmpty());
    if (m_rows.become(names))
        for (std::size_t i = 0; i < m_bench.session().model().document.numbers.size(); ++i)
            add(i);
    m_rows.refresh();
}

} // namespace fff::ui
