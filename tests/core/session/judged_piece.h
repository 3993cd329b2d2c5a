// A piece as the judge of what is held sees it: a solid prism, and points of its surface. Nothing
// of the product's is in it but Vec2, Vec3 and Frame.
#pragma once

#include "core/geometry/frame.h"
#include "tests/core/session/edge_grid.h"

#include <vector>

namespace fff::test {

/// Outline × thickness, half of it to each side of the frame's plane. mm
struct Prism
{
    PlainRing outer;
    std::vector<PlainRing> holes;
    Frame frame;
    double thickness = 3.0;
};

struct SurfacePoint
{
    Vec3 at;               // world
    double distance = 0.0; // from the other piece, mm
};

class JudgedPiece
{
public:
    explicit JudgedPiece(Prism prism);

    const Prism &prism() const { return m_prism; }
    const Frame &frame() const { return m_prism.frame; }
    const Vec3 &normal() const { return m_normal; }
    const EdgeGrid &edges() const { return m_edges; }
    double half() const { return 0.5 * m_prism.thickness; }

    /// How deep a point is in the piece: to the nearest of its faces and walls, 0 outside. mm
    double depth(const Vec3 &p) const;
    /// Whether that is at least so much, for less work.
    bool isWithin(const Vec3 &p, double depth) const;
    /// 0 inside; `limit` where it is farther away. mm
    double distance(const Vec3 &p, double limit) const;

    /// Points of this piece's walls and edges that are no more than `reach` from the other one, and
    /// of its faces and its middle no more than `faceReach`. Dense enough to see a wall of 0.5 mm.
    std::vector<SurfacePoint> pointsNear(const JudgedPiece &other, double reach,
                                         double faceReach) const;

private:
    std::vector<double> layers() const;
    void addWalls(const PlainRing &ring, const JudgedPiece &other, double reach,
                  std::vector<SurfacePoint> &points) const;
    void addFaces(const JudgedPiece &other, double reach, std::vector<SurfacePoint> &points) const;
    void addWithin(const JudgedPiece &other, const Vec2 &p, const std::vector<double> &heights,
                   double reach, std::vector<SurfacePoint> &points) const;
    Box2 boundsOf(const JudgedPiece &other, const Vec2 &along) const;
    bool isFarFrom(const JudgedPiece &other, double reach) const;
    Vec3 world(const Vec2 &p, double height) const;

    Prism m_prism;
    Vec3 m_normal;
    EdgeGrid m_edges;
    Vec3 m_middle;         // of a ball that holds it
    double m_radius = 0.0; // mm
};

} // namespace fff::test
