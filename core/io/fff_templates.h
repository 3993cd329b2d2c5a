// The templates of a `.fff` file. Internal to core/io; what is in them says fff_format.h.
#pragma once

#include "core/io/fff_annotations.h"

namespace fff::io {

/// A member of a document; nothing where it has none.
void writeTemplates(JsonWriter &json, const Document &document);
/// Their bytes may be missing.
std::vector<TemplatePointer> readTemplates(const JsonCursor &cursor,
                                           const ReferenceReaders &readers);

} // namespace fff::io
