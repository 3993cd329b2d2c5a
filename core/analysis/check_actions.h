// What can be done at once about what a check says.
//
// To add one: a Kind, its line in actionsOf(), for an edit what it makes in carriedOut(), and its
// words in ui/check_words.cpp.
#pragma once

#include "core/analysis/checks.h"
#include "core/analysis/flips.h"
#include "core/model/step.h"

#include <vector>

namespace fff {

struct CheckAction
{
    enum class Kind {
        // Edits: carriedOut() makes them.
        JoinAgain,       // NotConnected, NoSlit: where somebody wanted no joint
        MoveToOther,     // NotConnected: to the nearest section that a joint can then hold it to
                         // (joining_move.h)
        JoinWithTabs,    // NotConnected, NoSlit, Interference: where one ends on the other's face
        Trim,            // NoSlit, Interference: the one that loses less, to the other
        DeleteSections,  // NotConnected
        MakeAssemblable, // CannotAssemble: slits turned round (flips.h)
        StretchToGround, // Topples, LineSupport: its feet (stretching.h)
        DropToGround,    // NoContact, BelowGround: the whole model
        // What only shows something.
        ShowSteps,   // CanAssemble
        ChooseSheet, // TooLarge: the stock of its section
        WidenSlits,  // NarrowSlit: the same
        TryAgain,    // NotWorkedOut: its stage
        ShowReport,  // NotWorkedOut: where the model was set aside
    };
    Kind kind = Kind::ShowSteps;
    SectionRef section; // whom its words name: MoveToOther, JoinWithTabs, JoinAgain: the one it
                        // comes to, or is joined with; Trim: the one that is trimmed

    bool operator==(const CheckAction &) const = default;
};

/// Whether it changes the document.
bool isEdit(CheckAction::Kind kind);

struct CheckEdit
{
    Step step; // for the history
    Document document;
};

/// What there is, the mildest first. `flips`: those of this very model, as far as they are known.
/// Offered is only what carriedOut() can do. May take some milliseconds: for a worker.
std::vector<CheckAction> actionsOf(const Check &check, const Analysis &analysis,
                                   const Flips *flips = nullptr);

/// The model's document after an edit: the check is gone then, or says less. Nothing where it
/// cannot be had, or not any more: the analysis may be of a later model than the check.
std::optional<CheckEdit> carriedOut(const CheckAction &action, const Check &check,
                                    const Analysis &analysis, const Flips *flips = nullptr);

} // namespace fff
