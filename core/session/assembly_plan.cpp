#include "core/session/assembly_plan.h"

#include "core/assembly/crossing.h"

#include <algorithm>

namespace fff {

namespace {

/// The unit direction in which b comes off a.
Vec3 slideOf(const Analysis &analysis, const Joint &joint)
{
    const auto slitOf = [&](int host) -> const Slit * {
        const auto &slits = analysis.assembly.slits[static_cast<std::size_t>(host)];
        const auto found = std::find_if(slits.begin(), slits.end(),
                                        [&](const Slit &s) { return s.joint == joint.id; });
        return found == slits.end() ? nullptr : &*found;
    };
    const auto frameOf = [&](int section) -> const Frame & {
        return analysis.model.section(static_cast<std::size_t>(section))->frame;
    };
    const Slit *inA = slitOf(joint.a), *inB = slitOf(joint.b);
    if (joint.kind == JointKind::Mortise) {
        const int guest = inA ? joint.b : joint.a;
        return frameOf(guest).normal().cross(joint.crossing->axis.direction).normalized();
    }
    if (inA)
        return frameOf(joint.a).directionToWorld((inA->mouth - inA->inner).normalized());
    return frameOf(joint.b).directionToWorld((inB->inner - inB->mouth).normalized());
}

} // namespace

std::vector<Solid> solidsOf(const Analysis &analysis, std::vector<PartRef> &parts)
{
    std::vector<Solid> solids;
    parts.clear();
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const std::vector<Triangulation> &pieces = analysis.cuts[i]->triangulations();
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            solids.push_back(makeSolid(pieces[k], analysis.model.section(i)->frame,
                                       analysis.model.stockOf(i).thickness));
            parts.push_back({static_cast<int>(i), static_cast<int>(k)});
        }
    }
    return solids;
}

std::vector<Slide> slidesOf(const Analysis &analysis, const std::vector<PartRef> &parts)
{
    // Of each section its first part, and behind the last one their number.
    std::vector<int> first(analysis.model.sectionCount() + 1, 0);
    for (const PartRef &part : parts)
        ++first[static_cast<std::size_t>(part.section) + 1];
    for (std::size_t i = 1; i < first.size(); ++i)
        first[i] += first[i - 1];
    std::vector<Slide> slides;
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None)
            continue;
        const Vec3 direction = slideOf(analysis, joint);
        const auto a = static_cast<std::size_t>(joint.a), b = static_cast<std::size_t>(joint.b);
        // Which of the pieces of a divided section it holds matters little: a direction more to
        // try.
        for (int i = first[a]; i < first[a + 1]; ++i)
            for (int k = first[b]; k < first[b + 1]; ++k)
                slides.push_back({i, k, direction, joint.kind == JointKind::Mortise});
    }
    return slides;
}

std::vector<PartOverlap> overlapsOf(const std::vector<Solid> &solids, double depth)
{
    std::vector<Box3> boxes;
    for (const Solid &solid : solids)
        boxes.push_back(solid.box);
    std::vector<PartOverlap> overlaps;
    for (const auto &[a, b] : meetingPairs(boxes)) {
        if (const auto how = interpenetration(solids[static_cast<std::size_t>(a)],
                                              solids[static_cast<std::size_t>(b)], depth))
            overlaps.push_back({a, b, *how});
    }
    return overlaps;
}

ModelPlan planOf(const Analysis &analysis, const std::function<bool()> &isOutOfTime)
{
    ModelPlan result;
    const std::vector<Solid> solids = solidsOf(analysis, result.parts);
    PlanOptions options;
    for (const auto &stock : analysis.model.document.stocks)
        options.depth = std::max(options.depth, kTouchingDepth - stock->clearance);
    options.isOutOfTime = isOutOfTime;
    result.overlaps = overlapsOf(solids, options.depth);
    for (const PartOverlap &overlap : result.overlaps)
        options.ignored.emplace_back(overlap.a, overlap.b);
    result.plan = planAssembly(solids, slidesOf(analysis, result.parts), options);
    return result;
}

} // namespace fff
