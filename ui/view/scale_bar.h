// The bar that says how large the model is drawn.
#pragma once

#include "ui/view/length_unit.h"

namespace fff::ui {

struct ScaleBar
{
    double length = 0.0; // mm
    QString text;        // "50 mm", "1/4 in"
};

/// The longest round length of at most `longest` mm. Of millimetres and centimetres 1, 2 or 5 times
/// a power of ten; of inches the same from one inch on, halves of halves down to 1/64 below it, and
/// thousandths (1, 2, 5, 10) below those. From 10 m and from 10 feet on in metres and feet.
ScaleBar scaleBar(double longest, LengthUnit unit, const QLocale &locale);

} // namespace fff::ui
