// Bytes that a document keeps as they came: pictures and meshes. All versions of it share them.
#pragma once

#include <memory>
#include <string>

namespace fff {

/// Never changed; `bytes` is never null. What is derived from a picture or a mesh refers to it by
/// `sha256`. io::makeBlob (core/io/blobs.h) makes them.
struct Blob
{
    std::string sha256;    // of the bytes: 64 hexadecimal digits, small letters
    std::string mediaType; // "image/png", "model/stl"; empty: not known
    std::string name;      // of the file that it came from, for people; may be empty
    std::shared_ptr<const std::string> bytes;

    /// The same bytes, since they have the same hash.
    bool operator==(const Blob &other) const
    {
        return sha256 == other.sha256 && mediaType == other.mediaType && name == other.name;
    }
};

using BlobPointer = std::shared_ptr<const Blob>;

} // namespace fff
