// The one field for lengths: shows the unit that is set, and takes other units and sums ("1/2 in",
// "3*25.4"). Its value() is in mm, exact; only what is shown is rounded.
#pragma once

#include "ui/properties/number_edit.h"

namespace fff::ui {

class LengthEdit : public NumberEdit
{
    Q_OBJECT
public:
    /// All of the range, also its digits, is meant in mm.
    explicit LengthEdit(const Range &range, QWidget *parent = nullptr);

    void setLength(std::optional<double> millimetres) { setNumber(millimetres); }
    /// What "t" stands for in sums: the thickness, mm.
    void setThickness(std::optional<double> millimetres) { m_thickness = millimetres; }

Q_SIGNALS:
    void lengthEdited(double millimetres);

protected:
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;

private:
    void takeUnit();
    std::optional<double> parsed(const QString &text) const;

    std::optional<double> m_thickness;
};

} // namespace fff::ui
