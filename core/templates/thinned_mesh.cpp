#include "core/templates/thinned_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace fff {

namespace {

/// A surface takes up about so many triangles a cell that it passes.
constexpr double kTrianglesOfCell = 2.0;
constexpr int kCellBits = 21; // of a key along each axis

/// The cells of a grid that vertices are in, each with the mean of these.
class CellVertices
{
public:
    CellVertices(const TriangleMesh &mesh, double cell)
    {
        const Vec3 low = mesh.bounds().min;
        m_cellOf.reserve(mesh.positions().size());
        for (const Vec3 &p : mesh.positions()) {
            std::uint64_t key = 0;
            for (int axis = 0; axis < 3; ++axis)
                key = (key << kCellBits) |
                      static_cast<std::uint64_t>(std::floor((p[axis] - low[axis]) / cell));
            const auto [found, isNew] =
                m_cells.emplace(key, static_cast<std::uint32_t>(m_sums.size()));
            if (isNew) {
                m_sums.push_back(Vec3::Zero());
                m_counts.push_back(0.0);
            }
            m_sums[found->second] += p;
            m_counts[found->second] += 1.0;
            m_cellOf.push_back(found->second);
        }
    }

    std::uint32_t of(std::uint32_t vertex) const { return m_cellOf[vertex]; }
    std::vector<Vec3> means() const
    {
        std::vector<Vec3> means;
        means.reserve(m_sums.size());
        for (std::size_t i = 0; i < m_sums.size(); ++i)
            means.push_back(m_sums[i] / m_counts[i]);
        return means;
    }

private:
    std::unordered_map<std::uint64_t, std::uint32_t> m_cells;
    std::vector<std::uint32_t> m_cellOf; // of each vertex
    std::vector<Vec3> m_sums;
    std::vector<double> m_counts;
};

} // namespace

TriangleMeshPointer thinned(const TriangleMeshPointer &mesh, std::size_t most)
{
    if (mesh->triangles().size() <= most || most == 0)
        return mesh;
    const double cell =
        std::max(std::sqrt(kTrianglesOfCell * mesh->area() / static_cast<double>(most)),
                 mesh->size() / static_cast<double>((std::uint64_t(1) << kCellBits) - 1));
    if (!(cell > 0.0))
        return mesh;
    const CellVertices cells(*mesh, cell);
    std::vector<Triangle> triangles;
    for (const Triangle &t : mesh->triangles()) {
        Triangle corners{cells.of(t[0]), cells.of(t[1]), cells.of(t[2])};
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
        return mesh;
    return std::make_shared<const TriangleMesh>(cells.means(), std::move(triangles), mesh->unit());
}

} // namespace fff
