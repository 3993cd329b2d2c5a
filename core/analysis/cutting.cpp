#include "core/analysis/cutting.h"

#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/lying_parts.h"
#include "core/base/tolerances.h"
#include "core/fabrication/kerf.h"
#include "core/fabrication/sheet_supply.h"
#include "core/fabrication/wholeness.h"
#include "core/geometry/offset.h"
#include "core/geometry/uncut.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

/// Corners of an outline that the tool's middle keeps away from by this much, in kerfs and mm, lie
/// in what it is too wide for; acute corners are left by less.
constexpr double kMissedKerfs = 2.0, kMissed = 0.5;

std::string nameOf(const Analysis &analysis, const Part &part)
{
    return analysis.model.section(static_cast<std::size_t>(part.section))->name;
}

void addOnce(std::vector<std::string> &names, std::string name)
{
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
}

/// The narrowest slit as it will be drawn. Errors  ClosedSlit when one would have no width.
Result<std::optional<DrawnSlit>> narrowestDrawn(const Analysis &analysis, bool compensatesKerf)
{
    std::optional<DrawnSlit> least;
    for (std::size_t i = 0; i < analysis.assembly.slits.size(); ++i) {
        const double kerf = compensatesKerf ? analysis.model.stockOf(i).kerf : 0.0;
        std::optional<double> closed; // width
        visitOpenings(analysis.assembly.slits[i], [&](double width, const Vec2 &) {
            if (!closed && isClosedBy(kerf, width))
                closed = width;
            if (!least || width - kerf < least->width)
                least = DrawnSlit{width - kerf, kerf};
        });
        if (closed)
            return failure(
                ErrorCode::ClosedSlit, {},
                {analysis.model.section(i)->name, millimetres(*closed), millimetres(kerf)});
    }
    return least;
}

/// Names of sections with a hole or a notch that the kerf is too wide for.
std::vector<std::string> withUncutPlaces(const Analysis &analysis, const std::vector<Part> &parts,
                                         const std::vector<Part> &paths)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const double kerf = analysis.model.stockOf(static_cast<std::size_t>(parts[i].section)).kerf;
        if (kerf >= 2.0 * kLeastGrowth &&
            !comesEverywhere(parts[i].outline, paths[i].outline, kMissedKerfs * kerf + kMissed))
            addOnce(names, nameOf(analysis, parts[i]));
    }
    return names;
}

/// As the file will have it: where it lies on its sheet, rounded as it is written.
Contour written(const Contour &contour, const Placement &placement)
{
    std::vector<Vec2> points;
    points.reserve(contour.points().size());
    for (const Vec2 &p : contour.points())
        points.push_back((placement.apply(p) / kClipGrid).array().round() * kClipGrid);
    return Contour::ofPoints(std::move(points));
}

/// Whether rounding leaves the path as plain as it is.
bool isPlainAsWritten(const CurvedRegion &outline, const Placement &placement)
{
    std::vector<Contour> holes;
    for (const Contour &hole : outline.holes)
        holes.push_back(written(hole, placement));
    return isPlain(written(outline.outer, placement), holes, kSweepError / 8.0);
}

/// Errors  CannotOffset for the first path that rounding makes touch itself.
Result<void> judgeWritten(const Analysis &analysis, const Layout &layout,
                          const std::vector<Part> &parts)
{
    for (const Sheet &sheet : layout.sheets) {
        for (const Placement &placement : sheet.placements) {
            const Part &part = parts[static_cast<std::size_t>(placement.part)];
            const double kerf = analysis.model.stockOf(static_cast<std::size_t>(part.section)).kerf;
            if (kerf > 0.0 && !isPlainAsWritten(part.outline, placement))
                return failure(ErrorCode::CannotOffset, {},
                               {nameOf(analysis, part), millimetres(kerf)});
        }
    }
    return {};
}

/// Boxes go on whole sheets only.
bool hasSpares(const Document &document)
{
    return std::any_of(document.stocks.begin(), document.stocks.end(),
                       [](const auto &stock) { return !stock->spares.empty(); });
}

/// Each part once.
bool isOf(const Layout &layout, std::size_t partCount)
{
    std::vector<int> times(partCount, 0);
    for (const Sheet &sheet : layout.sheets)
        for (const Placement &placement : sheet.placements) {
            if (placement.part < 0 || static_cast<std::size_t>(placement.part) >= partCount)
                return false;
            ++times[static_cast<std::size_t>(placement.part)];
        }
    return std::all_of(times.begin(), times.end(), [](int count) { return count == 1; });
}

Layout layoutOf(const Model &model, const std::vector<Part> &parts, const CuttingOptions &options)
{
    if (options.lying && isOf(*options.lying, parts.size()))
        return *options.lying;
    if (!options.nesting && !hasSpares(model.document))
        return layOut(parts, model, options.layout);
    NestOptions nesting = options.nesting.value_or(NestOptions());
    if (!options.nesting && !options.layout.turnsFreely)
        nesting.turning = nest::Turning::Quarter;
    nesting.layout = options.layout;
    addWishes(model, bodiesOfParts(model, parts), nesting);
    return nestOut(parts, model, nesting).layout;
}

} // namespace

tl::unexpected<Error> nothingToExport(const Analysis &analysis)
{
    return analysis.model.sectionCount() == 0
               ? failure(ErrorCode::NothingToExport)
               : failure(ErrorCode::NothingToExport, {}, {analysis.model.section(0)->name});
}

Result<CutParts> cutParts(const Analysis &analysis, bool compensatesKerf)
{
    if (const Result<void> known = haveParts(analysis.model, analysis.bodies); !known)
        return tl::unexpected(known.error());
    CutParts made;
    made.parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    if (made.parts.empty())
        return nothingToExport(analysis);
    Cutting &cutting = made.cutting;
    for (const int section : sectionsWithoutPart(analysis.bodies))
        cutting.withoutPart.push_back(
            analysis.model.section(static_cast<std::size_t>(section))->name);
    cutting.partCount = static_cast<int>(made.parts.size());
    made.list = partList(made.parts, analysis.model);
    const auto slit = narrowestDrawn(analysis, compensatesKerf);
    if (!slit)
        return tl::unexpected(slit.error());
    cutting.slit = *slit;
    for (const Part &part : made.parts) {
        const Section &section = *analysis.model.section(static_cast<std::size_t>(part.section));
        made.engravings.push_back(engrave(part, section.marks));
        if (made.engravings.back().lines.error)
            return failure(ErrorCode::MarksNotCut, {}, {section.name});
        if (!made.engravings.back().hasNumber)
            addOnce(cutting.unmarked, nameOf(analysis, part));
        if (!made.engravings.back().jointsLeftOut.empty())
            addOnce(cutting.unmarkedJoints, nameOf(analysis, part));
    }
    made.isKerfApplied = compensatesKerf;
    if (compensatesKerf) {
        auto paths = compensateKerf(made.parts, analysis.model, analysis.bodies);
        if (!paths)
            return tl::unexpected(paths.error());
        cutting.uncut = withUncutPlaces(analysis, made.parts, *paths);
        made.parts = std::move(*paths);
    }
    return made;
}

Result<Cutting> cuttingOf(const Analysis &analysis, CutParts parts, const Layout &layout,
                          const DrawingExtras &extras)
{
    if (parts.isKerfApplied) {
        if (const auto judged = judgeWritten(analysis, layout, parts.parts); !judged)
            return tl::unexpected(judged.error());
    }
    Cutting cutting = std::move(parts.cutting);
    cutting.usedShare = usedShare(layout, parts.parts);
    for (const auto &stock : analysis.model.document.stocks)
        if (const int count = missingSheets(layout, *stock); count > 0)
            cutting.missing.push_back({stock->name, count});
    for (const int index : layout.oversized)
        addOnce(cutting.oversized, nameOf(analysis, parts.parts[static_cast<std::size_t>(index)]));
    cutting.drawing =
        cuttingDrawing(layout, std::move(parts.parts), std::move(parts.engravings), analysis.model,
                       {extras.hasReference, parts.isKerfApplied, extras.machine, extras.finish,
                        extras.hasJointColours});
    cutting.drawing.list = std::move(parts.list);
    return cutting;
}

std::shared_ptr<const Layout> layoutFor(const Analysis &analysis, const CuttingOptions &options)
{
    const Result<CutParts> parts = cutParts(analysis, options.compensatesKerf);
    if (!parts)
        return nullptr;
    return std::make_shared<const Layout>(layoutOf(analysis.model, parts->parts, options));
}

Result<Cutting> makeCutting(const Analysis &analysis, const CuttingOptions &options)
{
    Result<CutParts> parts = cutParts(analysis, options.compensatesKerf);
    if (!parts)
        return tl::unexpected(std::move(parts.error()));
    const Layout layout = layoutOf(analysis.model, parts->parts, options);
    return cuttingOf(analysis, *std::move(parts), layout, options);
}

} // namespace fff
