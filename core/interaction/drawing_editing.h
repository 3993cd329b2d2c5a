// What lines of a drawing from another program become: sections, a contour, holes, or marks.
#pragma once

#include "core/geometry/curve_path.h"
#include "core/interaction/contour_target.h"
#include "core/interaction/section_edit.h"
#include "core/model/mark.h"

namespace fff {

/// Lines in true size, and what they are called.
struct Drawing
{
    std::vector<CurvePath> lines; // mm, y upwards
    std::string name;             // of its file
};

/// A section for every outline, with its holes, on the plane of the front, beside the model and on
/// the ground, as they lie to each other; all are selected. Refused (DrawingOpen) where nothing is
/// enclosed.
SectionEdit drawingSections(const Model &model, const Drawing &drawing, const Naming &naming);
/// The largest outline with its holes in place of the section's contour and holes, about the same
/// middle. A note (DrawingLeft) says how many outlines were left out.
SectionEdit drawingContour(const Model &model, const SectionRef &section, const Drawing &drawing);
/// A hole for every outline, about the middle of the section.
SectionEdit drawingHoles(const Model &model, const SectionRef &section, const Drawing &drawing);
/// All lines as one mark, about the middle of the section.
SectionEdit drawingMark(const Model &model, const SectionRef &section, const Drawing &drawing,
                        Mark::Kind kind);

} // namespace fff
