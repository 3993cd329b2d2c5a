#include "core/io/stock_file.h"

#include "core/io/document_file.h"
#include "core/model/edits.h"

#include <utility>

namespace fff::io {

Result<void> writeStock(const QString &path, const Stock &stock)
{
    const Document usual = newDocument();
    const StockId before = usual.currentStock;
    return addStock(usual, stock)
        .and_then([before](Document both) {
            const StockId own = both.currentStock;
            return removeStock(std::move(both), before, own);
        })
        .and_then([&path](const Document &alone) { return writeDocument(path, alone); });
}

Result<Stock> readStock(const QString &path)
{
    return readDocument(path).map([](const LoadedDocument &loaded) {
        const Stock *current = loaded.document.find(loaded.document.currentStock);
        Stock stock = current ? *current : *loaded.document.stocks.front();
        stock.id = {};
        return stock;
    });
}

} // namespace fff::io
