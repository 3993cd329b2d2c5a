#include "core/model/document.h"

#include <algorithm>
#include <cassert>

namespace fff {

namespace {

template <class Pointers>
bool equalValues(const Pointers &a, const Pointers &b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto &x, const auto &y) { return x == y || *x == *y; });
}

} // namespace

const Section *Document::find(SectionId id) const
{
    const auto it = std::find_if(sections.begin(), sections.end(),
                                 [id](const SectionPointer &s) { return s->id == id; });
    return it == sections.end() ? nullptr : it->get();
}

const Stock *Document::find(StockId id) const
{
    const auto it =
        std::find_if(stocks.begin(), stocks.end(), [id](const auto &s) { return s->id == id; });
    return it == stocks.end() ? nullptr : it->get();
}

const Stock &Document::stockOf(const Section &section) const
{
    const Stock *stock = find(section.stock);
    assert(stock && "every section's stock is in the document");
    return *stock;
}

bool Document::isSame(const Document &other) const
{
    return sections == other.sections && stocks == other.stocks && operations == other.operations &&
           weights == other.weights && currentStock == other.currentStock;
}

bool Document::operator==(const Document &other) const
{
    return equalValues(sections, other.sections) && equalValues(stocks, other.stocks) &&
           operations == other.operations && weights == other.weights &&
           currentStock == other.currentStock && nextId == other.nextId;
}

Document newDocument()
{
    Document document;
    Stock stock = birchPlywood();
    stock.id = StockId{document.nextId++};
    document.currentStock = stock.id;
    document.stocks.push_back(std::make_shared<const Stock>(std::move(stock)));
    return document;
}

} // namespace fff
