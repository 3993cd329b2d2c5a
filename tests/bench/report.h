// What was measured, for people and for machines.
#pragma once

#include "tests/bench/measure.h"
#include "tests/bench/peer.h"

#include <optional>
#include <vector>

namespace fff::bench {

/// Aligned tables: milliseconds, kernels where they were run, ours over the peer's where it has
/// the row, and memory of an undo step.
std::string tables(const std::vector<Measurement> &rows, const std::optional<Peer> &peer);

/// Everything in it, unrounded.
std::string json(const std::vector<Measurement> &rows, const std::optional<Peer> &peer);

} // namespace fff::bench
