// Presets: the sheet materials that a stock can be made of. Every value can be edited afterwards.
#pragma once

#include "core/model/stock.h"

#include <span>
#include <vector>

namespace fff {

struct Material
{
    Stock stock;                     // without an id; its name is the one to translate
    std::vector<double> thicknesses; // mm, that are sold under this name
};

/// In the order in which they are offered; birchPlywood() and flatfabAcrylic() are not among them.
std::span<const Material> materials();

/// Sheets and beds of machines that are common, mm: width, height.
struct SheetSize
{
    const char *name; // to translate; empty: its numbers say it
    Vec2 size;
};
std::span<const SheetSize> commonSheets();

} // namespace fff
