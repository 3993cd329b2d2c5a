// The path that the pen sets point by point, until it closes to a contour. Canvas coordinates, mm.
#pragma once

#include "core/geometry/contour.h"

#include <optional>
#include <vector>

namespace fff {

/// A point of the path with its handles, which are counted from it. Without one, the piece on that
/// side leaves straight for where it goes.
struct PathPoint
{
    Vec2 at = Vec2::Zero();
    std::optional<Vec2> in, out;

    bool isCorner() const { return !in && !out; }
    bool operator==(const PathPoint &other) const = default;
};

/// The piece between two points: straight between corners. Where only one has a handle, the other
/// end's lies on a third of the way to it, so that no piece starts or ends without a direction.
CubicBezier pathPiece(const PathPoint &from, const PathPoint &to);

class PenPath
{
public:
    enum class End { In, Out };

    const std::vector<PathPoint> &points() const { return m_points; }
    bool isEmpty() const { return m_points.empty(); }
    std::size_t size() const { return m_points.size(); }
    /// From each point to the next, none back to the first.
    std::vector<CubicBezier> pieces() const;

    // Edits; those between two calls of keep() are one step.

    /// What follows is a new step.
    void keep();
    /// Adds a corner.
    void add(const Vec2 &at);
    /// Moves a point with its handles.
    void move(std::size_t index, const Vec2 &at);
    /// Pulls a handle of the point to `tip`; the other one follows to the opposite side, unless it
    /// is broken off, or was before. A handle without length is none.
    void bend(std::size_t index, End end, const Vec2 &tip, bool isBroken);
    /// Needs one.
    void removeLast();

    /// Steps back, and forth again until the next edit.
    bool canUndo() const;
    bool canRedo() const { return !m_after.empty(); }
    void undo();
    void redo();

    bool operator==(const PenPath &other) const { return m_points == other.m_points; }

private:
    std::vector<PathPoint> m_points;
    std::vector<std::vector<PathPoint>> m_before, m_after; // steps
};

/// What a path encloses when it closes from its last point to its first.
struct PathContour
{
    std::optional<CubicBezier> closing; // none where the path ends at its start
    /// Free of crossings; none while nothing of at least kMinArea is enclosed.
    std::optional<Contour> contour;
    bool wasCrossing = false; // the closed path crosses itself: the largest loop is kept
};

PathContour closedPath(const std::vector<PathPoint> &points);

} // namespace fff
