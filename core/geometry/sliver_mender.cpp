#include "core/geometry/sliver_mender.h"

#include "core/geometry/side_of_line.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>

namespace fff {

namespace {

/// Triangles lower than this are slivers, mm: what is drawn is in floats, which are this fine over
/// a metre.
constexpr double kSliver = 1e-4;

class SliverMender
{
public:
    explicit SliverMender(Triangulation &triangulation) : m_all(triangulation) {}
    bool run();

private:
    using Triangle = std::array<int, 3>;

    /// Where it stands in `triangles`.
    struct Sliver
    {
        std::size_t at = 0, edge = 0; // its longest: from the corner of that number to the next
    };
    const Vec2 &point(int vertex) const { return m_all.points[static_cast<std::size_t>(vertex)]; }
    std::optional<Sliver> sliverAt(std::size_t at) const;
    static std::uint64_t key(int from, int to)
    {
        return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
    }
    void put(std::size_t at, const Triangle &triangle)
    {
        m_all.triangles[at] = triangle;
        for (std::size_t i = 0; i < 3; ++i)
            m_leftOf[key(triangle[i], triangle[(i + 1) % 3])] = at;
    }
    void turnOver(const Sliver &sliver);

    Triangulation &m_all;
    std::unordered_map<std::uint64_t, std::size_t> m_leftOf; // the triangle to the left of an edge
    std::vector<std::size_t> m_waiting;
};

std::optional<SliverMender::Sliver> SliverMender::sliverAt(std::size_t at) const
{
    const Triangle &t = m_all.triangles[at];
    const Vec2 &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
    const std::array<double, 3> squared{(b - a).squaredNorm(), (c - b).squaredNorm(),
                                        (a - c).squaredNorm()};
    const auto longest = std::max_element(squared.begin(), squared.end());
    const double twice = cross(b - a, c - a);
    if (twice * twice > kSliver * kSliver * *longest)
        return std::nullopt;
    return Sliver{at, static_cast<std::size_t>(longest - squared.begin())};
}

void SliverMender::turnOver(const Sliver &sliver)
{
    const Triangle &t = m_all.triangles[sliver.at];
    const int i = t[sliver.edge], j = t[(sliver.edge + 1) % 3], b = t[(sliver.edge + 2) % 3];
    const auto found = m_leftOf.find(key(j, i));
    if (found == m_leftOf.end())
        return; // the boundary
    const std::size_t other = found->second;
    const Triangle &u = m_all.triangles[other];
    const int d = u[0] != i && u[0] != j ? u[0] : u[1] != i && u[1] != j ? u[1] : u[2];
    if (!(sideOfLine(point(i), point(d), point(b)) > 0.0) ||
        !(sideOfLine(point(d), point(j), point(b)) > 0.0))
        return;
    m_leftOf.erase(found);
    m_leftOf.erase(key(i, j));
    put(sliver.at, {i, d, b});
    put(other, {d, j, b});
    m_waiting.insert(m_waiting.end(), {sliver.at, other});
}

bool SliverMender::run()
{
    for (std::size_t i = 0; i < m_all.triangles.size(); ++i)
        if (sliverAt(i))
            m_waiting.push_back(i);
    if (m_waiting.empty())
        return true;
    for (std::size_t i = 0; i < m_all.triangles.size(); ++i)
        put(i, m_all.triangles[i]);
    // Every turn makes the longest edges shorter; many more than edges are rounding.
    std::size_t left = 8 * m_all.triangles.size();
    while (!m_waiting.empty() && left-- > 0) {
        const std::size_t at = m_waiting.back();
        m_waiting.pop_back();
        if (const auto sliver = sliverAt(at))
            turnOver(*sliver);
    }
    return m_waiting.empty();
}

} // namespace

bool mendSlivers(Triangulation &triangulation)
{
    return SliverMender(triangulation).run();
}

} // namespace fff
