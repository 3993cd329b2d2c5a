// The one field for lengths: owns the range and how many digits are shown, shows the unit that is
// set, and takes sums ("1/2 in", "3*25.4"). Its value() is in mm. Says a new value once when it is
// done: on Enter, when the focus leaves, or a moment after the last step of its arrows.
#pragma once

#include <QDoubleSpinBox>
#include <QTimer>

#include <optional>

namespace fff::ui {

class LengthEdit : public QDoubleSpinBox
{
    Q_OBJECT
public:
    struct Range
    {
        double least = 0.0, most = 0.0, step = 0.1; // mm
        int digits = 2;                             // shown of every value, in mm
        int mostDigits = 2;                         // shown where they are not zero, in mm
    };

    explicit LengthEdit(const Range &range, QWidget *parent = nullptr);

    /// Shows a value without announcing it; nothing: the selected things differ. Leaves the field
    /// alone while a person is typing in it.
    void setLength(std::optional<double> millimetres);
    /// What "t" stands for in sums: the thickness, mm.
    void setThickness(std::optional<double> millimetres) { m_thickness = millimetres; }

Q_SIGNALS:
    void lengthEdited(double millimetres);

protected:
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
    void wheelEvent(QWheelEvent *event) override;

private:
    void announce();
    void takeUnit();
    std::optional<double> parsed(QString text) const;

    std::optional<double> m_shown; // what the field held when last set from outside, or announced
    std::optional<double> m_thickness;
    Range m_range;
    QTimer m_settled;
    bool m_isSetting = false;
};

} // namespace fff::ui
