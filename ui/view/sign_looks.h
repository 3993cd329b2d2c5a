// How signs look by what they mean: their colours and lines.
#pragma once

#include "core/interaction/sign.h"
#include "ui/view/view_style.h"

#include <QPen>

namespace fff::ui {

struct SignLook
{
    QColor ViewStyle::*colour = nullptr;
    double width = 2.0;           // px
    double dash = 0.0, gap = 0.0; // in widths; 0: a whole line
    double fill = 0.0;            // alpha of what it surrounds
    bool isCased = true;          // on a wider line, so that it is seen on every stock
    double radius = 4.0;          // px, of a handle
};

const SignLook &lookOf(SignRole role);
QPen penOf(const SignLook &look, const ViewStyle &style);

} // namespace fff::ui
