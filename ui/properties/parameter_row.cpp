#include "ui/properties/parameter_row.h"

#include "core/session/operation_text.h"
#include "ui/base/icon.h"
#include "ui/properties/segmented_box.h"
#include "ui/properties/slider_field.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

using Unit = ParameterSpec::Unit;

struct ParameterRowTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::ParameterRow)
};

constexpr int kFieldWidth = 84; // px
/// What fields have room for.
const QString kNumber = QStringLiteral("88.88"), kLongNumber = QStringLiteral("1888.8");
constexpr double kLongLength = 1000.0; // mm
constexpr int kSegmentsWidth = 172;    // px; what takes more becomes a list
/// Digits that numbers as people say them are worth: the rest is rounding of radians and shares.
constexpr double kSpokenDigits = 1e6;

double rounded(double spoken)
{
    return std::round(spoken * kSpokenDigits) / kSpokenDigits;
}

QString unitOf(Unit unit)
{
    return unit == Unit::Share   ? ParameterRowTexts::tr("%")
           : unit == Unit::Angle ? ParameterRowTexts::tr("°")
                                 : QString();
}

/// Digits that a step of this size needs.
int digitsOf(double step)
{
    return step >= 1.0 ? 0 : step >= 0.1 ? 1 : 2;
}

int indexOfChoice(const ParameterSpec &spec, const std::string &key)
{
    for (std::size_t i = 0; i < spec.choices.size(); ++i)
        if (key == spec.choices[i].key)
            return static_cast<int>(i);
    return -1;
}

} // namespace

ParameterRow::ParameterRow(const ParameterSpec &spec, Reactions reactions, QWidget *parent)
    : PropertyRow(spec.unit == Unit::Switch ? QString() : operationText(spec.label), parent),
      m_spec(spec), m_reactions(std::move(reactions))
{
    if (spec.unit == Unit::Switch)
        makeSwitch();
    else if (spec.unit == Unit::Choice)
        makeChoice();
    else
        makeNumber();
    if (spec.tip)
        setToolTip(operationText(spec.tip));
}

void ParameterRow::makeSwitch()
{
    const QString name = operationText(m_spec.label);
    m_switch = new QCheckBox(name, this);
    setEditor(m_switch, m_spec.key, true);
    m_switch->setAccessibleName(name);
    if (m_switch->sizeHint().width() > kSegmentsWidth)
        giveWholeRow(); // in words that are longer than the field
    connect(m_switch, &QCheckBox::clicked, this,
            [this](bool isOn) { m_reactions.settled(ParameterValue(isOn)); });
}

void ParameterRow::makeChoice()
{
    QStringList texts;
    for (const ChoiceSpec &choice : m_spec.choices)
        texts += operationText(choice.label);
    const auto choose = [this](int index) {
        m_reactions.settled(
            ParameterValue(std::string(m_spec.choices[static_cast<std::size_t>(index)].key)));
    };
    if (SegmentedBox::widthOf(texts, font()) <= kSegmentsWidth) {
        m_segments = new SegmentedBox(texts, this);
        setEditor(m_segments, m_spec.key, true);
        m_segments->setSpoken(operationText(m_spec.label));
        connect(m_segments, &SegmentedBox::activated, this, choose);
        return;
    }
    m_choice = new ChoiceBox(this);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(8);
    setEditor(m_choice, m_spec.key, true);
    connect(m_choice, &QComboBox::activated, this, choose);
}

NumberEdit *ParameterRow::numberEdit()
{
    const auto spoken = [this](double value) { return rounded(spokenValue(m_spec.unit, value)); };
    NumberEdit::Range range{spoken(m_spec.least), spoken(m_spec.most), spoken(m_spec.step), 0, 2};
    range.digits = m_spec.unit == Unit::Length ? 1 : digitsOf(range.step);
    if (m_spec.unit == Unit::Count || m_spec.unit == Unit::Number)
        range.digits = range.mostDigits = 0;
    if (m_spec.unit == Unit::Length)
        return new LengthEdit(range, this);
    return new NumberEdit(range, unitOf(m_spec.unit), this);
}

void ParameterRow::makeNumber()
{
    const auto spoken = [this](double value) { return rounded(spokenValue(m_spec.unit, value)); };
    m_field = numberEdit();
    const bool isLong = m_spec.unit == Unit::Length && spoken(m_spec.most) >= kLongLength;
    const QString sign = m_spec.least < 0.0 ? QStringLiteral("\u2212") : QString();
    m_field->setMinimumWidth(
        std::max(kFieldWidth, m_field->widthFor(sign + (isLong ? kLongNumber : kNumber))));
    // There is one operation: nothing is mixed, but with it off nothing is known.
    m_field->findChild<QLineEdit *>()->setPlaceholderText(QStringLiteral("\u2013"));
    const double notch = spoken(m_spec.step);
    m_number = new SliderField({spoken(m_spec.sliderLeast), spoken(m_spec.sliderMost), notch, 5},
                               m_field, this);
    setEditor(m_number, m_spec.key, true);
    const auto valueOfSpoken = [this](double number) {
        return ParameterValue(valueSpoken(m_spec.unit, number));
    };
    connect(m_number, &SliderField::dragged, this,
            [this, valueOfSpoken](double number) { m_reactions.dragged(valueOfSpoken(number)); });
    connect(m_number, &SliderField::settled, this,
            [this, valueOfSpoken](double number) { m_reactions.settled(valueOfSpoken(number)); });
    connect(m_number, &SliderField::cancelled, this, [this] { m_reactions.cancelled(); });
    if (!m_spec.isFree)
        return;
    m_free = addButton(QStringLiteral("joint_reset"), "parameterFree",
                       ParameterRowTexts::tr("As it follows from the sections"),
                       [this] { m_reactions.settled(std::nullopt); });
}

void ParameterRow::setFollowed(Followed followed)
{
    if (m_field)
        m_field->setFollowed(std::move(followed));
}

void ParameterRow::settle()
{
    if (m_number)
        m_number->settle();
}

void ParameterRow::show(const Operation &operation, const OperationResult *result)
{
    const std::optional<ParameterValue> value = valueOf(m_spec, operation);
    const bool doesCount = counts(m_spec, operation);
    std::optional<double> found;
    if (result)
        if (const auto at = result->found.find(m_spec.key); at != result->found.end())
            found = at->second;
    // What another parameter decides is said, but not asked for.
    setVisible(doesCount || (found && m_number));
    setEnabled(doesCount);
    if (isHidden())
        return;
    if (m_switch) {
        m_switch->setChecked(value && std::get<bool>(*value));
    } else if (m_segments || m_choice) {
        const int index = value ? indexOfChoice(m_spec, std::get<std::string>(*value)) : -1;
        if (m_segments) {
            m_segments->setCurrent(index);
            return;
        }
        Choices choices;
        for (const ChoiceSpec &choice : m_spec.choices)
            choices.all.push_back({operationText(choice.label), QColor()});
        choices.current = index;
        m_choice->setChoices(choices);
    } else {
        const std::optional<double> number =
            value && doesCount ? std::optional(std::get<double>(*value)) : found;
        m_number->setNumber(number ? std::optional(rounded(spokenValue(m_spec.unit, *number)))
                                   : std::nullopt);
        if (m_free) {
            m_free->setVisible(value.has_value());
            setMarked(value.has_value(), value ? ParameterRowTexts::tr("Set by hand") : QString());
        }
    }
}

} // namespace fff::ui
