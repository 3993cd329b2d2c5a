// What a value is set with, as fits it: a slider with a field, a field alone, a box, buttons, a
// list, a line of text. Dragging is seen all along and is one step when it is done.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/values/values.h"
#include "ui/properties/number_edit.h"

#include <functional>

class QCheckBox;
class QLineEdit;

namespace fff::ui {

class ChoiceBox;
class SegmentedBox;
class SliderField;
class Workbench;

/// Of the kind: one number is that many of what people say: degrees, grams.
double spokenSize(ValueKind kind);
bool isNumeric(ValueKind kind);
/// What is typed for that many mm, radians, kg or plain ones.
std::string typedNumber(ValueKind kind, double number);

class ValueEditor : public QWidget
{
    Q_OBJECT
public:
    ValueEditor(Workbench &bench, const Value &value, bool isMade, QWidget *parent);

    /// Whether another editor fits the value better.
    bool fits(const Value &value, bool isMade) const;
    /// As the value is now. worth: null, it has none.
    void show(const Value &value, const Worth *worth);
    void setSpoken(const QString &name);

Q_SIGNALS:
    /// Empty: it was done, what was refused before counts no more.
    void refused(const QString &why);

private:
    void makeNumber();
    void makeChoice();
    void makeLine();
    NumberEdit *numberEdit() const;
    void takeLine();
    void preview(double spoken);
    void settle(double spoken);
    void type(std::string text);
    double inSteps(double spoken) const;

    Workbench &m_bench;
    const Value m_value; // as it was when this was made
    const bool m_isMade; // of an expression
    NumberEdit *m_number = nullptr;
    SliderField *m_slider = nullptr;
    QCheckBox *m_switch = nullptr;
    SegmentedBox *m_segments = nullptr;
    ChoiceBox *m_choice = nullptr;
    QLineEdit *m_line = nullptr;
};

} // namespace fff::ui
