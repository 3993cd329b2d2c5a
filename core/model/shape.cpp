#include "core/model/shape.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// The largest coordinate.
double reachOf(const Contour &contour)
{
    double reach = 0.0;
    for (const Vec2 &p : contour.points())
        reach = std::max({reach, std::abs(p.x()), std::abs(p.y())});
    return reach;
}

} // namespace

Result<ShapePointer> Shape::make(Contour contour, std::vector<Contour> holes)
{
    const std::shared_ptr<Shape> shape(new Shape);
    const double contourArea = contour.signedArea();
    if (!(std::abs(contourArea) >= kMinArea))
        return failure(ErrorCode::EmptyContour);
    const double farthest = reachOf(contour);
    if (farthest > kMaxCoordinate)
        return failure(ErrorCode::BadValue, {},
                       {std::to_string(farthest), std::to_string(kMaxCoordinate)});
    shape->m_contour = contourArea > 0.0 ? std::move(contour) : contour.reversed();
    shape->m_moments = fff::moments(shape->m_contour);
    for (Contour &hole : holes) {
        shape->m_holes.push_back(hole.signedArea() < 0.0 ? std::move(hole) : hole.reversed());
        shape->m_moments += fff::moments(shape->m_holes.back());
    }
    if (!(shape->m_moments.area >= kMinArea))
        return failure(ErrorCode::EmptyContour);
    return shape;
}

int Shape::controlPointCount() const
{
    std::size_t count = m_contour.points().size();
    for (const Contour &hole : m_holes)
        count += hole.points().size();
    return static_cast<int>(count);
}

Result<ShapePointer> Shape::make(Contour contour, std::vector<Contour> holes, Polyline chords,
                                 bool isPlain)
{
    const bool isTurned = contour.signedArea() < 0.0;
    const Result<ShapePointer> result = make(std::move(contour), std::move(holes));
    if (!result || chords.points.empty())
        return result;
    // Nobody else has seen it yet.
    const Shape &shape = **result;
    shape.m_chordsOnce.run([&] {
        shape.m_chords =
            isTurned ? reversed(chords, shape.m_contour.segmentCount()) : std::move(chords);
    });
    if (isPlain && shape.m_holes.empty())
        shape.m_plainOnce.run([&shape] { shape.m_isPlain = true; });
    return result;
}

const Polyline &Shape::chords() const
{
    m_chordsOnce.run([this] { m_chords = m_contour.flatten(kCutChord); });
    return m_chords;
}

bool Shape::isPlain() const
{
    m_plainOnce.run([this] { m_isPlain = fff::isPlain(m_contour, m_holes, kCutChord); });
    return m_isPlain;
}

const Region &Shape::region() const
{
    m_regionOnce.run([this] {
        m_region.outer = chords().points;
        for (const Contour &hole : m_holes)
            m_region.holes.push_back(hole.flatten(kCutChord).points);
        m_bounds = fff::bounds(m_region.outer);
    });
    return m_region;
}

const RegionTree &Shape::boundaries() const
{
    m_boundariesOnce.run([this] { m_boundaries.emplace(region()); });
    return *m_boundaries;
}

const Box2 &Shape::bounds() const
{
    region();
    return m_bounds;
}

const Result<Triangulation> &Shape::triangulation() const
{
    m_triangulationOnce.run([this] { m_triangulation = triangulate(region()); });
    return m_triangulation;
}

Region Shape::flatten(double tolerance) const
{
    Region region;
    region.outer = m_contour.flatten(tolerance).points;
    for (const Contour &hole : m_holes)
        region.holes.push_back(hole.flatten(tolerance).points);
    return region;
}

bool Shape::operator==(const Shape &other) const
{
    return this == &other || (m_contour == other.m_contour && m_holes == other.m_holes);
}

} // namespace fff
