#include "core/templates/thinned_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

namespace fff {

namespace {

/// A surface takes up about so many triangles a cell that it passes.
constexpr double kTrianglesOfCell = 2.0;
constexpr int kCellBits = 21; // of a key along each axis

/// The cell of a grid that each vertex is in, in the order in which they are met.
std::vector<std::uint32_t> cellsOf(const TriangleMesh &mesh, double cell)
{
    const Vec3 low = mesh.bounds().min;
    std::unordered_map<std::uint64_t, std::uint32_t> cells;
    std::vector<std::uint32_t> cellOf;
    cellOf.reserve(mesh.positions().size());
    for (const Vec3 &p : mesh.positions()) {
        std::uint64_t key = 0;
        for (int axis = 0; axis < 3; ++axis)
            key = (key << kCellBits) |
                  static_cast<std::uint64_t>(std::floor((p[axis] - low[axis]) / cell));
        cellOf.push_back(
            cells.emplace(key, static_cast<std::uint32_t>(cells.size())).first->second);
    }
    return cellOf;
}

/// By groups.
std::vector<Vec3> means(const std::vector<Vec3> &positions,
                        const std::vector<std::uint32_t> &groupOf)
{
    struct Sum
    {
        Vec3 sum = Vec3::Zero();
        double count = 0.0;
    };
    std::vector<Sum> sums;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (groupOf[i] >= sums.size()) // groups are numbered as they are met
            sums.emplace_back();
        sums[groupOf[i]].sum += positions[i];
        sums[groupOf[i]].count += 1.0;
    }
    std::vector<Vec3> means;
    means.reserve(sums.size());
    for (const Sum &group : sums)
        means.push_back(group.sum / group.count);
    return means;
}

} // namespace

ThinnedMesh::ThinnedMesh(const TriangleMeshPointer &mesh, std::size_t most) : m_mesh(mesh)
{
    if (mesh->triangles().size() <= most || most == 0)
        return;
    const double cell =
        std::max(std::sqrt(kTrianglesOfCell * mesh->area() / static_cast<double>(most)),
                 mesh->size() / static_cast<double>((std::uint64_t(1) << kCellBits) - 1));
    if (!(cell > 0.0))
        return;
    std::vector<std::uint32_t> cells = cellsOf(*mesh, cell);
    std::vector<Triangle> triangles;
    for (const Triangle &t : mesh->triangles()) {
        Triangle corners{cells[t[0]], cells[t[1]], cells[t[2]]};
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            continue;
        // The same one is told from all others by where it begins.
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    if (triangles.empty())
        return;
    m_mesh = std::make_shared<const TriangleMesh>(means(mesh->positions(), cells),
                                                  std::move(triangles), mesh->unit());
    m_vertexOf = std::move(cells);
}

TriangleMeshPointer ThinnedMesh::moved(const TriangleMeshPointer &mesh) const
{
    if (isWhole())
        return mesh;
    assert(mesh->positions().size() == m_vertexOf.size() && "a mesh of the same vertices");
    return std::make_shared<const TriangleMesh>(means(mesh->positions(), m_vertexOf),
                                                m_mesh->triangles(), mesh->unit());
}

} // namespace fff
