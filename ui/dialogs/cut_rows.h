// How cuts begin and end, as rows of the Export panel.
#pragma once

#include "core/fabrication/cut_finish.h"
#include "core/model/stock.h"
#include "ui/properties/property_rows.h"

#include <functional>
#include <vector>

namespace fff::ui {

/// Adds tabs, their width, leads and common lines to the group; all rows that are refreshed.
/// read   how cuts are made now; what a person chooses of it is written
std::vector<PropertyRow *> addCutRows(PropertyGroup *group, const std::function<CutFinish()> &read,
                                      const std::function<void(const CutFinish &)> &write);

/// The slit of a fit coupon that fitted (core/fabrication/fit_coupon.h): what is chosen is written
/// as the clearance.
PropertyRow *fittedSlitRow(const std::function<double()> &clearance,
                           const std::function<void(double)> &write, QWidget *parent);

} // namespace fff::ui
