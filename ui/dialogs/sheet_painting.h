// How a sheet with its parts is drawn (ui/sheet_view.h shows it).
#pragma once

#include "ui/dialogs/sheet_paths.h"

#include <QTransform>

#include <vector>

class QPainter;

namespace fff::ui {

/// Of a part on its sheet.
struct PartLook
{
    bool isPinned = false;
    bool keepsToGrain = false;
    bool isLeftOut = false; // it is in somebody's hand
};

struct SheetPainting
{
    QTransform transform; // from sheet coordinates to the painter's, px
    double margin = 0.0;  // mm
    bool hasReference = false;
    bool hasGrain = false;            // along the sheet's width: parts keep to it
    bool isTooLarge = false;          // no sheet, but a part that fits none
    std::vector<PartLook> looks = {}; // of each part, or none
};

/// Below the sheet, as writers have it: its lower left corner and size, mm, sheet coordinates.
QRectF referenceBar();

void paintSheet(const SheetPaths &sheet, const SheetPainting &how, QPainter &painter);
/// The part that the cursor is on, over what was painted.
void paintHovered(const PartPaths &part, const SheetPainting &how, QPainter &painter);
/// One that is in somebody's hand: as it would lie, hatched where it may not.
void paintHeld(const PartPaths &part, const SheetPainting &how, bool isSound, QPainter &painter);
/// One that is selected: its outline, and a dashed box round it.
void paintChosen(const PartPaths &part, const SheetPainting &how, QPainter &painter);

/// Where the pin of a pinned part is, px; its radius.
QPointF pinPlace(const PartPaths &part, const SheetPainting &how);
inline constexpr double kPinRadius = 8.0;

/// The largest font that a number is read in without leaving the part; 0: none. Pixels of a font
/// are between kLeastDigits and kMostDigits.
int digitsThatFit(const PartPaths &part, const QTransform &transform, const QFont &font);
inline constexpr int kLeastDigits = 8, kMostDigits = 13; // px

} // namespace fff::ui
