#include "core/templates/united_loops.h"

#include "core/geometry/boolean.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace fff {

namespace {

/// mm: as large as this all loops are for the union, whose grid is one of mm; a file may be in any
/// unit.
constexpr double kSizeOfCut = 250.0;
/// mm; of polygons nothing is flattened.
constexpr double kNoChord = 0.01;

class LoopUnion
{
public:
    LoopUnion(const std::vector<CutLoop> &loops, const Frame &frame) : m_frame(frame)
    {
        Box2 box;
        for (const CutLoop &loop : loops)
            for (const Vec3 &p : loop.points)
                box.extend(frame.toLocal(p));
        m_origin = box.isEmpty() ? Vec2::Zero() : box.center();
        m_scale = box.isEmpty() ? 0.0 : kSizeOfCut / box.size().maxCoeff();
        for (const CutLoop &loop : loops) {
            Polygon points;
            for (const Vec3 &p : loop.points)
                points.push_back(m_scale * (frame.toLocal(p) - m_origin));
            m_loops.push_back(std::move(points));
        }
    }

    bool isPossible() const { return std::isfinite(m_scale) && m_scale > 0.0; }
    bool isNeeded(const std::vector<CutLoop> &loops) const
    {
        return meetSomewhere() || isAnyInMaterial(loops);
    }
    std::optional<std::vector<CutLoop>> united() const;

private:
    std::vector<Contour> contours() const
    {
        std::vector<Contour> all;
        for (const Polygon &points : m_loops)
            all.push_back(Contour::ofPolygon(points));
        return all;
    }
    bool meetSomewhere() const
    {
        if (std::any_of(m_loops.begin(), m_loops.end(),
                        [](const Polygon &points) { return points.size() < 3; }))
            return true;
        std::vector<Contour> all = contours();
        const Contour first = std::move(all.front());
        all.erase(all.begin());
        return !isPlain(first, all, kNoChord);
    }
    /// They do not meet: where one point lies, there lies all of a loop.
    bool isAnyInMaterial(const std::vector<CutLoop> &loops) const
    {
        std::vector<Box2> boxes;
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const Vec2 &point = m_loops[i].front();
            int winding = 0;
            for (std::size_t k = 0; k < i; ++k) // the larger ones
                if (boxes[k].contains(point) && locate(point, m_loops[k]) == Side::Inside)
                    winding += loops[k].isHole ? -1 : 1;
            boxes.push_back(bounds(m_loops[i]));
            if (winding > (loops[i].isHole ? 1 : 0))
                return true;
        }
        return false;
    }
    CutLoop loopOf(const Polygon &points, bool isHole) const;

    const Frame &m_frame;
    Vec2 m_origin = Vec2::Zero();
    double m_scale = 0.0;
    std::vector<Polygon> m_loops;
};

CutLoop LoopUnion::loopOf(const Polygon &points, bool isHole) const
{
    CutLoop loop;
    loop.isHole = isHole;
    loop.isOriented = true;
    for (const Vec2 &p : points)
        loop.points.push_back(m_frame.toWorld(p / m_scale + m_origin));
    loop.area = std::abs(signedArea(points)) / (m_scale * m_scale);
    return loop;
}

std::optional<std::vector<CutLoop>> LoopUnion::united() const
{
    const Result<std::vector<CurvedRegion>> regions =
        windingRegions(contours(), WindingRule::NonZero, kNoChord);
    if (!regions || regions->empty())
        return std::nullopt; // chords there and back, say, which enclose nothing
    std::vector<CutLoop> all;
    for (const CurvedRegion &region : *regions) {
        all.push_back(loopOf(region.outer.polygon(kNoChord), false));
        for (const Contour &hole : region.holes)
            all.push_back(loopOf(hole.polygon(kNoChord), true));
    }
    return all;
}

} // namespace

void uniteLoops(std::vector<CutLoop> &loops, const Frame &frame)
{
    // What was guessed says little of what is inside: it would take away what is known.
    const auto bridged = std::stable_partition(loops.begin(), loops.end(),
                                               [](const CutLoop &loop) { return loop.isClosed(); });
    std::vector<CutLoop> closed(loops.begin(), bridged);
    // And a hole may be one in such a loop.
    const bool isKnown =
        bridged == loops.end() ||
        std::none_of(closed.begin(), closed.end(), [](const CutLoop &loop) { return loop.isHole; });
    if (!closed.empty() && isKnown) {
        const LoopUnion all(closed, frame);
        if (all.isPossible() && all.isNeeded(closed))
            if (std::optional<std::vector<CutLoop>> united = all.united())
                closed = *std::move(united);
    }
    closed.insert(closed.end(), std::make_move_iterator(bridged),
                  std::make_move_iterator(loops.end()));
    std::stable_sort(closed.begin(), closed.end(),
                     [](const CutLoop &a, const CutLoop &b) { return a.area > b.area; });
    loops = std::move(closed);
}

} // namespace fff
