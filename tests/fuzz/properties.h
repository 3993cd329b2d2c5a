// What must hold for any input, beyond not crashing. A property that fails stops the program, so
// that the fuzzer keeps the input.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

namespace fff::fuzz {

/// Stops with what is wrong when it does not hold.
void require(bool holds, const char *what);

/// It names a place, and its text is one line that holds the place and a sentence.
void requireClear(const Error &error);

/// What was read can be written, and is then read as the same document without a warning: nothing
/// is left to mend.
void requireRoundTrip(const Document &document);

} // namespace fff::fuzz
