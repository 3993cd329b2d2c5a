#include "core/geometry/tangle.h"

#include "core/base/tolerances.h"
#include "core/geometry/clip_grid.h"
#include "core/geometry/simple_ring.h"

#include <algorithm>

namespace fff {

namespace {

/// Of a sweep along this axis, which stops wherever an edge begins or ends.
double workAlong(const Polygon &corners, int axis)
{
    std::vector<double> stops;
    stops.reserve(corners.size());
    for (const Vec2 &corner : corners)
        stops.push_back(corner[axis]);
    std::sort(stops.begin(), stops.end());
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    const auto rankOf = [&stops](double stop) {
        return static_cast<double>(std::lower_bound(stops.begin(), stops.end(), stop) -
                                   stops.begin());
    };
    double work = 0.0;
    double before = rankOf(corners.back()[axis]);
    for (const Vec2 &corner : corners) {
        const double rank = rankOf(corner[axis]);
        work += std::abs(rank - before);
        before = rank;
    }
    return work;
}

} // namespace

double crossingWork(const Contour &contour)
{
    const Polygon corners = contour.polygon(kCutChord);
    const auto count = static_cast<double>(corners.size());
    if (corners.size() < 3 || count * count <= kMostCrossingWork)
        return count * count;
    // Which of the two ways is looked for crossings, whichever is less; they are taken apart
    // upwards.
    const double upwards = workAlong(corners, 1), least = std::min(workAlong(corners, 0), upwards);
    // Looking is that much cheaper than taking apart.
    if (least > 40.0 * kMostCrossingWork)
        return least;
    const ClipGrid grid(bounds(corners));
    GridRing ring;
    for (const Vec2 &corner : corners)
        if (const GridPoint point = grid.snap(corner); ring.empty() || ring.back() != point)
            ring.push_back(point);
    return isSimple(ring) ? 0.0 : upwards;
}

} // namespace fff
