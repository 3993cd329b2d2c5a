#include "ui/docks/value_editor.h"

#include "core/base/tolerances.h"
#include "core/interaction/value_editing.h"
#include "core/values/number_text.h"
#include "ui/bench/workbench.h"
#include "ui/properties/choice_box.h"
#include "ui/properties/driven_field.h"
#include "ui/properties/length_edit.h"
#include "ui/properties/mass_edit.h"
#include "ui/properties/name_completion.h"
#include "ui/properties/segmented_box.h"
#include "ui/properties/slider_field.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>

#include <cmath>

namespace fff::ui {

namespace {

constexpr int kValueField = 96, kChoicesWidth = 150;     // px
constexpr double kMostSpoken = 1e6, kGramOfValue = 1e-3; // kg
constexpr double kNotches = 100.0;                       // of a slider whose value has no step
constexpr int kPageNotches = 5;                          // notches
/// Digits that numbers as people say them are worth: the rest is rounding of radians and grams.
constexpr double kSpokenDigits = 1e6;

double roundedSpoken(double spoken)
{
    return std::round(spoken * kSpokenDigits) / kSpokenDigits;
}

/// Of 1, 2, 5 · 10ⁿ: one that reads well.
double goodStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    const double lead = step / power;
    return power * (lead < 1.5 ? 1.0 : lead < 3.5 ? 2.0 : lead < 7.5 ? 5.0 : 10.0);
}

/// As people say them.
struct SpokenRange
{
    double least = -kMostSpoken, most = kMostSpoken, step = 1.0;
    bool isWhole = false; // both ends are known, and one is above the other
};

SpokenRange spokenRange(const Value &value)
{
    const double size = spokenSize(value.kind);
    SpokenRange range;
    if (value.kind == ValueKind::Mass)
        range.least = 0.0;
    if (value.range.least)
        range.least = roundedSpoken(*value.range.least / size);
    if (value.range.most)
        range.most = roundedSpoken(*value.range.most / size);
    range.isWhole = value.range.least && value.range.most && range.least < range.most;
    if (value.range.step && *value.range.step > 0.0)
        range.step = roundedSpoken(*value.range.step / size);
    else if (range.isWhole && value.kind != ValueKind::Count)
        range.step = goodStep((range.most - range.least) / kNotches);
    else if (value.kind == ValueKind::Ratio || value.kind == ValueKind::Number)
        range.step = 0.1;
    return range;
}

} // namespace

double spokenSize(ValueKind kind)
{
    return kind == ValueKind::Angle ? radians(1.0) : kind == ValueKind::Mass ? kGramOfValue : 1.0;
}

bool isNumeric(ValueKind kind)
{
    return kind != ValueKind::Text && kind != ValueKind::Choice && kind != ValueKind::Switch;
}

std::string typedNumber(ValueKind kind, double number)
{
    Worth worth;
    worth.powers = kind == ValueKind::Length  ? kLengthPowers
                   : kind == ValueKind::Angle ? kAnglePowers
                   : kind == ValueKind::Mass  ? kMassPowers
                                              : Powers();
    worth.number = number;
    return exactText(worth, kind);
}

ValueEditor::ValueEditor(Workbench &bench, const Value &value, bool isMade, QWidget *parent)
    : QWidget(parent), m_bench(bench), m_value(value), m_isMade(isMade)
{
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    if (isNumeric(value.kind)) {
        makeNumber();
    } else if (value.kind == ValueKind::Text || isMade) {
        makeLine();
    } else if (value.kind == ValueKind::Choice) {
        makeChoice();
    } else {
        m_switch = new QCheckBox(this);
        row->addWidget(m_switch);
        setFocusProxy(m_switch);
        connect(m_switch, &QCheckBox::clicked, this,
                [this](bool isOn) { type(isOn ? "yes" : "no"); });
    }
}

NumberEdit *ValueEditor::numberEdit() const
{
    const SpokenRange of = spokenRange(m_value);
    NumberEdit::Range range{of.least, of.most, of.step, 0, 3};
    if (m_value.kind == ValueKind::Count)
        range.digits = range.mostDigits = 0;
    if (m_value.kind == ValueKind::Length) {
        range.digits = 1;
        return new LengthEdit(range);
    }
    if (m_value.kind == ValueKind::Mass)
        return new MassEdit(range);
    return new NumberEdit(range, m_value.kind == ValueKind::Angle ? tr("°") : QString());
}

void ValueEditor::makeNumber()
{
    m_number = numberEdit();
    m_number->setMinimumWidth(kValueField);
    m_number->setFollowed(followedBy(m_bench, m_value.id));
    const SpokenRange range = spokenRange(m_value);
    setFocusProxy(m_number);
    if (!range.isWhole || m_isMade) {
        layout()->addWidget(m_number);
        connect(m_number, &NumberEdit::numberEdited, this, &ValueEditor::settle);
        return;
    }
    m_slider = new SliderField({range.least, range.most, range.step, kPageNotches}, m_number, this);
    layout()->addWidget(m_slider);
    connect(m_slider, &SliderField::dragged, this, &ValueEditor::preview);
    connect(m_slider, &SliderField::settled, this, &ValueEditor::settle);
    connect(m_slider, &SliderField::cancelled, this, [this] { m_bench.session().cancelPreview(); });
}

void ValueEditor::makeChoice()
{
    QStringList texts;
    for (const std::string &choice : m_value.choices)
        texts += QString::fromStdString(choice);
    const auto choose = [this](int index) {
        type(m_value.choices[static_cast<std::size_t>(index)]);
    };
    if (SegmentedBox::widthOf(texts, font()) <= kChoicesWidth) {
        m_segments = new SegmentedBox(texts, this);
        layout()->addWidget(m_segments);
        connect(m_segments, &SegmentedBox::activated, this, choose);
        return;
    }
    m_choice = new ChoiceBox(this);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    layout()->addWidget(m_choice);
    setFocusProxy(m_choice);
    connect(m_choice, &QComboBox::activated, this, choose);
}

void ValueEditor::makeLine()
{
    m_line = new QLineEdit(this);
    layout()->addWidget(m_line);
    setFocusProxy(m_line);
    new NameCompletion(m_line, NameCompletion::Where::BehindEquals,
                       [this] { return valueNames(m_bench); });
    connect(m_line, &QLineEdit::editingFinished, this, &ValueEditor::takeLine);
}

void ValueEditor::takeLine()
{
    if (!m_line->isModified())
        return;
    m_line->setModified(false);
    type(m_line->text().toStdString());
}

bool ValueEditor::fits(const Value &value, bool isMade) const
{
    return value.id == m_value.id && value.kind == m_value.kind && value.range == m_value.range &&
           value.choices == m_value.choices && isMade == m_isMade;
}

void ValueEditor::show(const Value &value, const Worth *worth)
{
    const std::optional<double> spoken =
        worth && isNumeric(value.kind)
            ? std::optional(roundedSpoken(worth->number / spokenSize(value.kind)))
            : std::nullopt;
    // What has no number is not "mixed": it stands there as it was typed.
    if (m_number && !spoken)
        m_number->findChild<QLineEdit *>()->setPlaceholderText(QString::fromStdString(value.typed));
    if (m_slider)
        m_slider->setNumber(spoken);
    else if (m_number)
        m_number->setNumber(spoken);
    else if (m_switch)
        m_switch->setChecked(worth && worth->number != 0.0);
    else if (m_line && !(m_line->hasFocus() && m_line->isModified()) &&
             m_line->text() != QString::fromStdString(value.typed))
        m_line->setText(QString::fromStdString(value.typed));
    if (!m_segments && !m_choice)
        return;
    int index = -1;
    for (std::size_t i = 0; i < value.choices.size(); ++i)
        if (worth && value.choices[i] == worth->text)
            index = static_cast<int>(i);
    if (m_segments) {
        m_segments->setCurrent(index);
        return;
    }
    Choices choices;
    for (const std::string &choice : value.choices)
        choices.all.push_back({QString::fromStdString(choice), QColor()});
    choices.current = index;
    m_choice->setChoices(choices);
}

void ValueEditor::setSpoken(const QString &name)
{
    if (m_slider)
        m_slider->setSpoken(name, {});
    else if (m_segments)
        m_segments->setSpoken(name);
    else if (focusProxy())
        focusProxy()->setAccessibleName(name);
}

/// Steps are counted from the least one.
double ValueEditor::inSteps(double spoken) const
{
    const SpokenRange range = spokenRange(m_value);
    const double steps = std::round((spoken - range.least) / range.step);
    return std::min(range.most, roundedSpoken(range.least + steps * range.step));
}

void ValueEditor::preview(double spoken)
{
    const Document &document = m_bench.session().committed().document;
    const double number = inSteps(spoken) * spokenSize(m_value.kind);
    if (Understood<Document> next =
            typeValue(document, m_value.id, typedNumber(m_value.kind, number), {}))
        m_bench.session().preview(*std::move(next));
}

void ValueEditor::settle(double spoken)
{
    const double stepped = m_slider && !m_number->hasFocus() ? inSteps(spoken) : spoken;
    type(typedNumber(m_value.kind, stepped * spokenSize(m_value.kind)));
}

void ValueEditor::type(std::string text)
{
    const Document &document = m_bench.session().committed().document;
    const Value *known = document.values.find(m_value.id);
    if (!known)
        return;
    Value next = *known;
    next.typed = std::move(text);
    next.reading = m_line ? windowReading(locale()) : Reading();
    const QString why = tryEdit(m_bench, valueChanged(document, std::move(next)));
    m_bench.session().cancelPreview();
    Q_EMIT refused(why);
}

} // namespace fff::ui
