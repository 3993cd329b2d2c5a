#include "core/operations/facet_model.h"

#include "core/assembly/fingers.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/model/edits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

namespace fff {

namespace {

/// What is cut off reaches this far over the edge of what it is cut from, mm.
constexpr double kOverFacet = 1.0;
/// Planes that meet flatter than this have no line of use between them (0.5°).
constexpr double kFlatEdge = 0.0087266462599716477;
/// At a corner of the boundary that is nearly straight, what is cut off goes on by no more than
/// this times its width.
constexpr double kMostCarriedOn = 4.0;

/// A piece in its sheet's mid-plane.
struct Sheet
{
    const MeshFacet *facet = nullptr;
    Frame frame;
    std::vector<Polygon> rings; // as the loops
    ShapePointer shape;         // null: too small
    SectionId id;
};

/// How two sheets meet at a line: by how much each is cut back from it, in its own plane, mm.
double cutBack(double thickness, double cosine)
{
    return thickness * std::sqrt((1.0 + cosine) / std::max(1.0 - cosine, kOnLine));
}

class FacetModeller
{
public:
    FacetModeller(Document document, const TriangleMesh &mesh, const std::string &name)
        : m_mesh(mesh), m_name(name), m_facets(meshFacets(mesh))
    {
        m_model.document = std::move(document);
        m_stock = *m_model.document.find(m_model.document.currentStock);
    }

    Result<FacetModel> make(const LongWork &work);

private:
    void place();
    double widthAt(double cosine, double height) const;
    Polygon alongEdge(const Sheet &sheet, const Polygon &ring, std::size_t edge,
                      const MeshFacet &beyond) const;
    bool isBehind(const MeshFacet &one, const MeshFacet &plane) const;
    std::optional<Polygon> atVertex(const Sheet &sheet, const MeshFacet &other) const;
    void cutToShape(Sheet &sheet, std::size_t index);
    Result<void> addSections();
    Result<void> join();

    const TriangleMesh &m_mesh;
    const std::string &m_name;
    const std::vector<MeshFacet> m_facets;
    Stock m_stock;
    std::vector<Sheet> m_sheets;
    std::vector<std::set<std::size_t>> m_atVertices; // pieces at each vertex of the mesh
    FacetModel m_model;
};

void FacetModeller::place()
{
    m_atVertices.resize(m_mesh.positions().size());
    for (std::size_t i = 0; i < m_facets.size(); ++i) {
        const MeshFacet &facet = m_facets[i];
        Sheet sheet{&facet, {}, {}, nullptr, {}};
        Vec3 longest = Vec3::Zero();
        for (const auto &loop : facet.loops)
            for (const FacetEdge &edge : loop) {
                const Vec3 way = m_mesh.positions()[edge.to] - m_mesh.positions()[edge.from];
                if (way.norm() > longest.norm() + kMinOverlap)
                    longest = way;
                m_atVertices[edge.from].insert(i);
            }
        const Vec3 x = (longest - longest.dot(facet.normal) * facet.normal).normalized();
        sheet.frame = {facet.middle - 0.5 * m_stock.thickness * facet.normal, x,
                       facet.normal.cross(x)};
        for (const auto &loop : facet.loops) {
            sheet.rings.emplace_back();
            for (const FacetEdge &edge : loop)
                sheet.rings.back().push_back(sheet.frame.toLocal(m_mesh.positions()[edge.from]));
        }
        m_sheets.push_back(std::move(sheet));
    }
}

/// By how much a sheet is cut back from an edge, mm; the height of another one's plane above it is
/// of 1 mm away from there.
double FacetModeller::widthAt(double cosine, double height) const
{
    if (std::abs(height) < std::sin(kFlatEdge))
        return 0.0; // it goes on
    const double thickness = m_stock.thickness, plane = 0.5 * cutBack(thickness, cosine);
    const bool isOuter = height < 0.0;
    double width = isOuter ? 2.0 * plane : 0.0;
    // Where it has fingers it makes room for those of the other at once, so that others that start
    // at the same corner keep off it.
    if (std::abs(height) >= std::sin(kMinTabAngle - kTabAngleRounding))
        width += fingerCut(0.5 * thickness, 0.5 * thickness, cosine).back - plane;
    return width;
}

/// What the sheet beyond an edge takes off this one; empty: nothing.
Polygon FacetModeller::alongEdge(const Sheet &sheet, const Polygon &ring, std::size_t edge,
                                 const MeshFacet &beyond) const
{
    const std::size_t count = ring.size();
    const Vec2 &from = ring[edge], &to = ring[(edge + 1) % count];
    const Vec2 way = (to - from).normalized(), inwards = perpendicular(way);
    const Vec3 along = sheet.frame.directionToWorld(way);
    const Vec3 own = sheet.frame.directionToWorld(inwards), other = along.cross(beyond.normal);
    const Vec3 away = other - other.dot(along) * along; // into the other sheet, from the edge
    const double cosine = std::clamp(own.dot(away.normalized()), -1.0, 1.0);
    const double height = away.dot(sheet.facet->normal) / away.norm();
    const double width = widthAt(cosine, height);
    if (width <= kTouchingDepth)
        return {};
    // Past a corner that is blunt the other sheet goes on beside this one.
    const auto carriedOn = [&](const Vec2 &before, const Vec2 &after) {
        const double turn = std::atan2(cross(before, after), before.dot(after));
        if (turn <= 0.0)
            return width;
        return turn >= 0.5 * std::numbers::pi
                   ? 0.0
                   : width * std::min(kMostCarriedOn, 1.0 / std::tan(turn));
    };
    const double low = carriedOn(from - ring[(edge + count - 1) % count], to - from);
    const double high = carriedOn(to - from, ring[(edge + 2) % count] - to);
    const Vec2 begin = from - low * way, end = to + high * way;
    return {begin - kOverFacet * inwards, end - kOverFacet * inwards, end + width * inwards,
            begin + width * inwards};
}

bool FacetModeller::isBehind(const MeshFacet &one, const MeshFacet &plane) const
{
    for (const FacetEdge &edge : one.loops.front())
        if (plane.normal.dot(m_mesh.positions()[edge.from] - plane.middle) > kCoplanarDepth)
            return false;
    return true;
}

/// What a sheet with which it shares a vertex alone takes off it, of two that are each behind the
/// other's plane.
std::optional<Polygon> FacetModeller::atVertex(const Sheet &sheet, const MeshFacet &other) const
{
    const Vec3 &n = sheet.facet->normal;
    const double cosine = -n.dot(other.normal); // of the angle inside
    const Vec2 out = sheet.frame.directionToLocal(other.normal);
    if (out.norm() < std::sin(kFlatEdge) || !isBehind(*sheet.facet, other) ||
        !isBehind(other, *sheet.facet))
        return {};
    // Where the other's plane goes through this one's, in the plane of the mesh.
    const Vec3 onFace = sheet.frame.origin + 0.5 * m_stock.thickness * n;
    const double far = other.normal.dot(other.middle - onFace) / out.norm();
    const Vec2 way = out.normalized(), along = perpendicular(way);
    const double width = cutBack(m_stock.thickness, cosine);
    const Box2 box = bounds(sheet.rings.front());
    const double size = box.size().norm() + std::abs(far) + width + kOverFacet;
    return Polygon{(far - width) * way - size * along, (far + size) * way - size * along,
                   (far + size) * way + size * along, (far - width) * way + size * along};
}

void FacetModeller::cutToShape(Sheet &sheet, std::size_t index)
{
    std::vector<Polygon> cuts;
    std::set<std::size_t> beside, atVertices;
    for (std::size_t k = 0; k < sheet.rings.size(); ++k)
        for (std::size_t e = 0; e < sheet.rings[k].size(); ++e) {
            const FacetEdge &edge = sheet.facet->loops[k][e];
            const std::set<std::size_t> &there = m_atVertices[edge.from];
            atVertices.insert(there.begin(), there.end());
            if (edge.beyond < 0)
                continue;
            const auto beyond = static_cast<std::size_t>(edge.beyond);
            beside.insert(beyond);
            Polygon cut = alongEdge(sheet, sheet.rings[k], e, m_facets[beyond]);
            if (!cut.empty())
                cuts.push_back(std::move(cut));
        }
    beside.insert(index);
    for (const std::size_t other : atVertices)
        if (!beside.contains(other))
            if (std::optional<Polygon> cut = atVertex(sheet, m_facets[other]))
                cuts.push_back(*std::move(cut));
    const Result<Contour> drawn = Contour::fromPolygon(sheet.rings.front());
    const Result<ResolvedContour> outer =
        drawn ? resolveCrossings(*drawn) : Result<ResolvedContour>(tl::unexpected(drawn.error()));
    if (!outer)
        return;
    std::vector<Contour> holes;
    for (std::size_t k = 1; k < sheet.rings.size(); ++k)
        if (Result<Contour> hole = Contour::fromPolygon(sheet.rings[k]))
            holes.push_back(*std::move(hole));
    Result<std::vector<CurvedRegion>> pieces = subtract(outer->contour, holes, cuts, kCutChord);
    if (!pieces || pieces->empty() || pieces->front().outer.signedArea() < kSmallestFacet)
        return;
    if (Result<ShapePointer> shape =
            Shape::make(std::move(pieces->front().outer), std::move(pieces->front().holes)))
        sheet.shape = *std::move(shape);
}

Result<void> FacetModeller::addSections()
{
    std::vector<NewSection> sections;
    std::vector<Sheet *> made;
    for (Sheet &sheet : m_sheets) {
        if (!sheet.shape) {
            ++m_model.tooSmall;
            continue;
        }
        NewSection section;
        section.name = m_name + " " + std::to_string(sections.size() + 1);
        section.shape = sheet.shape;
        section.frame = sheet.frame;
        sections.push_back(std::move(section));
        made.push_back(&sheet);
    }
    if (sections.empty())
        return failure(ErrorCode::EmptyContour, m_name);
    const std::size_t first = m_model.document.sections.size();
    Result<Document> next = fff::addSections(std::move(m_model.document), std::move(sections));
    if (!next)
        return tl::unexpected(std::move(next.error()));
    m_model.document = *std::move(next);
    for (std::size_t i = 0; i < made.size(); ++i) {
        made[i]->id = m_model.document.sections[first + i]->id;
        m_model.sections.push_back(made[i]->id);
    }
    return {};
}

Result<void> FacetModeller::join()
{
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < m_facets.size(); ++i)
        for (const auto &loop : m_facets[i].loops)
            for (const FacetEdge &edge : loop)
                if (edge.beyond > static_cast<int>(i))
                    pairs.emplace(i, static_cast<std::size_t>(edge.beyond));
    for (const auto &[i, k] : pairs) {
        if (!m_sheets[i].shape || !m_sheets[k].shape)
            continue;
        const Section &a = *m_model.document.find(m_sheets[i].id);
        const Section &b = *m_model.document.find(m_sheets[k].id);
        if (const auto tabs = cutTabs({a, m_stock}, {b, m_stock}); !tabs) {
            m_model.bare.push_back({a.id, b.id, tabs.error()});
            continue;
        }
        JointOverride wanted;
        wanted.a = a.id;
        wanted.b = b.id;
        wanted.kind = JointKind::Tabs;
        Result<Document> next = setJointOverride(std::move(m_model.document), std::move(wanted));
        if (!next)
            return tl::unexpected(std::move(next.error()));
        m_model.document = *std::move(next);
        ++m_model.joints;
    }
    return {};
}

Result<FacetModel> FacetModeller::make(const LongWork &work)
{
    if (m_facets.size() > kMostFacets)
        return failure(ErrorCode::BadCount, m_name,
                       {std::to_string(m_facets.size()), std::to_string(kMostFacets)});
    place();
    for (std::size_t i = 0; i < m_sheets.size(); ++i) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        if (!m_sheets[i].rings.empty())
            cutToShape(m_sheets[i], i);
        work.tell(static_cast<double>(i + 1) / static_cast<double>(m_sheets.size()));
    }
    if (Result<void> added = addSections(); !added)
        return tl::unexpected(std::move(added.error()));
    if (Result<void> joined = join(); !joined)
        return tl::unexpected(std::move(joined.error()));
    return std::move(m_model);
}

} // namespace

Result<FacetModel> facetModel(Document document, const TriangleMesh &mesh, const std::string &name,
                              const LongWork &work)
{
    return FacetModeller(std::move(document), mesh, name).make(work);
}

} // namespace fff
