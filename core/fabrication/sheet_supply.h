// The sheets that there are of a stock: those that are used up first, then whole ones.
#pragma once

#include "core/fabrication/layout.h"
#include "core/nesting/problem.h"

#include <vector>

namespace fff {

class SheetSupply
{
public:
    /// Where the options have a size, sheets of that and nothing else.
    SheetSupply(const Stock &stock, const LayoutOptions &options);

    int spareCount() const { return static_cast<int>(m_spares.size()); }
    /// Whether there can be such a sheet, as Sheet::index has it.
    bool has(int index) const { return index >= -spareCount(); }
    /// That one, with nothing on it.
    Sheet sheet(int index) const;
    const Vec2 &whole() const { return m_whole.size; }

    /// As kinds of a problem: each of the spare ones once, so many whole ones once each, and as
    /// many as it takes.
    std::vector<nest::SheetKind> kinds(int wholes) const;
    /// Index of a sheet of that kind; of the last kind, of the first one there.
    int indexOfKind(int kind) const
    {
        return kind < spareCount() ? -1 - kind : kind - spareCount();
    }
    int kindOf(int index) const { return index < 0 ? -1 - index : index + spareCount(); }

private:
    Sheet m_whole;
    std::vector<Sheet> m_spares; // each of them
};

/// Whether margins leave anything of its whole sheets, or of an offcut.
bool hasRoom(const Stock &stock, const LayoutOptions &options);
/// What it covers, to nest on.
Region outlineOf(const Sheet &sheet);
/// mm²
double areaOf(const Sheet &sheet);
/// Whole sheets of that stock that a layout takes beyond those that there are; 0 where that is not
/// said.
int missingSheets(const Layout &layout, const Stock &stock);
/// Of each of the layout's sheets, whether it is one of these: the last of its stock are.
std::vector<bool> areMissing(const Layout &layout, const Document &document);

} // namespace fff
