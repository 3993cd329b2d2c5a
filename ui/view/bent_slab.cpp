#include "ui/view/bent_slab.h"

#include <cmath>

namespace fff::ui {

namespace {

std::array<float, 3> floatsOf(const Vec3 &v)
{
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

PackedNormal packedUnit(const Vec3 &normal, bool flag)
{
    const Vec3 n = normal.norm() > 0.0 ? Vec3(127.0 * normal.normalized()) : Vec3(0.0, 0.0, 127.0);
    return {static_cast<std::int8_t>(std::lround(n.x())),
            static_cast<std::int8_t>(std::lround(n.y())),
            static_cast<std::int8_t>(std::lround(n.z())), static_cast<std::int8_t>(flag ? 127 : 0)};
}

/// How the middle of the sheet turns at a point: its normal is (0, 0, 1) + t turn + t² more.
struct Turning
{
    Vec3 turn = Vec3::Zero(), more = Vec3::Zero();
};

/// Of each point, the mean over the triangles around it by their areas.
std::vector<Turning> turningsOf(const StressField &field, const std::vector<Vec3> &moved)
{
    std::vector<Turning> turnings(moved.size());
    std::vector<double> areas(moved.size(), 0.0); // twice
    for (const auto &t : field.triangles) {
        std::array<Vec3, 3> at, by;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(t[k]);
            at[k] = Vec3(field.points[i].x(), field.points[i].y(), 0.0);
            by[k] = moved[i];
        }
        const Vec3 a = at[1] - at[0], b = at[2] - at[0];
        const Vec3 movedA = by[1] - by[0], movedB = by[2] - by[0];
        for (const int point : t) {
            const auto i = static_cast<std::size_t>(point);
            turnings[i].turn += a.cross(movedB) + movedA.cross(b);
            turnings[i].more += movedA.cross(movedB);
            areas[i] += a.cross(b).z();
        }
    }
    for (std::size_t i = 0; i < turnings.size(); ++i) {
        if (!(areas[i] > 0.0))
            continue;
        turnings[i].turn /= areas[i];
        turnings[i].more /= areas[i];
    }
    return turnings;
}

class BentWalls
{
public:
    BentWalls(BentSlab &slab, const StressField &field)
        : m_slab(slab), m_count(static_cast<std::uint32_t>(field.points.size())),
          m_next(boundaryOf(field))
    {
        for (const auto &[from, to] : m_next) {
            const Vec2 along = field.points[static_cast<std::size_t>(to)] -
                               field.points[static_cast<std::size_t>(from)];
            m_out[from] = Vec2(along.y(), -along.x()).normalized();
            m_before[to] = from;
        }
    }

    void add()
    {
        for (const auto &[from, to] : m_next) {
            addWall(from, to);
            addFaceLine(top(from), top(to), Vec3::UnitZ(), outOf(from));
            addFaceLine(bottom(from), bottom(to), -Vec3::UnitZ(), outOf(from));
            if (const auto before = m_before.find(from); before != m_before.end())
                addLine(top(from), bottom(from), outOf(before->second), outOf(from),
                        isCorner(before->second, from));
        }
    }

private:
    std::uint32_t top(int i) const { return static_cast<std::uint32_t>(i); }
    std::uint32_t bottom(int i) const { return m_count + static_cast<std::uint32_t>(i); }
    Vec3 outOf(int side) const
    {
        const Vec2 out = m_out.at(side);
        return {out.x(), out.y(), 0.0};
    }
    bool isCorner(int before, int side) const
    {
        return m_out.at(before).dot(m_out.at(side)) < std::cos(kCornerAngle);
    }
    /// Smooth where the boundary is.
    Vec3 outAt(int point, int side) const
    {
        const auto before = m_before.find(point);
        if (before == m_before.end() || !m_out.count(point))
            return outOf(side);
        return isCorner(before->second, point) ? outOf(side)
                                               : Vec3(outOf(before->second) + outOf(point));
    }
    void addWall(int from, int to)
    {
        SlabMesh &mesh = m_slab.flat;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const auto &[vertex, point] :
             {std::pair(top(from), from), std::pair(bottom(from), from), std::pair(bottom(to), to),
              std::pair(top(to), to)}) {
            mesh.vertices.push_back(
                {mesh.vertices[vertex].position, packedUnit(outAt(point, from), true)});
            m_slab.motions.push_back({m_slab.motions[vertex].by});
            m_slab.onFace.push_back(vertex);
        }
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u})
            mesh.triangles.push_back(first + k);
    }
    void addLine(std::uint32_t from, std::uint32_t to, const Vec3 &a, const Vec3 &b, bool isAlways)
    {
        SlabMesh &mesh = m_slab.flat;
        mesh.edges.push_back({mesh.vertices[from].position, mesh.vertices[to].position,
                              packedUnit(a, isAlways), packedUnit(b, false)});
        m_slab.edgeMotions.push_back({m_slab.motions[from].by, m_slab.motions[to].by});
    }
    void addFaceLine(std::uint32_t from, std::uint32_t to, const Vec3 &face, const Vec3 &out)
    {
        addLine(from, to, face, out, true);
        m_slab.edgeMotions.back().turn = m_slab.motions[from].turn;
        m_slab.edgeMotions.back().turnMore = m_slab.motions[from].turnMore;
    }

    BentSlab &m_slab;
    std::uint32_t m_count;
    std::map<int, int> m_next, m_before;
    std::map<int, Vec2> m_out; // of the side that begins at a point
};

} // namespace

std::map<int, int> boundaryOf(const StressField &field)
{
    std::map<std::pair<int, int>, int> sides;
    for (const auto &t : field.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++sides[{t[k], t[(k + 1) % 3]}];
    std::map<int, int> next;
    for (const auto &[side, count] : sides)
        if (!sides.count({side.second, side.first}))
            next[side.first] = side.second;
    return next;
}

std::array<float, 3> BentSlab::placeAt(std::size_t vertex, double times) const
{
    std::array<float, 3> place = flat.vertices[vertex].position;
    for (std::size_t k = 0; k < place.size(); ++k)
        place[k] += static_cast<float>(times) * motions[vertex].by[k];
    return place;
}

BentSlab bentSlab(const StressField &field, const std::vector<Vec3> &moved, double half)
{
    BentSlab slab;
    SlabMesh &mesh = slab.flat;
    const std::vector<Turning> turnings = turningsOf(field, moved);
    const auto count = static_cast<std::uint32_t>(field.points.size());
    for (const int side : {1, -1})
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 &at = field.points[i];
            slab.onFace.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(
                {{static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(side)},
                 packedUnit(side * Vec3::UnitZ(), false)});
            slab.motions.push_back({floatsOf({moved[i].x(), moved[i].y(), moved[i].z() / half}),
                                    floatsOf(side * turnings[i].turn),
                                    floatsOf(side * turnings[i].more)});
        }
    for (const auto &t : field.triangles) {
        for (const int i : t)
            mesh.triangles.push_back(static_cast<std::uint32_t>(i));
        for (const int i : {t[0], t[2], t[1]})
            mesh.triangles.push_back(count + static_cast<std::uint32_t>(i));
    }
    BentWalls(slab, field).add();
    mesh.coverStarts = {mesh.triangles.size()};
    return slab;
}

} // namespace fff::ui
