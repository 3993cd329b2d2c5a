// Lines cut off at a clip path. Internal to io.
#pragma once

#include "core/geometry/contour.h"
#include "core/geometry/curve_path.h"

#include <vector>

namespace fff::io {

/// The union of its contours; without any it leaves nothing. Many lines may be cut at it: each
/// meets those contours only that come near.
class SvgClip
{
public:
    explicit SvgClip(std::vector<Contour> contours);

    /// Of a closed line what it encloses within the clip, of an open one what lies in it.
    /// Errors  as windingRegions() and clippedLine().
    Result<std::vector<CurvePath>> clipped(const CurvePath &path) const;

private:
    struct Piece
    {
        Contour contour;
        Box2 box;
        bool isConvex = false;
        Polygon corners; // of a convex one
    };

    /// Calls visit for the pieces whose boxes meet this one, until it says true.
    template <class Visit>
    void visitNear(const Box2 &box, Visit visit) const;
    bool hasAll(const Box2 &box) const;
    std::vector<Contour> near(const Box2 &box) const;

    std::vector<Piece> m_pieces; // from left to right
    std::vector<double> m_reach; // how far to the right any piece up to here goes
};

} // namespace fff::io
