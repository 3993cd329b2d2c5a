#include "core/skin/coons_patch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr int kLeastRows = 4, kMostRows = 40;
/// Shares of a side that differ by rounding alone are the same.
constexpr double kSameShare = 1e-9;

/// Cubic Hermite weights of both ends and of the derivatives there.
struct Weights
{
    explicit Weights(double t)
        : start((1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t)), end(t * t * (3.0 - 2.0 * t)),
          leave(t * (1.0 - t) * (1.0 - t)), come(-t * t * (1.0 - t))
    {
    }
    double start, end, leave, come;
};

Vec3 mixed(const Weights &w, const Vec3 &start, const Vec3 &end, const Vec3 &leave,
           const Vec3 &come)
{
    return w.start * start + w.end * end + w.leave * leave + w.come * come;
}

/// How the patch leads across two opposite sides, from the one to the other.
class Across
{
public:
    /// first, last: the sides; before, after: those that lead from the one to the other at their
    /// starts and ends
    Across(const SkinCurve &first, const SkinCurve &last, const SkinCurve &before,
           const SkinCurve &after)
        : m_first(first), m_last(last), m_before(before.startDirection() * before.length()),
          m_after(after.startDirection() * after.length()),
          m_beforeEnd(-before.reversed().startDirection() * before.length()),
          m_afterEnd(-after.reversed().startDirection() * after.length())
    {
    }

    Vec3 leave(double s) const { return along(m_first, m_before, m_after, s); }
    Vec3 come(double s) const { return along(m_last, m_beforeEnd, m_afterEnd, s); }
    Vec3 at(double s, const Weights &w) const
    {
        return mixed(w, m_first.pointAt(s), m_last.pointAt(s), leave(s), come(s));
    }

private:
    /// In the skin's plane there, no faster than half a circle across.
    Vec3 along(const SkinCurve &side, const Vec3 &start, const Vec3 &end, double s) const
    {
        Vec3 way = (1.0 - s) * start + s * end;
        const Vec3 normal = side.normalAt(s);
        const double speed = way.norm();
        way -= normal.dot(way) * normal;
        const double flat = way.norm();
        const double most =
            arcSpeed(std::numbers::pi) * (m_last.pointAt(s) - m_first.pointAt(s)).norm();
        return flat > 0.0 ? Vec3(std::min(speed, most) / flat * way) : way;
    }

    const SkinCurve &m_first, &m_last;
    Vec3 m_before, m_after, m_beforeEnd, m_afterEnd;
};

class CoonsSurface
{
public:
    explicit CoonsSurface(const PatchSides &s)
        : m_up(s.south, s.north, s.west, s.east), m_right(s.west, s.east, s.south, s.north)
    {
        const std::array<double, 2> ends{0.0, 1.0};
        for (std::size_t i = 0; i < 2; ++i) {
            m_corners[0][i] = s.south.pointAt(ends[i]);
            m_corners[1][i] = s.north.pointAt(ends[i]);
            m_upwards[0][i] = m_up.leave(ends[i]);
            m_upwards[1][i] = m_up.come(ends[i]);
            m_rightwards[i][0] = m_right.leave(ends[i]);
            m_rightwards[i][1] = m_right.come(ends[i]);
        }
    }

    Vec3 operator()(double u, double v) const
    {
        const Weights across(u), up(v);
        return m_up.at(u, up) + m_right.at(v, across) - corners(across, up);
    }

private:
    /// What both have in common.
    Vec3 corners(const Weights &across, const Weights &up) const
    {
        std::array<Vec3, 2> rows, leads;
        for (std::size_t row = 0; row < 2; ++row) {
            rows[row] = mixed(across, m_corners[row][0], m_corners[row][1], m_rightwards[row][0],
                              m_rightwards[row][1]);
            leads[row] = across.start * m_upwards[row][0] + across.end * m_upwards[row][1];
        }
        return mixed(up, rows[0], rows[1], leads[0], leads[1]);
    }

    Across m_up, m_right;
    std::array<std::array<Vec3, 2>, 2> m_corners, m_upwards, m_rightwards; // [row][column]
};

/// Arcs between two curves.
class LuneSurface
{
public:
    LuneSurface(const SkinCurve &south, const SkinCurve &north) : m_south(south), m_north(north) {}

    Vec3 operator()(double u, double v) const
    {
        const Vec3 from = m_south.pointAt(u), to = m_north.pointAt(u);
        const Vec3 leave = inwards(m_south, u), come = inwards(m_north, u);
        const double angle = std::acos(std::clamp(leave.dot(come), -1.0, 1.0));
        const double speed = arcSpeed(angle) * (to - from).norm();
        return mixed(Weights(v), from, to, speed * leave, speed * come);
    }

private:
    static Vec3 inwards(const SkinCurve &side, double u)
    {
        const double step = 0.02;
        const Vec3 way =
            side.pointAt(std::min(u + step, 1.0)) - side.pointAt(std::max(u - step, 0.0));
        return side.normalAt(u).cross(way).normalized();
    }
    const SkinCurve &m_south, &m_north;
};

/// Triangles between two chains of vertices that run the same way, the first to the right of the
/// second; where each of them is told by a share.
struct Chain
{
    std::vector<std::uint32_t> vertices;
    std::vector<double> at;
};

void zip(GrowingMesh &mesh, const Chain &right, const Chain &left)
{
    std::size_t r = 0, l = 0;
    while (r + 1 < right.vertices.size() || l + 1 < left.vertices.size()) {
        const bool isRight =
            l + 1 >= left.vertices.size() ||
            (r + 1 < right.vertices.size() && right.at[r + 1] <= left.at[l + 1] + kSameShare);
        if (isRight) {
            mesh.face(right.vertices[r], right.vertices[r + 1], left.vertices[l]);
            ++r;
        } else {
            mesh.face(right.vertices[r], left.vertices[l + 1], left.vertices[l]);
            ++l;
        }
    }
}

int rowsFor(const SkinCurve &a, const SkinCurve &b)
{
    const std::size_t most = std::max(a.points.size(), b.points.size()) - 1;
    return static_cast<int>(std::clamp<std::size_t>(most, kLeastRows, kMostRows));
}

/// A grid inside, whose rim is joined to what the sides have as points.
template <class Surface>
void fillGrid(GrowingMesh &mesh, const PatchSides &sides, int columns, int rows,
              const Surface &surface)
{
    std::vector<std::vector<std::uint32_t>> grid; // rows − 1 × columns − 1
    for (int j = 1; j < rows; ++j) {
        std::vector<std::uint32_t> &row = grid.emplace_back();
        for (int i = 1; i < columns; ++i)
            row.push_back(
                mesh.add(surface(static_cast<double>(i) / columns, static_cast<double>(j) / rows)));
    }
    for (std::size_t j = 0; j + 1 < grid.size(); ++j)
        for (std::size_t i = 0; i + 1 < grid[j].size(); ++i) {
            mesh.face(grid[j][i], grid[j][i + 1], grid[j + 1][i + 1]);
            mesh.face(grid[j][i], grid[j + 1][i + 1], grid[j + 1][i]);
        }
    const auto row = [&](std::size_t j) {
        Chain chain{grid[j], {}};
        for (int i = 1; i < columns; ++i)
            chain.at.push_back(static_cast<double>(i) / columns);
        return chain;
    };
    const auto column = [&](std::size_t i) {
        Chain chain;
        for (int j = 1; j < rows; ++j) {
            chain.vertices.push_back(grid[static_cast<std::size_t>(j - 1)][i]);
            chain.at.push_back(static_cast<double>(j) / rows);
        }
        return chain;
    };
    const auto side = [](const SkinCurve &curve) { return Chain{curve.vertices, curve.at}; };
    zip(mesh, side(sides.south), row(0));
    zip(mesh, row(grid.size() - 1), side(sides.north));
    zip(mesh, column(0), side(sides.west));
    zip(mesh, side(sides.east), column(grid.front().size() - 1));
}

SkinCurve pointOf(const SkinCurve &curve)
{
    return {{curve.vertices.front()}, {curve.points.front()}, {curve.normals.front()}, {0.0}, {}};
}

} // namespace

void fillPatch(GrowingMesh &mesh, const PatchSides &sides)
{
    fillGrid(mesh, sides, rowsFor(sides.south, sides.north), rowsFor(sides.west, sides.east),
             CoonsSurface(sides));
}

void fillLune(GrowingMesh &mesh, const SkinCurve &south, const SkinCurve &north)
{
    const PatchSides sides{south, pointOf(south.reversed()), north, pointOf(south)};
    const int rows = rowsFor(south, north);
    fillGrid(mesh, sides, rows, std::max(kLeastRows, rows / 2), LuneSurface(south, north));
}

} // namespace fff
