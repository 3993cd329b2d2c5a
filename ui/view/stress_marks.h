// How strained the model is, over the view: the weakest cross-sections as lines, and what colours
// mean. Where stress is known all over a body, that is drawn on it (field_painter.h), and of its
// lines those across necks that are too narrow on the screen for colours to be read, and the one
// that is asked about.
#pragma once

#include "core/analysis/bent_model.h"
#include "core/analysis/stress_lines.h"
#include "core/interaction/view_state.h"
#include "ui/view/force_marks.h"
#include "ui/view/mark_pen.h"
#include "ui/view/stress_colours.h"

#include <QLocale>

namespace fff::ui {

/// Alpha of what is older than the model that is shown.
inline constexpr double kOlderStress = 0.4;

struct StressMarks
{
    std::vector<StressLine> lines;         // the worst last
    AnalysisPointer analysis;              // that they are of
    std::shared_ptr<const BentModel> bent; // stress all over bodies, which is drawn in place of
                                           // their lines; null: not known
    double least = 0.2;                    // what the legend begins with
    double safety = 0.0;                   // factor that stress is judged with; 0: not said
    double limit = 0.0;            // MPa: what the sheet bears that is strained most; 0: not known
    std::vector<ForceMark> forces; // at feet and joints
    HoldVerdict verdict = HoldVerdict::Holds;
    bool isRated = true;  // of all sheets it is known what they bear
    bool isOlder = false; // than the model that is shown
    int lit = -1;         // the line that is ringed; −1: none
    bool hasCard = false; // what is known of that one is shown, too
};

/// Of what was worked out, without forces.
/// least  of what the sheet bears: less is not shown
StressMarks stressMarksOf(AnalysisPointer analysis, const Strength &strength, double least = 0.2);

/// Of all that is strained at least as much as is shown, the worst; 0: nothing is.
double worstShown(const StressMarks &marks);

/// What is said where there are no lines: that nothing is strained, or that it is not known.
QString withoutLines(const StressMarks &marks, const QLocale &locale);

/// The line that is seen at a point of the view, px, or near enough to it to be meant; −1: none.
int lineAt(const QPointF &point, const StressMarks &marks, const Camera &camera,
           const Vec2 &viewport, const ViewState &view);

/// Lines behind a section are hidden.
void paintStress(MarkPen &pen, const StressMarks &marks, const ViewState &view,
                 const QLocale &locale);

/// What its colours mean, or why there are none, under the view cube; says where that ends, px.
double paintStressKey(MarkPen &pen, const StressMarks &marks, const QLocale &locale);
/// The same while the model is shown where it moves, and how many times as far: lines and forces
/// would lie beside their places. null: no stress is shown.
void paintMovedKey(MarkPen &pen, const StressMarks *marks, double times, const QLocale &locale);

/// The ring round the line that is asked about, and its card, over all else.
void paintAskedLine(MarkPen &pen, const StressMarks &marks, const QLocale &locale);

} // namespace fff::ui
