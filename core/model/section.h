// One planar section of a document, and how a section is named from elsewhere.
#pragma once

#include "core/base/ids.h"
#include "core/geometry/figure.h"
#include "core/geometry/frame.h"
#include "core/geometry/mirror_axis.h"
#include "core/model/mark.h"
#include "core/model/shape.h"

#include <compare>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fff {

/// A drawn section by its id, or one that an operation made by the operation's id and a structural
/// key ("3", "0/2/1"; core/model/instance_key.h). Survives re-evaluation; may name nothing for a
/// while (dormant). Drawn ones come first in their order.
struct SectionRef
{
    SectionId drawn; // valid: a drawn section, and the rest is empty
    OperationId operation;
    std::string key;

    SectionRef() = default;
    SectionRef(SectionId id) : drawn(id) {}
    SectionRef(OperationId id, std::string instance) : operation(id), key(std::move(instance)) {}

    bool operator==(const SectionRef &) const = default;
    std::strong_ordering operator<=>(const SectionRef &other) const;
};

/// On which section one was drawn, and the slit's segment there, from inside to where the stroke
/// left, in the parent's frame coordinates (mm).
/// What keeps its distance to a section that was drawn on another one, along an axis of that one's
/// frame, when that one is stretched; along the other axis, and without such an end, it goes as far
/// as the place that it is on.
enum class HoldsTo { Proportion, Left, Right, Bottom, Top };

struct Parent
{
    SectionRef section;
    Vec2 slitFrom = Vec2::Zero();
    Vec2 slitTo = Vec2::Zero();
    /// It neither goes along when that is moved nor keeps its angle to it (core/model/moving.h).
    bool isFree = false;
    HoldsTo holdsTo = HoldsTo::Proportion;

    bool operator==(const Parent &other) const
    {
        return section == other.section && slitFrom == other.slitFrom && slitTo == other.slitTo &&
               isFree == other.isFree && holdsTo == other.holdsTo;
    }
};

/// Of what an operation copied: from where, so that what a document keeps at places of a section is
/// there on its copies, too.
struct CopyOf
{
    SectionRef section;
    std::shared_ptr<const CopyOf> before = {}; // what that one is a copy of; null: of none
    /// p → matrix p + shift, from its frame coordinates to those of the copy, mm.
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Identity();
    Vec2 shift = Vec2::Zero();
    bool isMirrored = false; // the copy's normal is the other one

    Vec2 operator()(const Vec2 &p) const { return matrix * p + shift; }
    bool operator==(const CopyOf &other) const
    {
        return section == other.section && matrix == other.matrix && shift == other.shift &&
               isMirrored == other.isMirrored &&
               (before == other.before || (before && other.before && *before == *other.before));
    }
};

struct Section
{
    SectionId id;         // of a drawn one
    SectionRef made = {}; // of one that an operation made: which; else empty
    std::string name;
    std::optional<Parent> parent;
    ShapePointer shape; // never null in a document
    Frame frame;
    StockId stock;
    bool isLocked = false; // a person wants it to stay as it is
    /// That boundaries of its shape were made of. Those that have been edited since are left out by
    /// the edits of the shape (core/model/figures.h).
    std::vector<Figure> figures = {};
    std::vector<MarkPointer> marks = {}; // never null; on the side that the normal points to

    /// To which it was made symmetric and shall stay so when its points are edited, frame
    /// coordinates; counts as long as it is (core/model/symmetric_section.h).
    std::optional<MirrorAxis> symmetry = {};
    /// Of one that an operation made of another one.
    std::optional<CopyOf> copyOf = {};

    SectionRef ref() const { return id.isValid() ? SectionRef(id) : made; }
    /// Same values; shapes are compared by their curves.
    bool operator==(const Section &other) const;
};

using SectionPointer = std::shared_ptr<const Section>;

/// Box of the section's mid-plane region in the world, mm. The slab reaches half a thickness
/// further.
Box3 worldBounds(const Shape &shape, const Frame &frame);

} // namespace fff
