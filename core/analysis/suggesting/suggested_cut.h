// The loops in which planes cut a template, as what may become sections.
#pragma once

#include "core/analysis/suggesting/suggested_ground.h"
#include "core/analysis/suggesting/suggested_planes.h"
#include "core/geometry/frame.h"
#include "core/geometry/polygon.h"
#include "core/model/shape.h"
#include "core/templates/template_mesh.h"

#include <vector>

namespace fff {

struct SuggestedCut
{
    Frame frame;       // upright, where the template is
    Region region;     // in its coordinates, within kCutError of the size of what will be cut
    double area = 0.0; // mm²
    Vec3 centre = Vec3::Zero(); // of the area; world, mm
    double preference = 1.0;
    std::vector<FormSamples::Shown> shown = {};
};

/// Of the mesh's size: how far what is only looked at may be off.
inline constexpr double kCutError = 1.5e-3;

/// One of each piece that a plane cuts, of at least so many mm². Where shells of the mesh run into
/// each other they are one piece. Errors  Cancelled.
Result<std::vector<SuggestedCut>> suggestedCuts(const Template &one,
                                                const std::vector<SuggestedPlane> &planes,
                                                const FormSamples &samples, double leastArea,
                                                const LongWork &work);

/// The contour that follows the template, without what is below the ground, and with feet on it.
/// Errors  EmptyContour where nothing of it stays, those of curveOf(), clip(), windingRegions() and
/// Shape::make().
Result<ShapePointer> shapeOf(const SuggestedCut &cut, const Template &one,
                             const SuggestedGround &ground);

/// Of a section that is there, within `error` mm.
SuggestedCut cutOfSection(const Section &section, double error);

/// Points in the world along all of its boundary, so far apart, mm.
std::vector<Vec3> pointsAlong(const Frame &frame, const Region &region, double step);

} // namespace fff
