// What the checks of a model keep of each section for the next time, so that an edit costs the work
// on the sections that it touches.
#pragma once

#include "core/analysis/captives.h"
#include "core/fabrication/layout.h"

#include <memory>
#include <vector>

namespace fff {

/// Not for several threads at once.
struct CheckCaches
{
    struct OfSection
    {
        // What the rest was worked out of.
        std::vector<BodyPointer> bodies;
        double kerf = 0.0; // mm
        Vec2 room = Vec2::Zero();
        bool turnsFreely = true;

        int contactsSince = 0;                                 // number of the check since when
                                                               // they touch the ground as now
        std::vector<std::shared_ptr<const OutlineSize>> sizes; // of each body, with the kerf
    };
    /// How far it is to the bodies that are not in the group.
    struct OfGroup
    {
        std::vector<int> group; // indices of bodies
        Box3 box;               // of all of them

        double distance = std::numeric_limits<double>::infinity(); // mm; infinite: nothing there
        int other = -1;                                            // section of the nearest
        Vec3 at = Vec3::Zero();                                    // of the group, nearest to it
    };

    /// What of a group is on the ground.
    struct OfStance
    {
        std::vector<int> group; // indices of bodies
        int since = 0;          // number of the check

        GroundContact contact; // with the corners of the hull only
    };

    std::vector<OfSection> sections; // by index in the model
    std::vector<OfStance> stances;   // in the order of the groups
    int count = 0;                   // of checks
    std::vector<OfGroup> gaps;       // of loose groups
    LayoutCache layout;
    CaptiveCache captives;
};

/// Works out what is not known of the sections of this model, and forgets of groups what they may
/// have changed.
void refreshCaches(const Analysis &analysis, const LayoutOptions &options, CheckCaches &caches);

} // namespace fff
