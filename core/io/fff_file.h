// The bytes of a `.fff` file: the document's JSON (core/io/fff_format.h), or, when it has blobs, a
// ZIP with
//
//     document.json      the same JSON, which names them
//     blobs/SHA256       the bytes of each, by their hash in 64 hexadecimal digits
//
// and nothing else, but that "blobs/" may be an entry itself, as in what other programs pack. Which
// of the two it is is decided by what is in it.
#pragma once

#include "core/io/formats.h"

namespace fff::io {

/// The same document makes the same bytes. Errors  those of writeFff; BadCount for more blobs, or
/// larger ones, than core/io/archive.h has room for.
Result<std::string> writeFffFile(const Document &document);

/// name    how errors call the file
/// blobs   where the bytes are for JSON alone that names some (a copy that a crash left): what is
///         not there is left out, with a warning; without it, as in a ZIP, that is an error
/// Errors  those of readFff; of a ZIP that is none of ours NotAModel; those of core/io/archive.h;
///         BadArchive for an entry that is missing, that the document does not name, or whose bytes
///         have another hash than its name says.
/// Warnings  those of readFff
Result<LoadedDocument> readFffFile(std::string_view bytes, const std::string &name = {},
                                   const BlobSource &blobs = {});

const Format &fffFormat();

} // namespace fff::io
