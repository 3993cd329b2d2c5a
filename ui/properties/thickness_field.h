// A stock's thickness, mm.
#pragma once

#include "ui/properties/slider_field.h" // first: moc stumbles over some standard headers

#include "ui/properties/length_edit.h"

namespace fff::ui {

class ThicknessField : public SliderField
{
    Q_OBJECT
public:
    static constexpr NumberEdit::Range kRange{0.1, 100.0, 0.05, 2, 3}; // mm, of the field
    static constexpr double kSliderLeast = 0.5, kSliderMost = 5.0;     // mm

    explicit ThicknessField(QWidget *parent = nullptr);

    void setFollowed(Followed followed);
    /// Announces nothing. Nothing: several stocks that differ.
    void setThickness(std::optional<double> millimetres);

private:
    ThicknessField(LengthEdit *edit, QWidget *parent);

    LengthEdit *m_edit;
    std::optional<double> m_thickness; // as last set: "t" in the field
};

} // namespace fff::ui
