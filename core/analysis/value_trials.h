// What becomes of a model over the ranges of its values: it is made in corners and in places
// between them, and judged by all that finds something, as an edit is that is tried (trial.h).
#pragma once

#include "core/analysis/check_rules.h"
#include "core/analysis/finding.h"
#include "core/analysis/ranged_values.h"
#include "core/analysis/stage.h"

#include <array>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace fff {

struct TriedPlace
{
    TrialPlace at;
    Message wrong; // not empty: there is no such model, and why
    /// By the subject. Unknown where there is no model, or it could not be judged.
    std::array<Severity, static_cast<std::size_t>(Subject::Joints) + 1> worst{};
    std::vector<Message> faults; // titles of its errors, each once

    bool holds() const { return wrong.isEmpty() && faults.empty(); }
    Severity worstOf(Subject subject) const { return worst[static_cast<std::size_t>(subject)]; }
};

struct ValueTrials
{
    std::vector<RangedValue> values;
    std::vector<TriedPlace> places; // as trialPlaces() has them
    std::size_t corners = 0;        // of them
    double allCorners = 0.0;        // that there are
    TrialExtent extent;

    std::size_t failing() const;
    /// Titles of errors and in how many places they are, the most frequent first; without a model,
    /// "Cannot be made".
    std::vector<std::pair<Message, int>> faults() const;
    /// Of `places`, those that do not hold, the worst first: with the most to be said against it.
    std::vector<std::size_t> worst() const;
};

/// What is said of a place where the values do not go together.
inline constexpr Text kCannotBeMade = FFF_TEXT("Finding", "Cannot be made");
/// "width 400 mm, boards 6"
std::vector<std::pair<std::string, Worth>> worthsAt(const std::vector<RangedValue> &values,
                                                    const TrialPlace &place);

/// Nothing once stop is requested, soon. Of a model without such values there are no places. The
/// same for the same model and rules, as far as planning is: it takes what time it is given.
std::optional<ValueTrials> tryValues(const Model &model, const CheckRules &rules,
                                     const TrialExtent &extent, Progress &progress,
                                     std::stop_token stop);

} // namespace fff
