// Which control point, handle or piece of contour lies under the cursor.
#pragma once

#include "core/interaction/point_selection.h"
#include "core/interaction/selection.h"
#include "core/interaction/sight.h"

#include <optional>
#include <vector>

namespace fff {

/// What of a contour can be dragged.
struct PointTarget
{
    enum class Kind { Anchor, Handle, Line };

    Kind kind = Kind::Anchor;
    PointAddress point;               // Line: the anchor that its segment starts at
    HandleSide side = HandleSide::In; // Handle
    double t = 0.0;                   // Line: where on the segment
    Vec2 place = Vec2::Zero();        // frame coordinates

    bool operator==(const PointTarget &other) const
    {
        return kind == other.kind && point == other.point && side == other.side && t == other.t &&
               place == other.place;
    }
};

/// The section whose points are shown: the one that is selected, if it is drawn or the image of a
/// drawn one, unless it is hidden or seen on its edge.
std::optional<SectionRef> sectionWithPoints(const Sight &sight, const Selection &selection);

/// The control points of a section, as it is shown, that are marked and can be held: those that are
/// selected, then corners, then the others along each boundary, of which the ones are left out that
/// would come nearer than kPointsApart to one that is there. Nearer to the eye there are all.
/// Sorted; they depend on the scale, not on where the view is.
std::vector<PointAddress> shownPoints(const Section &section,
                                      const std::vector<PointAddress> &selected,
                                      const Camera &camera, const Vec2 &viewport);
/// px
inline constexpr double kPointsApart = 12.0;

/// What of that section is there (px): of anchors that are shown and of the handles of selected
/// points the nearest within 10 px, else the contour, where no other section lies before it. These
/// marks are drawn over everything, so nothing else hides them.
std::optional<PointTarget> pointTargetAt(const Sight &sight, const SectionRef &section,
                                         const PointSelection &selected, const Vec2 &position);

/// Where the ray through a place of the screen meets the section's plane, frame coordinates.
std::optional<Vec2> placeOnPlane(const Frame &frame, const Camera &camera, const Vec2 &viewport,
                                 const Vec2 &position);

} // namespace fff
