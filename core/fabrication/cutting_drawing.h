// What is sent to a machine: the lines of all parts as they lie on their sheets, by what is done
// along them. Every format of cutting files is written from this alone.
#pragma once

#include "core/fabrication/layout.h"
#include "core/fabrication/marks.h"

#include <string>
#include <vector>

namespace fff {

enum class LineRole {
    Engrave,  // that people drew on sections
    Score,    // the same, to fold along
    InnerCut, // round a hole
    OuterCut, // round the part
};

/// Sheet coordinates: mm, origin at the sheet's lower left, y up.
struct CuttingLine
{
    LineRole role = LineRole::OuterCut;
    CurvePath path; // of cuts closed
};

struct CuttingPart
{
    int number = 0;                 // engraved
    std::string name;               // of its section
    Strokes label;                  // its number, and those of its joints; sheet coordinates
    std::vector<CuttingLine> lines; // as they are to be cut: what is drawn, holes, the outside
};

struct CuttingSheet
{
    int number = 1;
    Vec2 size = Vec2::Zero(); // mm
    StockId stock;
    std::vector<CuttingPart> parts;
};

struct CuttingDrawing
{
    std::vector<CuttingSheet> sheets;
    std::vector<Stock> stocks; // that are on them, in the document's order
    bool isKerfApplied = false;
    bool hasReference = true; // a bar of 100 mm x 10 mm, to measure after cutting: a guide
};

struct DrawingOptions
{
    bool hasReference = true;
    bool isKerfApplied = false; // what `parts` are: outlines as designed, or compensated already
};

/// `layout` and `parts` belong to `model`; `engravings` to the parts, one each, or none at all.
CuttingDrawing cuttingDrawing(const Layout &layout, const std::vector<Part> &parts,
                              const std::vector<Engraving> &engravings, const Model &model,
                              const DrawingOptions &options = {});

/// The sheet at the index alone, with its stock.
CuttingDrawing onSheet(const CuttingDrawing &drawing, std::size_t index);

} // namespace fff
