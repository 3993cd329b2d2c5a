// What there is at a place of the screen, and which camera goes with it: for gestures, clicks and
// hovering alike.
#pragma once

#include "core/interaction/pick.h"
#include "core/interaction/problem_marks.h"
#include "core/interaction/view_cube.h"

#include <optional>
#include <span>
#include <vector>

namespace fff {

/// A model as it is seen now. Refers to what it is made of; make one when it is asked.
struct Sight
{
    const Model &model;
    const Camera &camera;
    const Vec2 &viewport; // px
    const ViewState &view;
    std::span<const ProblemMark> marks;
    std::span<const Box2> covered = {}; // by what stands over the view, px

    /// Sections under the place (px), nearest first.
    std::vector<Hit> hitsAt(const Vec2 &position) const;
    /// Whether the section is seen so much on edge there that points on it are guesses.
    bool isOnEdge(const Hit &hit) const;
    /// On the handle of the plane that cuts the view open.
    bool isOnHandle(const Vec2 &position) const;
    std::optional<CubePart> cubePartAt(const Vec2 &position) const;
    /// The mark of a problem that is there; none: there is none.
    std::optional<PlacedMark> markAt(const Vec2 &position) const;
    /// It has a number there; a dot is in nobody's way.
    bool isOnNumber(const Vec2 &position) const;

    /// What a turn that begins there turns about: what lies there, else the middle of the model.
    Vec3 pivotAt(const Vec2 &position) const;
    /// The same view; in perspective, pixels count at the depth of what is there.
    Camera cameraAt(const Vec2 &position) const;
    /// The middle of those sections that exist; of the model when there are none, and where the
    /// first section will be when that is empty. World, mm.
    Vec3 middleOf(const std::vector<SectionRef> &sections) const;
};

} // namespace fff
