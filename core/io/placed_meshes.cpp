#include "core/io/placed_meshes.h"

namespace fff::io {

bool addPlaced(MeshBuilder &builder, const MeshDraft &part, const Eigen::Affine3d &place)
{
    MeshDraft &draft = builder.draft;
    const std::uint64_t first = draft.positions.size();
    // Nothing of this is more than what is in memory already, but it may be placed very often.
    if (!builder.expectTriangles(draft.triangles.size() + part.triangles.size(), 0,
                                 std::numeric_limits<std::uint64_t>::max(), {}) ||
        !builder.expectVertices(first + part.positions.size(), 0,
                                std::numeric_limits<std::uint64_t>::max(), {}))
        return false;
    for (const Vec3 &p : part.positions)
        draft.positions.push_back(place * p);
    const bool isMirrored = place.linear().determinant() < 0.0;
    for (const Triangle &t : part.triangles) {
        Triangle moved{};
        for (std::size_t i = 0; i < 3; ++i)
            moved[i] =
                t[i] < part.positions.size() ? static_cast<std::uint32_t>(first + t[i]) : kNoVertex;
        if (isMirrored)
            std::swap(moved[1], moved[2]);
        builder.addTriangle(moved[0], moved[1], moved[2]);
    }
    return !builder.failed();
}

} // namespace fff::io
