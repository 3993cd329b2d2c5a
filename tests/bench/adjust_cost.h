// What a move of a slider costs that whoever adjusts a model has in the hand.
#pragma once

#include "core/base/result.h"
#include "tests/bench/kernel.h"

#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// CPU time of one thread in milliseconds: of each slider the middle one of its moves from end to
/// end, and of the sliders the dearest.
struct AdjustCost
{
    std::string name;
    int sections = 0;
    std::string slider;  // the dearest
    double model = 0.0;  // what is typed to the model: values, numbers, operations
    double event = 0.0;  // the same with joints, slits, cut sections and bodies
    double kernel = 0.0; // as in Measurement
};

/// Of 50 replicas that follow three values, and of the folders' models (.fff) with values that are
/// adjusted.
/// Errors  those of reading.
Result<std::vector<AdjustCost>> adjustCosts(const QStringList &folders,
                                            const std::optional<Kernel> &kernel);

/// In kernels where they were run. Nothing of none.
std::string adjustTable(const std::vector<AdjustCost> &costs);

} // namespace fff::bench
