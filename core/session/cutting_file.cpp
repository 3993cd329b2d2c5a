#include "core/session/cutting_file.h"

#include "core/fabrication/kerf.h"
#include "core/fabrication/wholeness.h"
#include "core/io/svg_writer.h"
#include "core/session/narrow_slits.h"

#include <algorithm>

namespace fff {

namespace {

std::string nameOf(const Analysis &analysis, const Part &part)
{
    return analysis.model.section(static_cast<std::size_t>(part.section))->name;
}

void addOnce(std::vector<std::string> &names, std::string name)
{
    if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(std::move(name));
}

/// The narrowest slit as it will be drawn, and whose slits would have no width.
void measureSlits(const Analysis &analysis, bool compensatesKerf, CuttingFile &file)
{
    for (std::size_t i = 0; i < analysis.assembly.slits.size(); ++i) {
        const double kerf = compensatesKerf ? analysis.model.stockOf(i).kerf : 0.0;
        for (const Slit &slit : analysis.assembly.slits[i]) {
            if (slit.role != SlitRole::Slit)
                continue;
            const double width = narrowest(slit) - kerf;
            file.slitWidth = std::min(width, file.slitWidth.value_or(width));
            if (width <= 0.0)
                addOnce(file.closedSlits, analysis.model.section(i)->name);
        }
    }
}

} // namespace

Result<CuttingFile> makeCuttingFile(const Analysis &analysis, const CuttingFileOptions &options)
{
    if (const Result<void> known = haveParts(analysis.model, analysis.cuts); !known)
        return tl::unexpected(known.error());
    std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.cuts);
    if (parts.empty())
        return failure(ErrorCode::NothingToExport);
    CuttingFile file;
    file.partCount = static_cast<int>(parts.size());
    measureSlits(analysis, options.compensatesKerf, file);
    std::vector<Engraving> engravings;
    for (const Part &part : parts) {
        const Section &section = *analysis.model.section(static_cast<std::size_t>(part.section));
        engravings.push_back(engrave(part, section.marks));
        if (engravings.back().lines.error)
            return failure(ErrorCode::MarksNotCut, {}, {section.name});
        if (!engravings.back().hasNumber)
            addOnce(file.unmarked, nameOf(analysis, part));
        if (!engravings.back().jointsLeftOut.empty())
            addOnce(file.unmarkedJoints, nameOf(analysis, part));
    }
    if (options.compensatesKerf)
        parts = compensateKerf(std::move(parts), analysis.model, analysis.cuts);
    const Layout layout = layOut(parts, analysis.model, options.layout);
    file.sheetCount = static_cast<int>(layout.sheets.size());
    file.usedShare = usedShare(layout, parts);
    for (const int index : layout.oversized)
        addOnce(file.oversized, nameOf(analysis, parts[static_cast<std::size_t>(index)]));

    io::SvgOptions svg;
    svg.hasReference = options.hasReference;
    svg.kerfApplied = options.compensatesKerf;
    if (!options.isFilePerSheet) {
        file.svg = io::writeSvg(layout, parts, engravings, analysis.model, svg);
        return file;
    }
    for (const Sheet &sheet : layout.sheets) {
        file.sheets.push_back(
            io::writeSvg(Layout{{sheet}, {}}, parts, engravings, analysis.model, svg));
        ++svg.firstSheet;
    }
    return file;
}

} // namespace fff
