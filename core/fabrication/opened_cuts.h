// Cuts with tabs and leads, and without what another one cuts. Internal to fabrication.
#pragma once

#include "core/fabrication/cutting_order.h"

#include <span>
#include <vector>

namespace fff {

/// What is followed of each of these closed cuts by the sheet's finish: as it is where nothing of
/// it is left out; else open pieces in the order of the line.
///
///   tabs    on the outside of a part, as evenly round it as their places allow: none within
///           kTabRoom of a corner, at a slit, or where another cut would go through; each the width
///           asked for, so fewer than asked for where there is no room
///   leads   one before and one behind a cut, at 45° from it on the side of the waste (outside of
///           parts, inside holes), at a place as of tabs, apart from these. Where none fits, off
///           every other cut by kLeadRoom and on the sheet, the cut has none
///   shared  edges that lie on those of a cut before are left to that
///
/// cuts  of the sheet, as they are drawn: outsides counter-clockwise, holes clockwise
std::vector<std::vector<ToolLine>> openedCuts(std::span<const ToolLine *const> cuts,
                                              const CuttingSheet &sheet);

/// Indices of the cuts that get no lead, though the finish asks for leads.
std::vector<std::size_t> cutsWithoutLead(std::span<const ToolLine *const> cuts,
                                         const CuttingSheet &sheet);

// mm
inline constexpr double kTabRoom = 1.0;
inline constexpr double kLeadRoom = 0.5;

} // namespace fff
