#include "tests/bench/nesting_cost.h"

#include "core/fabrication/nested_layout.h"
#include "core/io/document_file.h"
#include "core/io/nesting_instance.h"
#include "core/nesting/nester.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/text_table.h"
#include "tests/core/fabrication/parts_of.h"

#include <QDir>
#include <QTextStream>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace fff::bench {

namespace {

/// Round ones with a few lobes, and a slit in every other one.
std::vector<Part> lobedParts(int count, StockId stock)
{
    constexpr unsigned kSeed = 17;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> size(12.0, 60.0), depth(0.05, 0.35);
    std::vector<Part> parts;
    for (int i = 0; i < count; ++i) {
        const double radius = size(random), lobe = depth(random);
        const int lobes = 2 + i % 5;
        Polygon outline;
        constexpr int kCorners = 48;
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kCorners;
            outline.push_back(radius * (1.0 + lobe * std::sin(lobes * angle)) *
                              Vec2(std::cos(angle), 0.6 * std::sin(angle)));
        }
        std::vector<Polygon> slits;
        if (i % 2 == 0)
            slits.push_back({{-1.5, 0.0}, {1.5, 0.0}, {1.5, 2.0 * radius}, {-1.5, 2.0 * radius}});
        Part part;
        part.number = i + 1;
        part.stock = stock;
        part.outline = test::regionOf(*Contour::fromPolygon(outline), {}, slits);
        parts.push_back(std::move(part));
    }
    return parts;
}

} // namespace

Result<std::vector<StripResult>> stripResults(const QStringList &folders,
                                              const std::vector<double> &seconds,
                                              const QStringList &only)
{
    std::vector<StripResult> results;
    for (const QString &folder : folders) {
        const QStringList names{QStringLiteral("*.json")};
        for (const QFileInfo &file : QDir(folder).entryInfoList(names, QDir::Files, QDir::Name)) {
            if (!only.isEmpty() && !only.contains(file.completeBaseName()))
                continue;
            const Result<std::string> bytes = io::readFile(file.absoluteFilePath());
            if (!bytes)
                return tl::unexpected(bytes.error());
            const auto instance = io::readNestingInstance(*bytes, file.fileName().toStdString());
            if (!instance)
                return tl::unexpected(instance.error());
            StripResult result{file.completeBaseName().toStdString(), 0, {}};
            for (const nest::Piece &piece : instance->problem.pieces)
                result.pieces += piece.demand;
            for (const double s : seconds)
                result.densities.push_back(
                    100.0 *
                    nest::nestPieces(instance->problem, {1, nest::workOf(s), true}).density);
            results.push_back(std::move(result));
            QTextStream(stderr) << file.completeBaseName() << Qt::endl;
        }
    }
    return results;
}

std::string stripTable(const std::vector<StripResult> &results, const std::vector<double> &seconds)
{
    std::vector<TableRow> rows{{"", "pieces"}};
    for (const double s : seconds)
        rows.front().push_back(QStringLiteral("%1 s, %").arg(s).toStdString());
    for (const StripResult &result : results) {
        rows.push_back({result.name, std::to_string(result.pieces)});
        for (const double density : result.densities)
            rows.back().push_back(fixed(density, 2));
    }
    return aligned("Strips", rows);
}

std::vector<NestingCost> nestingCosts(int runs, const std::optional<Kernel> &kernel)
{
    const Model model{newDocument(), {}};
    std::vector<NestingCost> costs;
    for (const int count : {50, 154, 800, 3200}) {
        const std::vector<Part> parts = lobedParts(count, model.document.currentStock);
        NestingCost cost;
        cost.parts = count;
        cost.milliseconds = std::numeric_limits<double>::infinity();
        const double before = kernel ? kernel->run() : 0.0;
        for (int run = 0; run < runs; ++run) {
            double once = 0.0;
            const NestedLayout nested = timed(once, [&] { return nestOut(parts, model, {}); });
            cost.milliseconds = std::min(cost.milliseconds, once);
            cost.sheets = static_cast<int>(nested.layout.sheets.size());
        }
        cost.kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
        cost.sheetsOfBoxes = static_cast<int>(layOut(parts, model, {}).sheets.size());
        costs.push_back(cost);
    }
    return costs;
}

std::string nestingTable(const std::vector<NestingCost> &costs)
{
    std::vector<TableRow> rows{{"parts", "ms", "kernels", "sheets", "by boxes"}};
    for (const NestingCost &cost : costs)
        rows.push_back({std::to_string(cost.parts), fixed(cost.milliseconds, 1),
                        cost.kernel > 0.0 ? fixed(cost.milliseconds / cost.kernel, 2) : "",
                        std::to_string(cost.sheets), std::to_string(cost.sheetsOfBoxes)});
    return aligned("First layouts", rows);
}

} // namespace fff::bench
