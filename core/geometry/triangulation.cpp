#include "core/geometry/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Uncertain.h>
#include <CGAL/exceptions.h>

#include <list>

namespace fff {

namespace {

struct FaceInfo
{
    int nesting = -1; // how many constraints lie between the face and infinity; odd is inside
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

void insertRing(Cdt &cdt, const Polygon &polygon)
{
    std::vector<Kernel::Point_2> ring;
    ring.reserve(polygon.size());
    for (const Vec2 &p : polygon)
        ring.emplace_back(p.x(), p.y());
    if (ring.size() >= 3)
        cdt.insert_constraint(ring.begin(), ring.end(), true);
}

void markNesting(const Cdt &cdt)
{
    std::list<Cdt::Edge> border;
    const auto flood = [&](Cdt::Face_handle start, int nesting) {
        std::vector<Cdt::Face_handle> stack{start};
        while (!stack.empty()) {
            const Cdt::Face_handle face = stack.back();
            stack.pop_back();
            if (face->info().nesting != -1)
                continue;
            face->info().nesting = nesting;
            for (int i = 0; i < 3; ++i) {
                const Cdt::Edge edge(face, i);
                const Cdt::Face_handle next = face->neighbor(i);
                if (next->info().nesting != -1)
                    continue;
                if (cdt.is_constrained(edge))
                    border.push_back(edge);
                else
                    stack.push_back(next);
            }
        }
    };
    flood(cdt.infinite_face(), 0);
    while (!border.empty()) {
        const Cdt::Edge edge = border.front();
        border.pop_front();
        flood(edge.first->neighbor(edge.second), edge.first->info().nesting + 1);
    }
}

/// Throws what CGAL throws.
Triangulation constrainedDelaunay(const Region &region)
{
    Triangulation result;
    Cdt cdt;
    insertRing(cdt, region.outer);
    for (const Polygon &hole : region.holes)
        insertRing(cdt, hole);
    if (cdt.dimension() < 2)
        return result;
    markNesting(cdt);

    result.points.reserve(cdt.number_of_vertices());
    for (const auto &vertex : cdt.finite_vertex_handles()) {
        vertex->info() = static_cast<int>(result.points.size());
        result.points.emplace_back(vertex->point().x(), vertex->point().y());
    }
    for (const auto &face : cdt.finite_face_handles()) {
        if (face->info().nesting % 2 == 1)
            result.triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return result;
}

} // namespace

Triangulation triangulate(const Region &region)
{
    try {
        return constrainedDelaunay(region);
    } catch (const CGAL::Failure_exception &) {
        return {};
    } catch (const CGAL::Uncertain_conversion_exception &) {
        return {};
    }
}

} // namespace fff
