// How the model is looked at, besides the camera: what is hidden, stands back or is seen through.
// Belongs to the view, never to the document. Sections that do not exist now stay listed: undo may
// bring them back.
#pragma once

#include "core/geometry/vector.h"
#include "core/model/section.h"

#include <optional>
#include <set>

namespace fff {

/// Cuts the view open: what lies on the side that the normal points to is not seen.
struct ClipPlane
{
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); // unit

    double height(const Vec3 &p) const { return normal.dot(p - point); }
    bool operator==(const ClipPlane &other) const
    {
        return point == other.point && normal == other.normal;
    }
};

struct ViewState
{
    bool isXray = false;
    bool hasGround = true;         // grid, ground line and shadow
    bool showsStress = false;      // the weakest cross-sections
    std::set<SectionRef> isolated; // not empty: all others stand back as ghosts
    std::set<SectionRef> hidden;   // neither drawn nor picked
    std::set<SectionRef> problems; // drawn red and hatched: of the problem that is looked at
    std::set<SectionRef> faulty;   // a red outline only: of what the cursor is on, and feet
    std::set<SectionRef> doubtful; // of both, those of a warning: amber in place of red
    std::optional<ClipPlane> clip;

    bool isHidden(const SectionRef &ref) const { return hidden.count(ref) > 0; }
    bool isGhost(const SectionRef &ref) const
    {
        return !isolated.empty() && isolated.count(ref) == 0;
    }
    /// Ghosts are looked through, by the cursor too.
    bool isPicked(const SectionRef &ref) const { return !isHidden(ref) && !isGhost(ref); }
    bool picksAll() const { return hidden.empty() && isolated.empty(); }
    bool operator==(const ViewState &other) const = default;
};

} // namespace fff
