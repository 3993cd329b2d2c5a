#include "core/templates/united_loops.h"

#include "core/geometry/boolean.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
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
            for (const CutLoop::Bridge &bridge : loop.bridges)
                for (std::size_t k = 0; k <= bridge.chords; ++k)
                    m_bridged.insert(placeOf(points[(bridge.from + k) % points.size()]));
            m_loops.push_back(std::move(points));
        }
    }

    bool isPossible() const { return std::isfinite(m_scale) && m_scale > 0.0; }
    bool isNeeded(const std::vector<CutLoop> &loops) const
    {
        // Where guesses meet they say nothing of what is inside, and would take away what is known.
        std::vector<Polygon> guessed;
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (!loops[i].isClosed())
                guessed.push_back(m_loops[i]);
        return !meetSomewhere(guessed) && (meetSomewhere(m_loops) || isAnyInMaterial(loops));
    }
    std::optional<std::vector<CutLoop>> united() const;

private:
    static std::vector<Contour> contours(const std::vector<Polygon> &loops)
    {
        std::vector<Contour> all;
        for (const Polygon &points : loops)
            all.push_back(Contour::ofPolygon(points));
        return all;
    }
    static bool meetSomewhere(const std::vector<Polygon> &loops)
    {
        if (std::any_of(loops.begin(), loops.end(),
                        [](const Polygon &points) { return points.size() < 3; }))
            return true;
        if (loops.empty())
            return false;
        std::vector<Contour> all = contours(loops);
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
            if (winding != (loops[i].isHole ? 1 : 0))
                return true;
        }
        return false;
    }
    CutLoop loopOf(const Polygon &points, bool isHole) const;

    using Place = std::pair<double, double>;
    static Place placeOf(const Vec2 &p) { return {p.x(), p.y()}; }

    const Frame &m_frame;
    Vec2 m_origin = Vec2::Zero();
    double m_scale = 0.0;
    std::vector<Polygon> m_loops;
    std::set<Place> m_bridged; // points between which bridges run
};

CutLoop LoopUnion::loopOf(const Polygon &points, bool isHole) const
{
    CutLoop loop;
    loop.isHole = isHole;
    loop.isOriented = true;
    for (const Vec2 &p : points)
        loop.points.push_back(m_frame.toWorld(p / m_scale + m_origin));
    loop.area = std::abs(signedArea(points)) / (m_scale * m_scale);
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (!m_bridged.contains(placeOf(points[i])) ||
            !m_bridged.contains(placeOf(points[(i + 1) % count])))
            continue;
        if (!loop.bridges.empty() && loop.bridges.back().from + loop.bridges.back().chords == i)
            ++loop.bridges.back().chords;
        else
            loop.bridges.push_back({i, 1});
    }
    return loop;
}

std::optional<std::vector<CutLoop>> LoopUnion::united() const
{
    const Result<std::vector<CurvedRegion>> regions =
        windingRegions(contours(m_loops), WindingRule::NonZero, kNoChord);
    if (!regions || regions->empty())
        return std::nullopt; // chords there and back, say, which enclose nothing
    std::vector<CutLoop> all;
    for (const CurvedRegion &region : *regions) {
        all.push_back(loopOf(region.outer.polygon(kNoChord), false));
        for (const Contour &hole : region.holes)
            all.push_back(loopOf(hole.polygon(kNoChord), true));
    }
    std::stable_sort(all.begin(), all.end(),
                     [](const CutLoop &a, const CutLoop &b) { return a.area > b.area; });
    return all;
}

} // namespace

void uniteLoops(std::vector<CutLoop> &loops, const Frame &frame)
{
    if (loops.empty())
        return;
    const LoopUnion both(loops, frame);
    if (!both.isPossible() || !both.isNeeded(loops))
        return;
    if (std::optional<std::vector<CutLoop>> united = both.united())
        loops = *std::move(united);
}

} // namespace fff
