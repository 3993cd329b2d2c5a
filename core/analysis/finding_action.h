// What can be done at once about a finding.
//
// To add one: its ActionKind, in a file of its own or in that of the finding whose only one it is,
// and its name among the `actions` of findings.
#pragma once

#include "core/analysis/analysis.h"
#include "core/analysis/finding.h"
#include "core/analysis/flips.h"
#include "core/model/step.h"

#include <optional>
#include <vector>

namespace fff {

struct FindingAction
{
    const ActionKind *kind = nullptr;
    SectionRef section = {}; // whom its words name, where they name one that is not the finding's

    bool operator==(const FindingAction &) const = default;
};

struct FindingEdit
{
    Step step; // for the history
    Document document;
    Message said = {};    // what the person is told once it is done; may be empty
    Message offered = {}; // what a link says of it, where more is known by now than by its action
};

struct ActionKind
{
    /// "Move it to Body": a few words for a link.
    Message (*words)(const FindingAction &, const Finding &, const Model &);
    /// The model's document after it: the finding is gone then, or says less. Nothing where it
    /// cannot be had, or not any more: the analysis may be of a later model than the finding.
    /// `flips`: those of this very model, as far as they are known. Null: it only shows something,
    /// which is the window's.
    std::optional<FindingEdit> (*carriedOut)(const FindingAction &, const Finding &,
                                             const Analysis &, const Flips *) = nullptr;
    /// It is tried only as long as no other edit is offered: of many that do much the same, the
    /// first that helps is enough.
    bool isLastResort = false;
};

/// Whether it changes the document.
inline bool isEdit(const ActionKind &kind)
{
    return kind.carriedOut != nullptr;
}

/// What there is, the mildest first. Offered is only what carriedOut() can do. May take some
/// milliseconds: for a worker.
std::vector<FindingAction> actionsOf(const Finding &finding, const Analysis &analysis,
                                     const Flips *flips = nullptr);

/// Nothing for what only shows something.
std::optional<FindingEdit> carriedOut(const FindingAction &action, const Finding &finding,
                                      const Analysis &analysis, const Flips *flips = nullptr);

/// The words of one that says no more than them.
template <const Text &text>
Message plainWords(const FindingAction &, const Finding &, const Model &)
{
    return {text, {}};
}

} // namespace fff
