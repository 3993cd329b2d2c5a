// Sheet materials that a stock can be made of, and sizes of sheets.
#pragma once

#include "core/model/stock.h"

#include <span>
#include <vector>

namespace fff {

/// Every value can be edited afterwards. Those there are: core/io/material_library.h.
struct Material
{
    /// One for each thickness in which it is sold, without ids, at least one; their name is the one
    /// to translate.
    std::vector<Stock> stocks;

    const std::string &name() const { return stocks.front().name; }
};

/// Sheets and beds of machines that are common, mm: width, height.
struct SheetSize
{
    const char *name; // to translate; empty: its numbers say it
    Vec2 size;
};
std::span<const SheetSize> commonSheets();

} // namespace fff
