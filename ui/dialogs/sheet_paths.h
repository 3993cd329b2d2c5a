// The lines of a cutting drawing as paths to paint: the very curves that the writers put into
// files, sheet by sheet.
#pragma once

#include "core/fabrication/cutting_drawing.h"

#include <QPainterPath>
#include <QString>

#include <utility>
#include <vector>

namespace fff::ui {

/// Sheet coordinates: mm, origin at the sheet's lower left, y up.
struct PartPaths
{
    int number = 0;
    QString name;      // of its section
    QPainterPath cuts; // closed, holes and the outside; by the odd-even rule material
    // What of them is followed, with bridges, run-ins and edges left out; empty: all, as they are.
    QPainterPath followed;
    QPainterPath engraved, scored; // that people drew on it
    QPainterPath label;            // strokes of its number, and of those of its joints
    // Of the latter, where they have colours, 0xRRGGBB.
    std::vector<std::pair<unsigned, QPainterPath>> jointLabels;
    bool hasNumber = false; // its own, among the label
    QPointF roomiest;       // farthest from every cut: where a number is read best
};

struct SheetPaths
{
    int number = 1;       // among all sheets of the drawing
    QSizeF size;          // mm
    QPainterPath outline; // of an offcut; empty: a rectangle of that size
    StockId stock;
    double wholeFrom = 0.0; // mm: what lies above stays whole; 0: nothing does
    std::vector<PartPaths> parts;
};

/// What a file has of the part's cuts.
const QPainterPath &cutLines(const PartPaths &part);

/// One of each sheet, in their order; cuts by the sheets' finish.
std::vector<SheetPaths> sheetPaths(const CuttingDrawing &drawing);

} // namespace fff::ui
