// How a stock's slits are cut, as rows: their end, the tool, lead-in and bumps.
#pragma once

#include "core/model/stock.h"
#include "ui/properties/property_rows.h"

#include <functional>
#include <vector>

namespace fff::ui {

struct StockAccess
{
    std::function<const Stock *()> read; // never null while rows are refreshed
    std::function<void(const std::function<void(Stock &)> &)> edit;
    std::function<Followed(const char *field)> followed; // core/operations/driven_things.cpp
};

/// Adds the rows to the group; all that have to be refreshed, some of which show nothing.
std::vector<PropertyRow *> addSlitRows(PropertyGroup *group, const StockAccess &stock);

} // namespace fff::ui
