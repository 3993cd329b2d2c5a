#include "core/geometry/offset.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_recovery.h"
#include "core/geometry/raw_offset.h"
#include "core/geometry/swept_disc.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

// Each refines what the one before left faulty, and goes a little farther out: walls that lie as
// far from each other as the disc is wide are no way in then.
constexpr int kMaxTries = 6;
constexpr double kFartherOut = 1e-4; // mm, after the second try
constexpr double kRefinement = 0.25;
// Voids that the disc goes into with less play, in mm, have no path of their own; those of less
// than the second one have chords.
constexpr double kLeastPlay = 5e-4, kLeastCurved = 0.02;
// Curves this near to a fault, beyond the distance, in mm, are taken to have a share in it.
constexpr double kBesideFault = 0.1;

Box2 boxOf(const CubicBezier &curve)
{
    Box2 box;
    for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
        box.extend(p);
    return box;
}

std::vector<const Contour *> boundariesOf(const CurvedRegion &region)
{
    std::vector<const Contour *> all{&region.outer};
    for (const Contour &hole : region.holes)
        all.push_back(&hole);
    return all;
}

/// How far a point may move in the ring, mm, at most: what lies in a ring is as wide as that or
/// half of it.
double playOf(const Polygon &ring)
{
    double length = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        length += (ring[i] - ring[j]).norm();
    return length > 0.0 ? 2.0 * std::abs(signedArea(ring)) / length : 0.0;
}

class Grower
{
public:
    Grower(const CurvedRegion &region, double distance)
        : m_region(region), m_distance(distance), m_error(std::min(kOffsetError, 0.1 * distance)),
          m_chord(0.5 * m_error), m_boundaries(boundariesOf(region))
    {
        for (const Contour *boundary : m_boundaries) {
            const auto count = static_cast<std::size_t>(boundary->segmentCount());
            m_styles.push_back({std::vector<double>(count, 0.0), std::vector<char>(count, 0)});
        }
    }

    Result<CurvedRegion> grown()
    {
        for (int i = 0; i < kMaxTries; ++i) {
            m_farther = std::max(0, i - 1) * std::min(kFartherOut, 0.01 * m_distance);
            Result<CurvedRegion> result = attempt();
            if (!result)
                return result;
            const std::vector<SweepFault> faults = sweepFaults(m_region, *result, m_distance);
            if (faults.empty()) {
                if (m_isUnmitred || i + 1 == kMaxTries || !unmitre(*result))
                    return result;
                continue;
            }
            for (const SweepFault &fault : faults)
                giveWay(fault);
            m_chord *= kRefinement;
        }
        return failure(ErrorCode::CannotOffset);
    }

private:
    Result<CurvedRegion> attempt();
    static Result<CurvedRegion> withCurves(const std::vector<SourceRing> &sources,
                                           const ClipGrid &grid, const GridRegion &region);
    void giveWay(const SweepFault &fault);
    bool unmitre(const CurvedRegion &path);
    bool makeRound(const Vec2 &at);
    void refine(const Vec2 &at);

    const CurvedRegion &m_region;
    double m_distance, m_error, m_chord, m_farther = 0.0;
    bool m_isUnmitred = false;
    std::vector<const Contour *> m_boundaries;
    std::vector<OffsetStyle> m_styles; // of each
    std::vector<RawOffset> m_offsets;  // of each, of the last attempt
};

Result<CurvedRegion> Grower::attempt()
{
    m_offsets.clear();
    Box2 box;
    for (std::size_t i = 0; i < m_boundaries.size(); ++i) {
        Result<RawOffset> offset =
            rawOffset(*m_boundaries[i], m_distance + m_farther, m_error, m_styles[i]);
        if (!offset)
            return tl::unexpected(offset.error());
        box.extend(offset->contour.bounds());
        m_offsets.push_back(std::move(*offset));
    }
    const ClipGrid grid(box);
    std::vector<SourceRing> sources;
    std::vector<GridRing> rings;
    for (const RawOffset &offset : m_offsets) {
        sources.push_back(makeSourceRing(offset.contour, m_chord, grid, false));
        rings.push_back(sources.back().snapped);
    }
    const Result<std::vector<GridRegion>> regions = clip(rings, Winding::Positive, {});
    if (!regions)
        return tl::unexpected(regions.error());
    if (regions->empty())
        return failure(ErrorCode::CannotOffset);
    return withCurves(sources, grid,
                      *std::max_element(regions->begin(), regions->end(),
                                        [](const GridRegion &a, const GridRegion &b) {
                                            return area(a) < area(b);
                                        }));
}

Result<CurvedRegion> Grower::withCurves(const std::vector<SourceRing> &sources,
                                        const ClipGrid &grid, const GridRegion &region)
{
    std::vector<GridRing> rings{region.outer};
    for (const GridRing &hole : region.holes)
        if (playOf(grid.positions(hole)) >= kLeastPlay)
            rings.push_back(hole);
    Result<std::vector<RecoveredRing>> recovered = recoverCurves(sources, grid, rings);
    if (!recovered)
        return tl::unexpected(recovered.error());
    CurvedRegion result;
    for (RecoveredRing &ring : *recovered) {
        if (const double play = playOf(ring.chords); play < kLeastCurved) {
            if (auto chords = Contour::fromPolygon(ring.contour.polygon(play / 16.0)))
                ring.contour = std::move(*chords);
        }
        if (result.outer.segmentCount() == 0) {
            result.outer = std::move(ring.contour);
            result.region.outer = std::move(ring.chords);
        } else {
            result.holes.push_back(std::move(ring.contour));
            result.region.holes.push_back(std::move(ring.chords));
        }
    }
    return result;
}

void Grower::giveWay(const SweepFault &fault)
{
    if (fault.kind != SweepFault::Kind::NotReached || !makeRound(fault.at))
        refine(fault.at);
}

/// Where the disc fits by less than rounding, no mitre has to be in its way. Whether one was.
bool Grower::unmitre(const CurvedRegion &path)
{
    m_isUnmitred = true;
    bool wasCovered = false;
    for (const SweepFault &fault : placesLeft(m_region, path, m_distance))
        wasCovered = makeRound(fault.at) || wasCovered;
    return wasCovered;
}

/// Mitres that may cover the place. Whether there are any, or were.
bool Grower::makeRound(const Vec2 &at)
{
    bool isCovered = false;
    for (std::size_t i = 0; i < m_offsets.size(); ++i) {
        for (const RawOffset::Mitre &mitre : m_offsets[i].mitres) {
            if ((mitre.corner - at).norm() > kMitreLimit * m_distance + kSweepError)
                continue;
            m_styles[i].isRound[static_cast<std::size_t>(mitre.segment)] = 1;
            isCovered = true;
        }
    }
    return isCovered;
}

/// Chords in place of curves, or finer ones.
void Grower::refine(const Vec2 &at)
{
    const double reach = kMitreLimit * m_distance + kBesideFault;
    for (std::size_t i = 0; i < m_boundaries.size(); ++i) {
        for (int k = 0; k < m_boundaries[i]->segmentCount(); ++k) {
            Box2 box = boxOf(m_boundaries[i]->segment(k));
            box.min.array() -= reach;
            box.max.array() += reach;
            // As fine as everything else in the next attempt, so that no fault refines it twice.
            if (!box.contains(at))
                continue;
            m_styles[i].chords[static_cast<std::size_t>(k)] = kRefinement * m_chord;
            m_styles[i].arcChord = kRefinement * m_chord;
        }
    }
}

} // namespace

Result<CurvedRegion> grow(const CurvedRegion &region, double distance)
{
    if (distance < kLeastGrowth)
        return region;
    return Grower(region, distance).grown();
}

Result<CurvedRegion> growLoosely(const CurvedRegion &region, double distance)
{
    if (distance < kLeastGrowth)
        return region;
    const double error = std::min(kOffsetError, 0.1 * distance);
    CurvedRegion result;
    for (const Contour *boundary : boundariesOf(region)) {
        Result<RawOffset> offset = rawOffset(*boundary, distance, error);
        if (!offset)
            return tl::unexpected(offset.error());
        if (result.outer.segmentCount() == 0)
            result.outer = std::move(offset->contour);
        else if (offset->contour.signedArea() < 0.0)
            result.holes.push_back(std::move(offset->contour));
    }
    return result;
}

} // namespace fff
