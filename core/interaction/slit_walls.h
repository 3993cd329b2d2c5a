// Whether the slit of a section that is about to be drawn will hold it: judged by the rules that
// judge it afterwards (assembly/grips.h), with the section that it is drawn on alone.
#pragma once

#include "core/model/model.h"
#include "core/stroke/leaving.h"

#include <optional>

namespace fff {

struct SlitJudged
{
    bool isHeld = false;
    /// Material is on one side of the slit only: unit, world, to where there is none.
    std::optional<Vec3> missing;
};

/// What holds `guest` in `ground`, both of stocks of the document.
SlitJudged judgedSlit(const Document &document, const Section &ground, const Section &guest);

/// The same of a slit, from where it was pressed to where it ends (frame coordinates of `ground`,
/// mm), with a section across it that ends where it does. Costs nothing worth mentioning where both
/// sides are inside.
SlitJudged judgedSlit(const Document &document, const Section &ground, const Interior &interior,
                      const Vec2 &from, const Vec2 &to);

/// Where such a slit, which has one wall, has both and no thin web beside it: moved away from where
/// there is none, its end where it leaves the section then. Nothing where there is no such place.
std::optional<Parent> movedIn(const Document &document, const Section &ground,
                              const Interior &interior, const Parent &slit, const Vec3 &missing);

/// Whether the guest (of `moved`), whose slit was moved in, is held there and is better off than
/// where it was drawn (`drawn`, another document with it): its slit saws no deeper into the ground
/// than one that was drawn so long (mm) lets expect, and no other section is worse off.
bool isWellMovedIn(const Document &drawn, const Document &moved, SectionId guest,
                   const Section &ground, double slitLength);

} // namespace fff
