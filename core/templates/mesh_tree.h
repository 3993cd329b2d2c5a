// The triangles of a mesh in boxes, so that a cut costs what it meets.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/templates/cut_plane.h"
#include "core/templates/triangle_mesh.h"

#include <memory>
#include <vector>

namespace fff {

/// Triangles in the order of a curve that fills space, eight to a leaf, and boxes over these, four
/// to a box of the next level: flat arrays, made in one pass, with nothing to balance.
/// Source  C. Lauterbach et al. 2009, Fast BVH Construction on GPUs, Eurographics, section 3.
class MeshTree
{
public:
    /// Of a mesh that outlives the tree. O(n). Errors  Cancelled.
    static Result<MeshTree> make(const TriangleMesh &mesh, const LongWork &work = {});

    /// Of a mesh with the same triangles whose vertices lie elsewhere: in the order of this one,
    /// which is shared, with boxes of their own. What is near in this mesh and far in that one has
    /// larger boxes, and costs more than it meets. O(n), a small part of making one.
    MeshTree refitted(const TriangleMesh &mesh) const;

    /// Calls visit(face) for each face of the mesh that may meet the plane, and for none twice:
    /// those that do, and some beside them.
    template <class Visit>
    void meeting(const CutPlane &plane, Visit visit) const
    {
        const PlaneTest test = testOf(plane);
        search(m_levels.size() - 1, 0, m_levels.back().size(), test, visit);
    }

    std::size_t bytes() const;

private:
    /// About the middle of the mesh; rounded outwards.
    struct Box
    {
        std::array<float, 3> low{}, high{};
    };
    struct PlaneTest
    {
        Vec3 normal = Vec3::Zero(), size = Vec3::Zero(); // the normal, and its absolute values
        double offset = 0.0, slack = 0.0;                // N·O; by how much rounding may err
        bool meets(const Box &box) const
        {
            double middle = -2.0 * offset, reach = slack;
            for (std::size_t i = 0; i < 3; ++i) {
                const double low = box.low[i], high = box.high[i];
                middle += normal[static_cast<int>(i)] * (low + high);
                reach += size[static_cast<int>(i)] * (high - low);
            }
            return std::abs(middle) <= reach;
        }
    };
    static constexpr std::size_t kLeafFaces = 8, kFanOut = 4;

    PlaneTest testOf(const CutPlane &plane) const;
    /// Boxes about the triangles, which are in order.
    void fit(const TriangleMesh &mesh);

    /// Of boxes [first, end) of a level.
    template <class Visit>
    void search(std::size_t level, std::size_t first, std::size_t end, const PlaneTest &test,
                Visit &visit) const
    {
        const std::vector<Box> &boxes = m_levels[level];
        for (std::size_t i = first; i < end; ++i) {
            if (!test.meets(boxes[i]))
                continue;
            if (level > 0) {
                search(level - 1, kFanOut * i,
                       std::min(kFanOut * (i + 1), m_levels[level - 1].size()), test, visit);
                continue;
            }
            const std::size_t last = std::min(kLeafFaces * (i + 1), m_order->size());
            for (std::size_t f = kLeafFaces * i; f < last; ++f)
                visit((*m_order)[f]);
        }
    }

    Vec3 m_middle = Vec3::Zero();
    std::shared_ptr<const std::vector<std::uint32_t>> m_order; // faces
    std::vector<std::vector<Box>> m_levels;                    // leaves first
};

} // namespace fff
