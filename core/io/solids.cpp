#include "core/io/solids.h"

#include "core/base/groups.h"
#include "core/fabrication/layout.h"
#include "core/fabrication/wholeness.h"

#include <QtCore/QCoreApplication>

#include <map>
#include <utility>

namespace fff::io {

namespace {

constexpr const char *kPartsOption = "parts";
constexpr double kBetweenSheets = 10.0; // mm

/// Corners of triangles are the same vertex when triangles on shared edges lead from one to the
/// other; a point whose triangles fall into several such fans becomes several vertices.
Cap makeCap(const Triangulation &triangulation)
{
    const std::size_t count = triangulation.triangles.size();
    Groups fans(3 * count);
    std::map<std::array<int, 2>, std::size_t> edges; // directed edge of points -> its first corner
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            edges[{triangulation.triangles[t][k], triangulation.triangles[t][(k + 1) % 3]}] =
                3 * t + k;
    const auto following = [](std::size_t corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    };
    for (const auto &[edge, corner] : edges) {
        const auto opposite = edges.find({edge[1], edge[0]});
        if (opposite == edges.end())
            continue;
        fans.join(corner, following(opposite->second));
        fans.join(following(corner), opposite->second);
    }
    Cap cap;
    std::vector<int> vertexOf(3 * count, -1);
    const auto vertex = [&](std::size_t corner) {
        const std::size_t first = fans.firstOf(corner);
        if (vertexOf[first] < 0) {
            vertexOf[first] = static_cast<int>(cap.vertices.size());
            cap.vertices.push_back(triangulation.points[static_cast<std::size_t>(
                triangulation.triangles[corner / 3][corner % 3])]);
        }
        return vertexOf[first];
    };
    for (std::size_t t = 0; t < count; ++t)
        cap.triangles.push_back({vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)});
    for (const auto &[edge, corner] : edges)
        if (!edges.contains({edge[1], edge[0]}))
            cap.boundary.push_back({vertex(corner), vertex(following(corner))});
    return cap;
}

/// Both faces and the wall between them; `place` puts a point of the cap where it is, at a height
/// of the part, 0 … 1.
template <class Place>
PartSolid solidOf(const Cap &cap, const std::string &name, const Place &place)
{
    PartSolid solid{name, {}, {}};
    const auto count = static_cast<std::uint32_t>(cap.vertices.size());
    solid.vertices.reserve(2 * count);
    for (const double height : {1.0, 0.0})
        for (const Vec2 &p : cap.vertices)
            solid.vertices.push_back(place(p, height));
    solid.triangles.reserve(2 * (cap.triangles.size() + cap.boundary.size()));
    const auto add = [&solid](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        solid.triangles.push_back({a, b, c});
    };
    for (const auto &corners : cap.triangles) {
        const auto a = static_cast<std::uint32_t>(corners[0]),
                   b = static_cast<std::uint32_t>(corners[1]),
                   c = static_cast<std::uint32_t>(corners[2]);
        add(a, b, c);
        add(count + c, count + b, count + a);
    }
    for (const auto &edge : cap.boundary) {
        const auto a = static_cast<std::uint32_t>(edge[0]), b = static_cast<std::uint32_t>(edge[1]);
        add(count + a, count + b, b);
        add(count + a, b, a);
    }
    return solid;
}

PartSolid standing(const Body &body, const std::string &name)
{
    const Frame &frame = body.frame();
    const Vec3 up = body.thickness() * frame.normal();
    return solidOf(capOf(body), name, [&](const Vec2 &p, double height) {
        const Vec3 world = frame.toWorld(p) + (height - 0.5) * up;
        return Vec3(world.x(), -world.z(), world.y());
    });
}

std::vector<PartSolid> onSheets(const Model &model, const Bodies &bodies)
{
    std::vector<Part> parts(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        parts[i].section = bodies.sectionOf(static_cast<int>(i));
        parts[i].stock = model.stockOf(static_cast<std::size_t>(parts[i].section)).id;
        parts[i].outline = bodies[i].outline();
    }
    std::vector<PartSolid> solids(bodies.size());
    double top = 0.0;
    for (const Sheet &sheet : layOut(parts, model, LayoutOptions()).sheets) {
        for (const Placement &placement : sheet.placements) {
            const auto index = static_cast<std::size_t>(placement.part);
            const Body &body = bodies[index];
            const auto section = static_cast<std::size_t>(parts[index].section);
            solids[index] = solidOf(
                capOf(body), model.section(section)->name, [&](const Vec2 &p, double height) {
                    const Vec2 flat = placement.apply(p);
                    return Vec3(flat.x(), top + flat.y(), height * body.thickness());
                });
        }
        top += sheet.size.y() + kBetweenSheets;
    }
    return solids;
}

} // namespace

Cap capOf(const Body &body)
{
    return makeCap((*body.cut()->triangulations())[body.piece()]);
}

Result<std::vector<PartSolid>> partSolids(const Model &model, const Bodies &bodies, Lying lying)
{
    if (const Result<void> known = haveSolids(model, bodies); !known)
        return tl::unexpected(known.error());
    if (lying == Lying::OnSheets)
        return onSheets(model, bodies);
    std::vector<PartSolid> solids;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const auto section = static_cast<std::size_t>(bodies.sectionOf(static_cast<int>(i)));
        solids.push_back(standing(bodies[i], model.section(section)->name));
    }
    return solids;
}

FormatOption lyingOption(const char *title)
{
    return {.name = kPartsOption,
            .value = "HOW",
            .help =
                QT_TRANSLATE_NOOP("CommandLine", "How parts lie in an STL or 3MF file: in-place, "
                                                 "or flat on their sheets (in-place)."),
            .choices = {{.name = "in-place"}, {.name = "flat", .title = title}}};
}

Lying lyingOf(const FormatValues &values)
{
    return valueOf(values, kPartsOption, 0.0) == 0.0 ? Lying::InPlace : Lying::OnSheets;
}

} // namespace fff::io
