// What moving sections are drawn to: places where points of theirs are level with points of others,
// or with the middle of the world, along an axis.
#pragma once

#include "core/interaction/view_state.h"
#include "core/model/model.h"

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace fff {

class Alignment
{
public:
    /// moved: the sections whose points are to come level; along: what else moves then, and is
    /// nothing to be level with. Points are those of their contours and holes, and the middle of
    /// each; of what is seen of all others the same, and the world's origin.
    Alignment(const Model &model, const ViewState &view, const std::set<SectionRef> &moved,
              const std::set<SectionRef> &along);
    /// Of what is no section: these points of it, world.
    Alignment(const Model &model, const ViewState &view, std::vector<Vec3> own);

    struct Caught
    {
        double way = 0.0; // mm along the axis
        Vec3 own, other;  // own: where it is then
    };
    /// The same along one axis (unit): a drag asks for it with each move, so that the others are
    /// put in order once. O(own points · log of the others) each time.
    class Line
    {
    public:
        Line(const Alignment &alignment, const Vec3 &axis);
        /// The way nearest to `way`, within reach (mm), by which points that were moved by
        /// `before` come level with others.
        std::optional<Caught> nearest(double way, double reach,
                                      const Vec3 &before = Vec3::Zero()) const;

    private:
        Vec3 m_axis;
        std::vector<Vec3> m_own;
        std::vector<std::pair<double, Vec3>> m_others; // by their places on the axis
    };

private:
    std::vector<Vec3> m_own, m_others;
};

} // namespace fff
