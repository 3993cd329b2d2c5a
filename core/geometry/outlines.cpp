#include "core/geometry/outlines.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"

#include <algorithm>
#include <cmath>
#include <map>
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
        for (std::size_t i = 0; i < m_lines.size(); ++i)
            while (isOpen(i) && (extend(i, true) || extend(i, false)))
                ;
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
        return !m_lines[i].empty() && m_lines[i].front() != m_lines[i].back();
    }
    const Vec2 &end(const End &e) const
    {
        return e.isLast ? m_lines[e.line].back() : m_lines[e.line].front();
    }
    Cell cellOf(const Vec2 &p) const
    {
        return {static_cast<std::int64_t>(std::floor(p.x() / m_gap)),
                static_cast<std::int64_t>(std::floor(p.y() / m_gap))};
    }
    std::vector<End> near(const End &of) const
    {
        std::vector<End> found;
        const Vec2 &p = end(of);
        const Cell cell = cellOf(p);
        for (std::int64_t x = cell.first - 1; x <= cell.first + 1; ++x)
            for (std::int64_t y = cell.second - 1; y <= cell.second + 1; ++y)
                if (const auto it = m_ends.find({x, y}); it != m_ends.end())
                    for (const End &e : it->second)
                        if (!(e == of) && (end(e) - p).norm() <= m_gap)
                            found.push_back(e);
        return found;
    }
    void forget(const End &e) { std::erase(m_ends[cellOf(end(e))], e); }

    /// By what begins at this end of the line, if that is one thing.
    bool extend(std::size_t i, bool isLast)
    {
        const End here{i, isLast};
        const std::vector<End> others = near(here);
        if (others.size() != 1)
            return false;
        const End other = others.front();
        forget(here);
        forget(other);
        if (other.line == i) { // its own other end
            m_lines[i].back() = m_lines[i].front();
            return false;
        }
        const End far{other.line, !other.isLast};
        forget(far);
        std::vector<Vec2> more = std::exchange(m_lines[other.line], {});
        if (other.isLast == isLast)
            std::reverse(more.begin(), more.end());
        std::vector<Vec2> &points = m_lines[i];
        if (isLast) {
            points.insert(points.end(), more.begin() + 1, more.end());
        } else {
            more.insert(more.end(), points.begin() + 1, points.end());
            points = std::move(more);
        }
        m_ends[cellOf(end(here))].push_back(here);
        return true;
    }

    double m_gap;
    std::vector<std::vector<Vec2>> m_lines;
    std::map<Cell, std::vector<End>> m_ends; // of open lines
};

struct Ring
{
    Contour contour;
    Box2 box;
    double area = 0.0;
    int around = -1; // index of the smallest ring that it lies in
    bool isHole = false;
};

bool isIn(const Ring &inner, const Ring &outer)
{
    const bool canBe = (inner.box.min.array() >= outer.box.min.array()).all() &&
                       (inner.box.max.array() <= outer.box.max.array()).all();
    if (!canBe)
        return false;
    switch (nesting(inner.contour, outer.contour, kCutChord)) {
    case Nesting::FirstInside:
        return true;
    case Nesting::Meeting: {
        // Where they touch, the most of it says where it lies.
        const Polygon corners = inner.contour.polygon(kCutChord),
                      ring = outer.contour.polygon(kCutChord);
        const auto inside = std::count_if(corners.begin(), corners.end(), [&ring](const Vec2 &p) {
            return locate(p, ring) != Side::Outside;
        });
        return 2 * inside > std::ssize(corners);
    }
    default:
        return false;
    }
}

std::vector<Ring> ringsOf(const std::vector<CurvePath> &lines)
{
    std::vector<Ring> rings;
    for (const CurvePath &line : lines) {
        if (!line.isClosed())
            continue;
        std::vector<Vec2> points = line.points();
        points.pop_back();
        const Result<Contour> contour = Contour::fromPoints(std::move(points));
        const Result<ResolvedContour> whole =
            contour ? resolveCrossings(*contour) : Result<ResolvedContour>(ResolvedContour{});
        if (!contour || !whole)
            continue;
        const double area = whole->contour.signedArea();
        Ring ring{area < 0.0 ? whole->contour.reversed() : whole->contour, {}, std::abs(area)};
        ring.box = ring.contour.bounds();
        const bool isRepeated = std::any_of(rings.begin(), rings.end(), [&ring](const Ring &other) {
            return other.contour == ring.contour;
        });
        if (!isRepeated)
            rings.push_back(std::move(ring));
    }
    std::stable_sort(rings.begin(), rings.end(),
                     [](const Ring &a, const Ring &b) { return a.area > b.area; });
    return rings;
}

} // namespace

std::vector<CurvePath> joined(std::vector<CurvePath> lines, double gap)
{
    return Joiner(std::move(lines), gap).join();
}

std::vector<Outline> outlinesOf(const std::vector<CurvePath> &lines)
{
    std::vector<Ring> rings = ringsOf(lines);
    std::vector<Outline> outlines;
    std::vector<std::size_t> places(rings.size()); // of outer rings, in the outlines
    for (std::size_t i = 0; i < rings.size(); ++i) {
        Ring &ring = rings[i];
        for (std::size_t j = 0; j < i; ++j) {
            if (!isIn(ring, rings[j]))
                continue;
            ring.around = static_cast<int>(j); // smaller ones come later
        }
        ring.isHole = ring.around >= 0 && !rings[static_cast<std::size_t>(ring.around)].isHole;
        if (!ring.isHole) {
            places[i] = outlines.size();
            outlines.push_back({ring.contour, {}});
        } else {
            outlines[places[static_cast<std::size_t>(ring.around)]].holes.push_back(
                ring.contour.reversed());
        }
    }
    return outlines;
}

} // namespace fff
