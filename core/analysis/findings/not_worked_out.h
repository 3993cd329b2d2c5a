// A stage that failed, or was stopped: said in the place of what it would have found.
#pragma once

#include "core/analysis/finding_action.h"

namespace fff {

struct Stage;

/// Of a finding of these kinds.
struct StageFailure
{
    std::string_view stage = {}; // its name
    Text title = {};
    Error why;
};

extern const FindingKind kNotWorkedOut;
extern const FindingKind kOrderNotWorkedOut;    // the same, of how the model is put together
extern const FindingKind kStrengthNotWorkedOut; // of whether it holds

extern const ActionKind kTryAgain;   // its stage
extern const ActionKind kShowReport; // where the model was set aside

Finding notWorkedOut(const Stage &stage, Error why);

} // namespace fff
