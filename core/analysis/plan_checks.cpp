#include "core/analysis/plan_checks.h"

#include "core/assembly/cycles.h"
#include "core/base/tolerances.h"
#include "core/fabrication/wholeness.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace fff {

namespace {

/// The sections of parts, each once.
std::vector<int> sectionsOf(const std::vector<int> &parts, const ModelPlan &plan)
{
    std::set<int> sections;
    for (const int part : parts)
        sections.insert(plan.bodies.sectionOf(part));
    return {sections.begin(), sections.end()};
}

Vec3 placeOf(const Joint &joint)
{
    const Overlap &overlap = joint.crossing->overlaps.front();
    return joint.crossing->axis.at(overlap.meet);
}

CheckLink linkOf(const Model &model, const Joint &joint)
{
    const auto middleOf = [&](int index) {
        const Section &section = *model.section(static_cast<std::size_t>(index));
        return section.frame.toWorld(section.shape->centroid());
    };
    return {model.ref(static_cast<std::size_t>(joint.a)),
            model.ref(static_cast<std::size_t>(joint.b)),
            middleOf(joint.a),
            middleOf(joint.b),
            placeOf(joint),
            joint.crossing->axis.direction};
}

/// Why parts are locked: the ways in which the joints among them slide, and what stops the one that
/// could move.
void explain(const Analysis &analysis, const ModelPlan &plan, const std::vector<int> &sections,
             Check &check)
{
    std::vector<Vec3> ways;
    const auto isLocked = [&](int section) {
        return std::binary_search(sections.begin(), sections.end(), section);
    };
    const SharedRows<Joint> &rows = analysis.assembly.joints.rows();
    for (const int section : sections) {
        for (const Joint &joint : rows[static_cast<std::size_t>(section)]) {
            if (joint.kind == JointKind::None || !isLocked(joint.b))
                continue;
            ++check.count;
            check.links.push_back(linkOf(analysis.model, joint));
            if (!check.at)
                check.at = placeOf(joint);
            const Vec3 &way = joint.crossing->axis.direction;
            if (slidesAlongAxis(joint.kind) &&
                std::none_of(ways.begin(), ways.end(),
                             [&](const Vec3 &other) { return areParallel(way, other); }))
                ways.push_back(way);
        }
    }
    check.directions = static_cast<int>(ways.size());
    if (!plan.stop)
        return;
    const auto sectionOf = [&](int part) { return plan.bodies.sectionOf(part); };
    // Who moves is named first.
    check.sections = analysis.model.refs({sectionOf(plan.stop->part), sectionOf(plan.stop->by)});
    check.distance = plan.stop->distance;
    check.joint = JointRef(check.sections[0], check.sections[1]);
}

Check verdict(const Analysis &analysis, const ModelPlan &plan)
{
    Check check;
    switch (plan.plan.verdict) {
    case AssemblyPlan::Verdict::Possible:
        check.code = CheckCode::CanAssemble;
        check.severity = CheckSeverity::Good;
        check.count = static_cast<int>(plan.plan.steps.size());
        break;
    case AssemblyPlan::Verdict::Impossible: {
        check.code = CheckCode::CannotAssemble;
        check.severity = CheckSeverity::Error;
        const std::vector<int> sections = sectionsOf(plan.plan.locked, plan);
        check.sections = analysis.model.refs(sections);
        explain(analysis, plan, sections, check);
        break;
    }
    case AssemblyPlan::Verdict::NotFound:
        check.code = CheckCode::OrderUnknown;
        check.severity = CheckSeverity::Unknown;
        if (plan.failure) {
            check.failure = plan.failure;
            check.sections = analysis.model.refs(sectionsWithoutSolid(analysis.bodies));
        }
        break;
    }
    return check;
}

/// A hint, whatever planning finds: the paper's sign of what cannot be put together. Not where the
/// verdict speaks of the same sections.
void addCycles(const Analysis &analysis, const ModelPlan &plan, std::vector<Check> &all)
{
    const auto cycles = cyclesOf(analysis.model.sectionCount(), analysis.assembly.joints);
    std::set<int> sections;
    for (const std::vector<int> &cycle : cycles)
        sections.insert(cycle.begin(), cycle.end());
    const std::vector<int> locked = sectionsOf(plan.plan.locked, plan);
    if (std::includes(locked.begin(), locked.end(), sections.begin(), sections.end()))
        return;
    Check check;
    check.code = CheckCode::Cycle;
    check.severity = CheckSeverity::Note;
    check.sections = analysis.model.refs(
        cycles.size() == 1 ? cycles.front() : std::vector<int>(sections.begin(), sections.end()));
    check.count = static_cast<int>(cycles.size());
    std::set<std::pair<int, int>> linked; // a joint may be of several rings
    for (const std::vector<int> &cycle : cycles) {
        for (std::size_t i = 0, k = cycle.size() - 1; i < cycle.size(); k = i++) {
            const auto [a, b] = std::minmax(cycle[i], cycle[k]);
            const Joint *joint = analysis.assembly.joints.find(a, b);
            if (joint && linked.emplace(a, b).second)
                check.links.push_back(linkOf(analysis.model, *joint));
        }
    }
    if (!check.links.empty())
        check.at = check.links.front().at;
    all.push_back(std::move(check));
}

/// Between the planes of two sections, 0 … π/2.
double angleBetween(const Model &model, const std::pair<int, int> &sections)
{
    const Vec3 a = model.section(static_cast<std::size_t>(sections.first))->frame.normal();
    const Vec3 b = model.section(static_cast<std::size_t>(sections.second))->frame.normal();
    return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

/// What stays between the slits of a section and beside them. Less than half of the thickness
/// breaks in the hand; below the whole of it it is good to know.
void addWebs(const Analysis &analysis, std::size_t section, const std::vector<Web> &webs,
             std::vector<Check> &all)
{
    const Model &model = analysis.model;
    const std::vector<Slit> &slits = analysis.assembly.slits[section];
    const auto guestOf = [&](int slit) {
        const int guest = slits.at(static_cast<std::size_t>(slit)).guest;
        return model.ref(static_cast<std::size_t>(guest));
    };
    for (const Web &web : webs) {
        Check check;
        check.code = web.width > 0.0 || web.between != Web::Between::Slits ? CheckCode::ThinWeb
                                                                           : CheckCode::SlitsMeet;
        check.severity = CheckSeverity::Warning;
        if (web.width >= 0.5 * model.stockOf(section).thickness)
            check.severity = CheckSeverity::Note;
        check.sections = {model.ref(section)};
        check.guests = {guestOf(web.slit)};
        if (web.between == Web::Between::Slits)
            check.guests.push_back(guestOf(web.other));
        else
            check.joint = JointRef(check.sections.front(), check.guests.front());
        check.at = model.section(section)->frame.toWorld(web.at);
        check.distance = web.width;
        check.count = web.between == Web::Between::SlitAndHole ? 1 : 0;
        all.push_back(std::move(check));
    }
}

/// Those of each section, worked out anew where its slits or its stock are other ones.
void refresh(const Analysis &analysis, WebCaches &caches)
{
    caches.sections.resize(analysis.model.sectionCount());
    for (std::size_t i = 0; i < caches.sections.size(); ++i) {
        WebCaches::OfSection &known = caches.sections[i];
        const double thickness = analysis.model.stockOf(i).thickness;
        if (known.cut == analysis.cuts[i] && known.thickness == thickness)
            continue;
        known = {analysis.cuts[i], thickness,
                 thinWebs(analysis.model.section(i)->shape->region(), analysis.assembly.slits[i],
                          thickness)};
    }
}

} // namespace

std::vector<Check> planChecks(const Analysis &analysis, const ModelPlan &plan)
{
    WebCaches caches;
    return planChecks(analysis, plan, caches);
}

std::vector<Check> planChecks(const Analysis &analysis, const ModelPlan &plan, WebCaches &caches)
{
    std::vector<Check> all;
    refresh(analysis, caches);
    const bool isEmpty =
        plan.bodies.size() == 0 && plan.plan.verdict == AssemblyPlan::Verdict::Possible;
    if (isEmpty)
        return all;
    all.push_back(verdict(analysis, plan));
    // Of all pieces of two sections the deepest.
    std::map<std::pair<int, int>, const Interpenetration *> deepest;
    for (const PartOverlap &overlap : plan.overlaps) {
        const int a = plan.bodies.sectionOf(overlap.a);
        const int b = plan.bodies.sectionOf(overlap.b);
        const Interpenetration *&known = deepest[{a, b}];
        if (!known || overlap.how.depth > known->depth)
            known = &overlap.how;
    }
    for (const auto &[pair, how] : deepest) {
        const Joint *joint = analysis.assembly.joints.find(pair.first, pair.second);
        if (joint && joint->kind == JointKind::None)
            continue; // it is said of the joint
        Check check;
        check.code = CheckCode::Interference;
        check.severity = CheckSeverity::Warning;
        check.angle = angleBetween(analysis.model, pair);
        if (!joint && check.angle > kPracticallyParallel && check.angle < kMinJointAngle) {
            check.code = CheckCode::ShallowAngle; // that is why there is no slit
            check.severity = CheckSeverity::Error;
        }
        check.sections = analysis.model.refs({pair.first, pair.second});
        check.at = how->at;
        check.distance = how->depth;
        check.count = joint ? 1 : 0;
        if (joint)
            check.joint = JointRef(check.sections[0], check.sections[1]);
        all.push_back(std::move(check));
    }
    addCycles(analysis, plan, all);
    for (std::size_t i = 0; i < caches.sections.size(); ++i)
        addWebs(analysis, i, caches.sections[i].webs, all);
    return all;
}

std::function<bool()> timeLimit(std::chrono::milliseconds time)
{
    const auto end = std::chrono::steady_clock::now() + time;
    return [end] { return std::chrono::steady_clock::now() >= end; };
}

} // namespace fff
