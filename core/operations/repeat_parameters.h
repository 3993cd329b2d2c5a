// What linear and revolve ask for alike. Internal to operations.
#pragma once

#include "core/operations/operation_kind.h"
#include "core/operations/row.h"

namespace fff {

std::vector<InputSpec> repeatInputs();
ParameterSpec wholeBranchParameter();
/// Repeat by count or spacing, and the range.
std::vector<ParameterSpec> rowParameters(int standardCount);
std::vector<ParameterSpec> scaleParameters();

/// The row that these ask for. The range's ends are left to the caller.
RowRequest rowRequest(const OperationContext &context);
/// Says what the row could not do, and what of it could not be made.
void noticeRow(OperationContext &context, const Row &row, int leftOut);

/// The number that a copy's name ends with: 2, 3 … ahead of the source, −1, −2 … behind it.
std::string copyNumber(int number);

} // namespace fff
