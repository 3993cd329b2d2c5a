#include "core/analysis/checks.h"

#include "core/analysis/gap.h"
#include "core/analysis/narrow_slits.h"
#include "core/analysis/planned.h"
#include "core/analysis/stretching.h"
#include "core/assembly/found_joint.h"
#include "core/base/tolerances.h"
#include "core/fabrication/wholeness.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

// Beyond this many loose groups nobody reads how far each is from the rest.
constexpr std::size_t kMaxMeasuredGroups = 32;

using Group = std::vector<int>;

Check makeCheck(CheckCode code, CheckSeverity severity)
{
    Check check;
    check.code = code;
    check.severity = severity;
    return check;
}

Towards towards(const Vec2 &direction)
{
    if (std::abs(direction.x()) > std::abs(direction.y()))
        return direction.x() > 0.0 ? Towards::Right : Towards::Left;
    return direction.y() >= 0.0 ? Towards::Front : Towards::Back;
}

// --- connection

/// How far the groups after the first are from all other sections. What is known stays so.
void refreshGaps(const Analysis &analysis, const std::vector<Group> &groups, CheckCaches &caches)
{
    std::vector<CheckCaches::OfGroup> gaps;
    for (std::size_t g = 1; g < std::min(groups.size(), kMaxMeasuredGroups + 1); ++g) {
        const auto known = std::find_if(caches.gaps.begin(), caches.gaps.end(),
                                        [&](const auto &gap) { return gap.group == groups[g]; });
        gaps.push_back(known != caches.gaps.end() ? std::move(*known)
                                                  : measuredGap(analysis.bodies, groups[g]));
    }
    caches.gaps = std::move(gaps);
}

void addConnection(const Analysis &analysis, const std::vector<Group> &groups, CheckCaches &caches,
                   std::vector<Check> &all)
{
    refreshGaps(analysis, groups, caches);
    if (groups.size() == 1) {
        Check check = makeCheck(CheckCode::Connected, CheckSeverity::Good);
        check.sectionCount = static_cast<int>(groups.front().size());
        check.count = static_cast<int>(
            std::count_if(analysis.assembly.joints.begin(), analysis.assembly.joints.end(),
                          [](const Joint &joint) { return joint.kind != JointKind::None; }));
        all.push_back(std::move(check));
        return;
    }
    for (std::size_t g = 1; g < groups.size(); ++g) {
        Check check = makeCheck(CheckCode::NotConnected, CheckSeverity::Error);
        check.sections = analysis.model.refs(groups[g]);
        check.distance = -1.0;
        if (g <= caches.gaps.size() && caches.gaps[g - 1].other >= 0) {
            const CheckCaches::OfGroup &gap = caches.gaps[g - 1];
            check.distance = gap.distance;
            check.at = gap.at;
            check.other = analysis.model.ref(static_cast<std::size_t>(gap.other));
        }
        all.push_back(std::move(check));
    }
}

// --- stability

CheckCode codeOf(const Stability &stability)
{
    switch (stability.standing) {
    case Standing::Stands:
        return stability.tipAngle < kSteadyTilt ? CheckCode::Unsteady : CheckCode::Stands;
    case Standing::Topples:
        return CheckCode::Topples;
    case Standing::LineSupport:
        return CheckCode::LineSupport;
    case Standing::NoContact:
        return CheckCode::NoContact;
    case Standing::BelowGround:
        return CheckCode::BelowGround;
    }
    return CheckCode::Stands; // not reached: every case is above
}

/// The sections of a group that reach below the ground.
std::vector<SectionRef> sunkSections(const Analysis &analysis, const Group &group)
{
    Group sunk;
    for (const int section : group) {
        const auto bodies = analysis.bodies.of(section);
        if (std::any_of(bodies.begin(), bodies.end(), [](const BodyPointer &body) {
                return body->contact().lowestMiddle < -kGroundSunk;
            }))
            sunk.push_back(section);
    }
    return analysis.model.refs(sunk);
}

GroundContact contactOf(const Bodies &bodies, const Group &group)
{
    std::vector<const GroundContact *> contacts;
    for (const int section : group)
        for (const BodyPointer &body : bodies.of(section))
            contacts.push_back(&body->contact());
    GroundContact contact = together(contacts);
    contact.corners = convexHull(contact.corners);
    return contact;
}

/// The same as long as its sections' contacts are.
const GroundContact &refreshedContact(const Bodies &bodies, const Group &group,
                                      const CheckCaches &caches, CheckCaches::OfStance &stance)
{
    const auto isAsBefore = [&](int section) {
        return caches.sections[static_cast<std::size_t>(section)].contactsSince <= stance.since;
    };
    if (stance.group != group || !std::all_of(group.begin(), group.end(), isAsBefore))
        stance = {group, caches.count, contactOf(bodies, group)};
    return stance.contact;
}

Stability stabilityOf(const Bodies &bodies, const Group &group, const MassProperties &mass,
                      const GroundContact &contact)
{
    Box3 box;
    double thinnest = std::numeric_limits<double>::infinity();
    for (const int section : group) {
        for (const BodyPointer &body : bodies.of(section)) {
            box.extend(body->box());
            thinnest = std::min(thinnest, body->thickness());
        }
    }
    if (box.isEmpty())
        return {};
    return stability(contact, mass.centre, thinnest, box.size().maxCoeff());
}

Check stabilityCheck(const Analysis &analysis, const Group &group, const CheckCaches &caches,
                     CheckCaches::OfStance &stance)
{
    const MassProperties mass = loadedMass(analysis, group);
    const Stability stability = stabilityOf(
        analysis.bodies, group, mass, refreshedContact(analysis.bodies, group, caches, stance));
    Check check = makeCheck(codeOf(stability), CheckSeverity::Error);
    check.mass = mass;
    check.margin = stability.margin;
    check.tipAngle = stability.tipAngle;
    check.side = towards(stability.fall);
    check.support = stability.support;
    check.edge = stability.nearest;
    check.sectionCount = static_cast<int>(group.size());
    check.at = Vec3(check.mass.centre.x(), 0.0, check.mass.centre.z());
    switch (stability.standing) {
    case Standing::Stands:
        check.severity =
            check.code == CheckCode::Unsteady ? CheckSeverity::Warning : CheckSeverity::Good;
        break;
    case Standing::NoContact:
    case Standing::BelowGround:
        check.distance = std::abs(stability.height);
        check.at = stability.lowestPoint;
        break;
    case Standing::Topples:
    case Standing::LineSupport:
        check.feet = feetToStretch(analysis, group);
        break;
    }
    return check;
}

void addStability(const Analysis &analysis, const std::vector<Group> &groups, CheckCaches &caches,
                  std::vector<Check> &all)
{
    caches.stances.resize(groups.size());
    std::optional<Check> standing; // of all groups that stand, the one that falls first
    std::vector<Check> bad;
    int standingSections = 0;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        Check check = stabilityCheck(analysis, groups[g], caches, caches.stances[g]);
        if (check.code == CheckCode::BelowGround)
            check.sections = sunkSections(analysis, groups[g]);
        else if (groups.size() > 1)
            check.sections = analysis.model.refs(groups[g]);
        if (check.code == CheckCode::Stands || check.code == CheckCode::Unsteady) {
            standingSections += check.sectionCount;
            if (!standing || check.tipAngle < standing->tipAngle)
                standing = std::move(check);
        } else if (g == 0 || check.code != CheckCode::NoContact) {
            bad.push_back(std::move(check));
        }
    }
    if (!bad.empty()) {
        all.insert(all.end(), bad.begin(), bad.end());
    } else if (standing) {
        standing->sectionCount = standingSections;
        all.push_back(*standing);
    }
}

// --- size

void addSize(const Analysis &analysis, const LayoutOptions &options, CheckCaches &caches,
             std::vector<Check> &all)
{
    const Model &model = analysis.model;
    std::vector<SizedPart> parts;
    for (std::size_t i = 0; i < caches.sections.size(); ++i) {
        const auto &sizes = caches.sections[i].sizes;
        for (const auto &size : sizes)
            parts.push_back({model.section(i)->stock, size});
    }
    const Layout layout = layOutBySize(parts, model, options, caches.layout);
    std::vector<int> oversized = layout.oversized;
    std::sort(oversized.begin(), oversized.end());
    int last = -1;
    for (const int index : oversized) {
        const int section = analysis.bodies.sectionOf(index);
        if (section == last) {
            ++all.back().count;
            continue;
        }
        last = section;
        const Body &body = analysis.bodies.at(index);
        Check check = makeCheck(CheckCode::TooLarge, CheckSeverity::Error);
        check.sections = {body.key().section};
        const Box2 box = bounds(body.outline().region.outer);
        check.size = {box.size().maxCoeff(), box.size().minCoeff()};
        check.sheet =
            options.sheet.value_or(model.stockOf(static_cast<std::size_t>(section)).sheet);
        check.at = body.frame().toWorld(box.center());
        check.margin = options.margin;
        check.count = 1;
        all.push_back(std::move(check));
    }
    if (!oversized.empty())
        return;
    Check check = makeCheck(CheckCode::FitsSheet, CheckSeverity::Good);
    check.count = static_cast<int>(layout.sheets.size());
    check.share = usedShare(layout, parts);
    if (!layout.sheets.empty() &&
        std::all_of(layout.sheets.begin(), layout.sheets.end(),
                    [&](const Sheet &sheet) { return sheet.size == layout.sheets.front().size; }))
        check.sheet = layout.sheets.front().size;
    all.push_back(std::move(check));
}

// --- joints

/// What could not be worked out.
void addFailures(const Analysis &analysis, std::vector<Check> &all)
{
    const Model &model = analysis.model;
    for (const Operation *operation : failedOperations(model)) {
        Check check = makeCheck(CheckCode::NotMade, CheckSeverity::Error);
        check.failure = Error{ErrorCode::OperationFailed, {}, {operation->name}};
        all.push_back(std::move(check));
    }
    for (const int index : uncutSections(analysis.bodies)) {
        const Section &section = *model.section(static_cast<std::size_t>(index));
        Check check = makeCheck(CheckCode::NotCutOut, CheckSeverity::Error);
        check.sections = {section.ref()};
        check.at = section.frame.toWorld(section.shape->centroid());
        check.failure = Error{ErrorCode::NotCutOut, {}, {section.name}};
        all.push_back(std::move(check));
    }
}

void addJoints(const Analysis &analysis, const CheckRules &rules, std::vector<Check> &all)
{
    const Model &model = analysis.model;
    for (const Joint &joint : analysis.assembly.joints) {
        const Crossing &crossing = *joint.crossing;
        const bool collides = joint.kind == JointKind::None;
        if (!collides && !(crossing.angle < rules.shallowAngle))
            continue;
        const auto longest = std::max_element(
            crossing.overlaps.begin(), crossing.overlaps.end(),
            [](const Overlap &a, const Overlap &b) { return a.to - a.from < b.to - b.from; });
        Check check = makeCheck(collides ? CheckCode::NoSlit : CheckCode::ShallowAngle,
                                CheckSeverity::Warning);
        check.sections = model.refs({joint.a, joint.b});
        check.joint = JointRef(check.sections[0], check.sections[1]);
        check.at = crossing.axis.at(0.5 * (longest->from + longest->to));
        check.distance = longest->to - longest->from;
        check.angle = crossing.angle;
        check.leastAngle = rules.shallowAngle;
        if (collides)
            check.noSlit = whyNoSlit(model, joint);
        all.push_back(std::move(check));
    }
    addFailures(analysis, all);
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const std::size_t parts = analysis.cuts[i]->parts().size();
        if (parts == 1)
            continue;
        const Section &section = *model.section(i);
        Check check = parts == 0 ? makeCheck(CheckCode::NothingLeft, CheckSeverity::Error)
                                 : makeCheck(CheckCode::Divided, CheckSeverity::Warning);
        check.sections = {model.ref(i)};
        check.at = section.frame.toWorld(section.shape->centroid());
        check.count = static_cast<int>(parts);
        all.push_back(std::move(check));
    }
}

} // namespace

CheckSubject subjectOf(CheckCode code)
{
    switch (code) {
    case CheckCode::Connected:
    case CheckCode::NotConnected:
        return CheckSubject::Connection;
    case CheckCode::Stands:
    case CheckCode::Unsteady:
    case CheckCode::Topples:
    case CheckCode::LineSupport:
    case CheckCode::NoContact:
    case CheckCode::BelowGround:
        return CheckSubject::Stability;
    case CheckCode::FitsSheet:
    case CheckCode::TooLarge:
        return CheckSubject::Size;
    case CheckCode::Mass:
        return CheckSubject::Mass;
    case CheckCode::CanAssemble:
    case CheckCode::CannotAssemble:
    case CheckCode::OrderUnknown:
        return CheckSubject::Assembly;
    case CheckCode::NoSlit:
    case CheckCode::Interference:
    case CheckCode::ShallowAngle:
    case CheckCode::Cycle:
    case CheckCode::SlitsMeet:
    case CheckCode::ThinWeb:
    case CheckCode::NarrowSlit:
    case CheckCode::Divided:
    case CheckCode::NothingLeft:
    case CheckCode::NotCutOut:
    case CheckCode::NotMade:
    case CheckCode::NotWorkedOut:
        return CheckSubject::Joints;
    }
    return CheckSubject::Joints; // not reached: every code is above
}

CheckSubject subjectOf(const Check &check)
{
    const bool isOfPlan = check.stage && std::string_view(check.stage) == kPlanned.name;
    return isOfPlan ? CheckSubject::Assembly : subjectOf(check.code);
}

std::vector<SectionRef> concerned(const Check &check)
{
    std::vector<SectionRef> sections = check.sections;
    for (const HighFoot &foot : check.feet)
        if (std::find(sections.begin(), sections.end(), foot.section) == sections.end())
            sections.push_back(foot.section);
    return sections;
}

MassProperties loadedMass(const Analysis &analysis, const std::vector<int> &sections)
{
    const Model &model = analysis.model;
    MassProperties sum;
    for (const int section : sections) {
        const auto index = static_cast<std::size_t>(section);
        const Section &host = *model.section(index);
        sum += analysis.bodies.massOf(section);
        for (const Weight &weight : model.document.weights)
            if (weight.section == model.ref(index))
                sum += {weight.mass, host.frame.toWorld(weight.position)};
    }
    return sum;
}

Stability stabilityOf(const Analysis &analysis, const std::vector<int> &sections)
{
    return stabilityOf(analysis.bodies, sections, loadedMass(analysis, sections),
                       contactOf(analysis.bodies, sections));
}

std::vector<Check> checks(const Analysis &analysis, const LayoutOptions &layout,
                          const CheckRules &rules)
{
    CheckCaches caches;
    return checks(analysis, caches, layout, rules);
}

std::vector<Check> checks(const Analysis &analysis, CheckCaches &caches,
                          const LayoutOptions &layout, const CheckRules &rules)
{
    std::vector<Check> all;
    const std::size_t count = analysis.model.sectionCount();
    refreshCaches(analysis, layout, caches);
    if (count == 0)
        return all;
    const std::vector<Group> groups = connectedGroups(count, analysis.assembly.joints);
    addConnection(analysis, groups, caches, all);
    addStability(analysis, groups, caches, all);
    addSize(analysis, layout, caches, all);
    Check mass = makeCheck(CheckCode::Mass, CheckSeverity::Good);
    mass.mass = analysis.bodies.mass();
    mass.at = mass.mass.centre;
    all.push_back(std::move(mass));
    addJoints(analysis, rules, all);
    std::vector<Check> narrow = narrowSlits(analysis);
    std::move(narrow.begin(), narrow.end(), std::back_inserter(all));
    return all;
}

std::optional<CheckSeverity> worst(const std::vector<Check> &checks, CheckSubject subject)
{
    std::optional<CheckSeverity> result;
    for (const Check &check : checks)
        if (subjectOf(check) == subject)
            result = std::max(check.severity, result.value_or(check.severity));
    return result;
}

} // namespace fff
