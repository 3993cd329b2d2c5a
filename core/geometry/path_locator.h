// Where on a line a point is nearest, how far along that is, and what of the line lies between two
// such places.
#pragma once

#include "core/geometry/box_tree.h"
#include "core/geometry/curve_path.h"

#include <optional>
#include <vector>

namespace fff {

/// Of one line, which stays as it is; an empty one has no places. Lengths along it are those of
/// chords that are off the curve by kChord at most; places are on the curve itself.
class PathLocator
{
public:
    static constexpr double kChord = 0.005; // mm

    PathLocator() = default;
    explicit PathLocator(CurvePath path);

    const CurvePath &path() const { return m_path; }
    bool isClosed() const { return m_path.isClosed(); }
    double length() const { return m_lengths.empty() ? 0.0 : m_lengths.back(); } // mm

    struct Place
    {
        double along = 0.0; // mm from the start, below length()
        Vec2 at = Vec2::Zero();
        double distance = 0.0; // mm
    };
    /// The nearest place that is not further than `reach`. O(log chords + chords within reach).
    std::optional<Place> nearest(const Vec2 &p, double reach) const;
    /// The same of what lies within `window` mm along the line of a place on it, both ways; of a
    /// closed line also across its start.
    std::optional<Place> nearest(const Vec2 &p, double reach, double around, double window) const;

    /// So far along; of a closed line modulo its length, else held at its ends.
    Vec2 at(double along) const;
    /// Unit, the way the line runs there.
    Vec2 directionAt(double along) const;
    /// From there to there along the line, exactly on it; backwards where `to` is less. Of a closed
    /// line `to` may lie beyond its end, and either before its start, by less than its length.
    std::vector<CubicBezier> piece(double from, double to) const;

private:
    struct Vertex
    {
        int segment = 0;
        double t = 0.0;
    };
    std::size_t chordAt(double along) const;
    Vertex vertexAt(double along) const;
    double wrapped(double along) const;
    void look(std::size_t chord, const Vec2 &p, double &reach, std::optional<Place> &best) const;
    void polish(const Vec2 &p, std::optional<Place> &place) const;
    void addPiece(double from, double to, std::vector<CubicBezier> &pieces) const;

    CurvePath m_path;
    Polygon m_points;              // ends of chords
    std::vector<Vertex> m_origins; // of each chord's start, and the end of the line
    std::vector<double> m_lengths; // along, of each point
    BoxTree m_tree;                // of chords
};

} // namespace fff
