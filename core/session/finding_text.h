// Findings in words.
#pragma once

#include "core/analysis/finding.h"
#include "core/session/message_text.h"

namespace fff {

/// Why, in whole sentences, for a row and for the command line; the title is not repeated where it
/// does not begin the sentence. `model` is the one that was looked at.
inline QString findingText(const Finding &finding, const Model &model,
                           const UnitWords &units = metricUnits())
{
    return messageText(finding.kind->sentence(finding, model), units);
}

} // namespace fff
