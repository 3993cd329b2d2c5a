#include "core/templates/mesh_surface.h"

#include <cassert>
#include <cmath>

namespace fff {

namespace {

/// At a vertex of more faces these are not compared with each other: it is one corner.
constexpr std::size_t kMostFaces = 256;

/// The faces at each vertex, one list after the other.
struct FacesOfVertices
{
    std::vector<std::uint32_t> begins, faces;

    explicit FacesOfVertices(const TriangleMesh &mesh)
        : begins(mesh.positions().size() + 1, 0), faces(3 * mesh.triangles().size())
    {
        for (const Triangle &t : mesh.triangles())
            for (const std::uint32_t vertex : t)
                ++begins[vertex + 1];
        for (std::size_t i = 1; i < begins.size(); ++i)
            begins[i] += begins[i - 1];
        std::vector<std::uint32_t> next(begins.begin(), begins.end() - 1);
        for (std::uint32_t f = 0; f < mesh.triangles().size(); ++f)
            for (const std::uint32_t vertex : mesh.triangles()[f])
                faces[next[vertex]++] = f;
    }
};

/// Twice as long as the area of the face.
std::vector<Vec3> areaNormals(const TriangleMesh &mesh)
{
    std::vector<Vec3> normals;
    normals.reserve(mesh.triangles().size());
    const std::vector<Vec3> &p = mesh.positions();
    for (const Triangle &t : mesh.triangles())
        normals.push_back((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]));
    return normals;
}

std::array<float, 3> toFloats(const Vec3 &p)
{
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

class SurfaceMaker
{
public:
    explicit SurfaceMaker(const TriangleMesh &mesh)
        : m_mesh(mesh), m_middle(0.5 * (mesh.bounds().min + mesh.bounds().max)), m_faces(mesh),
          m_normals(areaNormals(mesh)), m_cosine(std::cos(kCreaseAngle))
    {
        m_surface.indices.resize(3 * mesh.triangles().size());
        m_surface.corners.reserve(mesh.positions().size());
    }

    void add(std::uint32_t vertex);
    MeshSurface take() { return std::move(m_surface); }

private:
    bool looksAlike(std::uint32_t a, std::uint32_t b) const
    {
        const double lengths = m_normals[a].norm() * m_normals[b].norm();
        return m_normals[a].dot(m_normals[b]) >= m_cosine * lengths;
    }

    const TriangleMesh &m_mesh;
    const Vec3 m_middle;
    const FacesOfVertices m_faces;
    const std::vector<Vec3> m_normals;
    const double m_cosine;
    MeshSurface m_surface;
};

/// The sum of the faces that look like this one, for each: equal sums are one corner.
void SurfaceMaker::add(std::uint32_t vertex)
{
    const std::size_t begin = m_faces.begins[vertex], end = m_faces.begins[vertex + 1];
    const std::size_t first = m_surface.corners.size();
    for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t face = m_faces.faces[i];
        Vec3 normal = Vec3::Zero();
        for (std::size_t k = begin; k < end; ++k)
            if (end - begin > kMostFaces || looksAlike(face, m_faces.faces[k]))
                normal += m_normals[m_faces.faces[k]];
        const double length = normal.norm();
        if (length > 0.0)
            normal /= length;
        const MeshSurface::Corner corner{toFloats(m_mesh.positions()[vertex] - m_middle),
                                         toFloats(normal)};
        std::size_t known = first;
        while (known < m_surface.corners.size() && m_surface.corners[known].normal != corner.normal)
            ++known;
        if (known == m_surface.corners.size())
            m_surface.corners.push_back(corner);
        const Triangle &triangle = m_mesh.triangles()[face];
        for (std::size_t c = 0; c < 3; ++c)
            if (triangle[c] == vertex)
                m_surface.indices[3 * face + c] = static_cast<std::uint32_t>(known);
        if (end - begin > kMostFaces && i == begin) {
            // The same for all of them.
            for (std::size_t k = begin + 1; k < end; ++k)
                for (std::size_t c = 0; c < 3; ++c)
                    if (m_mesh.triangles()[m_faces.faces[k]][c] == vertex)
                        m_surface.indices[3 * m_faces.faces[k] + c] =
                            static_cast<std::uint32_t>(known);
            return;
        }
    }
}

} // namespace

MeshSurface surfaceOf(const TriangleMesh &mesh, const LongWork &work)
{
    constexpr std::uint32_t kAsk = 1U << 16; // vertices
    SurfaceMaker maker(mesh);
    for (std::uint32_t vertex = 0; vertex < mesh.positions().size(); ++vertex) {
        if (vertex % kAsk == 0 && work.isStopped())
            return {};
        maker.add(vertex);
    }
    return maker.take();
}

MeshSurface movedSurface(const MeshSurface &before, const TriangleMesh &mesh)
{
    const std::vector<Triangle> &triangles = mesh.triangles();
    assert(before.indices.size() == 3 * triangles.size() && "a mesh of the same triangles");
    const std::vector<Vec3> &positions = mesh.positions();
    const Vec3 middle = 0.5 * (mesh.bounds().min + mesh.bounds().max);
    std::vector<Vec3> normals(before.corners.size(), Vec3::Zero());
    MeshSurface surface{std::vector<MeshSurface::Corner>(before.corners.size()), before.indices};
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Triangle &t = triangles[f];
        const Vec3 normal =
            (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t corner = surface.indices[3 * f + c];
            normals[corner] += normal;
            surface.corners[corner].position = toFloats(positions[t[c]] - middle);
        }
    }
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (const double length = normals[i].norm(); length > 0.0)
            surface.corners[i].normal = toFloats(normals[i] / length);
    return surface;
}

} // namespace fff
