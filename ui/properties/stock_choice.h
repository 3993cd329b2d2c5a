// The stocks that can be chosen: those of the document, then the built-in ones that it does not
// have yet.
#pragma once

#include "core/model/document.h"

#include "ui/properties/choice_box.h"

#include <QLocale>
#include <QString>

#include <optional>
#include <vector>

namespace fff::ui {

class Workbench;

std::vector<Stock> stockChoices(const Document &document);
/// "Birch plywood 3.0 mm"
QString stockText(const Stock &stock, const QLocale &locale);

/// By name alone. current: nothing when several are meant.
Choices choicesOfStock(const Document &document, std::optional<StockId> current);

/// The document with this choice in it; `id` is what the stock is called there.
Document withStock(Document document, const Stock &choice, StockId &id);

/// Commits the choice as the stock of the next sections.
void chooseNewStock(Workbench &bench, int choice);

} // namespace fff::ui
