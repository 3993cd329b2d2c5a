// Makes up PNGs whose parts have the checksums that they ought to have: with any others a reader
// looks no further.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fff::fuzz {

/// As libFuzzer's mutators; what is no PNG is changed like any other bytes.
std::size_t mutatePng(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned int seed);

} // namespace fff::fuzz
