// What weights stand for, as it is seen over the model: a glass, a book, cutlery, a plain block.
#pragma once

#include "core/model/placed_loads.h"
#include "core/model/section.h"

#include <QColor>

#include <array>
#include <vector>

namespace fff::ui {

/// A weight that is to be seen where it acts.
struct SceneThing
{
    std::string preset;         // of its load; one that has no look is a block
    double mass = 0.0;          // kg, for the size of a block
    double filled = 0.0;        // kg of water
    Vec3 at = Vec3::Zero();     // where it stands, or by which it hangs; world, mm
    Vec3 along = Vec3::UnitX(); // unit, horizontal: its width
    int section = -1;           // that carries it, in the scene
    bool isHidden = false;

    bool operator==(const SceneThing &) const = default;
};

/// Those of all weights of a model, in the order of placedLoads(): none where there are more than
/// kMostThings, which nobody could tell from each other.
std::vector<SceneThing> thingsOf(const Model &model);
inline constexpr std::size_t kMostThings = 64;

struct ThingVertex
{
    std::array<float, 3> position; // world, mm
    std::array<float, 3> normal;   // unit, out of it
    std::array<float, 4> colour;   // 0 … 1, not premultiplied
};

/// Triangles, three vertices each, counter-clockwise from without.
void addTriangles(const SceneThing &thing, std::vector<ThingVertex> &vertices);
/// Their corners, of those that are not hidden; world, mm.
std::vector<Vec3> cornersOf(const std::vector<SceneThing> &things);

} // namespace fff::ui
