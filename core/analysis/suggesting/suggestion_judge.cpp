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
}

std::optional<SuggestionJudge::Faults> SuggestionJudge::faultsOf(const Document &document)
{
    const AnalysisPointer analysis = analyseNext(evaluate(document), m_analysis);
    const std::size_t sections = analysis->model.sectionCount();
    Faults faults;
    faults.groups = heldGroups(analysis->bodies, analysis->assembly.joints, analysis->grips).size();
    faults.loosePieces = std::max(analysis->bodies.size(), sections) - sections;
    if (faults.groups > std::max<std::size_t>(m_before.groups, 1) && document.sections.size() > 1)
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
    if (faults->thinWalls > m_before.thinWalls) {
        if (!allowsThinWalls)
            return Verdict::Weak;
        m_before.thinWalls = faults->thinWalls;
    }
    m_document = *std::move(next);
    return Verdict::Taken;
}

} // namespace fff
