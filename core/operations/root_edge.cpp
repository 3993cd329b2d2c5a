#include "core/operations/root_edge.h"

#include "core/geometry/arc_length.h"
#include "core/geometry/contour_points.h"

namespace fff {

using Hold = SourceCrossing::Hold;

const Contour &boundaryOf(const Section &root, int ring)
{
    return ring == 0 ? root.shape->contour()
                     : root.shape->holes()[static_cast<std::size_t>(ring - 1)];
}

bool leavesHigh(const SourceCrossing &source)
{
    if (source.hold != Hold::Middle)
        return source.hold == Hold::High;
    const Overlap &o = source.overlap;
    return o.b.to.at - o.a.to.at > o.a.from.at - o.b.from.at;
}

RootEdge edgeOf(const Section &root, const SourceCrossing &source, bool isHigh)
{
    const AxisEnd &end = isHigh ? source.overlap.a.to : source.overlap.a.from;
    const Contour &boundary = boundaryOf(root, end.ring);
    // The end lies on a chord: the curve itself is near.
    const NearestPlace place = nearestPlace(boundary, source.line.at(end.at));
    RootEdge edge;
    edge.ring = end.ring;
    edge.at = place.at;
    edge.point = positionAt(boundary, place.at);
    edge.tangent = directionAt(boundary, place.at);
    edge.outwards = isHigh ? source.line.direction : Vec2(-source.line.direction);
    return edge;
}

} // namespace fff
