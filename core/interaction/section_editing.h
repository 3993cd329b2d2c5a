// What edits of whole sections make of the document, several at once: shared by drags, keys,
// commands and the fields of the window. A section that an operation made in its own way, and one
// that is locked, is not edited: the refusal names it (MadeByOperation, Locked).
#pragma once

#include "core/interaction/gizmo_drag.h"
#include "core/interaction/section_edit.h"
#include "core/interaction/section_words.h"
#include "core/model/model.h"
#include "core/operations/copies.h"

#include <optional>
#include <vector>

namespace fff {

/// Of these sections the first that cannot be edited, and why.
std::optional<Hint> whyNotEdited(const Model &model, const std::vector<SectionRef> &sections);
/// The section of the document that is edited with this one (core/model/origin.h), or why not.
tl::expected<const Section *, Hint> drawnSection(const Model &model, const SectionRef &ref);

/// All moved by the transform. Steps of the same kind and sections after each other are one with
/// `merges` (an arrow key pressed again). With a stretch only the first section is, along the axes
/// x and y of `frame` in its plane. Refused where nothing would be left (WouldBeEmpty), or where it
/// would go beyond what a file holds (EditFailed).
SectionEdit transformed(const Model &model, const std::vector<SectionRef> &sections,
                        const Transform &transform, const Frame &frame, bool takesChildren,
                        bool merges = false);
/// The same of copies of them, each one such transform further; the last ones are selected. A
/// stretch that differs in its two ways is left out.
SectionEdit transformedCopies(const Copies &copies, const Model &model,
                              const std::vector<SectionRef> &sections, Transform transform);

/// The middle of the box of its contour, in the world, mm.
Vec3 positionOf(const Section &section);
/// Each moved so that one coordinate of its position is `value`.
SectionEdit withPosition(const Model &model, const std::vector<SectionRef> &sections, int axis,
                         double value, bool takesChildren);
/// Each turned by the least turn so that one coordinate of its normal is `value`, −1 … 1, and the
/// others keep their ratio. A note (HeldByParent) says where one is held and came to another one.
SectionEdit withNormal(const Model &model, const std::vector<SectionRef> &sections, int axis,
                       double value, bool takesChildren);
/// Each turned about its slit to this angle, 0 … π, to what it is on (angleToParent()). Refused for
/// one that is on nothing (OnNothing), as the next one.
SectionEdit withAngle(const Model &model, const std::vector<SectionRef> &sections, double angle,
                      bool takesChildren);
/// Each at a right angle to what it is on, and held there again.
SectionEdit madeOrthogonal(const Model &model, const std::vector<SectionRef> &sections,
                           bool takesChildren);
/// Each with its normal along the nearest of the world's axes; of one that is held, the nearest
/// that keeps its angle. Refused where there is none (HeldByParent).
SectionEdit alignedToAxis(const Model &model, const std::vector<SectionRef> &sections,
                          bool takesChildren);

/// On the other one, with the slit where the two meet now; an empty one: on nothing. Refused where
/// they do not meet (DoNotMeet), or where that one is on this (EditFailed).
SectionEdit putOn(const Model &model, const SectionRef &section, const SectionRef &parent);
SectionEdit freed(const Model &model, const std::vector<SectionRef> &sections, bool isFree);
/// What each keeps its distance to when the section that it is on is stretched.
SectionEdit heldTo(const Model &model, const std::vector<SectionRef> &sections, HoldsTo end);
SectionEdit locked(const Model &model, const std::vector<SectionRef> &sections, bool isLocked);

/// Drawn sections go, with their images; one that an operation made in its own way is left out of
/// what that makes. step: what the history says of all of them; null: that they were deleted, or
/// left out.
SectionEdit deleted(const Model &model, const std::vector<SectionRef> &sections,
                    const CountedText *step = nullptr);

/// All of another document added and moved by `way`, mm; it is selected. Symmetries of the whole
/// model become those of what comes.
SectionEdit added(const Model &model, const Document &other, const Vec3 &way, Step step);
/// The least way along the world's X after which the box of what comes stands 20 mm beside that of
/// the model; none where one of them is empty.
Vec3 wayBeside(const Model &model, const Document &other);

/// A copy of all of them where they are, moved by `way`, mm; it is selected.
SectionEdit duplicated(const Model &model, const std::vector<SectionRef> &sections,
                       const Vec3 &way);
/// A mirror image of all of them, across the plane through `point` with this unit normal.
SectionEdit mirroredCopy(const Model &model, const std::vector<SectionRef> &sections,
                         const Vec3 &point, const Vec3 &normal);

} // namespace fff
