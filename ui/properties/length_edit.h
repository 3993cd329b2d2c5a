// The one field for lengths: shows the unit that is set, and takes other units and sums ("1/2 in",
// "3*25.4", "2*t"). Its value() is in mm, exact; only what is shown is rounded.
#pragma once

#include "ui/properties/number_edit.h"

#include <functional>
#include <utility>

namespace fff::ui {

class LengthEdit : public NumberEdit
{
    Q_OBJECT
public:
    /// All of the range, also its digits, is meant in mm.
    explicit LengthEdit(const Range &range, QWidget *parent = nullptr);

    void setLength(std::optional<double> millimetres) { setNumber(millimetres); }
    /// What "t" stands for in sums: the thickness, mm, asked for when it is needed. Nothing when it
    /// differs.
    using Thickness = std::function<std::optional<double>()>;
    void setThickness(Thickness thickness) { m_thickness = std::move(thickness); }

Q_SIGNALS:
    void lengthEdited(double millimetres);

protected:
    Expression read(const QString &text) const override;
    QString textFromValue(double value) const override;

private:
    void takeUnit();

    Thickness m_thickness;
};

} // namespace fff::ui
