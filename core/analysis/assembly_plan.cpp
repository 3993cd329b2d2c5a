#include "core/analysis/assembly_plan.h"

#include "core/assembly/crossing.h"
#include "core/assembly/fingers.h"
#include "core/base/tolerances.h"
#include "core/fabrication/wholeness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace fff {

namespace {

/// Calls visit(a, b) for each body of the joint's a with each of its b.
template <class Visit>
void forEachPair(const Bodies &bodies, const Joint &joint, Visit visit)
{
    const auto endOf = [&](int section) { return bodies.firstOf(section + 1); };
    for (int a = bodies.firstOf(joint.a); a < endOf(joint.a); ++a)
        for (int b = bodies.firstOf(joint.b); b < endOf(joint.b); ++b)
            visit(a, b);
}

/// The slits of each joint, in their sections' order and within each in that of its row.
class SlitsOfJoints
{
public:
    explicit SlitsOfJoints(const Analysis &analysis)
        : m_first(analysis.assembly.joints.size() + 2, 0)
    {
        const auto forEach = [&](auto visit) {
            for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i)
                for (const Slit &slit : analysis.assembly.slits[i])
                    visit(static_cast<int>(i), slit);
        };
        forEach(
            [&](int, const Slit &slit) { ++m_first[static_cast<std::size_t>(slit.joint) + 1]; });
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        m_all.resize(m_first.back());
        std::vector<std::size_t> next = m_first;
        forEach([&](int section, const Slit &slit) {
            m_all[next[static_cast<std::size_t>(slit.joint)]++] = {section, &slit};
        });
    }

    /// Calls visit(section, slit) for each of them.
    template <class Visit>
    void forEach(const Joint &joint, Visit visit) const
    {
        const auto id = static_cast<std::size_t>(joint.id);
        for (std::size_t i = m_first[id]; i < m_first[id + 1]; ++i)
            visit(m_all[i].first, *m_all[i].second);
    }

private:
    std::vector<std::size_t> m_first; // of each joint, by its id
    std::vector<std::pair<int, const Slit *>> m_all;
};

bool haveFingers(const Analysis &analysis, const Joint &joint)
{
    const auto areIn = [&](int section) {
        return areFingers(
            slitsOfJoint(analysis.assembly.slits[static_cast<std::size_t>(section)], joint.id));
    };
    return joint.kind == JointKind::Tabs && areIn(joint.a) && areIn(joint.b);
}

/// The unit direction in which b comes off a.
Vec3 slideOf(const Analysis &analysis, const Joint &joint, const SlitsOfJoints &slits)
{
    const Slit *inA = nullptr, *inB = nullptr;
    slits.forEach(joint, [&](int section, const Slit &slit) {
        const Slit *&first = section == joint.a ? inA : inB;
        first = first ? first : &slit;
    });
    const auto frameOf = [&](int section) -> const Frame & {
        return analysis.model.section(static_cast<std::size_t>(section))->frame;
    };
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

Hold holdOf(const Analysis &analysis, const Joint &joint, const SlitsOfJoints &slits)
{
    Hold hold;
    double surest = 0.0; // mm: of what both slits hold longest
    for (const Overlap &overlap : joint.crossing->overlaps)
        surest = std::max(surest, std::min(overlap.to - overlap.meet, overlap.meet - overlap.from));
    double clearance = 0.0, loose = 0.0;
    for (const int section : {joint.a, joint.b}) {
        const Stock &stock = analysis.model.stockOf(static_cast<std::size_t>(section));
        clearance = std::max(clearance, stock.clearance);
    }
    slits.forEach(joint, [&](int, const Slit &slit) {
        const double length = (slit.mouth - slit.inner).norm();
        hold.length = std::max(hold.length, length);
        if (slit.form)
            loose = std::max(loose, looseWall(*slit.form, {length, 0.5 * slit.width}));
    });
    // One of the two slits holds the other section by its faces, and least where the way turns to
    // the middle between both planes' normals.
    constexpr double kCertain = 2.0;
    hold.play = std::atan2(kCertain * (clearance + kTouchingDepth),
                           (surest - loose) * std::sin(0.5 * joint.crossing->angle));
    return hold;
}

/// How deep the parts of joints are pressed into each other: by a negative clearance of the stocks
/// that have their slits, and by bumps from both sides.
Collisions::Depths pressedDepths(const Analysis &analysis)
{
    std::map<int, double> ofJoints;
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const double clearance = analysis.model.stockOf(i).clearance;
        for (const Slit &slit : analysis.assembly.slits[i]) {
            const double bumps = slit.form ? 2.0 * slit.form->bumps : 0.0;
            if (clearance < 0.0 || bumps > 0.0) {
                double &depth = ofJoints[slit.joint];
                depth = std::max(depth, bumps + std::max(0.0, -clearance));
            }
        }
    }
    Collisions::Depths depths;
    for (const auto &[id, depth] : ofJoints) {
        const Joint &joint = analysis.assembly.joints[static_cast<std::size_t>(id - 1)];
        forEachPair(analysis.bodies, joint, [&, depth = depth](int a, int b) {
            depths[std::minmax(a, b)] = kTouchingDepth + depth;
        });
    }
    return depths;
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

std::vector<SolidPointer> solidsOf(const Bodies &bodies, const std::function<bool()> &isOutOfTime)
{
    std::vector<SolidPointer> solids;
    for (const Body &body : bodies) {
        if (isOutOfTime && isOutOfTime())
            return {};
        solids.push_back(*body.solid());
    }
    return solids;
}

std::vector<Slide> slidesOf(const Analysis &analysis)
{
    const Bodies &bodies = analysis.bodies;
    const SlitsOfJoints slits(analysis);
    std::vector<Slide> slides;
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None)
            continue;
        Slide slide;
        slide.direction = slideOf(analysis, joint, slits);
        slide.goesBothWays = !slidesAlongAxis(joint.kind);
        Hold hold;
        if (!slide.goesBothWays) {
            hold = holdOf(analysis, joint, slits);
            slide.length = hold.length;
        }
        // Of pieces that do not hold each other it is one direction more to try.
        const std::vector<Grip> &held = analysis.grips.of(joint).held;
        const auto areHeld = [&](int a, int b) {
            return std::any_of(held.begin(), held.end(), [&](const Grip &grip) {
                return bodies.firstOf(joint.a) + grip.a == a &&
                       bodies.firstOf(joint.b) + grip.b == b;
            });
        };
        const bool hasFingers = haveFingers(analysis, joint);
        forEachPair(bodies, joint, [&](int a, int b) {
            slide.a = a;
            slide.b = b;
            slide.play = !slide.goesBothWays && areHeld(a, b) ? hold.play : Slide().play;
            if (!hasFingers) {
                slides.push_back(slide);
                return;
            }
            // Whatever the angle, each sheet comes off square to itself.
            for (const int section : {joint.a, joint.b}) {
                slide.direction =
                    analysis.model.section(static_cast<std::size_t>(section))->frame.normal();
                slides.push_back(slide);
            }
        });
    }
    return slides;
}

std::vector<PartOverlap> overlapsOf(Collisions &collisions,
                                    const std::function<bool()> &isOutOfTime)
{
    std::vector<Box3> boxes;
    for (std::size_t i = 0; i < collisions.size(); ++i)
        boxes.push_back(collisions.solid(static_cast<int>(i)).box);
    std::vector<PartOverlap> overlaps;
    for (const auto &[a, b] : meetingPairs(boxes)) {
        if (isOutOfTime && isOutOfTime())
            break;
        if (const auto &how = collisions.overlap(a, b))
            overlaps.push_back({a, b, *how});
    }
    return overlaps;
}

std::size_t pairsInEachOther(const ModelPlan &plan, double least)
{
    std::set<std::pair<int, int>> pairs;
    for (const PartOverlap &overlap : plan.overlaps)
        if (overlap.how.depth >= least)
            pairs.emplace(plan.bodies.sectionOf(overlap.a), plan.bodies.sectionOf(overlap.b));
    return pairs.size();
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
    if (const Result<void> known = haveSolids(analysis.model, analysis.bodies); !known) {
        result.plan.verdict = AssemblyPlan::Verdict::NotFound;
        result.failure = known.error();
        return result;
    }
    Collisions &collisions = caches.collisions;
    std::vector<SolidPointer> solids = solidsOf(analysis.bodies, isOutOfTime);
    if (solids.empty() && analysis.model.sectionCount() > 0)
        return result; // NotFound
    result.bodies = analysis.bodies;
    collisions.use(std::move(solids), pressedDepths(analysis));
    PlanOptions options;
    options.isOutOfTime = isOutOfTime;
    result.overlaps = overlapsOf(collisions, isOutOfTime);
    // What is in each other in its place may be so on its way, but no deeper.
    for (const PartOverlap &overlap : result.overlaps) {
        options.inEachOther.emplace_back(overlap.a, overlap.b);
        collisions.press(overlap.a, overlap.b,
                         std::max(collisions.depth(overlap.a, overlap.b), overlap.how.depth) +
                             kTouchingDepth);
    }
    const std::vector<Slide> slides = slidesOf(analysis);
    result.plan = planAssembly(collisions, slides, options);
    if (result.plan.locked.size() == 2)
        result.stop = stopOf(collisions, slides, result.plan.locked);
    return result;
}

} // namespace fff
