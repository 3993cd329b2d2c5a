#include "core/analysis/suggesting/suggestion_judge.h"

#include "core/analysis/checks.h"
#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/findings/wholeness.h"
#include "core/analysis/plan_checks.h"
#include "core/assembly/joint_state.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <map>
#include <utility>

namespace fff {

namespace {

/// So often planning may ask whether it shall go on; some milliseconds each at worst.
constexpr long kMostPlanningSteps = 20'000;

/// Those that hang on where sections lie; size, mass and stock are somebody else's matter.
constexpr Finder kJudges[] = {findConnection, findLoosePieces, findStanding,   findJointFaults,
                              findFailures,   findDivided,     findLooseJoints};

std::size_t wrongAmong(const std::vector<Finding> &found)
{
    return static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [](const Finding &finding) {
            return finding.severity >= Severity::Warning || finding.severity == Severity::Unknown;
        }));
}

} // namespace

SuggestionJudge::SuggestionJudge(Document document, std::stop_token stop)
    : m_document(std::move(document)), m_stop(std::move(stop))
{
    if (!m_document.sections.empty() || !m_document.operations.empty())
        m_before = faultsOf(m_document).value_or(Faults());
    m_before.groups = std::max<std::size_t>(m_before.groups, 1);
    for (const SectionPointer &section : m_document.sections)
        m_thereBefore.insert(section->id);
}

std::optional<SuggestionJudge::Faults> SuggestionJudge::faultsOf(const Document &document)
{
    const AnalysisPointer analysis = analyseNext(evaluate(document), m_analysis);
    const std::size_t sections = analysis->model.sectionCount();
    Faults faults;
    faults.groups = heldGroups(analysis->bodies, analysis->assembly.joints, analysis->grips).size();
    faults.loosePieces = std::max(analysis->bodies.size(), sections) - sections;
    if (faults.groups > std::max<std::size_t>(m_before.groups, 1) && sections > 1)
        return faults; // nobody needs to know more
    faults.findings = wrongAmong(checks(*analysis, m_checks, {}, {}, kJudges));
    if (faults.findings > m_before.findings)
        return faults;
    long steps = 0;
    const ModelPlan plan = planOf(
        *analysis, m_plan, [&] { return ++steps > kMostPlanningSteps || m_stop.stop_requested(); });
    if (plan.plan.verdict != AssemblyPlan::Verdict::Possible)
        return {};
    const std::vector<Finding> found = planChecks(*analysis, plan, m_planChecks);
    faults.thinWalls = static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [](const Finding &finding) {
            return finding.is(kThinWeb) && finding.severity >= Severity::Warning;
        }));
    faults.findings += wrongAmong(found) - faults.thinWalls;
    return faults;
}

std::optional<Document> SuggestionJudge::slidOnFrom(const Document &document, double side) const
{
    const Model model = evaluate(document);
    const SectionRef last(document.sections.back()->id);
    const int index = model.indexOf(last);
    Document next = document;
    std::optional<Vec3> way;
    for (const Joint &joint : m_analysis.last->assembly.joints) {
        if (joint.a != index && joint.b != index)
            continue;
        const int other = joint.a == index ? joint.b : joint.a;
        const JointRef ref(model.ref(static_cast<std::size_t>(other)), last);
        const std::optional<JointState> state = jointState(model, ref);
        if (!state || !slidesAlongAxis(state->kind))
            return {};
        const Vec3 opening = state->ref.b == last ? state->openingOfB() : -state->openingOfB();
        way = way.value_or(side * opening);
        if (opening.dot(*way) > 0.0)
            continue;
        if (!state->canFlip)
            return {};
        next = setJointOverride(std::move(next), flipped(model, *state)).value_or(next);
    }
    return next.isSame(document) ? std::nullopt : std::optional(std::move(next));
}

SuggestionJudge::Verdict SuggestionJudge::take(const std::vector<NewSection> &sections,
                                               bool allowsThinWalls)
{
    Result<Document> next = addSections(m_document, sections);
    if (!next)
        return Verdict::Refused;
    std::optional<Faults> faults = faultsOf(*next);
    const auto isGood = [this](const std::optional<Faults> &one) {
        return one && one->isNoMoreThan(m_before) && one->thinWalls <= m_before.thinWalls;
    };
    for (const double side : {1.0, -1.0}) {
        // Who is loose or falls over does so whichever way the slits open.
        const bool mayHelp = !faults || faults->isNoMoreThan(m_before);
        if (isGood(faults) || !mayHelp || sections.size() > 1 || m_stop.stop_requested())
            break;
        std::optional<Document> other = slidOnFrom(*next, side);
        if (!other)
            continue;
        const std::optional<Faults> then = faultsOf(*other);
        if (isGood(then) || (!faults && then)) {
            faults = then;
            next = *std::move(other);
        }
    }
    if (!faults || !faults->isNoMoreThan(m_before))
        return Verdict::Refused;
    const bool isWeak = faults->thinWalls > m_before.thinWalls;
    if (isWeak && !allowsThinWalls)
        return Verdict::Weak;
    const Document before = std::exchange(m_document, *std::move(next));
    const Faults faultsBefore = m_before;
    m_before.thinWalls = std::max(m_before.thinWalls, faults->thinWalls);
    turnPulledSlits();
    if (isWeak && breaks()) {
        m_document = before;
        m_before = faultsBefore;
        return Verdict::Refused;
    }
    return Verdict::Taken;
}

SuggestionJudge::Verdict SuggestionJudge::verdictOn(const Document &next)
{
    const std::optional<Faults> faults = faultsOf(next);
    if (!faults || !faults->isNoMoreThan(m_before))
        return Verdict::Refused;
    return faults->thinWalls > m_before.thinWalls ? Verdict::Weak : Verdict::Taken;
}

/// Under its own weight.
bool SuggestionJudge::breaks()
{
    const AnalysisPointer analysis = analyseNext(evaluate(m_document), m_analysis);
    const Strength strength = strengthOf(*analysis, StrengthRules(), m_strength, {m_stop, {}});
    return strength.verdict == HoldVerdict::Breaks || strength.verdict == HoldVerdict::NotWorkedOut;
}

SuggestionJudge::Pulls SuggestionJudge::pullsOf(const Document &document)
{
    const AnalysisPointer analysis = analyseNext(evaluate(document), m_analysis);
    const Strength strength = forcesIn(*analysis, StrengthRules(), m_strength, {m_stop, {}});
    Pulls pulls;
    if (!strength.equilibrium().isSound || !isPulledApart(strength.equilibrium()))
        return pulls;
    std::map<JointRef, double> pulled;
    const std::vector<LinkForce> &links = strength.equilibrium().links;
    for (std::size_t i = 0; i < links.size(); ++i) {
        if (!links[i].isOpen)
            continue;
        const Link &link = strength.made.structure.links[i];
        const auto refOf = [&](int body) {
            return analysis->model.ref(static_cast<std::size_t>(analysis->bodies.sectionOf(body)));
        };
        const SectionRef a = refOf(link.a), b = refOf(link.b);
        pulled[JointRef(std::min(a, b), std::max(a, b))] += links[i].asked;
    }
    std::vector<std::pair<double, JointRef>> sorted;
    for (const auto &[joint, pull] : pulled) {
        pulls.sum += pull;
        sorted.emplace_back(pull, joint);
    }
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto &x, const auto &y) { return x.first > y.first; });
    for (const auto &[pull, joint] : sorted)
        pulls.joints.push_back(joint);
    return pulls;
}

Document SuggestionJudge::withTurned(const std::vector<JointRef> &joints) const
{
    const Model model = evaluate(m_document);
    Document next = m_document;
    for (const JointRef &joint : joints) {
        const std::optional<JointState> state = jointState(model, joint);
        const bool isNew =
            !m_thereBefore.contains(joint.a.drawn) || !m_thereBefore.contains(joint.b.drawn);
        if (isNew && state && state->canFlip)
            next = setJointOverride(std::move(next), flipped(model, *state)).value_or(next);
    }
    return next;
}

void SuggestionJudge::turnPulledSlits()
{
    constexpr double kLess = 0.999; // of a pull: what is not less than this is the same
    Pulls pulls = pullsOf(m_document);
    for (bool isBetter = true; isBetter && pulls.sum > 0.0 && !m_stop.stop_requested();) {
        isBetter = false;
        // What slides on from one side has all its slits on that side: those of a section turn
        // together, or of all sections.
        std::vector<std::vector<JointRef>> tries{pulls.joints};
        std::map<SectionRef, std::vector<JointRef>> bySection;
        for (const JointRef &joint : pulls.joints) {
            bySection[joint.a].push_back(joint);
            bySection[joint.b].push_back(joint);
        }
        for (const auto &[section, joints] : bySection)
            if (joints.size() > 1 && joints.size() < pulls.joints.size())
                tries.push_back(joints);
        if (pulls.joints.size() > 1)
            for (const JointRef &joint : pulls.joints)
                tries.push_back({joint});
        for (const std::vector<JointRef> &joints : tries) {
            const Document next = withTurned(joints);
            if (m_stop.stop_requested())
                return;
            if (next.isSame(m_document))
                continue;
            const std::optional<Faults> faults = faultsOf(next);
            if (!faults || !faults->isNoMoreThan(m_before) ||
                faults->thinWalls > m_before.thinWalls)
                continue;
            Pulls then = pullsOf(next);
            if (then.sum >= kLess * pulls.sum)
                continue;
            m_document = next;
            pulls = std::move(then);
            isBetter = true;
            break;
        }
    }
}

} // namespace fff
