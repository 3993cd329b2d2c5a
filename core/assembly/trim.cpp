#include "core/assembly/trim.h"

#include "core/assembly/lobes.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"

namespace fff {

Result<ShapePointer> trimmed(const JointSide &section, const JointSide &to)
{
    const Frame &frame = section.section.frame, &other = to.section.frame;
    const std::optional<Axis> axis = intersectionAxis(frame, other);
    if (!axis)
        return failure(ErrorCode::NearlyParallel);
    const Vec3 n = frame.normal(), m = other.normal();
    const double angle = std::atan2(n.cross(m).norm(), std::abs(n.dot(m)));
    // What each slab takes up in the other's plane.
    const auto strip = slitWidth(section.stock.thickness, to.stock.thickness, angle, 0.0);
    const auto reach = slitWidth(to.stock.thickness, section.stock.thickness, angle, 0.0);
    if (!strip || !reach)
        return failure(ErrorCode::NearlyParallel);
    const PlaneLine line = lineInFrame(*axis, frame);
    const Vec2 half = 0.5 * *strip * perpendicular(line.direction);
    std::vector<Polygon> cuts;
    for (const Stretch &s : lobesIn(lineInFrame(*axis, other), *to.section.shape, 0.5 * *reach))
        cuts.push_back({line.at(s.from) - half, line.at(s.to) - half, line.at(s.to) + half,
                        line.at(s.from) + half});
    const Shape &shape = *section.section.shape;
    Result<std::vector<CurvedRegion>> pieces =
        subtract(shape.contour(), shape.holes(), cuts, kCutChord);
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    const double before = shape.contour().signedArea();
    if (before - pieces->front().outer.signedArea() < kMinArea)
        return failure(ErrorCode::BadValue, "section", {"", "a section that goes into the other"});
    return Shape::make(std::move(pieces->front().outer), std::move(pieces->front().holes));
}

} // namespace fff
