// What lies over the view while the steps of the assembly are shown: the arrow along which parts
// come, and the numbers that are engraved on them.
#pragma once

#include "ui/view/mark_pen.h"

#include <QLocale>

#include <vector>

namespace fff::ui {

struct StepMarks
{
    struct Number
    {
        Vec3 at = Vec3::Zero(); // world
        double extent = 0.0;    // of its part, the smaller one, mm
        int number = 0;
        bool isMoving = false; // of the step that is shown
    };
    std::vector<Vec3> way; // corners, world, from where it begins; none: nothing goes anywhere
    std::vector<Number> numbers;
};

/// Numbers of the step's parts first, then those for which there is room.
void paintSteps(MarkPen &pen, const StepMarks &marks, const QLocale &locale);

} // namespace fff::ui
