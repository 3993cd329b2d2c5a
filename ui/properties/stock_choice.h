// The stocks that can be chosen: those of the document, then the two that every document can start
// with, where it does not have them. All other presets are the stock editor's.
#pragma once

#include "core/model/document.h"

#include "ui/properties/choice_box.h"

#include <QLocale>
#include <QString>

#include <optional>
#include <span>
#include <vector>

namespace fff::ui {

class Workbench;

std::vector<Stock> stockChoices(const Document &document);
/// The name of a stock as people read it: that of a preset is translated.
QString stockName(const Stock &stock);
/// "Birch plywood 3.0 mm"
QString stockText(const Stock &stock, const QLocale &locale);

/// By name alone. current: nothing when several are meant.
Choices choicesOfStock(const Document &document, std::optional<StockId> current);

/// The document with this choice in it; `id` is what the stock is called there.
Document withStock(Document document, const Stock &choice, StockId &id);

/// Commits the choice as the stock of the next sections.
void chooseNewStock(Workbench &bench, int choice);

/// The document with other thicknesses of these stocks.
Result<Document> withThickness(Document document, std::span<const StockId> stocks,
                               double millimetres);
/// Shows it without a step; commitThickness makes it one.
void previewThickness(Workbench &bench, std::span<const StockId> stocks, double millimetres);
void commitThickness(Workbench &bench, std::span<const StockId> stocks, double millimetres);

} // namespace fff::ui
