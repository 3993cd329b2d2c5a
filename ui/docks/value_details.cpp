#include "ui/docks/value_details.h"

#include "core/interaction/value_editing.h"
#include "core/values/number_text.h"
#include "ui/base/icon.h"
#include "ui/base/lengths.h"
#include "ui/bench/workbench.h"
#include "ui/docks/value_editor.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/property_rows.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kDetailsIndent = 16; // px
constexpr int kBoundDigits = 3;

constexpr std::array kValueKinds{ValueKind::Length, ValueKind::Angle,  ValueKind::Count,
                                 ValueKind::Mass,   ValueKind::Ratio,  ValueKind::Number,
                                 ValueKind::Switch, ValueKind::Choice, ValueKind::Text};

QString valueKindName(ValueKind kind)
{
    switch (kind) {
    case ValueKind::Length:
        return ValueDetails::tr("Length");
    case ValueKind::Angle:
        return ValueDetails::tr("Angle");
    case ValueKind::Count:
        return ValueDetails::tr("Whole number");
    case ValueKind::Mass:
        return ValueDetails::tr("Mass");
    case ValueKind::Ratio:
        return ValueDetails::tr("Ratio");
    case ValueKind::Number:
        return ValueDetails::tr("Number");
    case ValueKind::Switch:
        return ValueDetails::tr("Yes or no");
    case ValueKind::Choice:
        return ValueDetails::tr("Choice");
    case ValueKind::Text:
        return ValueDetails::tr("Text");
    }
    return {};
}

QString boundText(const Value &value, const std::optional<double> &bound)
{
    if (!bound)
        return {};
    const QLocale locale;
    if (value.kind == ValueKind::Length)
        return lengthText(*bound, 0, kBoundDigits, locale);
    const QString unit = value.kind == ValueKind::Angle  ? QStringLiteral("°")
                         : value.kind == ValueKind::Mass ? QStringLiteral("\u202fg")
                                                         : QString();
    return numberText(*bound / spokenSize(value.kind), 0, kBoundDigits, locale) + unit;
}

/// False: it is no number of the kind.
bool readBound(const Value &value, const QString &text, std::optional<double> &bound)
{
    bound.reset();
    if (text.trimmed().isEmpty())
        return true;
    const Understood<Typed> typed =
        Typed::read(text.trimmed().toStdString(), value.kind, windowReading(QLocale()));
    const Names none = [](std::string_view) -> const Worth * { return nullptr; };
    const Understood<Worth> worth = typed ? typed->worth(none) : tl::unexpected(typed.error());
    if (worth)
        bound = worth->number;
    return worth.has_value();
}

/// The value as one of that kind: a number stays the number that people say.
void becomeKind(Value &value, ValueKind kind, const Worth *worth)
{
    const double spoken =
        worth && worth->type == Worth::Type::Number ? worth->number / spokenSize(value.kind) : 1.0;
    value.kind = kind;
    value.range = {};
    value.reading = {};
    if (kind == ValueKind::Choice && value.choices.empty())
        value.choices = {ValueDetails::tr("small").toStdString(),
                         ValueDetails::tr("large").toStdString()};
    if (kind == ValueKind::Choice)
        value.typed = value.choices.front();
    else if (kind == ValueKind::Switch)
        value.typed = "yes";
    else if (kind == ValueKind::Text)
        value.typed = worth ? shownText(*worth) : std::string();
    else
        value.typed = typedNumber(
            kind, spokenSize(kind) * (kind == ValueKind::Count ? std::round(spoken) : spoken));
}

QString joinedChoices(const std::vector<std::string> &choices)
{
    QStringList texts;
    for (const std::string &choice : choices)
        texts += QString::fromStdString(choice);
    return texts.join(QStringLiteral(" | "));
}

} // namespace

ValueDetails::ValueDetails(Workbench &bench, ValueId value, QWidget *parent)
    : QWidget(parent), m_bench(bench), m_id(value)
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(kDetailsIndent, 0, 0, 8);
    column->setSpacing(0);
    addKind();
    addRange();
    m_choices = add(
        tr("Choices"), "valueChoices", [](const Value &of) { return joinedChoices(of.choices); },
        [](Value &of, const QString &text) {
            of.choices.clear();
            for (const QString &choice : text.split(u'|', Qt::SkipEmptyParts))
                if (!choice.trimmed().isEmpty())
                    of.choices.push_back(choice.trimmed().toStdString());
            return !of.choices.empty();
        },
        tr("small | large", "an example of choices"));
    m_made = add(
        tr("Made of"), "valueMadeOf",
        [](const Value &of) { return QString::fromStdString(of.typed); },
        [](Value &of, const QString &text) {
            of.typed = text.trimmed().toStdString();
            of.reading = windowReading(QLocale());
            return true;
        },
        {});
    add(
        tr("Group"), "valueGroup", [](const Value &of) { return QString::fromStdString(of.group); },
        [](Value &of, const QString &text) {
            of.group = text.trimmed().toStdString();
            return true;
        },
        tr("heading above it"));
    add(
        tr("Note"), "valueNote", [](const Value &of) { return QString::fromStdString(of.note); },
        [](Value &of, const QString &text) {
            of.note = text.trimmed().toStdString();
            return true;
        },
        tr("what it is for"));
    addShown();
    addDelete();
}

const Value *ValueDetails::value() const
{
    return m_bench.session().committed().document.values.find(m_id);
}

void ValueDetails::make(SectionEdit edit)
{
    const QString why = tryEdit(m_bench, std::move(edit));
    refresh(); // what was refused goes back to what it was
    Q_EMIT refused(why);
}

void ValueDetails::change(const std::function<bool(Value &)> &how)
{
    const Value *known = value();
    if (!known)
        return;
    Value next = *known;
    if (!how(next)) {
        refresh();
        Q_EMIT refused(tr("This cannot be read as what is needed here."));
        return;
    }
    if (next != *known)
        make(valueChanged(m_bench.session().committed().document, std::move(next)));
}

PropertyRow *ValueDetails::add(const QString &name, const char *id,
                               std::function<QString(const Value &)> read, Change how,
                               const QString &placeholder)
{
    auto *line = new QLineEdit(this);
    line->setPlaceholderText(placeholder);
    connect(line, &QLineEdit::editingFinished, this, [this, line, how] {
        if (!line->isModified())
            return;
        line->setModified(false);
        const QString text = line->text();
        change([&](Value &of) { return how(of, text); });
    });
    auto *row = new EditorRow(
        name, id, line,
        [this, line, read] {
            const Value *of = value();
            if (of && !(line->hasFocus() && line->isModified()) && line->text() != read(*of))
                line->setText(read(*of));
        },
        this);
    layout()->addWidget(row);
    m_rows.push_back(row);
    return row;
}

void ValueDetails::addKind()
{
    auto *kind = new ChoiceRow(
        tr("Kind"), "valueKind",
        [this] {
            Choices choices;
            for (const ValueKind one : kValueKinds)
                choices.all.push_back({valueKindName(one), QColor()});
            if (const Value *of = value())
                choices.current =
                    static_cast<int>(std::find(kValueKinds.begin(), kValueKinds.end(), of->kind) -
                                     kValueKinds.begin());
            return choices;
        },
        [this](int index) {
            const Worth *worth = m_bench.session().committed().evaluation.values.worth(m_id);
            change([&](Value &of) {
                if (of.kind != kValueKinds[static_cast<std::size_t>(index)])
                    becomeKind(of, kValueKinds[static_cast<std::size_t>(index)], worth);
                return true;
            });
        },
        this);
    layout()->addWidget(kind);
    m_rows.push_back(kind);
}

void ValueDetails::addRange()
{
    const auto addBound = [this](const QString &name, const char *id,
                                 std::optional<double> ValueRange::*bound,
                                 const QString &placeholder) {
        m_ofNumbers.push_back(add(
            name, id, [bound](const Value &of) { return boundText(of, of.range.*bound); },
            [bound](Value &of, const QString &text) {
                const bool isStep = bound == &ValueRange::step;
                return readBound(of, text, of.range.*bound) &&
                       (!isStep || of.range.step.value_or(1.0) > 0.0);
            },
            placeholder));
    };
    addBound(tr("Minimum"), "valueLeast", &ValueRange::least, tr("any"));
    addBound(tr("Maximum"), "valueMost", &ValueRange::most, tr("any"));
    addBound(tr("Step"), "valueStep", &ValueRange::step, tr("any"));
}

void ValueDetails::addShown()
{
    auto *shown = new QCheckBox(tr("Others can adjust it"), this);
    shown->setToolTip(tr("It can be set where the design is shared for adjusting"));
    connect(shown, &QCheckBox::clicked, this, [this](bool isOn) {
        change([isOn](Value &of) {
            of.isShown = isOn;
            return true;
        });
    });
    auto *row = new EditorRow(
        {}, "valueShown", shown,
        [this, shown] {
            if (const Value *of = value())
                shown->setChecked(of->isShown);
        },
        this);
    layout()->addWidget(row);
    m_rows.push_back(row);
}

void ValueDetails::addDelete()
{
    auto *remove = new QPushButton(themedIcon(QStringLiteral("trash")), tr("Delete"), this);
    remove->setObjectName(QStringLiteral("valueDelete"));
    remove->setAutoDefault(false);
    remove->setToolTip(tr("What is made of it becomes plain numbers"));
    connect(remove, &QPushButton::clicked, this,
            [this] { make(valueRemoved(m_bench.session().committed().document, m_id)); });
    layout()->addWidget(remove);
    layout()->setAlignment(remove, Qt::AlignLeft);
}

void ValueDetails::refresh()
{
    const Value *of = value();
    if (!of)
        return;
    for (PropertyRow *row : m_rows)
        row->refresh();
    for (QWidget *row : m_ofNumbers)
        row->setVisible(isNumeric(of->kind));
    m_choices->setVisible(of->kind == ValueKind::Choice);
    m_made->setVisible(of->kind == ValueKind::Choice || of->kind == ValueKind::Switch);
}

} // namespace fff::ui
