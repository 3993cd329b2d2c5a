// How well pieces are nested in how much time, and what the first layout of many costs.
#pragma once

#include "tests/bench/kernel.h"

#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// Of one strip-packing instance.
struct StripResult
{
    std::string name;
    int pieces = 0;
    std::vector<double> densities; // %, by the seconds of work that were asked for
};

/// All `.json` of the folders, with one seed. Errors  those of reading.
Result<std::vector<StripResult>> stripResults(const QStringList &folders,
                                              const std::vector<double> &seconds,
                                              const QStringList &only);
std::string stripTable(const std::vector<StripResult> &results, const std::vector<double> &seconds);

/// The first layout of so many parts, all different.
struct NestingCost
{
    int parts = 0;
    double milliseconds = 0.0; // CPU time of one thread, of the shortest of the runs
    double kernel = 0.0;       // as in Measurement
    int sheets = 0, sheetsOfBoxes = 0;
};
std::vector<NestingCost> nestingCosts(int runs, const std::optional<Kernel> &kernel);
std::string nestingTable(const std::vector<NestingCost> &costs);

} // namespace fff::bench
