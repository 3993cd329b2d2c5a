// Whether a model is still all right with one more section: by the same analysis, plan and checks
// that a person is told by.
#pragma once

#include "core/analysis/assembly_plan.h"
#include "core/analysis/check_caches.h"
#include "core/analysis/plan_finder.h"
#include "core/analysis/strength.h"
#include "core/model/edits.h"

#include <optional>
#include <set>
#include <stop_token>
#include <vector>

namespace fff {

class SuggestionJudge
{
public:
    /// document  with the sections that are there before; what is wrong with these is not held
    ///           against those that come
    SuggestionJudge(Document document, std::stop_token stop);

    const Document &document() const { return m_document; }
    enum class Verdict {
        Taken,
        Weak,    // all is well but for thin walls beside slits
        Refused, // not all pieces are held, or it falls over, or cannot be assembled, or the like
    };
    /// Takes these sections where with them all pieces are held together, all of it stands and can
    /// be assembled, and nothing is wrong that was not wrong before, but for thin walls where these
    /// are allowed; else everything stays as it was. Deterministic: the search for the order of
    /// assembly ends by a count, not by a clock.
    Verdict take(const std::vector<NewSection> &sections, bool allowsThinWalls);
    /// Of this document as it is, by the same rules: Taken where it could be, Weak for thin walls
    /// alone. Nothing is taken.
    Verdict verdictOn(const Document &next);

private:
    /// What is wrong, so far as suggestions can help it; nothing where it cannot be told.
    struct Faults
    {
        std::size_t findings = 0, thinWalls = 0, groups = 0, loosePieces = 0;
        bool isNoMoreThan(const Faults &other) const
        {
            return findings <= other.findings && groups <= other.groups &&
                   loosePieces <= other.loosePieces;
        }
    };
    std::optional<Faults> faultsOf(const Document &document);
    /// The document with all slits of its last section opening to one end of their axes, where
    /// others than it has by itself are needed for that.
    std::optional<Document> slidOnFrom(const Document &document, double side) const;
    /// The joints that weight pulls open, and what with.
    struct Pulls
    {
        std::vector<JointRef> joints; // the strongest pull first
        double sum = 0.0;             // N; 0: nothing comes apart
    };
    Pulls pullsOf(const Document &document);
    /// Turns slits of joints that sections taken since the beginning have, where what stands in
    /// them is pulled out by weight alone, so far as nothing else gets worse by it.
    void turnPulledSlits();
    bool breaks();
    Document withTurned(const std::vector<JointRef> &joints) const;

    Document m_document;
    std::set<SectionId> m_thereBefore; // sections that were there before
    Faults m_before;
    std::stop_token m_stop;
    AnalysisCaches m_analysis;
    CheckCaches m_checks;
    PlanCaches m_plan;
    PlanCheckCaches m_planChecks;
    StrengthCaches m_strength;
};

} // namespace fff
