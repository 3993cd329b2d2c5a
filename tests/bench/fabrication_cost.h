// What it costs to lay a model's parts, to lay them again after an edit of one, and to write them.
#pragma once

#include "tests/bench/kernel.h"

#include <QString>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fff::bench {

/// CPU time of one thread, of the shortest of the runs, ms.
struct FabricationCost
{
    std::string name;
    int parts = 0, sheets = 0, sheetsOfBoxes = 0;
    double used = 0.0; // share of what the layout takes, see filledShare()
    double quick = 0.0, again = 0.0;
    std::vector<std::pair<std::string, double>> written; // by format
    double kernel = 0.0;                                 // as in Measurement
};

/// Errors  of reading, and of a model without parts.
Result<FabricationCost> fabricationCost(const std::string &name, const QString &path, int runs);
/// In kernels where these are known, else in ms.
std::string fabricationTable(const std::vector<FabricationCost> &costs);

} // namespace fff::bench
