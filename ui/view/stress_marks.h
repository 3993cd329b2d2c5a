// How strained the model is, over the view: the weakest cross-sections as lines, and what their
// colours mean.
#pragma once

#include "core/analysis/stress_lines.h"
#include "core/interaction/view_state.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

struct StressMarks
{
    std::vector<StressLine> lines; // the worst last
    AnalysisPointer analysis;      // that they are of
    double least = 0.2;            // what the legend begins with
    bool isOlder = false;          // than the model that is shown
};

/// From 20 % to 100 % of what the sheet bears: from blue to red, or from yellow to dark blue.
QColor stressColour(double use, bool isForColourBlind);

/// Lines behind a section are hidden.
void paintStress(MarkPen &pen, const StressMarks &marks, const ViewState &view,
                 const QLocale &locale);

} // namespace fff::ui
