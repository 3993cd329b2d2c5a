#include "core/templates/simplified_mesh.h"

#include "core/base/text.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <exception>

namespace fff {

namespace {

namespace collapse = CGAL::Surface_mesh_simplification;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Result<TriangleMeshPointer> noSurface()
{
    return failure(ErrorCode::BadValue, {},
                   {QT_TRANSLATE_NOOP("Error", "an edge with three faces or more"),
                    QT_TRANSLATE_NOOP("Error", "a mesh of which two faces meet at an edge")});
}

/// False where the faces are no surface.
bool fill(Surface &surface, const TriangleMesh &mesh)
{
    for (const Vec3 &p : mesh.positions())
        surface.add_vertex({p.x(), p.y(), p.z()});
    const auto vertex = [](std::uint32_t i) { return Surface::Vertex_index(i); };
    for (const Triangle &t : mesh.triangles())
        if (surface.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])) == Surface::null_face())
            return false;
    return true;
}

TriangleMeshPointer meshFrom(const Surface &surface, std::optional<double> unit)
{
    std::vector<Vec3> positions;
    std::vector<std::uint32_t> indices(surface.number_of_vertices() +
                                       surface.number_of_removed_vertices());
    for (const Surface::Vertex_index v : surface.vertices()) {
        indices[v] = static_cast<std::uint32_t>(positions.size());
        const auto &p = surface.point(v);
        positions.emplace_back(p.x(), p.y(), p.z());
    }
    std::vector<Triangle> triangles;
    for (const Surface::Face_index f : surface.faces()) {
        Triangle triangle{};
        std::size_t i = 0;
        for (const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
            triangle[i++] = indices[v];
        triangles.push_back(triangle);
    }
    return std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles), unit);
}

/// Asked after each collapse: so many edges are left, or somebody has stopped it.
class Enough : public collapse::Count_stop_predicate<Surface>
{
public:
    Enough(std::size_t edges, const LongWork &work)
        : collapse::Count_stop_predicate<Surface>(edges), m_work(&work)
    {
    }
    template <class Cost, class Profile>
    bool operator()(const Cost &cost, const Profile &profile, std::size_t first,
                    std::size_t now) const
    {
        return m_work->isStopped() ||
               collapse::Count_stop_predicate<Surface>::operator()(cost, profile, first, now);
    }

private:
    const LongWork *m_work;
};

} // namespace

Result<TriangleMeshPointer> simplified(const TriangleMeshPointer &mesh, std::size_t faces,
                                       const LongWork &work)
{
    if (mesh->triangles().size() <= faces)
        return mesh;
    try {
        Surface surface;
        if (!fill(surface, *mesh))
            return noSurface();
        // A closed mesh has three edges for every two faces; an open one a few more, so that it
        // takes another round or two.
        while (surface.number_of_faces() > faces && !work.isStopped()) {
            const std::size_t before = surface.number_of_faces();
            const std::size_t more = surface.number_of_edges() - 3 * before / 2;
            const Enough enough(3 * faces / 2 + more + 1, work);
            collapse::edge_collapse(surface, enough);
            if (surface.number_of_faces() >= before)
                break;
        }
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        if (surface.number_of_faces() == 0)
            return failure(ErrorCode::NotWorkedOut);
        surface.collect_garbage();
        return meshFrom(surface, mesh->unit());
    } catch (const std::exception &) {
        return failure(ErrorCode::NotWorkedOut);
    }
}

} // namespace fff
