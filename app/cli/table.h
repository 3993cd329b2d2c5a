// Tables that people write or take from a spreadsheet: CSV.
#pragma once

#include <QStringList>

#include <optional>
#include <vector>

namespace fff::cli {

struct TableRow
{
    int line = 0; // where it begins, from 1
    QStringList cells;
};

/// Rows in their order, empty ones left out; cells without blanks around them, but as they are in
/// quotes. Cells are parted by the first of ; tab and , that the first line has outside of quotes:
/// spreadsheets write semicolons where commas stand before decimals. UTF-8, with or without a byte
/// order mark. Nothing where a quote is not closed. Source  RFC 4180.
std::optional<std::vector<TableRow>> readTable(const QString &text);

} // namespace fff::cli
