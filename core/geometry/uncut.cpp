#include "core/geometry/uncut.h"

#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"

#include <algorithm>

namespace fff {

namespace {

std::vector<Polygon> ringsOf(const CurvedRegion &region)
{
    std::vector<Polygon> rings{region.outer.polygon(kDrawChord)};
    for (const Contour &hole : region.holes)
        rings.push_back(hole.polygon(kDrawChord));
    return rings;
}

struct Edges
{
    explicit Edges(const std::vector<Polygon> &rings)
    {
        for (const Polygon &ring : rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
                ends.push_back({ring[j], ring[i]});
        boxes.fill(ends.size(), [this](std::size_t i) { return boxOf(ends[i]); });
    }

    static Box2 boxOf(const std::pair<Vec2, Vec2> &edge)
    {
        return {edge.first.cwiseMin(edge.second), edge.first.cwiseMax(edge.second)};
    }

    bool isNear(const Vec2 &p, double reach) const
    {
        const Box2 around{p.array() - reach, p.array() + reach};
        return boxes.any([&](const Box2 &run) { return run.intersects(around); },
                         [&](std::size_t i) {
                             const auto &[from, to] = ends[i];
                             const Vec2 way = to - from;
                             const double squared = way.squaredNorm();
                             const double share =
                                 squared > 0.0 ? std::clamp(way.dot(p - from) / squared, 0.0, 1.0)
                                               : 0.0;
                             return (from + share * way - p).norm() <= reach;
                         });
    }

    std::vector<std::pair<Vec2, Vec2>> ends;
    BoxRuns boxes;
};

} // namespace

bool comesEverywhere(const CurvedRegion &part, const CurvedRegion &path, double reach)
{
    const std::vector<Polygon> ofPart = ringsOf(part), ofPath = ringsOf(path);
    const Edges edges(ofPath);
    for (const Polygon &ring : ofPart)
        for (const Vec2 &corner : ring)
            if (!edges.isNear(corner, reach))
                return false;
    return std::all_of(ofPart.begin() + 1, ofPart.end(), [&](const Polygon &hole) {
        return std::any_of(ofPath.begin() + 1, ofPath.end(), [&](const Polygon &ring) {
            return locate(ring.front(), hole) == Side::Inside;
        });
    });
}

} // namespace fff
