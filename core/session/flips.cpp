#include "core/session/flips.h"

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
        const int section = plan.parts[static_cast<std::size_t>(part)].section;
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

/// Where a section's slit of a joint opens to, unit, world; zero when it has none.
Vec3 openingOf(const Analysis &analysis, int section, int joint)
{
    const auto index = static_cast<std::size_t>(section);
    const auto &slits = analysis.assembly.slits[index];
    const auto slit = std::find_if(slits.begin(), slits.end(),
                                   [&](const Slit &s) { return s.joint == joint && s.isOpen; });
    if (slit == slits.end())
        return Vec3::Zero();
    return analysis.model.section(index)->frame.directionToWorld(
        (slit->mouth - slit->inner).normalized());
}

/// What is wanted of a joint when its slits are to change sides; nothing of one that has none.
std::optional<JointOverride> flipped(const Analysis &analysis, const Joint &joint)
{
    const Model &model = analysis.model;
    int a = joint.a, b = joint.b;
    if (model.ref(static_cast<std::size_t>(b)) < model.ref(static_cast<std::size_t>(a)))
        std::swap(a, b);
    Vec3 opening = openingOf(analysis, a, joint.id);
    if (opening.isZero())
        opening = -openingOf(analysis, b, joint.id);
    if (opening.isZero())
        return {};
    const SectionRef refA = model.ref(static_cast<std::size_t>(a));
    const SectionRef refB = model.ref(static_cast<std::size_t>(b));
    JointOverride wanted;
    if (const JointOverride *before = model.document.jointOverride(refA, refB))
        wanted = *before;
    wanted.a = refA;
    wanted.b = refB;
    const Frame &frame = model.section(static_cast<std::size_t>(a))->frame;
    wanted.opens = Vec2(-opening.dot(frame.x), -opening.dot(frame.y));
    return wanted;
}

Document with(Document document, const std::vector<JointOverride> &wanted)
{
    for (const JointOverride &joint : wanted)
        document = setJointOverride(document, joint).value_or(document);
    return document;
}

/// Whether a joint's slits do change sides: an override that cannot be had changes nothing.
bool doesFlip(const Document &document, const Analysis &before, const Joint &joint,
              const JointOverride &wanted)
{
    const Analysis after = analysed(with(document, {wanted}));
    const auto a = static_cast<std::size_t>(joint.a);
    return before.assembly.slits[a] != after.assembly.slits[a];
}

/// The flips that free a few sections by themselves, as few as are found.
class Search
{
public:
    Search(Document document, const std::function<bool()> &isOutOfTime)
        : m_document(std::move(document)), m_isOutOfTime(isOutOfTime)
    {
        const Analysis analysis = analysed(m_document);
        for (const Joint &joint : analysis.assembly.joints) {
            const std::optional<JointOverride> wanted = flipped(analysis, joint);
            if (wanted && doesFlip(m_document, analysis, joint, *wanted))
                m_candidates.push_back(*wanted);
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
