#include "core/skin/skin.h"

#include "core/skin/contour_network.h"
#include "core/skin/cycle_filling.h"
#include "core/skin/network_curves.h"
#include "core/skin/patch_judge.h"
#include "core/skin/ring_tubes.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace fff {

namespace {

/// How much of the time it takes to find where outlines meet.
constexpr double kMeetingShare = 0.4;

LongWork partOf(const LongWork &work, double from, double to)
{
    return {work.stop, [&work, from, to](double share) { work.tell(from + share * (to - from)); }};
}

std::optional<OpenPlace::Why> whyOpen(PatchFault fault)
{
    switch (fault) {
    case PatchFault::None:
        break;
    case PatchFault::FarOut:
    case PatchFault::Balloon:
        return OpenPlace::Why::Bulging;
    case PatchFault::Folded:
        return OpenPlace::Why::Folded;
    }
    return std::nullopt;
}

/// How often the cycle comes along an edge that it has been along.
std::size_t repeats(const std::vector<HalfEdge> &cycle)
{
    std::set<int> edges;
    for (const HalfEdge half : cycle)
        edges.insert(half / 2);
    return cycle.size() - edges.size();
}

/// A tube between two closed outlines comes back along the edge that joins them. What comes back
/// along more than one is no form of its own.
bool isPatch(const std::vector<HalfEdge> &cycle)
{
    const std::size_t again = repeats(cycle);
    return cycle.size() >= 2 && cycle.size() <= kMostSidesSeenWhole &&
           (again == 0 || (again == 1 && cycle.size() == 4));
}

/// Nothing: there is a patch.
std::optional<OpenPlace::Why> openOver(GrowingMesh &mesh, const std::vector<HalfEdge> &cycle,
                                       const ContourNetwork &network,
                                       const std::vector<SkinCurve> &curves)
{
    using Why = OpenPlace::Why;
    if (cycle.size() == 1) {
        const NetEdge &edge = network.edges[static_cast<std::size_t>(cycle.front() / 2)];
        const bool isFilled =
            fillFlat(mesh, walked(curves, cycle.front()),
                     network.outlines[static_cast<std::size_t>(edge.outline)].frame());
        return isFilled ? std::nullopt : std::optional(Why::Folded);
    }
    if (!isPatch(cycle))
        return Why::NoForm;
    std::vector<SkinCurve> sides;
    for (const HalfEdge half : cycle)
        sides.push_back(walked(curves, half));
    if (sides.size() > kMostSides && !isSeenWhole(sides))
        return Why::NoForm;
    PatchJudge judge(mesh);
    fillCycle(mesh, sides);
    return whyOpen(judge.faultOf(sides));
}

std::vector<int> sectionsOf(const std::vector<HalfEdge> &cycle, const ContourNetwork &network)
{
    std::set<int> sections;
    for (const HalfEdge half : cycle)
        sections.insert(network.edges[static_cast<std::size_t>(half / 2)].outline);
    return {sections.begin(), sections.end()};
}

/// Without vertices that no triangle has.
TriangleMeshPointer meshOf(const GrowingMesh &grown)
{
    constexpr std::uint32_t kUnused = ~std::uint32_t(0);
    std::vector<std::uint32_t> at(grown.points.size(), kUnused);
    std::vector<Vec3> points;
    std::vector<Triangle> triangles = grown.triangles;
    for (Triangle &triangle : triangles)
        for (std::uint32_t &corner : triangle) {
            if (at[corner] == kUnused) {
                at[corner] = static_cast<std::uint32_t>(points.size());
                points.push_back(grown.points[corner]);
            }
            corner = at[corner];
        }
    return std::make_shared<const TriangleMesh>(std::move(points), std::move(triangles), 1.0);
}

} // namespace

Error noSkin(const Skin &skin)
{
    Error error{ErrorCode::NoSkin, {}, {}};
    if (skin.open > 0)
        error.args.push_back(std::to_string(skin.open));
    return error;
}

Result<Skin> skinOf(const std::vector<SectionPointer> &sections, const LongWork &work)
{
    const Result<ContourNetwork> network =
        contourNetwork(sections, partOf(work, 0.0, kMeetingShare));
    if (!network)
        return tl::unexpected(network.error());
    GrowingMesh mesh;
    const std::vector<SkinCurve> curves = networkCurves(*network, mesh);
    const std::vector<std::vector<HalfEdge>> cycles = cyclesOf(*network);
    const LongWork filling = partOf(work, kMeetingShare, 1.0);
    Skin skin;
    for (std::size_t c = 0; c < cycles.size(); ++c) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        if (const auto why = openOver(mesh, cycles[c], *network, curves))
            skin.places.push_back({*why, sectionsOf(cycles[c], *network)});
        else
            ++skin.patches;
        filling.tell(static_cast<double>(c) / static_cast<double>(cycles.size()));
    }
    const Result<std::vector<RingPair>> pairs = ringPairs(sections, *network, work);
    if (!pairs)
        return tl::unexpected(pairs.error());
    const FilledTubes tubes = fillTubes(mesh, *pairs, *network);
    skin.patches += tubes.patches;
    for (const OpenTube &tube : tubes.open)
        if (const auto why = whyOpen(tube.fault))
            skin.places.push_back({*why, {std::min(tube.a, tube.b), std::max(tube.a, tube.b)}});
    std::stable_sort(
        skin.places.begin(), skin.places.end(),
        [](const OpenPlace &a, const OpenPlace &b) { return a.sections < b.sections; });
    skin.open = static_cast<int>(skin.places.size());
    if (!mesh.triangles.empty())
        skin.mesh = meshOf(mesh);
    return skin;
}

} // namespace fff
