// Tables of measurements as text.
#pragma once

#include <string>
#include <vector>

namespace fff::bench {

using TableRow = std::vector<std::string>;

std::string fixed(double value, int decimals);

/// The first column to the left, the others to the right.
std::string aligned(const std::string &title, const std::vector<TableRow> &rows);

/// What the name of a generated model says before its size; nothing of others.
std::string familyOf(const std::string &name);

} // namespace fff::bench
