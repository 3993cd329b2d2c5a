#include "tests/bench/value_cost.h"

#include "core/values/value_edits.h"
#include "tests/bench/growth_table.h"
#include "tests/bench/stopwatch.h"

#include <QTextStream>

#include <array>
#include <limits>

namespace fff::bench {

namespace {

/// The first one is a number; each other is made of the one before it, or all of the first.
Values madeValues(int count, bool isChain)
{
    Values values;
    for (int i = 0; i < count; ++i) {
        Value value;
        value.id = ValueId{i + 1};
        value.name = "v" + std::to_string(i);
        const std::string before = "v" + std::to_string(isChain ? i - 1 : 0);
        value.typed = i == 0 ? "12 mm" : "max(" + before + "/2; 1 in - " + before + ") + 0.5";
        values.list.push_back(makeValue(std::move(value)));
    }
    return values;
}

/// The edit of a slider, and what follows.
double moveCost(const Values &values, const EvaluatedValues &evaluated, int which, int runs)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        double once = 0.0;
        timed(once, [&] {
            const std::string typed = std::to_string(13 + run) + " mm";
            return EvaluatedValues::of(*typedValue(values, ValueId{which + 1}, typed, {}),
                                       evaluated);
        });
        shortest = std::min(shortest, once);
    }
    return shortest;
}

ValueCost valueCost(int count, bool isChain, int runs)
{
    ValueCost cost;
    cost.size = static_cast<std::size_t>(count);
    cost.name = (isChain ? "chain of " : "all of one, ") + std::to_string(count);
    cost.read = cost.all = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        double once = 0.0;
        const Values values = timed(once, [&] { return madeValues(count, isChain); });
        cost.read = std::min(cost.read, once);
        timed(once, [&] { return EvaluatedValues::of(values); });
        cost.all = std::min(cost.all, once);
    }
    const Values values = madeValues(count, isChain);
    const EvaluatedValues evaluated = EvaluatedValues::of(values);
    cost.first = moveCost(values, evaluated, 0, runs);
    cost.last = moveCost(values, evaluated, count - 1, runs);
    return cost;
}

constexpr std::array<GrowthColumn<ValueCost>, 4> kValueColumns{{{"read", &ValueCost::read},
                                                                {"all", &ValueCost::all},
                                                                {"first", &ValueCost::first},
                                                                {"last", &ValueCost::last}}};

} // namespace

std::vector<ValueCost> valueCosts(int runs, const std::optional<Kernel> &kernel)
{
    std::vector<ValueCost> costs;
    for (const bool isChain : {true, false})
        for (const int count : {250, 1000, 4000}) {
            const double before = kernel ? kernel->run() : 0.0;
            costs.push_back(valueCost(count, isChain, runs));
            costs.back().kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
            QTextStream(stderr) << QString::fromStdString(costs.back().name) << Qt::endl;
        }
    return costs;
}

std::string valueTable(const std::vector<ValueCost> &costs)
{
    return growthTable("Values", kValueColumns, costs);
}

} // namespace fff::bench
