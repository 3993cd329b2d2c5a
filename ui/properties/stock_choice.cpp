#include "ui/properties/stock_choice.h"

#include "core/model/edits.h"
#include "ui/measures.h"
#include "ui/view/view_style.h"
#include "ui/workbench.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace fff::ui {

std::vector<Stock> stockChoices(const Document &document)
{
    std::vector<Stock> choices;
    for (const auto &stock : document.stocks)
        choices.push_back(*stock);
    for (const Stock &builtIn : {birchPlywood(), flatfabAcrylic()}) {
        const bool known = std::any_of(choices.begin(), choices.end(), [&](const Stock &stock) {
            return stock.name == builtIn.name;
        });
        if (!known)
            choices.push_back(builtIn);
    }
    return choices;
}

QString stockText(const Stock &stock, const QLocale &locale)
{
    return QCoreApplication::translate("fff::ui::Stock", "%1 %2\u202fmm")
        .arg(QString::fromStdString(stock.name), numberText(stock.thickness, 1, 3, locale));
}

Document withStock(Document document, const Stock &choice, StockId &id)
{
    id = choice.id;
    if (document.find(choice.id))
        return document;
    const StockId current = document.currentStock;
    Result<Document> added = addStock(document, choice);
    if (!added)
        return document;
    id = added->currentStock;
    return setCurrentStock(*added, current).value_or(*added);
}

Choices choicesOfStock(const Document &document, std::optional<StockId> current)
{
    Choices choices;
    for (const Stock &stock : stockChoices(document)) {
        if (current && stock.id == *current)
            choices.current = static_cast<int>(choices.all.size());
        choices.all.push_back({QString::fromStdString(stock.name), stockLook(stock).face});
    }
    return choices;
}

void chooseNewStock(Workbench &bench, int choice)
{
    const Document &document = bench.session().committed().document;
    const Stock stock = stockChoices(document).at(static_cast<std::size_t>(choice));
    StockId id;
    const Document with = withStock(document, stock, id);
    bench.commit(QCoreApplication::translate("fff::ui::Stock", "Use %1 for new sections")
                     .arg(QString::fromStdString(stock.name)),
                 setCurrentStock(with, id));
}

} // namespace fff::ui
