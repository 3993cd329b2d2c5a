#include "core/io/svg_clip.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/line_clip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace fff::io {

namespace {

/// What the contours wind round, once: outer boundaries counter-clockwise, holes clockwise.
Result<std::vector<Contour>> united(const std::vector<Contour> &contours)
{
    if (contours.size() == 1)
        if (const auto whole = resolveCrossings(contours.front()); whole && !whole->wasCrossing) {
            const bool isTurned = whole->contour.signedArea() < 0.0;
            return std::vector<Contour>{isTurned ? whole->contour.reversed() : whole->contour};
        }
    std::vector<Contour> alike; // running the same way, so that they unite
    for (const Contour &contour : contours)
        alike.push_back(contour.signedArea() < 0.0 ? contour.reversed() : contour);
    Result<std::vector<CurvedRegion>> regions =
        windingRegions(alike, WindingRule::NonZero, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    std::vector<Contour> rings;
    for (CurvedRegion &region : *regions) {
        rings.push_back(std::move(region.outer));
        std::move(region.holes.begin(), region.holes.end(), std::back_inserter(rings));
    }
    return rings;
}

/// Once round all of them, clockwise.
Contour frameAround(const std::vector<Contour> &rings)
{
    Box2 box;
    for (const Contour &ring : rings)
        box.extend(ring.bounds());
    const Vec2 other(box.min.x(), box.max.y());
    Result<Contour> frame =
        Contour::fromPolygon({box.min, other, box.max, {box.max.x(), box.min.y()}});
    assert(frame && "the box of contours is within what a contour may have");
    return *std::move(frame);
}

/// What of the contour lies in the clip. Both wind once round what is theirs; with a frame that
/// takes one off everywhere, what is left are the places of both.
Result<std::vector<Contour>> clippedContour(const Contour &contour,
                                            const std::vector<Contour> &clip)
{
    Result<std::vector<Contour>> rings = united({contour});
    if (!rings)
        return rings;
    Result<std::vector<Contour>> ofClip = united(clip);
    if (!ofClip)
        return ofClip;
    std::move(ofClip->begin(), ofClip->end(), std::back_inserter(*rings));
    rings->push_back(frameAround(*rings));
    const Result<std::vector<CurvedRegion>> regions =
        windingRegions(*rings, WindingRule::Positive, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    const bool isOne = regions->size() == 1 && regions->front().holes.empty();
    if (isOne &&
        std::abs(regions->front().outer.signedArea()) >= std::abs(contour.signedArea()) - kMinArea)
        return std::vector<Contour>{contour}; // all of it
    std::vector<Contour> inside;
    for (const CurvedRegion &region : *regions) {
        inside.push_back(region.outer);
        for (const Contour &hole : region.holes)
            inside.push_back(hole.reversed());
    }
    return inside;
}

} // namespace

SvgClip::SvgClip(std::vector<Contour> contours)
{
    m_pieces.reserve(contours.size());
    for (Contour &contour : contours) {
        Piece piece;
        piece.box = contour.bounds();
        piece.corners = contour.polygon(kCutChord);
        piece.isConvex = convexHull(piece.corners).size() == piece.corners.size();
        if (!piece.isConvex)
            piece.corners = {};
        piece.contour = std::move(contour);
        m_pieces.push_back(std::move(piece));
    }
    std::stable_sort(m_pieces.begin(), m_pieces.end(),
                     [](const Piece &a, const Piece &b) { return a.box.min.x() < b.box.min.x(); });
    for (const Piece &piece : m_pieces)
        m_reach.push_back(m_reach.empty() ? piece.box.max.x()
                                          : std::max(m_reach.back(), piece.box.max.x()));
}

template <class Visit>
void SvgClip::visitNear(const Box2 &box, Visit visit) const
{
    // What lies to the left of it altogether comes first, what begins to the right of it last.
    const auto from = std::lower_bound(m_reach.begin(), m_reach.end(), box.min.x());
    for (auto i = static_cast<std::size_t>(from - m_reach.begin()); i < m_pieces.size(); ++i) {
        if (m_pieces[i].box.min.x() > box.max.x())
            return;
        if (m_pieces[i].box.intersects(box) && visit(m_pieces[i]))
            return;
    }
}

/// Whether a convex contour of the clip has all of the box: nothing is cut then, and what is in it
/// stays exactly what it is. False where that is not known.
bool SvgClip::hasAll(const Box2 &box) const
{
    bool isInOne = false;
    visitNear(box, [&](const Piece &piece) {
        const auto has = [&piece](double x, double y) {
            return locate(Vec2(x, y), piece.corners) != Side::Outside;
        };
        isInOne = piece.isConvex && piece.box.contains(box.min) && piece.box.contains(box.max) &&
                  has(box.min.x(), box.min.y()) && has(box.max.x(), box.min.y()) &&
                  has(box.max.x(), box.max.y()) && has(box.min.x(), box.max.y());
        return isInOne;
    });
    return isInOne;
}

std::vector<Contour> SvgClip::near(const Box2 &box) const
{
    std::vector<Contour> contours;
    visitNear(box, [&contours](const Piece &piece) {
        contours.push_back(piece.contour);
        return false;
    });
    return contours;
}

Result<std::vector<CurvePath>> SvgClip::clipped(const CurvePath &path) const
{
    const Box2 box = path.bounds();
    if (hasAll(box))
        return std::vector<CurvePath>{path};
    const std::vector<Contour> clip = near(box);
    std::vector<CurvePath> left;
    if (clip.empty())
        return left;
    if (!path.isClosed()) {
        std::vector<Contour> alike; // running the same way, so that they unite
        for (const Contour &contour : clip)
            alike.push_back(contour.signedArea() < 0.0 ? contour.reversed() : contour);
        const auto regions = windingRegions(alike, WindingRule::NonZero, kCutChord);
        if (!regions)
            return tl::unexpected(regions.error());
        for (const CurvedRegion &region : *regions) {
            const auto pieces = clippedLine(path.flatten(kCutChord), region.region);
            if (!pieces)
                return tl::unexpected(pieces.error());
            for (const Polygon &piece : *pieces)
                if (Result<CurvePath> cut = CurvePath::fromLine(piece))
                    left.push_back(*std::move(cut));
        }
        return left;
    }
    const Result<Contour> contour = path.ring();
    if (!contour)
        return tl::unexpected(contour.error());
    const auto pieces = clippedContour(*contour, clip);
    if (!pieces)
        return tl::unexpected(pieces.error());
    for (const Contour &piece : *pieces)
        left.push_back(CurvePath::around(piece));
    return left;
}

} // namespace fff::io
