// The operations of a `.fff` file. Internal to core/io; what is in them says fff_format.h.
#pragma once

#include "core/io/json_cursor.h"
#include "core/io/json_writer.h"
#include "core/model/document.h"

#include <functional>

namespace fff::io {

/// A drawn section's id, or { "operation": id, "instance": "key" }.
void writeRef(JsonWriter &json, const SectionRef &ref);

void writeOperation(JsonWriter &json, const Operation &operation);

/// What reading an operation asks of the reader of the document.
struct OperationSurroundings
{
    /// A section that may have been deleted.
    std::function<SectionRef(const JsonCursor &)> readRef;
    std::function<StockId(const JsonCursor &)> readStock;
    /// Of something that may have been deleted.
    std::function<std::int64_t(const JsonCursor &)> readGivenId;
};

/// All but its id. Fails with Unsupported for a kind, or a version of one, that is not known here:
/// the model would be another without it.
Operation readOperation(const JsonCursor &cursor, const OperationSurroundings &surroundings);

} // namespace fff::io
