// Where the marks of loads are: the place that one acts on, and the tip of a push's arrow.
#pragma once

#include "core/interaction/gesture.h"
#include "core/model/placed_loads.h"

#include <optional>

namespace fff {

/// A load that the cursor is over, where it is: it may be on a copy of its section.
struct LoadAt
{
    LoadId id;
    SectionRef section;
    Vec2 position = Vec2::Zero(); // there, frame coordinates, mm
    Vec3 push = Vec3::Zero();     // there, N
    bool isTip = false;           // of its arrow
    Vec2 grip = Vec2::Zero();     // px: from where it is held to its place, or its tip
};

/// Within reach of the position, by its mark, by what stands there, or by its words; nothing where
/// there is none, or its section is hidden.
std::optional<LoadAt> loadAt(const Vec2 &position, const GestureContext &context);

/// px that the arrow of a push is long, and the push whose arrow is: ten times the force is so much
/// more.
double arrowLength(double force);
double forceOfArrow(double length);

/// In the world: of a push on that section, and the other way round.
Vec3 pushInWorld(const Vec3 &push, const Frame &frame);
Vec3 pushInFrame(const Vec3 &push, const Frame &frame);

/// What is drawn of it: a mark, and of a push its arrow.
void addLoadMark(const Load &load, const PlacedLoad &placed, const Model &model, SignRole role,
                 Signs &signs);
/// Its name and how much it is: words come after all marks, which they keep off.
void addLoadWords(const Load &load, const PlacedLoad &placed, const Model &model, SignRole role,
                  Signs &signs);

} // namespace fff
