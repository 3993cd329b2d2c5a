#include "ui/properties/stock_choice.h"

#include "core/model/edits.h"
#include "ui/bench/measures.h"
#include "ui/bench/workbench.h"
#include "ui/view/view_style.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace fff::ui {

namespace {

// Names of presets (core/model/materials.cpp, stock.cpp), for lupdate too.
const char *const kNames[] = {
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Birch plywood"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Birch plywood 4 mm"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Birch plywood 6.5 mm"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Birch plywood 9 mm"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "MDF"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Acrylic"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Acrylic, clear"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Acrylic, red"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Corrugated board B"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Corrugated board C"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Corrugated board E"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Card"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Basswood"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "POM"),
    QT_TRANSLATE_NOOP("fff::ui::Stock", "Aluminium 6061"),
};

bool isPreset(const QByteArray &name)
{
    return std::any_of(std::begin(kNames), std::end(kNames),
                       [&](const char *preset) { return name == preset; });
}

} // namespace

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

QString stockName(const Stock &stock)
{
    const auto translated = [](const QByteArray &name) {
        return QCoreApplication::translate("fff::ui::Stock", name.constData());
    };
    const QByteArray name = QByteArray::fromStdString(stock.name);
    // "MDF 2", a second one of a preset, is read as the preset is; "Birch plywood 4 mm" is one.
    const qsizetype blank = name.lastIndexOf(' ');
    bool isNumber = false;
    name.mid(blank + 1).toUInt(&isNumber);
    if (blank > 0 && isNumber && !isPreset(name) && isPreset(name.first(blank)))
        return translated(name.first(blank)) + QString::fromUtf8(name.mid(blank));
    return isPreset(name) ? translated(name) : QString::fromStdString(stock.name);
}

QString stockText(const Stock &stock, const QLocale &locale)
{
    return QCoreApplication::translate("fff::ui::Stock", "%1 %2")
        .arg(stockName(stock), lengthText(stock.thickness, 1, 3, locale));
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
        choices.all.push_back({stockName(stock), stockLook(stock).face});
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
                     .arg(stockName(stock)),
                 setCurrentStock(with, id));
}

Result<Document> withThickness(Document document, std::span<const StockId> stocks,
                               double millimetres)
{
    Result<Document> next = std::move(document);
    for (StockId id : stocks) {
        const Stock *stock = next ? next->find(id) : nullptr;
        if (!stock)
            continue;
        Stock changed = *stock;
        setThickness(changed, millimetres, changed.isMeasured);
        next = setStock(std::move(*next), changed);
    }
    return next;
}

void previewThickness(Workbench &bench, std::span<const StockId> stocks, double millimetres)
{
    Result<Document> next =
        withThickness(bench.session().committed().document, stocks, millimetres);
    if (next)
        bench.session().preview(std::move(*next));
}

void commitThickness(Workbench &bench, std::span<const StockId> stocks, double millimetres)
{
    const Document &document = bench.session().committed().document;
    const Stock *stock = nullptr;
    for (StockId id : stocks)
        stock = stock ? stock : document.find(id);
    if (!stock)
        return;
    const QLocale locale;
    const QString text =
        //: a step of the history; %1 is a stock, %2 and %3 are lengths
        QCoreApplication::translate("fff::ui::Stock", "%1: %2 → %3 thick")
            .arg(stockName(*stock), lengthNumber(stock->thickness, 1, 3, locale),
                 lengthText(millimetres, 1, 3, locale));
    bench.commit(text, withThickness(document, stocks, millimetres));
}

} // namespace fff::ui
