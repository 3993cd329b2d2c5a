#include "core/templates/cut_segments.h"

#include <algorithm>

namespace fff {

namespace {

class SegmentCollector
{
public:
    SegmentCollector(const std::vector<Triangle> &triangles, OnPlane onPlane)
        : m_triangles(triangles), m_onPlane(onPlane)
    {
    }

    /// sides: of its corners.
    void add(std::uint32_t face, int a, int b, int c)
    {
        if (a == 0 && b == 0 && c == 0)
            m_found.liesInPlane = true;
        const std::array isAbove = {this->isAbove(a), this->isAbove(b), this->isAbove(c)};
        const int above = int(isAbove[0]) + int(isAbove[1]) + int(isAbove[2]);
        if (above == 0 || above == 3)
            return;
        // The corner that is alone on its side; the others follow it counter-clockwise.
        const bool isLoneAbove = above == 1;
        const std::size_t lone =
            isAbove[0] == isLoneAbove ? 0 : (isAbove[1] == isLoneAbove ? 1 : 2);
        const Triangle &t = m_triangles[face];
        const CrossedEdge ahead = edge(t[lone], t[(lone + 1) % 3]);
        const CrossedEdge behind = edge(t[lone], t[(lone + 2) % 3]);
        m_found.segments.push_back(isLoneAbove ? CutSegment{ahead, behind, face}
                                               : CutSegment{behind, ahead, face});
    }

    /// The tree has an order of its own: what comes out must not depend on it.
    CutSegments take()
    {
        const auto byFace = [](const CutSegment &a, const CutSegment &b) {
            return a.face < b.face;
        };
        if (!std::is_sorted(m_found.segments.begin(), m_found.segments.end(), byFace))
            std::sort(m_found.segments.begin(), m_found.segments.end(), byFace);
        return std::move(m_found);
    }

private:
    bool isAbove(int side) const { return side > 0 || (side == 0 && m_onPlane == OnPlane::Above); }
    static CrossedEdge edge(std::uint32_t a, std::uint32_t b)
    {
        return {std::min(a, b), std::max(a, b)};
    }

    const std::vector<Triangle> &m_triangles;
    const OnPlane m_onPlane;
    CutSegments m_found;
};

} // namespace

CutSegments cutSegments(const TriangleMesh &mesh, const CutPlane &plane, OnPlane onPlane,
                        const MeshTree *tree)
{
    const std::vector<Vec3> &positions = mesh.positions();
    const std::vector<Triangle> &triangles = mesh.triangles();
    const PlaneSides sides(plane);
    SegmentCollector collector(triangles, onPlane);
    if (tree) {
        tree->meeting(plane, [&](std::uint32_t face) {
            const Triangle &t = triangles[face];
            collector.add(face, sides.of(positions[t[0]]), sides.of(positions[t[1]]),
                          sides.of(positions[t[2]]));
        });
        return collector.take();
    }
    std::vector<std::int8_t> known(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        known[i] = static_cast<std::int8_t>(sides.of(positions[i]));
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const Triangle &t = triangles[f];
        const int a = known[t[0]], b = known[t[1]], c = known[t[2]];
        if (a != b || b != c || a == 0)
            collector.add(static_cast<std::uint32_t>(f), a, b, c);
    }
    return collector.take();
}

} // namespace fff
