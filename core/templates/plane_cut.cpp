#include "core/templates/plane_cut.h"

#include "core/templates/chain_closing.h"
#include "core/templates/loop_nesting.h"
#include "core/templates/united_loops.h"

#include <algorithm>

namespace fff {

void CutLoop::reverse()
{
    std::reverse(points.begin(), points.end());
    // From its other end; what led back to the first point begins there, and that is the last now.
    for (Bridge &bridge : bridges) {
        const std::size_t to = (bridge.from + bridge.chords) % points.size();
        bridge.from = points.size() - 1 - to;
    }
    std::reverse(bridges.begin(), bridges.end());
}

double PlaneCut::area() const
{
    double sum = 0.0;
    for (const CutLoop &loop : loops)
        sum += loop.isHole ? -loop.area : loop.area;
    return sum;
}

std::size_t PlaneCut::bridges() const
{
    std::size_t count = 0;
    for (const CutLoop &loop : loops)
        count += loop.bridges.size();
    return count;
}

std::vector<Message> PlaneCut::messages() const
{
    const std::size_t count = bridges();
    if (count == 0)
        return {};
    if (count == 1)
        return {{FFF_TEXT("Mesh", "A gap in the cut was closed by a smooth curve."), {}, {}}};
    return {{FFF_TEXT_OF_MANY("Mesh", "%n gaps in the cut were closed by smooth curves."),
             {},
             static_cast<int>(count)}};
}

PlaneCut planeCut(const TriangleMesh &mesh, const CutPlane &plane, const MeshTree *tree)
{
    const auto cutWith = [&](const CutSegments &found) {
        PlaneCut cut{plane, closedChains(cutChains(mesh, plane, found.segments), plane)};
        const Frame frame = frameOn(plane);
        nestLoops(cut.loops, frame);
        uniteLoops(cut.loops, frame);
        return cut;
    };
    const CutSegments below = cutSegments(mesh, plane, OnPlane::Above, tree);
    PlaneCut cut = cutWith(below);
    if (below.liesInPlane) {
        PlaneCut other = cutWith(cutSegments(mesh, plane, OnPlane::Below, tree));
        if (other.area() > cut.area())
            cut = std::move(other);
    }
    return cut;
}

} // namespace fff
