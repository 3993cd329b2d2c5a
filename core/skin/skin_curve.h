// A line that patches of the skin share, with the points that all of them use.
#pragma once

#include "core/geometry/vector.h"

#include <cstdint>
#include <vector>

namespace fff {

/// The vertices and triangles of a mesh that grows.
struct GrowingMesh
{
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    std::uint32_t add(const Vec3 &point)
    {
        points.push_back(point);
        return static_cast<std::uint32_t>(points.size() - 1);
    }
    /// Not when two of its corners are one.
    void face(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        if (a != b && b != c && c != a)
            triangles.push_back({a, b, c});
    }
};

struct SkinCurve
{
    std::vector<std::uint32_t> vertices; // n ≥ 1 of the mesh, in order
    std::vector<Vec3> points;            // n, theirs
    std::vector<Vec3> normals;           // n, unit, of the skin there, outwards
    std::vector<double> at;              // n, share of its length: 0 … 1, rising
    std::vector<Vec3> outwards =
        {}; // n, unit, out of the section in its plane; none inside of a patch

    bool isPoint() const { return points.size() == 1; }
    double length() const;
    Vec3 pointAt(double share) const;
    /// Unit.
    Vec3 normalAt(double share) const;
    /// Unit, how it leads off from its start: by a chord, since drawn lines tremble.
    Vec3 startDirection() const;

    SkinCurve reversed() const;
    /// Its points from one to another, first < last.
    SkinCurve part(std::size_t first, std::size_t last) const;
    /// The point in its middle; contours' curves have one there.
    std::size_t middle() const;
};

/// at: from the lengths of its chords.
void measure(SkinCurve &curve);

/// A cubic curve of so many chords from a point of the mesh to another, that leaves the one and
/// comes to the other as an arc does where both ways are those of an arc. startWay, endWay: unit,
/// along the curve.
SkinCurve bridge(GrowingMesh &mesh, std::uint32_t from, const Vec3 &startWay,
                 const Vec3 &startNormal, std::uint32_t to, const Vec3 &endWay,
                 const Vec3 &endNormal, int chords);

/// What a cubic Hermite curve has as derivative at its ends, so that it runs as an arc does: as
/// times the chord, for ways at its ends that differ by this angle.
double arcSpeed(double angle);

} // namespace fff
