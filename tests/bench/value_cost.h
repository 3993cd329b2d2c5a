// What values cost that are made of each other, by their number.
#pragma once

#include "tests/bench/kernel.h"

#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// CPU time of one thread in milliseconds, of the shortest of the runs.
struct ValueCost
{
    std::string name;
    std::size_t size = 0; // values
    double read = 0.0;    // texts to values
    double all = 0.0;     // all of them worked out, nothing known from before
    double first = 0.0;   // the first one changed and all that follows: a slider's move
    double last = 0.0;    // the same of the last one, which nothing is made of
    double kernel = 0.0;  // as in Measurement
};

/// Chains of 250, 1,000 and 4,000, and one value that as many others are made of.
std::vector<ValueCost> valueCosts(int runs, const std::optional<Kernel> &kernel);

/// In kernels where they were run, and beside each cost how many times that of the size before it
/// is.
std::string valueTable(const std::vector<ValueCost> &costs);

} // namespace fff::bench
