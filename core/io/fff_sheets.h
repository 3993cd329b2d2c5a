// What a `.fff` file says of how parts lie on their sheets: which are pinned, and how sections may
// be turned there. Internal to core/io.
#pragma once

#include "core/io/fff_annotations.h"

namespace fff::io {

/// Members of a document; nothing where it has none.
void writePins(JsonWriter &json, const Document &document);
void writeTurnings(JsonWriter &json, const Document &document);
/// In their order, each once: else BadValue.
std::vector<PinnedPlace> readPins(const JsonCursor &cursor, const ReferenceReaders &readers);
std::vector<SectionTurning> readTurnings(const JsonCursor &cursor, const ReferenceReaders &readers);

} // namespace fff::io
