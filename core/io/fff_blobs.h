// The blobs of a document (core/model/blob.h) as members of a `.fff` file's JSON, which names them;
// their bytes are elsewhere. Internal to core/io; what is in them says fff_format.h.
#pragma once

#include "core/io/blobs.h"
#include "core/io/json_cursor.h"
#include "core/io/json_writer.h"
#include "core/model/document.h"

namespace fff::io {

/// Nothing where it has none.
void writeBlobs(JsonWriter &json, const Document &document);

/// As they stand in a document. What `source` does not have is left out, with a warning: the rest
/// of the model is worth more than a refusal.
std::vector<BlobPointer> readBlobs(const JsonCursor &cursor, const BlobSource &source,
                                   Problems &problems);

} // namespace fff::io
