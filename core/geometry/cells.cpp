#include "core/geometry/cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fff {

namespace {

/// So few vertices need not be cut up any more.
constexpr std::size_t kFewVertices = 32;
/// Nor what is so small, mm.
constexpr double kSmallCell = 2.0;
/// A line keeps so far away from all vertices, mm: what it cuts off a corner is no sliver.
constexpr double kClear = 0.01;
/// Lines lie on a grid, shifted by this share of its step: what people draw lies on round numbers.
constexpr double kShift = 0.137;
/// Of the area: what rounding of the crossings changes.
constexpr double kSameArea = 1e-9;

/// Part of a ring on one side of the line, from one crossing to the next.
struct Chain
{
    Polygon points; // with both crossings
    std::size_t from = 0, to = 0;
    bool isHigh = false;
};

struct Crossing
{
    double at = 0.0;         // along the line
    std::size_t partner = 0; // the region is between them
};

/// One line through a region.
class Split
{
public:
    Split(int axis, double at) : m_axis(axis), m_at(at) {}

    /// The regions on both sides; false when they could not be told.
    bool cut(const Region &region, std::vector<Region> &low, std::vector<Region> &high)
    {
        std::array<std::vector<Polygon>, 2> whole;
        for (const Polygon *ring : ringsOf(region))
            if (!addChains(*ring))
                whole[isHigh(ring->front()) ? 1 : 0].push_back(*ring);
        if (!pair())
            return false;
        const std::size_t firstLow = low.size(), firstHigh = high.size();
        if (!link(low, high))
            return false;
        return place(whole[0], low, firstLow) && place(whole[1], high, firstHigh);
    }

private:
    static std::vector<const Polygon *> ringsOf(const Region &region)
    {
        std::vector<const Polygon *> rings{&region.outer};
        for (const Polygon &hole : region.holes)
            rings.push_back(&hole);
        return rings;
    }

    bool isHigh(const Vec2 &p) const { return p[m_axis] > m_at; }

    std::size_t addCrossing(const Vec2 &a, const Vec2 &b, Vec2 &point)
    {
        // The same point whichever way the edge runs, since the next cell has it the other way.
        const bool isAFirst = isHigh(b);
        const Vec2 &p = isAFirst ? a : b, &q = isAFirst ? b : a;
        point = p + (m_at - p[m_axis]) / (q[m_axis] - p[m_axis]) * (q - p);
        point[m_axis] = m_at;
        m_crossings.push_back({point[1 - m_axis], 0});
        return m_crossings.size() - 1;
    }

    /// False when the ring lies on one side.
    bool addChains(const Polygon &ring)
    {
        const std::size_t count = ring.size();
        std::size_t first = 0; // the first vertex behind a crossing
        while (first < count && isHigh(ring[first]) == isHigh(ring[(first + count - 1) % count]))
            ++first;
        if (first == count)
            return false;
        Vec2 point;
        const std::size_t begin =
            addCrossing(ring[(first + count - 1) % count], ring[first], point);
        Chain chain{{point}, begin, 0, isHigh(ring[first])};
        const Vec2 last = point;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 &here = ring[(first + i) % count], &next = ring[(first + i + 1) % count];
            chain.points.push_back(here);
            if (isHigh(here) == isHigh(next))
                continue;
            const bool isClosed = i + 1 == count;
            point = last;
            chain.to = isClosed ? begin : addCrossing(here, next, point);
            chain.points.push_back(point);
            m_chains.push_back(std::move(chain));
            chain = {{point}, m_chains.back().to, 0, isHigh(next)};
        }
        return true;
    }

    /// The region lies between the first and the second crossing of the line, the third and the
    /// fourth, and so on.
    bool pair()
    {
        std::vector<std::size_t> order(m_crossings.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return m_crossings[a].at < m_crossings[b].at;
        });
        if (order.size() % 2 != 0)
            return false;
        for (std::size_t i = 0; i + 1 < order.size(); i += 2) {
            if (m_crossings[order[i]].at == m_crossings[order[i + 1]].at)
                return false;
            m_crossings[order[i]].partner = order[i + 1];
            m_crossings[order[i + 1]].partner = order[i];
        }
        return true;
    }

    bool link(std::vector<Region> &low, std::vector<Region> &high)
    {
        constexpr std::size_t kNone = static_cast<std::size_t>(-1);
        // On each side one chain begins at a crossing, or one ends there.
        std::array<std::vector<std::size_t>, 2> begins;
        for (auto &side : begins)
            side.assign(m_crossings.size(), kNone);
        for (std::size_t i = 0; i < m_chains.size(); ++i)
            begins[m_chains[i].isHigh ? 1 : 0][m_chains[i].from] = i;
        std::vector<char> isUsed(m_chains.size(), char(false));
        for (std::size_t i = 0; i < m_chains.size(); ++i) {
            if (isUsed[i])
                continue;
            Polygon loop;
            std::size_t next = i;
            do {
                isUsed[next] = true;
                const Chain &chain = m_chains[next];
                loop.insert(loop.end(), chain.points.begin(), chain.points.end());
                next = begins[chain.isHigh ? 1 : 0][m_crossings[chain.to].partner];
                if (next == kNone || (next != i && isUsed[next]))
                    return false;
            } while (next != i);
            if (!(signedArea(loop) > 0.0))
                return false;
            (m_chains[i].isHigh ? high : low).push_back({std::move(loop), {}});
        }
        return true;
    }

    /// Holes that the line passes by.
    static bool place(std::vector<Polygon> &holes, std::vector<Region> &regions, std::size_t first)
    {
        for (Polygon &hole : holes) {
            std::size_t in = first;
            while (in + 1 < regions.size() &&
                   locate(hole.front(), regions[in].outer) != Side::Inside)
                ++in;
            if (in >= regions.size())
                return false;
            regions[in].holes.push_back(std::move(hole));
        }
        return true;
    }

    int m_axis;
    double m_at;
    std::vector<Chain> m_chains;
    std::vector<Crossing> m_crossings;
};

std::size_t vertexCount(const Region &region)
{
    std::size_t count = region.outer.size();
    for (const Polygon &hole : region.holes)
        count += hole.size();
    return count;
}

/// Where a line across the axis cuts the region well, on a grid that its bounds give; nothing when
/// vertices are everywhere.
std::optional<double> lineAcross(const Region &region, int axis, double from, double to)
{
    const double step = std::exp2(std::floor(std::log2((to - from) / 8.0)));
    const double middle = 0.5 * (from + to), shift = kShift * step;
    std::vector<double> lines;
    for (double line = (std::ceil((from + 0.25 * (to - from)) / step)) * step + shift;
         line < to - 0.25 * (to - from); line += step)
        lines.push_back(line);
    std::vector<char> isFree(lines.size(), char(true));
    const auto look = [&](const Polygon &ring) {
        for (const Vec2 &p : ring)
            for (std::size_t i = 0; i < lines.size(); ++i)
                isFree[i] = isFree[i] && std::abs(p[axis] - lines[i]) > kClear;
    };
    look(region.outer);
    for (const Polygon &hole : region.holes)
        look(hole);
    std::optional<double> best;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (isFree[i] && (!best || std::abs(lines[i] - middle) < std::abs(*best - middle)))
            best = lines[i];
    return best;
}

void addCells(Region region, std::vector<Region> &cells)
{
    const Box2 box = bounds(region.outer);
    const int axis = box.size().x() >= box.size().y() ? 0 : 1;
    if (vertexCount(region) > kFewVertices && box.size()[axis] > kSmallCell) {
        const auto line = lineAcross(region, axis, box.min[axis], box.max[axis]);
        std::vector<Region> low, high;
        if (line && Split(axis, *line).cut(region, low, high)) {
            for (Region &cell : low)
                addCells(std::move(cell), cells);
            for (Region &cell : high)
                addCells(std::move(cell), cells);
            return;
        }
    }
    cells.push_back(std::move(region));
}

} // namespace

std::vector<Region> cellsOf(const Region &region)
{
    std::vector<Region> cells;
    addCells(region, cells);
    double sum = 0.0;
    for (const Region &cell : cells)
        sum += area(cell);
    const double whole = area(region);
    if (!(std::abs(sum - whole) <= kSameArea * whole))
        cells.clear();
    return cells;
}

Result<Triangulation> triangulateCells(const Region &region)
{
    Triangulation all;
    for (const Region &cell : cellsOf(region)) {
        const Result<Triangulation> own = triangulate(cell);
        if (!own || own->triangles.empty())
            return triangulate(region);
        const int first = static_cast<int>(all.points.size());
        all.points.insert(all.points.end(), own->points.begin(), own->points.end());
        for (const auto &t : own->triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    return all.triangles.empty() ? triangulate(region) : all;
}

} // namespace fff
