// The words for stages: what they find out, how far they have come, why they did not.
#pragma once

#include "core/base/result.h"

#include <QString>

#include <string_view>

namespace fff {

/// What it finds out: "the order of assembly".
QString stageTitle(std::string_view stage);
/// "Working out the order of assembly… 40 %"; share: below 0 where nothing is known.
QString stageWork(std::string_view stage, double share);
/// Why there is no result, or that it was stopped, in two sentences.
QString stageFailure(std::string_view stage, const Error &why);

} // namespace fff
