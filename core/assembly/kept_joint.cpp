#include "core/assembly/kept_joint.h"

#include "core/assembly/intervals.h"
#include "core/assembly/slits.h"
#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// Whether the section's slits in this joint follow from what lies in the strip alone, and the
/// change does not come into it.
bool isApart(const JointSide &host, const JointSide &guest, const Crossing &crossing,
             const ShapeChange *change)
{
    if (hasForm(host.stock))
        return false; // lead-ins reach beyond the strip
    if (!change)
        return true;
    const Result<double> width = slitWidth(host.stock.thickness, guest.stock.thickness,
                                           crossing.angle, std::max(host.stock.clearance, 0.0));
    const PlaneLine line = lineInFrame(crossing.axis, host.section.frame);
    return width && change->isBeside(line.point, line.direction, 0.5 * *width + kEqualEnds);
}

std::vector<Slit> slitsFor(const std::vector<Slit> &row, int guest)
{
    std::vector<Slit> slits;
    auto it = std::lower_bound(row.begin(), row.end(), guest,
                               [](const Slit &slit, int wanted) { return slit.guest < wanted; });
    for (; it != row.end() && it->guest == guest; ++it) {
        slits.push_back(*it);
        slits.back().joint = 0;
    }
    return slits;
}

/// The ends on boundaries whose edges have other numbers now. The same object where none has.
std::shared_ptr<const Crossing> renumbered(const std::shared_ptr<const Crossing> &crossing,
                                           const ShapeChange *ofA, const ShapeChange *ofB)
{
    Crossing next = *crossing;
    bool isSame = true;
    for (Overlap &overlap : next.overlaps) {
        for (const auto &[interval, change] : {std::pair(&overlap.a, ofA), {&overlap.b, ofB}}) {
            if (!change)
                continue;
            for (AxisEnd *end : {&interval->from, &interval->to}) {
                const int edge = change->edgeNow(end->ring, end->edge);
                isSame = isSame && edge == end->edge;
                end->edge = edge;
            }
        }
    }
    return isSame ? crossing : std::make_shared<const Crossing>(std::move(next));
}

} // namespace

std::optional<FoundJoint> keptJoint(const Model &model, const Assembly &before, int a, int b,
                                    const ShapeChange *ofA, const ShapeChange *ofB)
{
    if (static_cast<std::size_t>(b) >= before.boxes.size())
        return std::nullopt;
    const Joint *joint = before.joints.find(a, b);
    // Whether a mortise fits is asked of the whole contour.
    if (!joint || !slidesAlongAxis(joint->kind) ||
        model.document.jointOverride(model.ref(static_cast<std::size_t>(a)),
                                     model.ref(static_cast<std::size_t>(b))))
        return std::nullopt;
    const JointSide sideA = sideOf(model, a), sideB = sideOf(model, b);
    if (!isApart(sideA, sideB, *joint->crossing, ofA) ||
        !isApart(sideB, sideA, *joint->crossing, ofB))
        return std::nullopt;
    FoundJoint found;
    found.joint = *joint;
    found.joint.id = 0;
    found.joint.crossing = renumbered(joint->crossing, ofA, ofB);
    found.slitsOfA = slitsFor(before.slits[static_cast<std::size_t>(a)], b);
    found.slitsOfB = slitsFor(before.slits[static_cast<std::size_t>(b)], a);
    return found;
}

} // namespace fff
