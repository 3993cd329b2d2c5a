#include "core/physics/plate_mesh.h"

#include "core/physics/plate_sizing.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polyline_simplification_2/Squared_distance_cost.h>
#include <CGAL/Polyline_simplification_2/Stop_above_cost_threshold.h>
#include <CGAL/Polyline_simplification_2/simplify.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fff {

namespace {

constexpr double kPlateEdges = 15.0;     // along the size of a plate
constexpr double kStraightShare = 0.004; // of an edge: what a boundary may be off
constexpr double kAngleBound = 0.125;    // sin² of the smallest angle, 20.7°

using PlateKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PlatePoint = PlateKernel::Point_2;
using PlateFaces = CGAL::Delaunay_mesh_face_base_2<PlateKernel>;
using PlateVertices =
    CGAL::Triangulation_vertex_base_with_info_2<int, PlateKernel,
                                                CGAL::Delaunay_mesh_vertex_base_2<PlateKernel>>;
using PlateTds = CGAL::Triangulation_data_structure_2<PlateVertices, PlateFaces>;
using PlateCdt =
    CGAL::Constrained_Delaunay_triangulation_2<PlateKernel, PlateTds, CGAL::Exact_predicates_tag>;

Vec2 vec(const PlatePoint &p)
{
    return {p.x(), p.y()};
}

/// What CGAL's mesher asks: is a triangle too large for its place, or too thin?
class PlateCriteria
{
public:
    explicit PlateCriteria(const PlateSizing *sizing = nullptr) : m_sizing(sizing) {}

    struct Quality
    {
        double sine = 1.0;   // sin² of the smallest angle
        double excess = 0.0; // longest edge over what is wanted; above 1 is too large

        /// Whether this one is worse.
        bool operator<(const Quality &other) const
        {
            if (excess > 1.0)
                return other.excess <= 1.0 || excess > other.excess;
            return other.excess <= 1.0 && sine < other.sine;
        }
    };

    class Is_bad
    {
    public:
        explicit Is_bad(const PlateSizing *sizing) : m_sizing(sizing) {}

        CGAL::Mesh_2::Face_badness operator()(const Quality &quality) const
        {
            if (quality.excess > 1.0)
                return CGAL::Mesh_2::IMPERATIVELY_BAD;
            return quality.sine < kAngleBound ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
        }
        CGAL::Mesh_2::Face_badness operator()(const PlateCdt::Face_handle &face,
                                              Quality &quality) const
        {
            const Vec2 a = vec(face->vertex(0)->point()), b = vec(face->vertex(1)->point()),
                       c = vec(face->vertex(2)->point());
            std::array<double, 3> sides{(b - a).squaredNorm(), (c - b).squaredNorm(),
                                        (a - c).squaredNorm()};
            std::sort(sides.begin(), sides.end());
            const double twice = cross(b - a, c - a);
            quality.sine = twice * twice / (sides[1] * sides[2]);
            quality.excess = std::sqrt(sides[2]) / (1.2 * m_sizing->edgeAt((a + b + c) / 3.0));
            return (*this)(quality);
        }

    private:
        const PlateSizing *m_sizing;
    };

    Is_bad is_bad_object() const { return Is_bad(m_sizing); }

private:
    const PlateSizing *m_sizing;
};

Polygon withoutRepeats(const Polygon &ring)
{
    Polygon kept;
    for (const Vec2 &p : ring) {
        if (kept.empty() || p != kept.back())
            kept.push_back(p);
    }
    while (kept.size() > 1 && kept.front() == kept.back())
        kept.pop_back();
    return kept;
}

/// The region with boundaries straightened by `off` mm at most; rings keep their nesting.
Region straightened(const Region &region, double off)
{
    namespace Simplify = CGAL::Polyline_simplification_2;
    using Vertices = Simplify::Vertex_base_2<PlateKernel>;
    using Faces = CGAL::Constrained_triangulation_face_base_2<PlateKernel>;
    using Tds = CGAL::Triangulation_data_structure_2<Vertices, Faces>;
    using Plain =
        CGAL::Constrained_Delaunay_triangulation_2<PlateKernel, Tds, CGAL::Exact_predicates_tag>;
    using Plus = CGAL::Constrained_triangulation_plus_2<Plain>;

    Plus plus;
    std::vector<Plus::Constraint_id> ids;
    const auto insert = [&](const Polygon &given) {
        const Polygon ring = withoutRepeats(given);
        if (ring.size() < 3)
            return;
        CGAL::Polygon_2<PlateKernel> polygon;
        for (const Vec2 &p : ring)
            polygon.push_back(PlatePoint(p.x(), p.y()));
        ids.push_back(plus.insert_constraint(polygon));
    };
    insert(region.outer);
    if (ids.empty())
        return {};
    for (const Polygon &hole : region.holes)
        insert(hole);
    Simplify::simplify(plus, Simplify::Squared_distance_cost(),
                       Simplify::Stop_above_cost_threshold(off * off));
    Region result;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        Polygon ring;
        for (auto p = plus.points_in_constraint_begin(ids[i]);
             p != plus.points_in_constraint_end(ids[i]); ++p)
            ring.push_back(vec(*p));
        ring = withoutRepeats(ring);
        if (i == 0)
            result.outer = std::move(ring);
        else if (ring.size() >= 3)
            result.holes.push_back(std::move(ring));
    }
    return result;
}

void insertBoundary(PlateCdt &cdt, const Region &region)
{
    const auto insert = [&](const Polygon &ring) {
        std::vector<PlateCdt::Vertex_handle> vertices;
        for (const Vec2 &p : ring)
            vertices.push_back(cdt.insert(PlatePoint(p.x(), p.y())));
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            const auto next = vertices[(i + 1) % vertices.size()];
            if (vertices[i] != next)
                cdt.insert_constraint(vertices[i], next);
        }
    };
    insert(region.outer);
    for (const Polygon &hole : region.holes)
        insert(hole);
}

/// A point in each piece of the plane that is bounded but not of the region.
std::vector<PlatePoint> pointsOutside(const PlateCdt &cdt, const Region &region)
{
    std::vector<PlatePoint> found;
    std::set<PlateCdt::Face_handle> seen;
    for (const PlateCdt::Face_handle start : cdt.all_face_handles()) {
        if (!seen.insert(start).second)
            continue;
        std::vector<PlateCdt::Face_handle> stack{start};
        bool isInfinite = false;
        double largest = -1.0;
        Vec2 middle = Vec2::Zero();
        while (!stack.empty()) {
            const PlateCdt::Face_handle face = stack.back();
            stack.pop_back();
            if (cdt.is_infinite(face)) {
                isInfinite = true;
            } else {
                const Vec2 a = vec(face->vertex(0)->point()), b = vec(face->vertex(1)->point()),
                           c = vec(face->vertex(2)->point());
                if (const double size = cross(b - a, c - a); size > largest) {
                    largest = size;
                    middle = (a + b + c) / 3.0;
                }
            }
            for (int i = 0; i < 3; ++i) {
                const PlateCdt::Face_handle next = face->neighbor(i);
                if (!cdt.is_constrained({face, i}) && seen.insert(next).second)
                    stack.push_back(next);
            }
        }
        if (!isInfinite && locate(middle, region) != Side::Inside)
            found.emplace_back(middle.x(), middle.y());
    }
    return found;
}

PlateMesh quadratic(const PlateCdt &cdt)
{
    PlateMesh mesh;
    for (const auto &vertex : cdt.finite_vertex_handles())
        vertex->info() = -1;
    const auto corner = [&](PlateCdt::Vertex_handle vertex) {
        if (vertex->info() < 0) {
            vertex->info() = static_cast<int>(mesh.points.size());
            mesh.points.push_back(vec(vertex->point()));
        }
        return vertex->info();
    };
    for (const auto &face : cdt.finite_face_handles()) {
        if (!face->is_in_domain())
            continue;
        mesh.triangles.push_back({corner(face->vertex(0)), corner(face->vertex(1)),
                                  corner(face->vertex(2)), -1, -1, -1});
    }
    mesh.corners = static_cast<int>(mesh.points.size());
    std::map<std::pair<int, int>, int> middles;
    for (auto &triangle : mesh.triangles) {
        for (std::size_t side = 0; side < 3; ++side) {
            const int from = triangle[(side + 1) % 3], to = triangle[(side + 2) % 3];
            const auto [at, isNew] =
                middles.emplace(std::minmax(from, to), static_cast<int>(mesh.points.size()));
            if (isNew)
                mesh.points.push_back(0.5 * (mesh.points[static_cast<std::size_t>(from)] +
                                             mesh.points[static_cast<std::size_t>(to)]));
            triangle[3 + side] = at->second;
        }
    }
    return mesh;
}

/// Throws what CGAL throws.
Result<PlateMesh> meshOf(const Region &given, const PlateMeshOptions &options, const LongWork &work)
{
    const Vec2 extent = bounds(given.outer).size();
    const double edge =
        std::min(extent.maxCoeff() / kPlateEdges, std::sqrt(area(given) / options.wantedCorners)) /
        options.fineness;
    const Region region = straightened(given, kStraightShare * edge);
    if (region.outer.size() < 3)
        return failure(ErrorCode::EmptyContour);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);

    const PlateSizing sizing(region, edge, options.linesAcross);
    PlateCdt cdt;
    insertBoundary(cdt, region);
    const std::vector<PlatePoint> outside = pointsOutside(cdt, region);
    CGAL::Delaunay_mesher_2<PlateCdt, PlateCriteria> mesher(cdt, PlateCriteria(&sizing));
    mesher.set_seeds(outside.begin(), outside.end(), false);
    mesher.init();
    bool isComplete = true;
    for (int step = 0; !mesher.is_refinement_done(); ++step) {
        if (static_cast<int>(cdt.number_of_vertices()) >= options.mostCorners) {
            isComplete = false;
            break;
        }
        if (step % 64 == 0 && work.isStopped())
            return failure(ErrorCode::Cancelled);
        if (!mesher.step_by_step_refine_mesh())
            break;
    }
    PlateMesh mesh = quadratic(cdt);
    if (mesh.triangles.empty())
        return failure(ErrorCode::EmptyContour);
    mesh.isComplete = isComplete;
    mesh.sharp = sharpCorners(region);
    return mesh;
}

} // namespace

Result<PlateMesh> plateMesh(const Region &region, const PlateMeshOptions &options,
                            const LongWork &work)
{
    const auto isFinite = [](const Polygon &ring) {
        return std::all_of(ring.begin(), ring.end(), [](const Vec2 &p) { return p.allFinite(); });
    };
    if (!isFinite(region.outer) || !std::all_of(region.holes.begin(), region.holes.end(), isFinite))
        return failure(ErrorCode::NonFinite);
    if (region.outer.size() < 3 || !(area(region) > 0.0))
        return failure(ErrorCode::EmptyContour);
    try {
        return meshOf(region, options, work);
    } catch (const CGAL::Failure_exception &) {
        return failure(ErrorCode::NotWorkedOut);
    } catch (const CGAL::Uncertain_conversion_exception &) {
        return failure(ErrorCode::NotWorkedOut);
    }
}

} // namespace fff
