#include "tests/bench/fabrication_cost.h"

#include "core/analysis/cutting.h"
#include "core/analysis/lying_parts.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/operations/evaluate.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/text_table.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

namespace fff::bench {

namespace {

/// Of several times what was not held up.
double shortestOf(int runs, const std::function<double()> &once)
{
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run)
        least = std::min(least, once());
    return least;
}

/// The same but for one in the middle, which is a little larger.
std::vector<Part> withOneLarger(std::vector<Part> parts)
{
    constexpr double kLarger = 1.02;
    Part &part = parts[parts.size() / 2];
    std::vector<Vec2> points = part.outline.outer.points();
    for (Vec2 &p : points)
        p *= kLarger;
    part.outline.outer = Contour::ofPoints(std::move(points));
    for (Vec2 &p : part.outline.region.outer)
        p *= kLarger;
    return parts;
}

double timeOfNesting(const std::vector<Part> &parts, const Model &model, const NestOptions &options)
{
    double once = 0.0;
    timed(once, [&] { return nestOut(parts, model, options); });
    return once;
}

/// As the stage does it: all that lay there stays, as far as it can.
double timeAgain(const Analysis &analysis, const std::vector<Part> &parts, const Layout &layout,
                 int runs)
{
    const std::vector<Part> next = withOneLarger(parts);
    return shortestOf(runs, [&] {
        double once = 0.0;
        timed(once, [&] {
            const BodiesOfParts bodies = bodiesOfParts(analysis.model, next);
            NestOptions options;
            if (auto lying = lyingStill({analysis.model, parts, layout}, next, bodies))
                options.pinned = *std::move(lying);
            return nestOut(next, analysis.model, options);
        });
        return once;
    });
}

std::vector<std::pair<std::string, double>> timesOfWriting(const Analysis &analysis,
                                                           const CuttingDrawing &drawing, int runs)
{
    std::vector<std::pair<std::string, double>> times;
    for (const io::Format *format : io::formats()) {
        const auto write = [&]() -> Result<std::string> {
            if (format->writesCutting())
                return format->writeCutting(drawing, {});
            return format->writeSolids(analysis.model, analysis.bodies, {});
        };
        if (!format->writesCutting() && !format->writesSolids())
            continue;
        times.emplace_back(format->key, shortestOf(runs, [&] {
                               double once = 0.0;
                               timed(once, write);
                               return once;
                           }));
    }
    return times;
}

} // namespace

Result<FabricationCost> fabricationCost(const std::string &name, const QString &path, int runs)
{
    Result<io::LoadedDocument> read = io::readDocument(path);
    if (!read)
        return tl::unexpected(read.error());
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(std::move(read->document)), caches);
    Result<CutParts> cut = cutParts(analysis, true);
    if (!cut)
        return tl::unexpected(cut.error());
    const std::vector<Part> &parts = cut->parts;
    const NestOptions options;
    FabricationCost cost;
    cost.name = name;
    cost.parts = static_cast<int>(parts.size());
    cost.quick = shortestOf(runs, [&] { return timeOfNesting(parts, analysis.model, options); });
    const Layout layout = nestOut(parts, analysis.model, options).layout;
    cost.sheets = static_cast<int>(layout.sheets.size());
    cost.sheetsOfBoxes =
        static_cast<int>(layOut(parts, analysis.model, options.layout).sheets.size());
    cost.used = filledShare(layout, parts, options.layout);
    cost.again = timeAgain(analysis, parts, layout, runs);
    const Result<Cutting> cutting = cuttingOf(analysis, *cut, layout, {});
    if (!cutting)
        return tl::unexpected(cutting.error());
    cost.written = timesOfWriting(analysis, cutting->drawing, runs);
    return cost;
}

std::string fabricationTable(const std::vector<FabricationCost> &costs)
{
    std::vector<TableRow> rows{{"", "parts", "sheets", "by boxes", "used, %", "quick", "again"}};
    if (!costs.empty())
        for (const auto &[format, time] : costs.front().written)
            rows.front().push_back(format);
    bool inKernels = !costs.empty();
    for (const FabricationCost &cost : costs)
        inKernels = inKernels && cost.kernel > 0.0;
    for (const FabricationCost &cost : costs) {
        constexpr double kPercent = 100.0;
        const auto time = [&](double ms) {
            return inKernels ? fixed(ms / cost.kernel, 3) : fixed(ms, 1);
        };
        rows.push_back({cost.name, std::to_string(cost.parts), std::to_string(cost.sheets),
                        std::to_string(cost.sheetsOfBoxes), fixed(kPercent * cost.used, 1),
                        time(cost.quick), time(cost.again)});
        for (const auto &[format, ms] : cost.written)
            rows.back().push_back(time(ms));
    }
    return aligned(inKernels ? "Fabrication, kernels" : "Fabrication, ms", rows);
}

} // namespace fff::bench
