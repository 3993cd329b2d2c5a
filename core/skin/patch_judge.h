// Whether a patch is part of a form, or folds over itself between contours that suggest none.
#pragma once

#include "core/skin/skin_curve.h"

#include <cstdint>
#include <map>
#include <vector>

namespace fff {

/// Why a patch is not part of a form.
enum class PatchFault {
    None,
    FarOut,  // it reaches far beyond the contours round it
    Folded,  // its outside is not where the sections have theirs
    Balloon, // it stands out from among the contours
};

/// Fills in a part of the skin and keeps it only if it is sound.
class PatchJudge
{
public:
    /// Of what is added to the mesh from now on.
    explicit PatchJudge(GrowingMesh &mesh)
        : m_mesh(mesh), m_points(mesh.points.size()), m_triangles(mesh.triangles.size())
    {
    }

    /// Stays near the contours round it, does not stand out from among them like a balloon, and has
    /// its outside where the sections have theirs along most of their length; else the mesh is as
    /// it was before.
    bool keeps(const std::vector<SkinCurve> &sides) { return faultOf(sides) == PatchFault::None; }
    /// The same, and why it is not kept.
    PatchFault faultOf(const std::vector<SkinCurve> &sides);

private:
    using Normals = std::map<std::uint32_t, Vec3>; // of the patch, at its vertices; of any length

    PatchFault found(const std::vector<SkinCurve> &sides) const;
    Normals normalsOfPatch() const;
    bool staysNear(const std::vector<SkinCurve> &sides) const;
    bool facesOutwards(const std::vector<SkinCurve> &sides, const Normals &normals) const;
    bool isBalloon(const std::vector<SkinCurve> &sides, const Normals &normals) const;

    GrowingMesh &m_mesh;
    std::size_t m_points, m_triangles; // that were there before
};

} // namespace fff
