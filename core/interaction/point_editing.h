// What an edit of control points makes of the document: shared by drags, keys, commands and the
// fields of the window.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/point_selection.h"
#include "core/model/hint.h"
#include "core/model/model.h"
#include "core/model/step.h"

#include <optional>
#include <span>

namespace fff {

struct EditedPoints
{
    Document document;
    Step step;
    SectionId section;
    std::vector<PointAddress> points; // to be selected then
    std::optional<Hint> note;         // what became of it beyond what was asked for
};

/// The document, or the refusal that says why there is none.
using PointEdit = tl::expected<EditedPoints, Hint>;

/// What a shape that could not be made is refused with.
Hint whyNoShape(const Error &error, const Section &section);

struct PointRules
{
    bool cutsAtGround = true; // what is below Y = 0 goes
    /// The section is symmetric to this line: what changes on one side does so on the other.
    std::optional<Halfplane> mirror = {};
};

/// The section with this shape; one that stays symmetric (symmetric_section.h) on both sides.
/// `places`: of the points to be selected, frame coordinates.
/// Refused where it is locked (Locked), or as the shape was: WouldCrossItself, WouldMeetHole,
/// WouldBeEmpty, TooFewPoints; where nothing of it is above the ground, WouldBeBelowGround.
PointEdit withEditedShape(const Document &document, SectionId section,
                          const Result<ShapePointer> &shape, std::span<const Vec2> places,
                          Step step, const PointRules &rules);

/// The selected points moved, mm; several such steps after each other are one in the history.
PointEdit movedSelection(const Document &document, const PointSelection &points, const Vec2 &by,
                         const PointRules &rules);
PointEdit withoutSelection(const Document &document, const PointSelection &points,
                           const PointRules &rules);
PointEdit withSelectionOfKind(const Document &document, const PointSelection &points,
                              PointKind kind, const PointRules &rules);
/// A point at this place of a boundary; it is selected.
PointEdit withInsertedPoint(const Document &document, SectionId section, int boundary,
                            const CurvePoint &at, const PointRules &rules);
/// Where a point goes in that is asked for without a place: in the middle between the two selected
/// points, or behind the one. None when there is no such place.
std::optional<std::pair<int, CurvePoint>> placeBetween(const Shape &shape,
                                                       const PointSelection &points);

/// Why a section that an operation made cannot be edited by itself.
tl::unexpected<Hint> madeByOperation(const Model &model, const SectionRef &ref);

/// The axis of the frame, x or y to either side, that an arrow key on the screen points along:
/// `arrow` is a unit vector, right and up.
Vec2 arrowAxis(const Frame &frame, const Camera &camera, const Vec2 &arrow);
/// The same of the world's axes, for a section as a whole.
Vec3 arrowAxis(const Camera &camera, const Vec2 &arrow);

} // namespace fff
