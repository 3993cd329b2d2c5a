// The first sections of a suggestion: the few that hold each other and stand.
#pragma once

#include "core/analysis/suggesting/shown_form.h"
#include "core/analysis/suggesting/suggested_group.h"

#include <deque>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace fff {

struct SuggestedBase
{
    std::vector<std::size_t> cuts; // in the order in which they come
    SuggestedGround ground;        // that they stand on
};

inline constexpr std::size_t kMostInBase = 4;

/// Two cuts where two stand, three or four where it takes these, of those that show most; on as
/// little ground as lets them stand steadily, first cut off by what is not seen, then on feet.
///
/// lowest, height  of the template, Y and mm
/// allowsWeak  cuts that leave thin walls beside slits will do (SuggestedGroup::Fit::Weak)
/// accepts  is asked about each that is found, the best first; at most a few times a height
/// Nothing where none is accepted, or it was stopped.
std::optional<SuggestedBase>
suggestedBase(const std::deque<SuggestedCut> &cuts, const FormSamples &samples, double thickness,
              double lowest, double height, bool allowsWeak,
              const std::function<bool(const SuggestedBase &)> &accepts,
              const std::stop_token &stop);

} // namespace fff
