#include "core/geometry/boolean.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"
#include "core/geometry/curve_recovery.h"
#include "core/geometry/simple_ring.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// kResolveChord as a fraction of a contour's extent, where that is more than metres: chords that
/// fine along hundreds of metres would be millions, and Clipper needs their square. No coarser than
/// crossings are looked for.
constexpr double kResolveFraction = 1e-7;
/// What is cut at the edge of what a document may hold may reach this far, mm.
constexpr double kFarthest = 8.0 * kMaxCoordinate;

GridRing counterClockwise(GridRing ring)
{
    if (signedArea(ring) < 0.0)
        std::reverse(ring.begin(), ring.end());
    return ring;
}

/// Regions as chords to regions with curves, largest first, without dust.
Result<std::vector<CurvedRegion>> withCurves(const std::vector<SourceRing> &sources,
                                             const ClipGrid &grid,
                                             const Result<std::vector<GridRegion>> &regions)
{
    if (!regions)
        return tl::unexpected(regions.error());
    std::vector<GridRing> rings;
    for (const GridRegion &region : *regions) {
        rings.push_back(region.outer);
        rings.insert(rings.end(), region.holes.begin(), region.holes.end());
    }
    Result<std::vector<RecoveredRing>> recovered = recoverCurves(sources, grid, rings);
    if (!recovered)
        return tl::unexpected(recovered.error());

    std::vector<CurvedRegion> result;
    std::size_t next = 0;
    for (const GridRegion &region : *regions) {
        CurvedRegion curved;
        RecoveredRing &outer = (*recovered)[next++];
        curved.outer = std::move(outer.contour);
        curved.region.outer = std::move(outer.chords);
        for (std::size_t i = 0; i < region.holes.size(); ++i) {
            RecoveredRing &hole = (*recovered)[next++];
            if (std::abs(signedArea(hole.chords)) < kMinArea)
                continue;
            curved.holes.push_back(std::move(hole.contour));
            curved.region.holes.push_back(std::move(hole.chords));
        }
        if (area(curved.region) >= kMinArea)
            result.push_back(std::move(curved));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const CurvedRegion &a, const CurvedRegion &b) {
                         return area(a.region) > area(b.region);
                     });
    return result;
}

/// On the grid, without points that follow their equal.
GridRing snapped(const Polygon &polygon, const ClipGrid &grid)
{
    GridRing ring;
    ring.reserve(polygon.size());
    for (const Vec2 &p : polygon) {
        const GridPoint point = grid.snap(p);
        if (ring.empty() || ring.back() != point)
            ring.push_back(point);
    }
    while (ring.size() > 1 && ring.back() == ring.front())
        ring.pop_back();
    return ring;
}

double areaOf(const std::vector<GridRegion> &regions)
{
    double sum = 0.0;
    for (const GridRegion &region : regions)
        sum += area(region);
    return sum;
}

double perimeter(const GridRing &ring)
{
    double sum = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        sum += std::hypot(static_cast<double>(ring[i].x - ring[j].x),
                          static_cast<double>(ring[i].y - ring[j].y));
    return sum;
}

/// More than what rounding leaves along its own border.
bool isLoop(const GridRegion &region)
{
    return area(region) > std::max(kMinArea / (kClipGrid * kClipGrid),
                                   perimeter(region.outer) * kClipSlack / kClipGrid);
}

/// What the ring winds round twice and more, where it winds once round all of `once`.
Result<std::vector<GridRegion>> woundAgain(const GridRing &ring,
                                           const std::vector<GridRegion> &once)
{
    std::vector<GridRing> rings{ring};
    const auto addReversed = [&rings](const GridRing &border) {
        rings.emplace_back(border.rbegin(), border.rend());
    };
    for (const GridRegion &region : once) {
        addReversed(region.outer);
        std::for_each(region.holes.begin(), region.holes.end(), addReversed);
    }
    return clip(rings, Winding::Positive, {});
}

/// Whether the ring winds round something twice or the wrong way. A ring that only touches itself
/// winds once round everything inside; what rounding to the grid adds is a sliver along the ring.
/// Where the ring is long that sliver may be more than a loop: these are looked at by themselves.
Result<bool> windsOddly(GridRing ring)
{
    ring = counterClockwise(std::move(ring));
    const double sliver = perimeter(ring) * kClipSlack / kClipGrid;
    const auto isAnyLoop = [](const std::vector<GridRegion> &regions) {
        return std::any_of(regions.begin(), regions.end(), isLoop);
    };
    const Result<std::vector<GridRegion>> against = clip({ring}, Winding::Negative, {});
    if (!against)
        return tl::unexpected(against.error());
    if (areaOf(*against) > sliver || isAnyLoop(*against))
        return true;
    const Result<std::vector<GridRegion>> along = clip({ring}, Winding::Positive, {});
    if (!along)
        return tl::unexpected(along.error());
    if (std::abs(areaOf(*along) - signedArea(ring)) > sliver)
        return true;
    const Result<std::vector<GridRegion>> again = woundAgain(ring, *along);
    if (!again)
        return tl::unexpected(again.error());
    return isAnyLoop(*again);
}

/// A grid has a place for each of its points.
bool isSomewhere(const Contour &contour)
{
    const std::vector<Vec2> &points = contour.points();
    return std::all_of(points.begin(), points.end(), [](const Vec2 &p) {
        return std::abs(p.x()) <= kFarthest && std::abs(p.y()) <= kFarthest;
    });
}

bool areSomewhere(const std::vector<Contour> &contours)
{
    return std::all_of(contours.begin(), contours.end(), isSomewhere);
}

bool isPolygon(const Contour &contour)
{
    for (int i = 0; i < contour.segmentCount(); ++i) {
        if (!contour.segment(i).isStraight(kClipGrid))
            return false;
    }
    return true;
}

} // namespace

Result<std::vector<CurvedRegion>> subtract(const Contour &contour,
                                           const std::vector<Contour> &holes,
                                           const std::vector<Polygon> &cuts, double chord)
{
    std::vector<Contour> contours;
    contours.reserve(cuts.size());
    for (const Polygon &cut : cuts) {
        if (cut.size() > 2) // else it encloses nothing
            contours.push_back(Contour::ofPolygon(cut));
    }
    return subtractContours(contour, holes, contours, chord);
}

Result<std::vector<CurvedRegion>> subtractContours(const Contour &contour,
                                                   const std::vector<Contour> &holes,
                                                   const std::vector<Contour> &cuts, double chord)
{
    if (!isSomewhere(contour) || !areSomewhere(holes) || !areSomewhere(cuts))
        return failure(ErrorCode::NonFinite);
    const ClipGrid grid(contour.bounds());
    std::vector<SourceRing> sources;
    sources.reserve(1 + holes.size() + cuts.size());
    sources.push_back(makeSourceRing(contour, chord, grid, false));
    for (const Contour &hole : holes)
        sources.push_back(makeSourceRing(hole, chord, grid, false));
    for (const Contour &cut : cuts)
        sources.push_back(makeSourceRing(cut, chord, grid, isPolygon(cut)));
    std::vector<GridRing> clips;
    clips.reserve(sources.size() - 1);
    for (std::size_t i = 1; i < sources.size(); ++i)
        clips.push_back(counterClockwise(sources[i].snapped));
    return withCurves(sources, grid,
                      clip({sources.front().snapped}, Winding::NonZero, clips).map(apartAtPoints));
}

Result<std::vector<CurvedRegion>> windingRegions(const std::vector<Contour> &contours,
                                                 WindingRule rule, double chord)
{
    if (!areSomewhere(contours))
        return failure(ErrorCode::NonFinite);
    Box2 box;
    for (const Contour &contour : contours)
        box.extend(contour.bounds());
    const ClipGrid grid(box);
    std::vector<SourceRing> sources;
    std::vector<GridRing> rings;
    for (const Contour &contour : contours) {
        sources.push_back(makeSourceRing(contour, chord, grid, false));
        rings.push_back(sources.back().snapped);
    }
    const Winding winding = rule == WindingRule::Positive ? Winding::Positive : Winding::NonZero;
    return withCurves(sources, grid, clip(rings, winding, {}));
}

Result<ResolvedContour> resolveCrossings(const Contour &contour)
{
    const ClipGrid grid(contour.bounds());
    Polyline chords = contour.flatten(kCutChord);
    const GridRing ring = snapped(chords.points, grid);
    if (ring.size() < 3)
        return failure(ErrorCode::EmptyContour);
    const bool isPlain = isSimple(ring);
    const Result<bool> isCrossing = isPlain ? Result<bool>(false) : windsOddly(ring);
    if (!isCrossing)
        return tl::unexpected(isCrossing.error());
    if (!*isCrossing && std::abs(signedArea(ring)) * (kClipGrid * kClipGrid) >= kMinArea)
        return ResolvedContour{contour, false, std::move(chords), isPlain};
    // Sharp tips carry loops smaller than the usual chords: a contour that crosses itself anywhere
    // is looked at closely once, so that none stays in it.
    const double chord =
        std::clamp(kResolveFraction * contour.bounds().size().maxCoeff(), kResolveChord, kCutChord);
    Result<std::vector<CurvedRegion>> regions =
        windingRegions({contour}, WindingRule::NonZero, chord);
    if (!regions)
        return tl::unexpected(regions.error());
    if (regions->empty())
        return failure(ErrorCode::EmptyContour);
    return ResolvedContour{std::move(regions->front().outer), true, {}, false};
}

Nesting nesting(const Contour &first, const Contour &second, double chord)
{
    const Polygon a = first.flatten(chord).points, b = second.flatten(chord).points;
    const Box2 boxA = bounds(a), boxB = bounds(b);
    if (a.empty() || b.empty())
        return Nesting::Meeting;
    if (!boxA.intersects(boxB))
        return Nesting::Apart;
    Box2 both = boxA;
    both.extend(boxB);
    const ClipGrid grid(both);
    if (meet(snapped(a, grid), snapped(b, grid)))
        return Nesting::Meeting;
    // They do not meet: where one vertex lies, there lies all of it.
    if (locate(a.front(), b) == Side::Inside)
        return Nesting::FirstInside;
    return locate(b.front(), a) == Side::Inside ? Nesting::SecondInside : Nesting::Apart;
}

bool isPlain(const Contour &contour, const std::vector<Contour> &others, double chord)
{
    const ClipGrid grid(contour.bounds());
    std::vector<GridRing> rings{snapped(contour.flatten(chord).points, grid)};
    for (const Contour &other : others)
        rings.push_back(snapped(other.flatten(chord).points, grid));
    return areSimpleAndApart(rings);
}

} // namespace fff
