// Stocks of a `.fff` file. Internal to core/io.
#pragma once

#include "core/io/json_cursor.h"
#include "core/io/json_writer.h"
#include "core/model/stock.h"

#include <cstdint>
#include <functional>

namespace fff::io {

using ShapeWriter = std::function<void(JsonWriter &, const Shape &)>;

void writeStock(JsonWriter &json, const Stock &stock, const ShapeWriter &writeShape);

/// What is read elsewhere.
struct StockReaders
{
    std::function<std::int64_t(const JsonCursor &)> readId;
    std::function<ShapePointer(const JsonCursor &)> readShape; // null: it has been said why
};

/// What is missing is as in a new stock.
Stock readStock(const JsonCursor &cursor, const StockReaders &readers);

} // namespace fff::io
