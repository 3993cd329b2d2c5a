// The stage of what can be done about what the others have found: each edit is tried on a copy and
// judged by all of them, and offered only where it helps and makes nothing worse.
#pragma once

#include "core/analysis/finding_action.h"
#include "core/analysis/stage.h"
#include "core/analysis/trial.h"

#include <memory>
#include <utility>

namespace fff {

/// More findings of one kind than this are one row: a number says as much.
inline constexpr int kMostAlike = 2;
/// Of so many of a row it is worked out what can be done about each.
inline constexpr int kMostTried = 12;

/// What a person sees in one row: a finding, or all of one kind and severity.
struct FindingRow
{
    Finding finding;          // of many: with the sections of all of them, and of no one place
    std::vector<Finding> all; // that it stands for, in their order: at least one

    int count() const { return static_cast<int>(all.size()); }
};
/// In the order of the findings, of many where the first one is.
std::vector<FindingRow> inRows(const std::vector<Finding> &findings);

/// Something that can be done.
struct Mend
{
    FindingAction action;
    // Of an edit: what it makes, and what was found out about that.
    std::optional<FindingEdit> edit;
    std::shared_ptr<const Trials::Outcome> tried;
    Message changes = {};

    bool isEdit() const { return edit.has_value(); }
};

struct Mends
{
    AnalysisPointer analysis; // that they are about
    std::vector<std::pair<Finding, std::vector<Mend>>> ofFindings;
    std::shared_ptr<Trials> trials; // the stage's own

    /// What can be done about the finding, or about the same verdict on another model; null where
    /// that is not known.
    const std::vector<Mend> *of(const Finding &finding) const;
    /// A second model with all that was worked out about it, as the last trial left it.
    void tidy() const
    {
        if (trials)
            trials->forget();
    }
};

inline constexpr StageOf<Mends> kMends{"mends"};

/// After stages that have findings: it looks at those of all of them, and has them judge.
Stage mendsOf(const std::vector<Stage> &others);

} // namespace fff
