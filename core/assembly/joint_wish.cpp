#include "core/assembly/joint_wish.h"

#include <cmath>

namespace fff {

namespace {

/// The overlap at a place of the axis, or null.
const Overlap *nearestOverlap(const Crossing &crossing, double at)
{
    const Overlap *nearest = nullptr;
    double least = 0.0;
    for (const Overlap &overlap : crossing.overlaps) {
        const double length = overlap.to - overlap.from;
        const double away = std::abs(at - 0.5 * (overlap.from + overlap.to));
        if (away <= length && (!nearest || away < least)) {
            nearest = &overlap;
            least = away;
        }
    }
    return nearest;
}

} // namespace

int overlapOf(const JointOverride::Share &share, const Frame &frameOfA, const Crossing &crossing)
{
    const Vec3 from = frameOfA.toWorld(share.at) - crossing.axis.point;
    const Overlap *overlap = nearestOverlap(crossing, from.dot(crossing.axis.direction));
    return overlap ? static_cast<int>(overlap - crossing.overlaps.data()) : -1;
}

int signAlong(const Vec3 &direction, const Axis &axis)
{
    constexpr double kSquare = 1e-6; // cosine: files round directions to less
    const double along = direction.dot(axis.direction);
    return std::abs(along) < kSquare ? 0 : along > 0.0 ? 1 : -1;
}

bool wantsTabs(const Model &model, int a, int b)
{
    if (model.document.jointOverrides.empty())
        return false;
    const JointOverride *wanted = model.document.jointOverride(
        model.ref(static_cast<std::size_t>(a)), model.ref(static_cast<std::size_t>(b)));
    return wanted && wanted->kind == JointKind::Tabs;
}

JointWish wishFor(const Model &model, int a, int b, const Crossing &crossing)
{
    JointWish wish;
    const std::vector<JointOverridePointer> &all = model.document.jointOverrides;
    if (all.empty())
        return wish;
    const SectionRef refA = model.ref(static_cast<std::size_t>(a));
    const SectionRef refB = model.ref(static_cast<std::size_t>(b));
    const JointOverride *wanted = model.document.jointOverride(refA, refB);
    if (!wanted)
        return wish;
    // What is said of the override's a, which is the joint's b when the model has it first.
    const bool isTurned = wanted->a == refB;
    const Frame &frame = model.section(static_cast<std::size_t>(isTurned ? b : a))->frame;
    wish.kind = wanted->kind;
    if (wanted->opens) {
        const int sign = signAlong(frame.directionToWorld(*wanted->opens), crossing.axis);
        wish.sign = isTurned ? -sign : sign;
    }
    for (const JointOverride::Share &share : wanted->shares) {
        const int overlap = overlapOf(share, frame, crossing);
        if (overlap < 0)
            continue;
        wish.shares.resize(crossing.overlaps.size(), 0.5);
        wish.shares[static_cast<std::size_t>(overlap)] = isTurned ? 1.0 - share.ofA : share.ofA;
    }
    return wish;
}

} // namespace fff
