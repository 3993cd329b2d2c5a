#include "core/session/assembly_plan.h"

#include "core/assembly/crossing.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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
    if (!slidesAlongAxis(joint.kind)) {
        const int guest = inA && inA->role == SlitRole::Slit ? joint.b : joint.a;
        return frameOf(guest).normal().cross(joint.crossing->axis.direction).normalized();
    }
    if (inA)
        return frameOf(joint.a).directionToWorld((inA->mouth - inA->inner).normalized());
    return frameOf(joint.b).directionToWorld((inB->inner - inB->mouth).normalized());
}

/// How the slits of a cross lap hold.
struct Hold
{
    double play = std::numbers::pi, length = 0.0; // see Slide
};

Hold holdOf(const Analysis &analysis, const Joint &joint)
{
    Hold hold;
    double surest = 0.0; // mm: of what both slits hold longest
    for (const Overlap &overlap : joint.crossing->overlaps)
        surest = std::max(surest, std::min(overlap.to - overlap.meet, overlap.meet - overlap.from));
    double clearance = 0.0, loose = 0.0;
    for (const int section : {joint.a, joint.b}) {
        const Stock &stock = analysis.model.stockOf(static_cast<std::size_t>(section));
        clearance = std::max(clearance, stock.clearance);
        for (const Slit &slit : analysis.assembly.slits[static_cast<std::size_t>(section)])
            if (slit.joint == joint.id) {
                const double length = (slit.mouth - slit.inner).norm();
                hold.length = std::max(hold.length, length);
                if (slit.form)
                    loose = std::max(loose, looseWall(*slit.form, {length, 0.5 * slit.width}));
            }
    }
    // One of the two slits holds the other section by its faces, and least where the way turns to
    // the middle between both planes' normals.
    constexpr double kCertain = 2.0;
    hold.play = std::atan2(kCertain * (clearance + kTouchingDepth),
                           (surest - loose) * std::sin(0.5 * joint.crossing->angle));
    return hold;
}

/// How deep bumps press into their guests, from both sides together, mm.
double bumpsOf(const Analysis &analysis)
{
    double highest = 0.0;
    for (const std::vector<Slit> &slits : analysis.assembly.slits)
        for (const Slit &slit : slits)
            if (slit.form)
                highest = std::max(highest, slit.form->bumps);
    return 2.0 * highest;
}

/// What stops the one of a locked pair that comes out of its slit.
std::optional<Stop> stopOf(Collisions &collisions, const std::vector<Slide> &slides,
                           const std::vector<int> &pair)
{
    const auto slide = std::find_if(slides.begin(), slides.end(), [&](const Slide &s) {
        return s.a == pair[0] && s.b == pair[1];
    });
    if (slide == slides.end())
        return {};
    const double met = collisions.wayUntil(slide->b, slide->a, collisions.way(slide->direction));
    if (!(met > 0.0) || std::isinf(met))
        return {};
    // Of two it is the smaller one that a person would move.
    const auto extent = [&](int part) { return collisions.solid(part).box.size().norm(); };
    return extent(slide->b) > extent(slide->a) ? Stop{slide->a, slide->b, met}
                                               : Stop{slide->b, slide->a, met};
}

} // namespace

std::vector<SolidPointer> solidsOf(const Analysis &analysis, std::vector<PartRef> &parts,
                                   PlanCaches &caches)
{
    std::vector<SolidPointer> solids;
    parts.clear();
    caches.sections.resize(analysis.model.sectionCount());
    for (std::size_t i = 0; i < caches.sections.size(); ++i) {
        PlanCaches::OfSection &known = caches.sections[i];
        const CutSectionPointer &cut = analysis.cuts[i];
        const Frame &frame = analysis.model.section(i)->frame;
        const double thickness = analysis.model.stockOf(i).thickness;
        if (known.cut != cut || known.frame != frame || known.thickness != thickness) {
            known = {cut, frame, thickness, {}};
            for (const Triangulation &piece : cut->triangulations())
                known.solids.push_back(
                    std::make_shared<const Solid>(makeSolid(piece, frame, thickness)));
        }
        for (const SolidPointer &solid : known.solids) {
            parts.push_back({static_cast<int>(i), static_cast<int>(&solid - known.solids.data())});
            solids.push_back(solid);
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
        const auto a = static_cast<std::size_t>(joint.a), b = static_cast<std::size_t>(joint.b);
        // Of a divided section it is not known which piece it holds: one direction more to try.
        const bool isWhole = first[a + 1] == first[a] + 1 && first[b + 1] == first[b] + 1;
        Slide slide;
        slide.direction = slideOf(analysis, joint);
        slide.goesBothWays = !slidesAlongAxis(joint.kind);
        if (!slide.goesBothWays) {
            const Hold hold = holdOf(analysis, joint);
            slide.length = hold.length;
            slide.play = isWhole ? hold.play : slide.play;
        }
        for (int i = first[a]; i < first[a + 1]; ++i)
            for (int k = first[b]; k < first[b + 1]; ++k) {
                slide.a = i;
                slide.b = k;
                slides.push_back(slide);
            }
    }
    return slides;
}

std::vector<PartOverlap> overlapsOf(Collisions &collisions)
{
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < collisions.size(); ++i)
        boxes.push_back(collisions.solid(static_cast<int>(i)).box);
    std::vector<PartOverlap> overlaps;
    for (const auto &[a, b] : meetingPairs(boxes)) {
        if (const auto &how = collisions.overlap(a, b))
            overlaps.push_back({a, b, *how});
    }
    return overlaps;
}

ModelPlan planOf(const Analysis &analysis, const std::function<bool()> &isOutOfTime)
{
    PlanCaches caches;
    return planOf(analysis, caches, isOutOfTime);
}

ModelPlan planOf(const Analysis &analysis, PlanCaches &caches,
                 const std::function<bool()> &isOutOfTime)
{
    ModelPlan result;
    double depth = kTouchingDepth;
    for (const auto &stock : analysis.model.document.stocks)
        depth = std::max(depth, kTouchingDepth - stock->clearance);
    depth += bumpsOf(analysis);
    Collisions &collisions = caches.collisions;
    collisions.use(solidsOf(analysis, result.parts, caches), depth);
    PlanOptions options;
    options.isOutOfTime = isOutOfTime;
    result.overlaps = overlapsOf(collisions);
    for (const PartOverlap &overlap : result.overlaps)
        options.ignored.emplace_back(overlap.a, overlap.b);
    const std::vector<Slide> slides = slidesOf(analysis, result.parts);
    result.plan = planAssembly(collisions, slides, options);
    if (result.plan.locked.size() == 2)
        result.stop = stopOf(collisions, slides, result.plan.locked);
    return result;
}

} // namespace fff
