#include "ui/view/slab_mesh.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace fff::ui {

namespace {

std::int8_t packed(double v)
{
    // Rounded; of a unit vector, so that it needs no care, and there are very many.
    return static_cast<std::int8_t>(127.0 * v + std::copysign(0.5, v));
}

PackedNormal packedNormal(const Vec2 &n, bool flag)
{
    return {packed(n.x()), packed(n.y()), 0, static_cast<std::int8_t>(flag ? 127 : 0)};
}

PackedNormal faceNormal(int side, bool flag)
{
    return {0, 0, static_cast<std::int8_t>(127 * side), static_cast<std::int8_t>(flag ? 127 : 0)};
}

std::array<float, 3> at(const Vec2 &p, int side)
{
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(side)};
}

/// Twice the area of a triangle of which nothing is seen, mm².
constexpr double kThinnest = 1e-8;

/// As it is uploaded.
Vec2 rounded(const Vec2 &p)
{
    return p.cast<float>().cast<double>();
}

/// The upper face, then the lower one.
void addFaces(SlabMesh &mesh, const Triangulation &triangulation)
{
    const auto upper = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto count = static_cast<std::uint32_t>(triangulation.points.size());
    for (const int side : {1, -1})
        for (const Vec2 &p : triangulation.points)
            mesh.vertices.push_back({at(p, side), faceNormal(side, false)});
    const std::size_t first = mesh.triangles.size();
    for (const auto &t : triangulation.triangles) {
        // After rounding to float a sliver may be a line; nothing of it would be seen.
        const Vec2 a = rounded(triangulation.points[t[0]]);
        if (!(cross(rounded(triangulation.points[t[1]]) - a,
                    rounded(triangulation.points[t[2]]) - a) > kThinnest))
            continue;
        for (const int i : t)
            mesh.triangles.push_back(upper + static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = first, end = mesh.triangles.size(); i < end; i += 3)
        for (const std::size_t k : {i, i + 2, i + 1})
            mesh.triangles.push_back(count + mesh.triangles[k]);
}

Polygon withoutRepeats(const Polygon &ring)
{
    Polygon points;
    points.reserve(ring.size());
    for (const Vec2 &p : ring) {
        if (points.empty() || points.back() != p)
            points.push_back(p);
    }
    while (points.size() > 1 && points.back() == points.front())
        points.pop_back();
    return points;
}

/// Positions along a wall that are hidden behind a cover: [from, to] of 0 … 1, and which one.
struct Hidden
{
    double from = 0.0, to = 0.0;
    std::size_t cover = 0;
};

/// A wall is one of a slit's when it lies on its border to this, mm.
constexpr double kOnSlit = 2e-3;

/// The part of the wall from a to b that a cover hides. Walls along a slit may be hidden in part,
/// the one at its inner end wholly.
std::optional<Hidden> partHidden(const Vec2 &a, const Vec2 &b, const SlitCover &cover,
                                 std::size_t index)
{
    const Vec2 side = perpendicular(cover.direction);
    const double fromAcross = side.dot(a - cover.inner);
    if (std::abs(fromAcross) > cover.halfWidth + kOnSlit)
        return {};
    const double toAcross = side.dot(b - cover.inner);
    const double from = cover.direction.dot(a - cover.inner);
    const double to = cover.direction.dot(b - cover.inner);
    if (std::abs(from) < kOnSlit && std::abs(to) < kOnSlit &&
        std::abs(toAcross) <= cover.halfWidth + kOnSlit)
        return Hidden{0.0, 1.0, index};
    const bool isAlong = std::abs(std::abs(fromAcross) - cover.halfWidth) < kOnSlit &&
                         std::abs(toAcross - fromAcross) < kOnSlit && from != to;
    if (!isAlong || std::min(from, to) < -kOnSlit || std::min(from, to) >= cover.length)
        return {};
    const double end = (cover.length - from) / (to - from); // of the cover, along the wall
    return to > from ? Hidden{0.0, std::min(end, 1.0), index}
                     : Hidden{std::max(end, 0.0), 1.0, index};
}

/// Finds covers by where they are: a wall that one hides has an end in its box.
class CoverFinder
{
public:
    explicit CoverFinder(std::span<const SlitCover> covers) : m_covers(covers)
    {
        for (std::size_t i = 0; i < covers.size(); ++i) {
            const SlitCover &cover = covers[i];
            const Vec2 end = cover.inner + cover.length * cover.direction;
            const double reach =
                kOnSlit + cover.halfWidth * std::abs(cover.direction.y()); // across, along x
            const double from = std::min(cover.inner.x(), end.x()) - reach - kOnSlit;
            const double to = std::max(cover.inner.x(), end.x()) + reach + kOnSlit;
            m_entries.push_back({from, to, i});
            m_widest = std::max(m_widest, to - from);
        }
        std::sort(m_entries.begin(), m_entries.end(),
                  [](const Entry &a, const Entry &b) { return a.from < b.from; });
    }

    std::optional<Hidden> hiddenPart(const Vec2 &a, const Vec2 &b)
    {
        for (const Vec2 &end : {a, b}) {
            const double x = end.x();
            goTo(x - m_widest);
            for (std::size_t i = m_near; i < m_entries.size() && m_entries[i].from <= x; ++i) {
                const Entry &entry = m_entries[i];
                if (entry.to < x)
                    continue;
                if (const auto hidden = partHidden(a, b, m_covers[entry.cover], entry.cover))
                    return hidden;
            }
        }
        return {};
    }

private:
    struct Entry
    {
        double from = 0.0, to = 0.0; // x
        std::size_t cover = 0;
    };

    /// To the first entry that starts there or behind: walls come one beside the other, so that it
    /// is mostly where the last one was.
    void goTo(double from)
    {
        while (m_near > 0 && m_entries[m_near - 1].from >= from)
            --m_near;
        while (m_near < m_entries.size() && m_entries[m_near].from < from)
            ++m_near;
    }

    std::span<const SlitCover> m_covers;
    std::vector<Entry> m_entries; // from left to right
    std::size_t m_near = 0;
    double m_widest = 0.0;
};

/// mm that lines may leave the boundary; so many of its points at most in one line.
constexpr double kLineError = 0.03;
constexpr std::size_t kLongestLine = 16;

constexpr std::size_t kQuadIndices = 6; // of its two triangles

class Walls
{
public:
    Walls(SlabMesh &mesh, std::span<const SlitCover> covers)
        : m_mesh(mesh), m_covers(covers), m_coverCount(covers.size())
    {
    }
    void add(const Polygon &ring);
    /// After all that is seen.
    void appendHidden()
    {
        std::vector<std::size_t> next(m_coverCount + 1, 0); // index of each cover
        for (const Quad &quad : m_hidden)
            next[quad.cover + 1] += kQuadIndices;
        next[0] = m_mesh.triangles.size();
        std::partial_sum(next.begin(), next.end(), next.begin());
        m_mesh.coverStarts = next;
        m_mesh.triangles.resize(next.back());
        for (const Quad &quad : m_hidden) {
            const auto corners = trianglesOf(quad.first);
            std::copy(corners.begin(), corners.end(),
                      m_mesh.triangles.begin() + static_cast<std::ptrdiff_t>(next[quad.cover]));
            next[quad.cover] += kQuadIndices;
        }
    }

private:
    void addEdges(const Polygon &points, const std::vector<Vec2> &normals,
                  const std::vector<char> &corner);
    /// The first of its vertices.
    std::uint32_t addQuad(const Vec2 &from, const Vec2 &to, const Vec2 &fromNormal,
                          const Vec2 &toNormal)
    {
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        const PackedNormal normalFrom = packedNormal(fromNormal, true);
        const PackedNormal normalTo = packedNormal(toNormal, true);
        m_mesh.vertices.push_back({at(from, -1), normalFrom});
        m_mesh.vertices.push_back({at(to, -1), normalTo});
        m_mesh.vertices.push_back({at(to, 1), normalTo});
        m_mesh.vertices.push_back({at(from, 1), normalFrom});
        return first;
    }
    static std::array<std::uint32_t, kQuadIndices> trianglesOf(std::uint32_t quad)
    {
        return {quad, quad + 1, quad + 2, quad, quad + 2, quad + 3};
    }
    void addTriangles(std::uint32_t quad)
    {
        const auto corners = trianglesOf(quad);
        m_mesh.triangles.insert(m_mesh.triangles.end(), corners.begin(), corners.end());
    }

    /// A wall that a cover hides.
    struct Quad
    {
        std::size_t cover = 0;
        std::uint32_t first = 0; // vertex
    };

    SlabMesh &m_mesh;
    CoverFinder m_covers;
    std::size_t m_coverCount;
    std::vector<Quad> m_hidden;
};

/// The walls along one ring. The material lies to its left (outer rings run counter-clockwise,
/// holes clockwise), so the wall of an edge looks to its right.
void Walls::add(const Polygon &ring)
{
    const Polygon points = withoutRepeats(ring);
    const std::size_t n = points.size();
    if (n < 3)
        return;

    std::vector<Vec2> normals(n); // of the edge from point i to the next
    for (std::size_t i = 0; i < n; ++i)
        normals[i] = -perpendicular(points[i + 1 < n ? i + 1 : 0] - points[i]).normalized();

    std::vector<char> corner(n);
    for (std::size_t i = 0; i < n; ++i)
        corner[i] = normals[i > 0 ? i - 1 : n - 1].dot(normals[i]) < std::cos(kCornerAngle);

    // Of two walls where the ring is smooth.
    const auto between = [&](std::size_t i) {
        return Vec2((normals[i > 0 ? i - 1 : n - 1] + normals[i]).normalized());
    };
    Vec2 fromBetween = corner[0] ? Vec2(Vec2::Zero()) : between(0);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = i + 1 < n ? i + 1 : 0;
        const Vec2 &from = points[i], &to = points[next], &own = normals[i];
        const Vec2 toBetween = corner[next] ? Vec2(Vec2::Zero()) : between(next);
        const Vec2 fromNormal = corner[i] ? own : fromBetween;
        const Vec2 toNormal = corner[next] ? own : toBetween;
        fromBetween = toBetween;

        // The very ends where it can be: neighbouring walls share them to the last digit.
        const auto quad = [&](double begin, double end) {
            return addQuad(begin > 0.0 ? Vec2(from + begin * (to - from)) : from,
                           end < 1.0 ? Vec2(from + end * (to - from)) : to,
                           begin > 0.0 ? own : fromNormal, end < 1.0 ? own : toNormal);
        };
        if (const std::optional<Hidden> hidden = m_covers.hiddenPart(from, to)) {
            if (hidden->from > 0.0)
                addTriangles(quad(0.0, hidden->from));
            if (hidden->to > hidden->from)
                m_hidden.push_back({hidden->cover, quad(hidden->from, hidden->to)});
            if (hidden->to < 1.0)
                addTriangles(quad(hidden->to, 1.0));
        } else {
            addTriangles(quad(0.0, 1.0));
        }
    }
    addEdges(points, normals, corner);
}

/// The lines of a ring, with fewer points than its walls: lines are looked at, and each costs four
/// points of work. They leave the ring by no more than kLineError and keep its corners.
void Walls::addEdges(const Polygon &points, const std::vector<Vec2> &normals,
                     const std::vector<char> &corner)
{
    const std::size_t n = points.size();
    const std::size_t first =
        static_cast<std::size_t>(std::find(corner.begin(), corner.end(), char(true)) -
                                 corner.begin()) %
        n;
    const auto isNear = [&](std::size_t from, std::size_t to) {
        const Vec2 &a = points[from % n], chord = points[to % n] - a;
        const double length = chord.norm();
        for (std::size_t i = from + 1; i < to; ++i) {
            const Vec2 d = points[i % n] - a;
            if (length < kLineError || std::abs(cross(chord, d)) > kLineError * length)
                return false;
        }
        return true;
    };
    Vec2 before = normals[(first + n - 1) % n];
    for (std::size_t begin = first; begin < first + n;) {
        std::size_t next = begin + 1;
        while (next < first + n && !corner[next % n] && next - begin < kLongestLine &&
               isNear(begin, next + 1))
            ++next;
        const Vec2 &from = points[begin % n], &to = points[next % n];
        const Vec2 own =
            next == begin + 1 ? normals[begin % n] : Vec2(-perpendicular(to - from).normalized());
        m_mesh.edges.push_back(
            {at(from, 1), at(to, 1), faceNormal(1, true), packedNormal(own, false)});
        m_mesh.edges.push_back(
            {at(from, -1), at(to, -1), faceNormal(-1, true), packedNormal(own, false)});
        m_mesh.edges.push_back({at(from, -1), at(from, 1), packedNormal(before, corner[begin % n]),
                                packedNormal(own, false)});
        before = own;
        begin = next;
    }
}

/// For all of it at once: there are thousands of slabs.
void reserveFor(std::span<const Region> regions, std::span<const Triangulation> triangulations,
                std::size_t covers, SlabMesh &mesh)
{
    std::size_t walls = 0, points = 0, triangles = 0;
    for (const Region &region : regions) {
        walls += region.outer.size();
        for (const Polygon &hole : region.holes)
            walls += hole.size();
    }
    for (const Triangulation &triangulation : triangulations) {
        points += triangulation.points.size();
        triangles += triangulation.triangles.size();
    }
    // A cover may divide two walls.
    mesh.vertices.reserve(2 * points + 4 * walls + 8 * covers);
    mesh.triangles.reserve(kQuadIndices * (triangles + walls + 2 * covers));
    mesh.edges.reserve(3 * walls);
}

} // namespace

SlabMesh buildSlab(std::span<const Region> regions, std::span<const Triangulation> triangulations,
                   std::span<const SlitCover> covers)
{
    SlabMesh mesh;
    reserveFor(regions, triangulations, covers.size(), mesh);
    for (const Triangulation &triangulation : triangulations)
        addFaces(mesh, triangulation);
    Walls walls(mesh, covers);
    for (const Region &region : regions) {
        walls.add(region.outer);
        for (const Polygon &hole : region.holes)
            walls.add(hole);
    }
    walls.appendHidden();
    return mesh;
}

} // namespace fff::ui
