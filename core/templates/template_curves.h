// The lines of a drawing that is a template, once its file is read.
#pragma once

#include "core/base/result.h"
#include "core/geometry/outlines.h"
#include "core/model/template.h"

namespace fff {

/// Immutable. In mm of the file, about the middle of the box of all of it, y upwards.
struct TemplateCurves
{
    std::vector<CurvePath> lines;  // made one where they meet
    std::vector<Outline> outlines; // what the closed ones enclose, largest first
    std::vector<CurvePath> open;   // the others, and what is too tangled to enclose anything
    Vec2 size = Vec2::Zero();
};

/// Errors  EmptyContour for no lines, and for those that are all one point; NotWorkedOut, as
/// outlinesOf().
Result<TemplateCurvesPointer> makeTemplateCurves(std::vector<CurvePath> lines);

} // namespace fff
