// How strained the model is, over the view: the weakest cross-sections as lines, and what their
// colours mean.
#pragma once

#include "core/analysis/stress_lines.h"
#include "core/interaction/view_state.h"
#include "ui/view/force_marks.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

struct StressMarks
{
    std::vector<StressLine> lines; // the worst last
    AnalysisPointer analysis;      // that they are of
    double least = 0.2;            // what the legend begins with
    std::vector<ForceMark> forces; // at feet and joints
    bool isKnown = true;           // forces are known and can be trusted
    bool isRated = true;           // of all sheets it is known what they bear
    bool isOlder = false;          // than the model that is shown
    int lit = -1;                  // the line that is ringed; −1: none
    bool hasCard = false;          // what is known of that one is shown, too
};

/// From 20 % to 100 % of what the sheet bears: from blue to red, or from yellow to dark blue.
QColor stressColour(double use, bool isForColourBlind);

/// Of what was worked out, without forces.
StressMarks stressMarksOf(AnalysisPointer analysis, const Strength &strength);

/// What is said where there are no lines: that nothing is strained, or that it is not known.
QString withoutLines(const StressMarks &marks, const QLocale &locale);

/// The line that is seen at a point of the view, px, or near enough to it to be meant; −1: none.
int lineAt(const QPointF &point, const StressMarks &marks, const Camera &camera,
           const Vec2 &viewport, const ViewState &view);

/// Lines behind a section are hidden.
void paintStress(MarkPen &pen, const StressMarks &marks, const ViewState &view,
                 const QLocale &locale);

/// The ring round the line that is asked about, and its card, over all else.
void paintAskedLine(MarkPen &pen, const StressMarks &marks, const QLocale &locale);

} // namespace fff::ui
