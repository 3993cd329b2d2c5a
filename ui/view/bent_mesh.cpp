#include "ui/view/bent_mesh.h"

#include <cmath>
#include <map>

namespace fff::ui {

namespace {

PackedNormal packedUnit(const Vec3 &normal, bool flag)
{
    const Vec3 n = normal.norm() > 0.0 ? Vec3(127.0 * normal.normalized()) : Vec3(0.0, 0.0, 127.0);
    return {static_cast<std::int8_t>(std::lround(n.x())),
            static_cast<std::int8_t>(std::lround(n.y())),
            static_cast<std::int8_t>(std::lround(n.z())), static_cast<std::int8_t>(flag ? 127 : 0)};
}

/// The way round the triangles: from each point of the boundary to the next, material on the left.
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

/// Of each point, of the bent middle of the sheet.
std::vector<Vec3> normalsOf(const StressField &field, const std::vector<Vec3> &middle)
{
    std::vector<Vec3> normals(middle.size(), Vec3::Zero());
    for (const auto &t : field.triangles) {
        const Vec3 &a = middle[static_cast<std::size_t>(t[0])];
        const Vec3 across = (middle[static_cast<std::size_t>(t[1])] - a)
                                .cross(middle[static_cast<std::size_t>(t[2])] - a);
        for (const int i : t)
            normals[static_cast<std::size_t>(i)] += across;
    }
    return normals;
}

class BentWalls
{
public:
    BentWalls(SlabMesh &mesh, const StressField &field, const std::vector<Vec3> &normals)
        : m_mesh(mesh), m_count(static_cast<std::uint32_t>(field.points.size())),
          m_normals(normals), m_next(boundaryOf(field))
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
            addLine(top(from), top(to), m_normals[static_cast<std::size_t>(from)], outOf(from),
                    true);
            addLine(bottom(from), bottom(to), -m_normals[static_cast<std::size_t>(from)],
                    outOf(from), true);
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
        const auto first = static_cast<std::uint32_t>(m_mesh.vertices.size());
        for (const auto &[vertex, point] :
             {std::pair(top(from), from), std::pair(bottom(from), from), std::pair(bottom(to), to),
              std::pair(top(to), to)})
            m_mesh.vertices.push_back(
                {m_mesh.vertices[vertex].position, packedUnit(outAt(point, from), true)});
        for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u})
            m_mesh.triangles.push_back(first + k);
    }
    void addLine(std::uint32_t from, std::uint32_t to, const Vec3 &a, const Vec3 &b, bool isAlways)
    {
        m_mesh.edges.push_back({m_mesh.vertices[from].position, m_mesh.vertices[to].position,
                                packedUnit(a, isAlways), packedUnit(b, false)});
    }

    SlabMesh &m_mesh;
    std::uint32_t m_count;
    const std::vector<Vec3> &m_normals;
    std::map<int, int> m_next, m_before;
    std::map<int, Vec2> m_out; // of the side that begins at a point
};

} // namespace

SlabMesh bentMesh(const StressField &field, const std::vector<Vec3> &moved, double half)
{
    SlabMesh mesh;
    std::vector<Vec3> middle;
    middle.reserve(field.points.size());
    for (std::size_t i = 0; i < field.points.size(); ++i)
        middle.push_back(Vec3(field.points[i].x(), field.points[i].y(), 0.0) + moved[i]);
    const std::vector<Vec3> normals = normalsOf(field, middle);
    const auto count = static_cast<std::uint32_t>(field.points.size());
    for (const int side : {1, -1})
        for (std::size_t i = 0; i < middle.size(); ++i)
            mesh.vertices.push_back(
                {{static_cast<float>(middle[i].x()), static_cast<float>(middle[i].y()),
                  static_cast<float>(side + middle[i].z() / half)},
                 packedUnit(side * normals[i], false)});
    for (const auto &t : field.triangles) {
        for (const int i : t)
            mesh.triangles.push_back(static_cast<std::uint32_t>(i));
        for (const int i : {t[0], t[2], t[1]})
            mesh.triangles.push_back(count + static_cast<std::uint32_t>(i));
    }
    BentWalls(mesh, field, normals).add();
    mesh.coverStarts = {mesh.triangles.size()};
    return mesh;
}

} // namespace fff::ui
