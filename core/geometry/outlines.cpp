#include "core/geometry/outlines.h"

#include "core/geometry/boolean.h"
#include "core/geometry/ring_nesting.h"
#include "core/geometry/tangle.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

namespace fff {

namespace {

/// Joins open lines at their ends, which it finds by a grid of cells as wide as the gap.
class Joiner
{
public:
    Joiner(std::vector<CurvePath> lines, double gap) : m_gap(gap)
    {
        for (CurvePath &line : lines)
            m_lines.push_back(line.points());
        for (std::size_t i = 0; i < m_lines.size(); ++i)
            if (isOpen(i))
                for (const bool isLast : {false, true})
                    m_ends[cellOf(end({i, isLast}))].push_back({i, isLast});
    }

    std::vector<CurvePath> join()
    {
        for (std::size_t i = 0; i < m_lines.size(); ++i) {
            if (!isOpen(i))
                continue;
            m_growing.assign(m_lines[i].begin(), m_lines[i].end());
            m_grown = i;
            while (isOpen(i) && (extend(i, true) || extend(i, false)))
                ;
            m_grown = kNone;
            m_lines[i].assign(m_growing.begin(), m_growing.end());
        }
        std::vector<CurvePath> result;
        for (std::vector<Vec2> &points : m_lines)
            if (Result<CurvePath> path = CurvePath::fromPoints(std::move(points)))
                result.push_back(*std::move(path));
        return result;
    }

private:
    struct End
    {
        std::size_t line = 0;
        bool isLast = false;
        bool operator==(const End &) const = default;
    };
    using Cell = std::pair<std::int64_t, std::int64_t>;

    bool isOpen(std::size_t i) const
    {
        return (i == m_grown || !m_lines[i].empty()) && end({i, false}) != end({i, true});
    }
    const Vec2 &end(const End &e) const
    {
        if (e.line == m_grown)
            return e.isLast ? m_growing.back() : m_growing.front();
        return e.isLast ? m_lines[e.line].back() : m_lines[e.line].front();
    }
    Cell cellOf(const Vec2 &p) const
    {
        return {static_cast<std::int64_t>(std::floor(p.x() / m_gap)),
                static_cast<std::int64_t>(std::floor(p.y() / m_gap))};
    }
    /// The one other end that is near; nothing for none, or for several.
    std::optional<End> near(const End &of) const
    {
        std::optional<End> found;
        const Vec2 &p = end(of);
        const Cell cell = cellOf(p);
        for (std::int64_t x = cell.first - 1; x <= cell.first + 1; ++x)
            for (std::int64_t y = cell.second - 1; y <= cell.second + 1; ++y)
                if (const auto it = m_ends.find({x, y}); it != m_ends.end())
                    for (const End &e : it->second) {
                        if (e == of || (end(e) - p).norm() > m_gap)
                            continue;
                        if (found)
                            return std::nullopt;
                        found = e;
                    }
        return found;
    }
    void forget(const End &e) { std::erase(m_ends[cellOf(end(e))], e); }

    /// By what begins at this end of the line, if that is one thing.
    bool extend(std::size_t i, bool isLast)
    {
        const End here{i, isLast};
        const std::optional<End> found = near(here);
        if (!found)
            return false;
        const End other = *found;
        forget(here);
        forget(other);
        if (other.line == i) { // its own other end
            m_growing.back() = m_growing.front();
            return false;
        }
        const End far{other.line, !other.isLast};
        forget(far);
        std::vector<Vec2> more = std::exchange(m_lines[other.line], {});
        if (other.isLast == isLast)
            std::reverse(more.begin(), more.end());
        if (isLast) {
            m_growing.insert(m_growing.end(), more.begin() + 1, more.end());
        } else {
            m_growing.pop_front();
            m_growing.insert(m_growing.begin(), more.begin(), more.end());
        }
        m_ends[cellOf(end(here))].push_back(here);
        return true;
    }

    static constexpr auto kNone = static_cast<std::size_t>(-1);

    double m_gap;
    std::vector<std::vector<Vec2>> m_lines;
    std::size_t m_grown = kNone;             // the line that is being joined, whose points are in:
    std::deque<Vec2> m_growing;              // both ends grow for what is added to them
    std::map<Cell, std::vector<End>> m_ends; // of open lines
};

struct Ring
{
    Contour contour; // counter-clockwise
    double area = 0.0;
};

std::size_t hashOf(const Contour &contour)
{
    constexpr std::size_t kSpread = 0x9e3779b97f4a7c15ull;
    std::size_t hash = contour.points().size();
    for (const Vec2 &p : contour.points())
        for (const double value : {p.x(), p.y()})
            hash = (hash ^ std::hash<double>()(value)) * kSpread + (hash >> 29);
    return hash;
}

/// What closed lines wind round, each once, largest first.
Result<std::vector<Contour>> ringsOf(const std::vector<CurvePath> &lines)
{
    std::vector<Ring> rings;
    std::unordered_multimap<std::size_t, std::size_t> known; // by hash
    for (const CurvePath &line : lines) {
        if (!line.isClosed())
            continue;
        const Result<Contour> contour = line.ring();
        if (!contour)
            return tl::unexpected(contour.error());
        if (crossingWork(*contour) > kMostCrossingWork)
            continue;
        const Result<ResolvedContour> whole = resolveCrossings(*contour);
        if (!whole && whole.error().code == ErrorCode::EmptyContour)
            continue;
        if (!whole)
            return tl::unexpected(whole.error());
        const double area = whole->contour.signedArea();
        Ring ring{area < 0.0 ? whole->contour.reversed() : whole->contour, std::abs(area)};
        const std::size_t hash = hashOf(ring.contour);
        const auto [from, to] = known.equal_range(hash);
        if (std::any_of(from, to, [&](const auto &item) {
                return rings[item.second].contour == ring.contour;
            }))
            continue;
        known.emplace(hash, rings.size());
        rings.push_back(std::move(ring));
    }
    std::stable_sort(rings.begin(), rings.end(),
                     [](const Ring &a, const Ring &b) { return a.area > b.area; });
    std::vector<Contour> contours;
    contours.reserve(rings.size());
    for (Ring &ring : rings)
        contours.push_back(std::move(ring.contour));
    return contours;
}

} // namespace

std::vector<CurvePath> joined(std::vector<CurvePath> lines, double gap)
{
    return Joiner(std::move(lines), gap).join();
}

double largestTangle(const std::vector<CurvePath> &lines)
{
    double most = 0.0;
    for (const CurvePath &line : lines) {
        if (!line.isClosed())
            continue;
        if (const Result<Contour> contour = line.ring())
            most = std::max(most, crossingWork(*contour));
    }
    return most;
}

Result<std::vector<Outline>> outlinesOf(const std::vector<CurvePath> &lines)
{
    const Result<std::vector<Contour>> found = ringsOf(lines);
    if (!found)
        return tl::unexpected(found.error());
    const std::vector<Contour> &rings = *found;
    const std::vector<int> around = ringsAround(rings);
    std::vector<Outline> outlines;
    std::vector<std::size_t> places(rings.size()); // of outer rings, in the outlines
    std::vector<bool> areHoles(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const auto outer = static_cast<std::size_t>(around[i]);
        areHoles[i] = around[i] >= 0 && !areHoles[outer];
        if (areHoles[i]) {
            outlines[places[outer]].holes.push_back(rings[i].reversed());
        } else {
            places[i] = outlines.size();
            outlines.push_back({rings[i], {}, around[i] >= 0});
        }
    }
    return outlines;
}

} // namespace fff
