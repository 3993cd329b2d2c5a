#include "tests/bench/text_table.h"

#include <algorithm>
#include <cstdio>

namespace fff::bench {

namespace {

std::size_t width(const std::string &text)
{
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; // the first byte of a character
    }));
}

} // namespace

std::string fixed(double value, int decimals)
{
    char buffer[64];
    const int length = std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    return {buffer, static_cast<std::size_t>(length)};
}

std::string aligned(const std::string &title, const std::vector<TableRow> &rows)
{
    std::vector<std::size_t> widths;
    for (const TableRow &row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], width(row[i]));
    }
    std::string out = title + "\n";
    for (const TableRow &row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - width(row[i]), ' ');
            out += i == 0 ? row[i] + space : "  " + space + row[i];
        }
        out += '\n';
    }
    return out + '\n';
}

std::string familyOf(const std::string &name)
{
    const std::size_t size = name.find_first_of("0123456789");
    const bool isSized = size != 0 && size != std::string::npos && name[size - 1] == ' ';
    return isSized ? name.substr(0, size) : std::string();
}

} // namespace fff::bench
