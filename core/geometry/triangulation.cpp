#include "core/geometry/triangulation.h"

#include "core/base/fault_point.h"
#include "core/geometry/sweep_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Uncertain.h>
#include <CGAL/exceptions.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <numeric>
#include <utility>

namespace fff {

namespace {

struct FaceInfo
{
    int piece = -1; // of the plane that the boundary cuts up
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

/// All vertices first, near ones after each other, then the edges: inserting a ring along itself
/// makes fans that are flipped over and over.
void insertRings(Cdt &cdt, const Region &region)
{
    std::vector<Kernel::Point_2> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    const auto addRing = [&](const Polygon &ring) {
        if (ring.size() < 3)
            return;
        const std::size_t first = points.size();
        for (const Vec2 &p : ring)
            points.emplace_back(p.x(), p.y());
        for (std::size_t i = 0; i < ring.size(); ++i)
            edges.emplace_back(first + i, first + (i + 1 < ring.size() ? i + 1 : 0));
    };
    addRing(region.outer);
    for (const Polygon &hole : region.holes)
        addRing(hole);

    if (points.empty())
        return; // CGAL takes the address of the first
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    using Traits = CGAL::Spatial_sort_traits_adapter_2<
        Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::const_type>;
    CGAL::hilbert_sort(order.begin(), order.end(),
                       Traits(CGAL::make_property_map(std::as_const(points))));
    std::vector<Cdt::Vertex_handle> vertices(points.size());
    Cdt::Face_handle hint;
    for (const std::size_t i : order) {
        vertices[i] = cdt.insert(points[i], hint);
        hint = vertices[i]->face();
    }
    for (const auto &[from, to] : edges) {
        if (vertices[from] != vertices[to])
            cdt.insert_constraint(vertices[from], vertices[to]);
    }
}

double doubleArea(Cdt::Face_handle face)
{
    const auto at = [&](int i) {
        return Vec2(face->vertex(i)->point().x(), face->vertex(i)->point().y());
    };
    return std::abs(cross(at(1) - at(0), at(2) - at(0)));
}

/// Gives every face the number of its piece. Which of the pieces lie inside is asked of the region,
/// at the middle of each one's largest face: counting the constraints on the way from outside goes
/// wrong where two rings share an edge, which is one constraint.
std::vector<bool> markPieces(const Cdt &cdt, const Region &region)
{
    std::vector<bool> isInside;
    for (const Cdt::Face_handle start : cdt.all_face_handles()) {
        if (start->info().piece != -1)
            continue;
        const int piece = static_cast<int>(isInside.size());
        Cdt::Face_handle largest;
        double size = -1.0;
        bool isInfinite = false;
        std::vector<Cdt::Face_handle> stack{start};
        start->info().piece = piece;
        while (!stack.empty()) {
            const Cdt::Face_handle face = stack.back();
            stack.pop_back();
            if (cdt.is_infinite(face)) {
                isInfinite = true;
            } else if (const double area = doubleArea(face); area > size) {
                size = area;
                largest = face;
            }
            for (int i = 0; i < 3; ++i) {
                const Cdt::Face_handle next = face->neighbor(i);
                if (next->info().piece != -1 || cdt.is_constrained(Cdt::Edge(face, i)))
                    continue;
                next->info().piece = piece;
                stack.push_back(next);
            }
        }
        if (isInfinite) {
            isInside.push_back(false);
            continue;
        }
        const auto &a = largest->vertex(0)->point(), &b = largest->vertex(1)->point(),
                   &c = largest->vertex(2)->point();
        const Vec2 middle((a.x() + b.x() + c.x()) / 3.0, (a.y() + b.y() + c.y()) / 3.0);
        isInside.push_back(locate(middle, region) == Side::Inside);
    }
    return isInside;
}

/// Throws what CGAL throws.
Triangulation constrainedDelaunay(const Region &region)
{
    Triangulation result;
    Cdt cdt;
    insertRings(cdt, region);
    if (cdt.dimension() < 2)
        return result;
    const std::vector<bool> isInside = markPieces(cdt, region);

    result.points.reserve(cdt.number_of_vertices());
    for (const auto &vertex : cdt.finite_vertex_handles()) {
        vertex->info() = static_cast<int>(result.points.size());
        result.points.emplace_back(vertex->point().x(), vertex->point().y());
    }
    for (const auto &face : cdt.finite_face_handles()) {
        if (isInside[static_cast<std::size_t>(face->info().piece)])
            result.triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return result;
}

} // namespace

Result<Triangulation> triangulate(const Region &region)
{
    try {
        if (failsHere(FaultPoint::Triangles))
            throw CGAL::Failure_exception("CGAL", "asked for", __FILE__, __LINE__, "", "");
        if (std::optional<Triangulation> plain = sweepTriangles(region))
            return *std::move(plain);
        return constrainedDelaunay(region);
    } catch (const CGAL::Failure_exception &) {
        return failure(ErrorCode::NotWorkedOut);
    } catch (const CGAL::Uncertain_conversion_exception &) {
        return failure(ErrorCode::NotWorkedOut);
    }
}

} // namespace fff
