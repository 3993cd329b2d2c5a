// What the Checks dock lists: a row for each verdict, and one for equal ones, which says how many
// places it has and steps through them; and the marks of these places in the view.
#pragma once

#include "core/analysis/mends.h"
#include "core/interaction/problem_marks.h"
#include "ui/docks/check_row.h"

#include <QLocale>

#include <optional>
#include <vector>

namespace fff {
class CheckList;
}

namespace fff::ui {

struct CheckEntry
{
    FindingRow row;
    int number = 0; // of a problem, from 1 on
    int place = 0;  // which of its findings is looked at

    /// What can be done at once, and about which finding: about all, then about the one that is
    /// looked at.
    struct Offer
    {
        Mend mend;
        Finding finding;
    };
    std::vector<Offer> offers = {};

    int count() const { return row.count(); }
    const Finding &finding() const { return row.all[static_cast<std::size_t>(place)]; }
    /// Which of its findings that is; −1: none.
    int placeOf(const Finding &finding) const;
};

bool isProblem(const Finding &finding);

/// The worst first, numbered; those that had several places look at the same one as before.
std::vector<CheckEntry> checkEntries(const CheckList &list, const std::vector<CheckEntry> &before);
/// What its row shows.
CheckRow::Content contentOf(const CheckEntry &entry, const CheckList &list);
/// A mark for each place of each problem; one without a place of its own stands where its sections
/// are. chosen: the finding that is looked at, if one is.
std::vector<ProblemMark> marksOf(const std::vector<CheckEntry> &entries, const Model &model,
                                 const std::optional<Finding> &chosen);

} // namespace fff::ui
