// From an analysed model to what is cut: parts, kerf, layout, drawing, and what is to be said of
// it.
#pragma once

#include "core/analysis/analysis.h"
#include "core/fabrication/cutting_drawing.h"
#include "core/fabrication/nested_layout.h"
#include "core/fabrication/part_list.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace fff {

/// What is drawn besides the parts.
struct DrawingExtras
{
    bool hasReference = true; // a 100 mm bar beside the sheets, to check the printed size
    std::shared_ptr<const Machine> machine = nullptr; // that it is for; none: no particular one
    std::optional<CutFinish> finish = {};             // none: the machine's
    bool hasJointColours = false;                     // numbers of joints in a colour for each
};

struct CuttingOptions : DrawingExtras
{
    LayoutOptions layout;
    /// By true outlines, with `layout`, and what the document wants of them (sheet_wishes.h); none:
    /// by boxes, which know nothing of that.
    std::optional<NestOptions> nesting = {};
    /// How the parts lie already, with these options; null: they are to be laid.
    std::shared_ptr<const Layout> lying = {};
    bool compensatesKerf = true; // each cut path offset by half its stock's kerf
};

/// The narrowest slit as it is drawn: the cutter takes the kerf off its walls again.
struct DrawnSlit
{
    double width = 0.0, kerf = 0.0; // mm; what is cut is as wide as both together
};

/// Whole sheets of a stock that are taken beyond those that there are.
struct MissingSheets
{
    std::string stock; // its name
    int count = 0;
};

struct Cutting
{
    CuttingDrawing drawing;
    int partCount = 0;
    double usedShare = 0.0;               // of the sheets' area that parts cover, 0 … 1
    std::vector<std::string> withoutPart; // names of sections of which slits leave nothing
    std::vector<std::string> oversized;   // names of sections with a part that fits no sheet
    std::vector<std::string> unmarked; // names of sections with a part too slim to carry its number
    std::vector<std::string> unmarkedJoints; // the same for the numbers of all its joints
    std::vector<std::string> uncut; // with a hole or a notch that is narrower than the kerf
    std::vector<MissingSheets> missing;
    std::optional<DrawnSlit> slit; // of any

    int sheetCount() const { return static_cast<int>(drawing.sheets.size()); }
};

/// All of a cutting but where its parts lie.
struct CutParts
{
    std::vector<Part> parts; // as they are cut
    std::vector<Engraving> engravings;
    std::vector<ListedPart> list; // of all parts as designed, without kerf
    Cutting cutting;              // without a drawing
    bool isKerfApplied = false;
};

/// Errors  NothingToExport for a model without sections, or of which slits leave nothing; as
/// haveParts(); MarksNotCut; ClosedSlit for a slit that the kerf closes, CannotOffset for a part
/// without a path, with the section's name.
Result<Cutting> makeCutting(const Analysis &analysis, const CuttingOptions &options = {});

/// Its two steps.
Result<CutParts> cutParts(const Analysis &analysis, bool compensatesKerf);
/// layout  of these parts, which are the analysis's
Result<Cutting> cuttingOf(const Analysis &analysis, CutParts parts, const Layout &layout,
                          const DrawingExtras &extras);

/// How its parts lie with these options, for those who tell of sheets beside a drawing. Null where
/// nothing can be cut.
std::shared_ptr<const Layout> layoutFor(const Analysis &analysis, const CuttingOptions &options);

/// Of a model that has no part: whether because it has no section, or because slits leave nothing.
tl::unexpected<Error> nothingToExport(const Analysis &analysis);

} // namespace fff
