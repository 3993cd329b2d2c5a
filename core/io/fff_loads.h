// Weights and pushes of a `.fff` file. Internal to core/io.
#pragma once

#include "core/io/fff_annotations.h"

namespace fff::io {

/// Members of a document: weights, and pushes where it has some.
void writeLoads(JsonWriter &json, const Document &document);
/// In the order of their ids.
std::vector<Load> readLoads(const JsonCursor &weights, const JsonCursor &pushes,
                            const ReferenceReaders &readers);

} // namespace fff::io
