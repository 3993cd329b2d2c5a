// What lines of a drawing from another program, or of a template, become: sections, a contour,
// holes, or marks.
#pragma once

#include "core/geometry/curve_path.h"
#include "core/geometry/similarity.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/drawing_words.h"
#include "core/interaction/section_edit.h"
#include "core/model/mark.h"

namespace fff {

/// So many of what a person draws over at once; a photograph that is traced may have thousands.
inline constexpr std::size_t kMostPlacedSections = 200, kMostPlacedHoles = 2000;

/// Lines, and what they are called.
struct Drawing
{
    std::vector<CurvePath> lines; // y upwards; mm, in true size, where they lie nowhere
    std::string name;             // of its file, or of a template
    /// Where a template has them in the world.
    std::optional<Similarity> place = {};
    Text step = steps::kImportDrawing; // what the history says, of the name
    /// Where they were counted already: too many are refused before their lines are looked into.
    std::size_t outlines = 0;
};

/// A section for every outline, with its holes, on the plane of the front, beside the model and on
/// the ground, as they lie to each other; all are selected. Refused (DrawingOpen) where nothing is
/// enclosed.
SectionEdit drawingSections(const Model &model, const Drawing &drawing, const Naming &naming);
/// The same of a drawing that lies somewhere: there, each as if it were drawn. Refused where it has
/// more than kMostPlacedSections outlines (kTooManyOutlines), or all of it is below the ground.
SectionEdit placedSections(const Model &model, const Drawing &drawing, const DrawingRules &rules);

// On a section, what lies somewhere stays there, as it is seen from straight above the section;
// refused where it lies aslant to it (kDrawingAslant).

/// The largest outline with its holes in place of the section's contour and holes, about the same
/// middle. A note (DrawingLeft) says how many outlines were left out.
SectionEdit drawingContour(const Model &model, const SectionRef &section, const Drawing &drawing);
/// A hole for every outline, about the middle of the section.
SectionEdit drawingHoles(const Model &model, const SectionRef &section, const Drawing &drawing);
/// All lines as one mark, about the middle of the section.
SectionEdit drawingMark(const Model &model, const SectionRef &section, const Drawing &drawing,
                        Mark::Kind kind);

} // namespace fff
