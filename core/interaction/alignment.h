// What moving sections are drawn to: places where points of theirs are level with points of others,
// or with the middle of the world, along an axis.
#pragma once

#include "core/interaction/view_state.h"
#include "core/model/model.h"

#include <optional>
#include <set>
#include <vector>

namespace fff {

class Alignment
{
public:
    /// Nothing to align with.
    Alignment() = default;
    /// moved: the sections that move. Points are those of their contours and holes, and the middle
    /// of each; of what is seen of all others the same, and the world's origin.
    Alignment(const Model &model, const ViewState &view, const std::set<SectionRef> &moved);

    struct Caught
    {
        double way = 0.0; // mm along the axis
        Vec3 own, other;  // own: where it is then
    };
    /// The way nearest to `way`, within reach (mm), by which points that were moved by `before`
    /// come level with others. axis: unit.
    std::optional<Caught> nearest(const Vec3 &axis, double way, double reach,
                                  const Vec3 &before = Vec3::Zero()) const;

private:
    std::vector<Vec3> m_own, m_others;
};

} // namespace fff
