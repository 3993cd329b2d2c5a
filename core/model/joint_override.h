// What a person wants of a joint in place of what follows from its geometry.
#pragma once

#include "core/model/section.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

enum class JointKind {
    CrossLap,         // two half slits, each open where its section ends
    ExtendedCrossLap, // one section reaches beyond the other: its slit runs from its contour to the
                      // meeting point
    Mortise,          // one closed slit, the other section passes through uncut
    Tabs,             // one section ends on the other's face, with tabs that reach through slots;
                      // or both end at a corner, with fingers between each other
    None,             // they meet but no slit lets them slide together: they collide
};

/// Of two sections, whether they meet now or not: what cannot be had just now is dormant, and what
/// is not said is as by itself.
struct JointOverride
{
    /// How much of an overlap one of the two slits takes.
    struct Share
    {
        Vec2 at = Vec2::Zero(); // in the overlap, frame coordinates of a
        double ofA = 0.5;       // kLeastShare … 1 − kLeastShare

        bool operator==(const Share &other) const { return at == other.at && ofA == other.ofA; }
    };

    SectionRef a, b;               // a < b
    std::optional<JointKind> kind; // CrossLap stands for the extended one too
    std::optional<Vec2> opens;     // where a's slit opens to, unit, frame coordinates of a
    std::vector<Share> shares;     // at most one an overlap

    bool isEmpty() const { return !kind && !opens && shares.empty(); }
    bool operator==(const JointOverride &other) const
    {
        return a == other.a && b == other.b && kind == other.kind && opens == other.opens &&
               shares == other.shares;
    }
};

using JointOverridePointer = std::shared_ptr<const JointOverride>;

/// A slit that takes less of an overlap holds nothing.
inline constexpr double kLeastShare = 0.05;
/// Shares that differ by less are one.
inline constexpr double kSameShare = 1e-9;

} // namespace fff
