// Changes JSON as JSON: what mutating bytes almost never reaches, because the text has to stay
// JSON.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fff::fuzz {

/// A mutator for libFuzzer: changes, doubles, moves or takes away one value, or a few bytes. What
/// is not JSON has its bytes changed.
std::size_t mutateJson(std::uint8_t *data, std::size_t size, std::size_t maxSize,
                       unsigned int seed);

} // namespace fff::fuzz
