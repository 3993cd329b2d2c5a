// Moving drawn sections, with what was drawn on them: pure edits, exact enough to be undone by
// their inverse.
//
// A section that was drawn on another one
//   - goes along when that one is moved and it is not moved itself (MovingRules::takesChildren),
//   - keeps its angle to it when it is moved alone, or left behind: it is turned by the least turn
//     that brings the angle back, about the middle of its slit. One that stood at a right angle, to
//     kRightAngle, stands exactly so afterwards.
// Free ones (Parent::isFree) do neither. The slit's segment stays where the two planes meet.
#pragma once

#include "core/geometry/plane_map.h"
#include "core/geometry/similarity.h"
#include "core/model/document.h"

#include <functional>
#include <optional>
#include <span>

namespace fff {

/// How one section is moved: in the world, mm. `placement` turns, scales and shifts; a reflection
/// mirrors it, too.
struct SectionMove
{
    SectionId section;
    Similarity placement = {};
    /// What it is drawn on has no say in it.
    bool breaksAngle = false;
};

struct MovingRules
{
    bool takesChildren = true;
    /// Of a section that an operation makes: where it is before and after the move. Nothing for one
    /// that is not there, with which nothing goes along.
    struct Frames
    {
        Frame before, after;
    };
    std::function<std::optional<Frames>(const SectionRef &)> framesOf = {};
};

/// Sections that are moved alike keep what is between them bit for bit, but for rounding of their
/// frames. Errors  UnknownReference, place = the id; EmptyContour, NonFinite, place = the section's
/// name, where it is scaled to nothing or moved beyond kMaxCoordinate.
Result<Document> movedSections(Document document, std::span<const SectionMove> moves,
                               const MovingRules &rules = {});

/// A section stretched in its plane, frame coordinates, with what lies on it. What was drawn on it
/// goes along without being turned: as far as its slit's middle does, or, along one of the frame's
/// axes, as far as the end that it holds to (Parent::holdsTo). Errors  as movedSections().
Result<Document> stretchedSection(Document document, SectionId id, const PlaneMap &map,
                                  const MovingRules &rules = {});

/// The least turn of a section about the middle of its slit, without one about the middle of its
/// shape, that gives it this normal or the opposite one (unit).
Similarity turnToNormal(const Section &section, const Frame *parent, const Vec3 &normal);
/// The turn of a section about its slit, so that its plane is at this angle (0 … π, as
/// angleToParent() counts it) to its parent's.
Similarity turnToAngle(const Section &section, const Frame &parent, double angle);
/// Between the two planes, 0 … π: from the parent's plane, on the side that the slit's direction
/// × the parent's normal points to, up to the section's.
double angleToParent(const Section &section, const Frame &parent);

/// Errors  UnknownReference; BadValue, place "parent", where it was drawn on nothing.
Result<Document> setFree(Document document, SectionId id, bool isFree);

/// Cosine between the two normals that counts as a right angle (no unit).
inline constexpr double kRightAngle = 1e-6;

} // namespace fff
