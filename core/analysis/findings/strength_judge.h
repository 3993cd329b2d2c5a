// For edits that are to make a model hold: whether each of them does.
#pragma once

#include "core/analysis/finding_action.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/strength.h"
#include "core/operations/evaluate.h"

namespace fff {

/// Judges one document after the other, each for the work of what differs from the one before.
class StrengthJudge
{
public:
    /// before, finding  a verdict with Held, and what it was found in.
    StrengthJudge(const Analysis &before, const Finding &finding)
        : m_before(before), m_isError(finding.severity == Severity::Error)
    {
        m_rules.safety = finding.details<Held>()->safety;
    }

    struct Judged
    {
        AnalysisPointer analysis;
        Strength strength;
    };
    /// Until the next one is asked for.
    const Judged &on(const Document &document)
    {
        if (m_judged.analysis && document.isSame(m_judged.analysis->model.document))
            return m_judged;
        m_judged.analysis = analyseNext(evaluate(document, m_before.model), m_analysis);
        m_judged.strength = strengthOf(*m_judged.analysis, m_rules, m_strength);
        return m_judged;
    }
    HoldVerdict verdictOn(const Document &document) { return on(document).strength.verdict; }

    /// Than the verdict of the finding.
    bool isBetter(HoldVerdict verdict) const
    {
        return verdict == HoldVerdict::Holds || (verdict == HoldVerdict::BarelyHolds && m_isError);
    }
    double safety() const { return m_rules.safety; }

private:
    const Analysis &m_before;
    bool m_isError;
    Judged m_judged;
    AnalysisCaches m_analysis;
    StrengthRules m_rules;
    StrengthCaches m_strength;
};

/// Of all candidates the first that holds, or else the first that nearly does. make: candidate →
/// std::optional<FindingEdit>.
template <class Candidates, class Make>
std::optional<FindingEdit> firstThatHolds(const Candidates &candidates, StrengthJudge &judge,
                                          Make make)
{
    std::optional<FindingEdit> nearly;
    for (const auto &candidate : candidates) {
        std::optional<FindingEdit> edit = make(candidate);
        if (!edit)
            continue;
        const HoldVerdict verdict = judge.verdictOn(edit->document);
        if (verdict == HoldVerdict::Holds)
            return edit;
        if (!nearly && judge.isBetter(verdict))
            nearly = std::move(edit);
    }
    return nearly;
}

/// Whether the same pairs of sections meet, and as often: what is added to one is in nobody's way.
bool meetAsBefore(const Analysis &before, const Analysis &after);

} // namespace fff
