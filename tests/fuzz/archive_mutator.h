// Changes a `.fff` file as what it is, text or ZIP: changed bytes hardly ever make an archive whose
// check sums are right.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fff::fuzz {

/// A mutator for libFuzzer: text now and then becomes an archive with a blob, and in an archive the
/// document, a blob, a name, or a few bytes are changed, or an entry is doubled or goes.
std::size_t mutateFff(std::uint8_t *data, std::size_t size, std::size_t maxSize, unsigned int seed);

} // namespace fff::fuzz
