#include "core/operations/kept_slits.h"

#include "core/assembly/assembly.h"
#include "core/assembly/crossing.h"
#include "core/base/tolerances.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

SectionRef follow(const Replacements &replacements, const SectionRef &ref)
{
    const auto it = replacements.find(ref);
    return it == replacements.end() ? ref : it->second;
}

/// How the slits of a, the first of a joint, are cut.
struct Laps
{
    /// What the slit takes of an overlap, mm.
    struct Depth
    {
        double own = 0.0, whole = 0.0;
    };

    int sign = 0; // to which end of the axis they open, ±1; 0: there are none
    std::vector<Depth> depths;
};

Laps lapsOf(const Model &model, const Assembly &assembly, const Joint &joint)
{
    const auto index = static_cast<std::size_t>(joint.a);
    const Frame &frame = model.section(index)->frame;
    Laps laps;
    for (const Slit &slit : assembly.slits[index])
        if (slit.joint == joint.id && slit.isOpen && slit.role == SlitRole::Slit) {
            const Vec3 way = frame.directionToWorld(slit.mouth - slit.inner);
            laps.sign = way.dot(joint.crossing->axis.direction) > 0.0 ? 1 : -1;
            break;
        }
    for (const Overlap &o : joint.crossing->overlaps)
        laps.depths.push_back({laps.sign > 0 ? o.to - o.meet : o.meet - o.from, o.to - o.from});
    return laps;
}

/// The same of b.
Laps turned(Laps laps)
{
    laps.sign = -laps.sign;
    for (Laps::Depth &depth : laps.depths)
        depth.own = depth.whole - depth.own;
    return laps;
}

bool isSame(const Laps &a, const Laps &b)
{
    const auto isSameDepth = [](const Laps::Depth &one, const Laps::Depth &other) {
        return std::abs(one.own - other.own) <= kTouchingDepth;
    };
    return a.sign == b.sign && std::equal(a.depths.begin(), a.depths.end(), b.depths.begin(),
                                          b.depths.end(), isSameDepth);
}

/// The sections of a joint, as they are named now, with frames as they were.
struct KeptJoint
{
    SectionRef a, b;
    const Frame &frameOfA, &frameOfB;
};

JointOverride keptAs(const Laps &laps, const Joint &joint, const KeptJoint &of,
                     const JointOverride *known)
{
    const bool isTurned = of.b < of.a;
    const Frame &frame = isTurned ? of.frameOfB : of.frameOfA;
    const Laps ofFirst = isTurned ? turned(laps) : laps;
    const Axis &axis = joint.crossing->axis;
    JointOverride wanted = known ? *known : JointOverride();
    wanted.a = std::min(of.a, of.b);
    wanted.b = std::max(of.a, of.b);
    wanted.opens = frame.directionToLocal(ofFirst.sign * axis.direction);
    wanted.shares.clear();
    for (std::size_t i = 0; i < ofFirst.depths.size(); ++i) {
        const Overlap &o = joint.crossing->overlaps[i];
        const auto &[own, whole] = ofFirst.depths[i];
        const bool isCutByBoth = own > 0.0 && own < whole;
        if (isCutByBoth && !meetsInMiddle(o))
            wanted.shares.push_back({frame.toLocal(axis.at(0.5 * (o.from + o.to))),
                                     std::clamp(own / whole, kLeastShare, 1.0 - kLeastShare)});
    }
    return wanted;
}

} // namespace

Result<Document> withSlitsKept(Document document, const Model &model,
                               const Replacements &replacements)
{
    const Model next = evaluate(document, model);
    const Assembly before = assemble(model), after = assemble(next);
    for (const Joint &joint : before.joints) {
        const SectionRef a = follow(replacements, model.ref(static_cast<std::size_t>(joint.a)));
        const SectionRef b = follow(replacements, model.ref(static_cast<std::size_t>(joint.b)));
        const int i = next.indexOf(a), j = next.indexOf(b);
        const Joint *now =
            i < 0 || j < 0 ? nullptr : after.joints.find(std::min(i, j), std::max(i, j));
        if (!now || !now->crossing || !joint.crossing)
            continue;
        // Along the direction of the axis before, of the section that was first then.
        const Laps was = lapsOf(model, before, joint);
        Laps is = lapsOf(next, after, *now);
        if (now->a != i)
            is = turned(is);
        if (now->crossing->axis.direction.dot(joint.crossing->axis.direction) < 0.0)
            is.sign = -is.sign;
        if (was.sign == 0 || isSame(was, is))
            continue;
        const KeptJoint kept{a, b, next.find(a)->frame, next.find(b)->frame};
        Result<Document> with = setJointOverride(
            std::move(document), keptAs(was, joint, kept, document.jointOverride(a, b)));
        if (!with)
            return with;
        document = *std::move(with);
    }
    return document;
}

} // namespace fff
