// A field for a number with a unit behind it. Says a new value once when it is done: on Enter, when
// the focus leaves, or a moment after the last step of its arrows.
#pragma once

#include <QDoubleSpinBox>
#include <QTimer>

#include <optional>

namespace fff::ui {

class NumberEdit : public QDoubleSpinBox
{
    Q_OBJECT
public:
    struct Range
    {
        double least = 0.0, most = 0.0, step = 0.1;
        int digits = 2;     // shown of every value
        int mostDigits = 2; // shown where they are not zero
    };

    /// unit  its sign, behind the number; may be empty
    NumberEdit(const Range &range, const QString &unit, QWidget *parent = nullptr);

    /// Shows a value without announcing it; nothing: the selected things differ. Leaves the field
    /// alone while a person is typing in it.
    void setNumber(std::optional<double> number);

Q_SIGNALS:
    void numberEdited(double number);

protected:
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void wheelEvent(QWheelEvent *event) override;

    const Range &range() const { return m_range; }
    void setUnit(const QString &sign, double step);
    /// Without the unit; the digits that are shown stand for all that the value has.
    bool showsValue(const QString &text) const;

private:
    void announce();
    void showNothing();

    Range m_range;
    QString m_suffix;              // the unit behind every number
    std::optional<double> m_shown; // what the field held when last set from outside, or announced
    QTimer m_settled;
    bool m_isSetting = false;
};

} // namespace fff::ui
