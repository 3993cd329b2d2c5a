// What lies over the model: the marks of a gesture (ui/UI.md, section 3), the line of the ground,
// the scale bar and the invitation of an empty document. Painted with QPainter in
// device-independent pixels.
#pragma once

#include "core/analysis/problem_look.h"
#include "core/interaction/interaction.h"
#include "core/interaction/view_state.h"
#include "core/operations/operation_kind.h"
#include "ui/view/bearing_marks.h"
#include "ui/view/length_unit.h"
#include "ui/view/step_marks.h"
#include "ui/view/stress_marks.h"
#include "ui/view/view_style.h"

#include <QLocale>
#include <QPainter>
#include <QString>

#include <optional>

namespace fff::ui {

struct OverlayScene
{
    const Overlay &overlay;
    const Hovered &hovered;
    const Camera &camera;
    Vec2 viewport;
    bool isEmpty = false; // nothing is to be seen yet
    bool isIdle = true;   // no gesture
    ViewState view = {};
    Box3 bounds = {};                // of the model
    QString hoveredName = {};        // of the section under the cursor
    std::optional<double> busy = {}; // the model is being worked on: how often its mark went round
    LengthUnit unit = LengthUnit::Millimetre;
    std::vector<PlacedMark> marks = {};      // of problems: numbers and dots
    int litMark = 0;                         // the one that is drawn larger
    ProblemLook problems = {};               // what is drawn of them besides
    std::vector<SectionPointer> ghosts = {}; // that are not in the model
    bool areGhostsOld = false;               // what is tried stands in their place
    const StepMarks *steps = nullptr;        // of the assembly, which is shown instead of the model
    SectionPointer edited = {};              // whose points are shown, as it is shown
    const OperationKind *operation = nullptr; // whose handles there are
    Signs selected = {};                      // overlay.selected, as it is shown
    Signs dimensions = {};                    // of the model
    const StressMarks *stress = nullptr;      // null: not shown
    const BearingMarks *bearing = nullptr;    // shown in place of those; null: not
    double timesMoved =
        0.0; // the model is shown where it moves, so many times as far; 0: it is not
    std::vector<ProblemMark> problemMarks = {}; // that `marks` stand for
    std::vector<QRectF> covered = {};           // by what stands over the view, px: no words there
    QRectF *offer = nullptr;                    // is told where the words of an offer are, px
    bool isOfferLit = false;                    // the cursor is on them
    std::vector<QRectF> *words = nullptr;       // is told where all words that were placed are, px
};

/// Leaves the painter's state changed. Lengths are written as the locale has them.
void paintOverlay(QPainter &painter, const OverlayScene &scene, const ViewStyle &style,
                  const QLocale &locale);

} // namespace fff::ui
