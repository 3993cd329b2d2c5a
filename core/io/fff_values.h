// Values with names of a `.fff` file, and what was typed for its numbers. Internal to core/io; what
// is in them says fff_format.h.
#pragma once

#include "core/io/fff_annotations.h"

namespace fff::io {

/// Members of a document; nothing where it has none.
void writeValues(JsonWriter &json, const Document &document);
void writeBindings(JsonWriter &json, const Document &document);

/// With presets. An expression that is none here is kept: the value says what is wrong with it.
/// nextId: the document's.
Values readValues(const JsonCursor &root, std::int64_t nextId, const ReferenceReaders &readers);
/// Those of numbers that `document`, which is whole otherwise, has: what a later version knows is a
/// number all the same.
/// lost  of each that is no binding here: nothing has the number, or it has become another one
/// since
std::vector<BindingPointer>
readBindings(const JsonCursor &cursor, const Document &document, const ReferenceReaders &readers,
             const std::function<void(const JsonCursor &item, const std::string &typed)> &lost);

} // namespace fff::io
