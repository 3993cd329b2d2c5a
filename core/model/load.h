// What acts on sections besides their own weight: masses that hang there or lie on them, and
// pushes.
#pragma once

#include "core/model/section.h"

#include <string>

namespace fff {

inline constexpr double kMaxWeight = 1e6; // kg
inline constexpr double kMaxPush = 1e6;   // N
/// Of a patch or an edge, mm.
inline constexpr double kLeastSpread = 1.0, kMostSpread = 1e4;

enum class LoadKind {
    Weight, // a mass
    Push,   // a force that is no mass: a hand, a string, wind
};

/// What of a section a load acts on.
enum class Spread {
    Point,   // its place
    Patch,   // what the section has of a disc about its place
    Edge,    // a stretch of its edge, about what is nearest to its place
    Hanging, // its place, by a string: the mass is below it
};

struct Load
{
    LoadId id;
    SectionRef section;
    Vec2 position = Vec2::Zero(); // frame coordinates of the section, mm
    double mass = 0.35;           // kg, with what is filled in; of a weight
    std::string name = {};        // may be empty: it has none of its own
    LoadKind kind = LoadKind::Weight;
    Vec3 push = Vec3::Zero();      // N, along x, y and the normal of the section's frame; of a push
    Spread spread = Spread::Point; // of a push not Hanging
    double width = 20.0;           // mm: diameter of a patch, length of an edge
    double height = 0.0;           // mm: its centre of mass is so far above its place
    std::string preset = {};       // key of what it was taken for (load_presets.h); may be empty
    double filled = 0.0;           // kg of its mass: what a vessel has been filled with
    bool isRepeated = true;        // copies that operations make of its section carry it, too

    bool isPush() const { return kind == LoadKind::Push; }
    bool operator==(const Load &other) const
    {
        return id == other.id && section == other.section && position == other.position &&
               mass == other.mass && name == other.name && kind == other.kind &&
               push == other.push && spread == other.spread && width == other.width &&
               height == other.height && preset == other.preset && filled == other.filled &&
               isRepeated == other.isRepeated;
    }
};

} // namespace fff
