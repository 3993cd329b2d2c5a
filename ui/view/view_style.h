// Colours and widths of the view. The window fills it from its theme; the values here are the light
// theme's, so that pictures made without a window look the same.
#pragma once

#include "core/model/stock.h"

#include <QColor>

namespace fff::ui {

struct ViewStyle
{
    QColor top = QColor(0xfa, 0xfb, 0xfc), bottom = QColor(0xdc, 0xe2, 0xe9); // background
    QColor gridFine = QColor(0xc3, 0xcb, 0xd5), gridStrong = QColor(0x99, 0xa4, 0xb1);
    QColor shadow = QColor(0x18, 0x20, 0x2c, 102);
    QColor text = QColor(0x1b, 0x21, 0x27), muted = QColor(0x54, 0x5f, 0x6b);
    QColor strong = QColor(0x7d, 0x87, 0x93); // borders of what floats over the view
    QColor panel = QColor(0xff, 0xff, 0xff);  // their ground, and the casing of lines
    QColor accent = QColor(0x1b, 0x62, 0xc9);
    QColor slit = QColor(0xc2, 0x41, 0x0c);
    QColor symmetry = QColor(0xa3, 0x1f, 0x93); // the axis, and what says that it is used
    QColor guide = QColor(0x00, 0x75, 0x6b);    // what something snaps to
    QColor deadZone = QColor(0x54, 0x5f, 0x6b);
    QColor edge = QColor(0x2b, 0x21, 0x18);
    QColor problem = QColor(0xb3, 0x26, 0x1e); // its outline and hatch
    QColor problemFace = QColor(0xe5, 0x8a, 0x80), problemSide = QColor(0xb2, 0x3b, 0x33);
    QColor warning = QColor(0x8a, 0x53, 0x00);
    QColor warningFace = QColor(0xf0, 0xc0, 0x74), warningSide = QColor(0xb0, 0x74, 0x1c);
    QColor warningHatch = QColor(0x8a, 0x53, 0x00);
    QColor made = QColor(0x5f, 0x4b, 0xb6); // marks of the operation that is selected
    QColor madeFace = QColor(0xcf, 0xc4, 0xf2), madeSide = QColor(0x7c, 0x6a, 0xc8); // its sections
    QColor problemHatch = QColor(0xb3, 0x26, 0x1e);
    QColor casing;                 // round the outline of a selected section; invalid: none
    bool isForColourBlind = false; // stress is told by lightness
    bool casesHover = false;       // and of a hovered one
    double hoverAlpha = 0.6;       // of its outline
    double siblingAlpha = 0.4;     // of those that the same operation made
    double faceBrightness = 1.0;   // of the stocks' faces

    double edgeWidth = 1.0, silhouetteWidth = 1.4; // px
    double engravedWidth = 1.8, scoredWidth = 0.9; // px, of lines that are drawn on sections
    double problemWidth = 2.2;                     // px, of the outline of what has a problem
    double hoverWidth = 2.0, selectionWidth = 2.4; // px

    bool operator==(const ViewStyle &other) const = default;
};

/// How a stock looks: its faces and the edge that the machine leaves.
struct StockLook
{
    QColor face, side;
    double alpha = 1.0; // acrylic alone lets light through
};

/// By words in its name ("Birch plywood", "Acrylic, red"); a plain grey card for unknown names.
StockLook stockLook(const Stock &stock);

} // namespace fff::ui
