#include "core/analysis/flips.h"

#include "core/assembly/joint_state.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <set>

namespace fff {

namespace {

/// Sets of parts that are freed one after the other, at most.
constexpr int kMaxRounds = 16;
/// Flips that are tried together. Of k joints O(k³) tries.
constexpr int kMostAtOnce = 3;

Analysis analysed(const Document &document)
{
    AnalysisCaches caches;
    return analyse(evaluate(document), caches);
}

/// The sections of locked parts; empty when not all of them are drawn.
std::vector<SectionId> drawnSections(const Analysis &analysis, const ModelPlan &plan)
{
    std::set<SectionId> ids;
    for (const int part : plan.plan.locked) {
        const int section = plan.bodies.sectionOf(part);
        const SectionRef ref = analysis.model.ref(static_cast<std::size_t>(section));
        if (!ref.drawn.isValid())
            return {};
        ids.insert(ref.drawn);
    }
    return {ids.begin(), ids.end()};
}

/// The document with these sections alone.
Document only(const Document &document, const std::vector<SectionId> &ids)
{
    std::vector<SectionId> others;
    for (const SectionPointer &section : document.sections)
        if (!std::binary_search(ids.begin(), ids.end(), section->id))
            others.push_back(section->id);
    return removeSections(document, others).value_or(document);
}

Document with(Document document, const std::vector<JointOverride> &wanted)
{
    for (const JointOverride &joint : wanted)
        document = setJointOverride(document, joint).value_or(document);
    return document;
}

/// The flips that free a few sections by themselves, as few as are found.
class Search
{
public:
    Search(Document document, const std::function<bool()> &isOutOfTime)
        : m_document(std::move(document)), m_isOutOfTime(isOutOfTime)
    {
        const Model model = evaluate(m_document);
        const Assembly assembly = assemble(model);
        for (const Joint &joint : assembly.joints) {
            const JointRef ref(model.ref(static_cast<std::size_t>(joint.a)),
                               model.ref(static_cast<std::size_t>(joint.b)));
            const std::optional<JointState> state = jointState(model, ref);
            if (state && state->canFlip)
                m_candidates.push_back(flipped(model, *state));
        }
    }

    std::optional<std::vector<JointOverride>> find()
    {
        for (int count = 1; count <= kMostAtOnce; ++count) {
            std::vector<JointOverride> chosen;
            if (choose(0, count, chosen))
                return chosen;
        }
        return {};
    }

private:
    bool choose(std::size_t first, int count, std::vector<JointOverride> &chosen)
    {
        if (count == 0) {
            const ModelPlan plan = planOf(analysed(with(m_document, chosen)), m_isOutOfTime);
            return plan.plan.verdict == AssemblyPlan::Verdict::Possible;
        }
        for (std::size_t i = first; i < m_candidates.size(); ++i) {
            if (m_isOutOfTime && m_isOutOfTime())
                return false;
            chosen.push_back(m_candidates[i]);
            if (choose(i + 1, count - 1, chosen))
                return true;
            chosen.pop_back();
        }
        return false;
    }

    Document m_document;
    const std::function<bool()> &m_isOutOfTime;
    std::vector<JointOverride> m_candidates;
};

} // namespace

std::optional<Flips> flipsThatHelp(const Analysis &analysis, const ModelPlan &plan,
                                   const std::function<bool()> &isOutOfTime)
{
    if (plan.plan.verdict != AssemblyPlan::Verdict::Impossible)
        return {};
    Flips flips{analysis.model.document, 0};
    std::vector<SectionId> locked = drawnSections(analysis, plan);
    std::set<std::vector<SectionId>> known;
    for (int round = 0; round < kMaxRounds; ++round) {
        if (locked.empty() || !known.insert(locked).second)
            return {};
        const auto found = Search(only(flips.document, locked), isOutOfTime).find();
        if (!found)
            return {};
        flips.document = with(std::move(flips.document), *found);
        flips.count += static_cast<int>(found->size());
        const Analysis next = analysed(flips.document);
        const ModelPlan nextPlan = planOf(next, isOutOfTime);
        if (nextPlan.plan.verdict == AssemblyPlan::Verdict::Possible)
            return flips;
        locked = drawnSections(next, nextPlan);
    }
    return {};
}

} // namespace fff
