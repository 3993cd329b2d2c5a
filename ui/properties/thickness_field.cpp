#include "ui/properties/thickness_field.h"

namespace fff::ui {

ThicknessField::ThicknessField(QWidget *parent) : ThicknessField(new LengthEdit(kRange), parent) {}

ThicknessField::ThicknessField(LengthEdit *edit, QWidget *parent)
    : SliderField({kSliderLeast, kSliderMost, 0.05}, edit, parent), m_edit(edit)
{
    setNames("thicknessSlider", "thicknessEdit");
    setSpoken(tr("Thickness"), {});
    edit->setThickness([this] { return m_thickness; });
}

void ThicknessField::setFollowed(Followed followed)
{
    m_edit->setFollowed(std::move(followed));
}

void ThicknessField::setThickness(std::optional<double> millimetres)
{
    m_thickness = millimetres;
    setNumber(millimetres);
}

} // namespace fff::ui
