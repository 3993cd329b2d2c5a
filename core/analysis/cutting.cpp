#include "core/analysis/cutting.h"

#include "core/analysis/findings/narrow_slits.h"
#include "core/base/tolerances.h"
#include "core/fabrication/kerf.h"
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

} // namespace

tl::unexpected<Error> nothingToExport(const Analysis &analysis)
{
    return analysis.model.sectionCount() == 0
               ? failure(ErrorCode::NothingToExport)
               : failure(ErrorCode::NothingToExport, {}, {analysis.model.section(0)->name});
}

Result<Cutting> makeCutting(const Analysis &analysis, const CuttingOptions &options)
{
    if (const Result<void> known = haveParts(analysis.model, analysis.bodies); !known)
        return tl::unexpected(known.error());
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    if (parts.empty())
        return nothingToExport(analysis);
    Cutting cutting;
    for (const int section : sectionsWithoutPart(analysis.bodies))
        cutting.withoutPart.push_back(
            analysis.model.section(static_cast<std::size_t>(section))->name);
    cutting.partCount = static_cast<int>(parts.size());
    std::vector<ListedPart> list = partList(parts, analysis.model); // as designed, without kerf
    const auto slit = narrowestDrawn(analysis, options.compensatesKerf);
    if (!slit)
        return tl::unexpected(slit.error());
    cutting.slit = *slit;
    std::vector<Engraving> engravings;
    for (const Part &part : parts) {
        const Section &section = *analysis.model.section(static_cast<std::size_t>(part.section));
        engravings.push_back(engrave(part, section.marks));
        if (engravings.back().lines.error)
            return failure(ErrorCode::MarksNotCut, {}, {section.name});
        if (!engravings.back().hasNumber)
            addOnce(cutting.unmarked, nameOf(analysis, part));
        if (!engravings.back().jointsLeftOut.empty())
            addOnce(cutting.unmarkedJoints, nameOf(analysis, part));
    }
    if (options.compensatesKerf) {
        auto paths = compensateKerf(parts, analysis.model, analysis.bodies);
        if (!paths)
            return tl::unexpected(paths.error());
        cutting.uncut = withUncutPlaces(analysis, parts, *paths);
        parts = std::move(*paths);
    }
    const Layout layout = layOut(parts, analysis.model, options.layout);
    if (options.compensatesKerf) {
        if (const auto judged = judgeWritten(analysis, layout, parts); !judged)
            return tl::unexpected(judged.error());
    }
    cutting.usedShare = usedShare(layout, parts);
    for (const int index : layout.oversized)
        addOnce(cutting.oversized, nameOf(analysis, parts[static_cast<std::size_t>(index)]));
    cutting.drawing =
        cuttingDrawing(layout, std::move(parts), std::move(engravings), analysis.model,
                       {options.hasReference, options.compensatesKerf, options.machine});
    cutting.drawing.list = std::move(list);
    return cutting;
}

} // namespace fff
