// A contour with its holes, immutable, shared by every section that looks like it, and the owner of
// all that follows from it alone. Derived values are computed at first use, once, from any thread.
#pragma once

#include "core/base/once.h"
#include "core/base/result.h"
#include "core/geometry/contour.h"
#include "core/geometry/moments.h"
#include "core/geometry/region_tree.h"
#include "core/geometry/triangulation.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

class Shape
{
public:
    /// Turns the contour counter-clockwise and the holes clockwise. Crossings are the caller's
    /// matter (core/geometry/boolean.h mends them). Errors  EmptyContour when the contour, or what
    /// the holes leave of it, has less than kMinArea; BadValue where it reaches beyond
    /// kMaxCoordinate.
    static Result<std::shared_ptr<const Shape>> make(Contour contour,
                                                     std::vector<Contour> holes = {});
    /// The same where it has been seen before: `chords` are those of the contour to kCutChord, or
    /// none, and `isPlain` what isPlain() says of the contour alone.
    static Result<std::shared_ptr<const Shape>> make(Contour contour, std::vector<Contour> holes,
                                                     Polyline chords, bool isPlain);

    Shape(const Shape &) = delete;
    Shape &operator=(const Shape &) = delete;

    const Contour &contour() const { return m_contour; }
    const std::vector<Contour> &holes() const { return m_holes; }
    int controlPointCount() const;

    /// Of the contour, to kCutChord.
    const Polyline &chords() const;
    /// The region on these chords and those of the holes.
    const Region &region() const;
    /// Of the region's rings.
    const RegionTree &boundaries() const;
    /// Contour and holes neither touch themselves nor each other, on the chords of region().
    bool isPlain() const;
    /// Of `region()`. Errors  as triangulate().
    const Result<Triangulation> &triangulation() const;
    /// Exact for the curves.
    const Moments &moments() const { return m_moments; }
    double area() const { return m_moments.area; }
    Vec2 centroid() const { return m_moments.centroid(); }
    /// Of the region's vertices: tight to kCutChord.
    const Box2 &bounds() const;

    /// The region to another tolerance, not kept.
    Region flatten(double tolerance) const;

    /// Same curves; says nothing about sharing.
    bool operator==(const Shape &other) const;

private:
    Shape() = default;
    Contour m_contour;
    std::vector<Contour> m_holes;
    Moments m_moments;
    mutable Polyline m_chords;
    mutable Once m_chordsOnce, m_regionOnce, m_triangulationOnce, m_plainOnce, m_boundariesOnce;
    mutable bool m_isPlain = false;
    mutable Region m_region;
    mutable Box2 m_bounds;
    mutable std::optional<RegionTree> m_boundaries;
    mutable Result<Triangulation> m_triangulation;
};

using ShapePointer = std::shared_ptr<const Shape>;

} // namespace fff
