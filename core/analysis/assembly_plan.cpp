#include "core/analysis/assembly_plan.h"

#include "core/assembly/crossing.h"
#include "core/base/tolerances.h"
#include "core/fabrication/wholeness.h"
#include "core/geometry/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace fff {

namespace {

/// Of each section its first part; those of one section come one after the other.
class FirstParts
{
public:
    FirstParts(const Analysis &analysis, const std::vector<PartRef> &parts)
        : m_first(analysis.model.sectionCount() + 1, 0)
    {
        for (const PartRef &part : parts)
            ++m_first[static_cast<std::size_t>(part.section) + 1];
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    }

    int count(int section) const { return end(section) - begin(section); }
    /// Calls visit(a, b) for each part of the joint's a with each of its b.
    template <class Visit>
    void forEachPair(const Joint &joint, Visit visit) const
    {
        for (int a = begin(joint.a); a < end(joint.a); ++a)
            for (int b = begin(joint.b); b < end(joint.b); ++b)
                visit(a, b);
    }

private:
    int begin(int section) const { return m_first[static_cast<std::size_t>(section)]; }
    int end(int section) const { return m_first[static_cast<std::size_t>(section) + 1]; }

    std::vector<int> m_first; // and behind the last one their number
};

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
Collisions::Depths pressedDepths(const Analysis &analysis, const FirstParts &first)
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
        first.forEachPair(joint, [&, depth = depth](int a, int b) {
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

/// Parts of more triangles than this are cut up into cells: an edit of a long spine, and who asks
/// about one of its ribs, has to do with a few of them.
constexpr std::size_t kManyTriangles = 192;

SolidPointer solidOf(const CutSection &cut, std::size_t piece, const Frame &frame, double thickness)
{
    const Triangulation &triangles = (*cut.triangulations())[piece];
    auto whole = std::make_shared<const Solid>(makeSolid(triangles, frame, thickness));
    if (triangles.triangles.size() <= kManyTriangles)
        return whole;
    const Result<Triangulation> cells = triangulateCells(cut.parts()[piece].region);
    if (!cells)
        return whole; // the same, only slower
    return std::make_shared<const Solid>(cutUp(std::move(whole), *cells));
}

} // namespace

std::vector<SolidPointer> solidsOf(const Analysis &analysis, std::vector<PartRef> &parts,
                                   PlanCaches &caches, const std::function<bool()> &isOutOfTime)
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
            if (isOutOfTime && isOutOfTime()) {
                parts.clear();
                return {};
            }
            known = {cut, frame, thickness, {}};
            for (std::size_t k = 0; k < cut->parts().size(); ++k)
                known.solids.push_back(solidOf(*cut, k, frame, thickness));
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
    const FirstParts first(analysis, parts);
    const SlitsOfJoints slits(analysis);
    std::vector<Slide> slides;
    for (const Joint &joint : analysis.assembly.joints) {
        if (joint.kind == JointKind::None)
            continue;
        // Of a divided section it is not known which piece it holds: one direction more to try.
        const bool isWhole = first.count(joint.a) == 1 && first.count(joint.b) == 1;
        Slide slide;
        slide.direction = slideOf(analysis, joint, slits);
        slide.goesBothWays = !slidesAlongAxis(joint.kind);
        if (!slide.goesBothWays) {
            const Hold hold = holdOf(analysis, joint, slits);
            slide.length = hold.length;
            slide.play = isWhole ? hold.play : slide.play;
        }
        first.forEachPair(joint, [&](int a, int b) {
            slide.a = a;
            slide.b = b;
            slides.push_back(slide);
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

ModelPlan planOf(const Analysis &analysis, const std::function<bool()> &isOutOfTime)
{
    PlanCaches caches;
    return planOf(analysis, caches, isOutOfTime);
}

ModelPlan planOf(const Analysis &analysis, PlanCaches &caches,
                 const std::function<bool()> &isOutOfTime)
{
    ModelPlan result;
    if (const Result<void> known = haveSolids(analysis.model, analysis.cuts); !known) {
        result.plan.verdict = AssemblyPlan::Verdict::NotFound;
        result.failure = known.error();
        return result;
    }
    Collisions &collisions = caches.collisions;
    std::vector<SolidPointer> solids = solidsOf(analysis, result.parts, caches, isOutOfTime);
    if (solids.empty() && analysis.model.sectionCount() > 0)
        return result; // NotFound
    collisions.use(std::move(solids), pressedDepths(analysis, FirstParts(analysis, result.parts)));
    PlanOptions options;
    options.isOutOfTime = isOutOfTime;
    result.overlaps = overlapsOf(collisions, isOutOfTime);
    for (const PartOverlap &overlap : result.overlaps)
        options.ignored.emplace_back(overlap.a, overlap.b);
    const std::vector<Slide> slides = slidesOf(analysis, result.parts);
    result.plan = planAssembly(collisions, slides, options);
    if (result.plan.locked.size() == 2)
        result.stop = stopOf(collisions, slides, result.plan.locked);
    return result;
}

} // namespace fff
