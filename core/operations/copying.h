// Copies of sections elsewhere in space. Internal to operations.
#pragma once

#include "core/model/transformed.h"
#include "core/operations/operation_context.h"

namespace fff {

/// A section and what is attached to it, to be copied together.
struct Branch
{
    struct Member
    {
        SectionPointer section;
        std::string key; // below that of a copy; empty: the section itself
        int parent = -1; // index of the member that it is on
    };
    std::vector<Member> members; // the section first, parents before children
};

/// The section alone.
Branch branchOf(const SectionPointer &section);
/// With all that was drawn on it, on that, and so on, and what operations above put there; sections
/// that were drawn on nothing belong to it where they meet it and not `root`. Without `root` and
/// what that is on; there may be none (null).
Branch wholeBranchOf(OperationContext &context, const SectionPointer &section,
                     const SectionPointer &root);

/// One copy of a branch.
struct Copy
{
    std::string key;           // of the section's copy
    std::string number;        // which names end with
    Section section;           // the section's copy, but for its name
    Similarity placement = {}; // of all others
    /// Besides, what is on the section goes along where that was stretched: a point p of it by
    /// stretch · (p − stretchedFrom), before it is placed.
    Eigen::Matrix3d stretch = Eigen::Matrix3d::Zero();
    Vec3 stretchedFrom = Vec3::Zero();
};

/// Adds a copy of every member. Whether all of them could be made: scaled too small, a shape is
/// none any more.
bool addCopy(OperationContext &context, const Branch &branch, const Copy &copy);

/// The shape of the instance of that key: the one that it had before, if it is still the same. Says
/// why there is none any more.
ShapeMap shapeOf(OperationContext &context, const std::string &key);

/// What a copy is called: "Rib" gives "Rib 2", "Rib 1" gives "Rib 1.2".
std::string copiedName(const std::string &name, const std::string &number);

} // namespace fff
