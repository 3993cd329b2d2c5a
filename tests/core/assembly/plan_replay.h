// Carries out the plan of an assembly, step by step, and looks whether parts run into each other:
// with plates of its own, by other means than planning.
#pragma once

#include "tests/core/assembly/line_oracle.h"

#include <QString>

#include <map>
#include <set>
#include <utility>

namespace fff::test {

/// What is wrong with a plan; empty when it can be carried out. Parts that are in each other where
/// they end up may be so on their way, but must not go through each other.
inline QString fault(const Analysis &analysis, const ModelPlan &plan)
{
    const std::vector<CutPlate> plates = platesOf(analysis.bodies);
    constexpr double kInset = 0.5e-3; // mm
    std::map<std::pair<int, int>, double> overlapping;
    for (const PartOverlap &overlap : plan.overlaps)
        overlapping[{overlap.a, overlap.b}] = overlap.how.depth;
    // Of what overlaps, the middles: they share more than a plate's thickness where one goes
    // through the other. What is as deep in it as that where it ends up cannot be made anyway.
    const auto runsInto = [&](int part, int other, const Vec3 &by) {
        const CutPlate &still = plates[static_cast<std::size_t>(other)],
                       &moved = plates[static_cast<std::size_t>(part)];
        const auto known = overlapping.find(std::minmax(part, other));
        const double half = std::min(still.half, moved.half);
        if (known != overlapping.end() && known->second > half)
            return false;
        return areInEachOther(still, moved, by, known == overlapping.end() ? kInset : 0.98 * half);
    };
    std::vector<std::set<int>> heaps; // of parts that are together
    const auto heapOf = [&](const auto &parts) {
        return std::find(heaps.begin(), heaps.end(), std::set(parts.begin(), parts.end()));
    };
    for (std::size_t s = 0; s < plan.plan.steps.size(); ++s) {
        const AssemblyStep &step = plan.plan.steps[s];
        const QString where = QStringLiteral("step %1: ").arg(s + 1);
        if (step.parts.size() == 1)
            heaps.push_back({step.parts.front()});
        const auto moved = heapOf(step.parts);
        if (moved == heaps.end())
            return where + QStringLiteral("its group has not been put together");
        if (step.onto.empty())
            continue;
        const auto there = heapOf(step.onto);
        if (there == heaps.end())
            return where + QStringLiteral("what it is brought to is not there");
        // Backwards, out of its place.
        Vec3 place = Vec3::Zero();
        for (auto move = step.moves.rbegin(); move != step.moves.rend(); ++move) {
            if (std::abs(move->direction.norm() - 1.0) > 1e-9)
                return where + QStringLiteral("no unit direction");
            for (int i = 0; i <= 50; ++i) {
                const Vec3 by = place - move->direction * (move->distance * i / 50.0);
                for (const int part : step.parts)
                    for (const int other : step.onto)
                        if (runsInto(part, other, by))
                            return where + QStringLiteral("%1 runs into %2").arg(part).arg(other);
            }
            place -= move->direction * move->distance;
        }
        std::set<int> together = *moved;
        together.insert(there->begin(), there->end());
        std::erase_if(heaps,
                      [&](const std::set<int> &heap) { return together.contains(*heap.begin()); });
        heaps.push_back(std::move(together));
    }
    if (heaps.size() > 1 || (heaps.empty() && plan.bodies.size() > 0))
        return QStringLiteral("not all parts are together at the end");
    return heaps.empty() || heaps.front().size() == plan.bodies.size()
               ? QString()
               : QStringLiteral("parts are missing at the end");
}

} // namespace fff::test
