// What drawings of other programs cost, by their size.
#pragma once

#include "tests/bench/kernel.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// CPU time of one thread in milliseconds.
struct DrawingCost
{
    std::string name;
    int size = 0;          // rectangles, or corners of the path
    double read = 0.0;     // the file to lines
    double sections = 0.0; // lines to a document with a section for every outline
    double holes = 0.0;    // to one with a hole for every outline
    double marks = 0.0;    // to one in which all of it is engraved
    double command = 0.0;  // what the window runs, from the file to the model in the session
    double kernel = 0.0;   // as in Measurement
};

/// Rectangles beside each other and in each other, paths of lines and of curves, each in several
/// sizes; those whose names are wanted.
std::vector<DrawingCost> drawingCosts(const std::function<bool(const std::string &)> &isWanted,
                                      const std::optional<Kernel> &kernel);

/// In kernels where they were run, and beside each cost how many times that of the size before it
/// is.
std::string drawingTable(const std::vector<DrawingCost> &costs);

} // namespace fff::bench
