// Costs by size, of whatever kind.
#pragma once

#include "tests/bench/text_table.h"

#include <array>

namespace fff::bench {

template <class Cost>
struct GrowthColumn
{
    const char *name;
    double Cost::*field; // ms
};

/// In kernels where they were run, and beside each cost how many times that of the size before it
/// is. Costs have a name, a size and a kernel. Nothing of none.
template <class Cost, std::size_t Columns>
std::string growthTable(const std::string &what,
                        const std::array<GrowthColumn<Cost>, Columns> &columns,
                        const std::vector<Cost> &costs)
{
    if (costs.empty())
        return {};
    const bool inKernels = costs.front().kernel > 0.0;
    std::vector<TableRow> rows(1 + costs.size());
    rows.front().emplace_back();
    for (const auto &column : columns)
        rows.front().push_back(column.name + std::string(8, ' ')); // over the costs themselves
    for (std::size_t i = 0; i < costs.size(); ++i) {
        const bool isNext = i > 0 && costs[i].size > costs[i - 1].size;
        rows[i + 1].push_back(costs[i].name);
        for (const auto &column : columns) {
            const auto valueOf = [&](const Cost &cost) {
                return cost.*column.field / (inKernels ? cost.kernel : 1.0);
            };
            const std::string growth =
                isNext ? fixed(valueOf(costs[i]) / valueOf(costs[i - 1]), 1) : std::string();
            rows[i + 1].push_back(fixed(valueOf(costs[i]), 4) + (isNext ? " × " : "   ") +
                                  std::string(growth.size() < 5 ? 5 - growth.size() : 0, ' ') +
                                  growth);
        }
    }
    return aligned(what + ", in " + (inKernels ? "kernels" : "milliseconds") +
                       ", and times the size before",
                   rows);
}

} // namespace fff::bench
