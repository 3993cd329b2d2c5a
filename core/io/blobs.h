// Bytes by their hash: how blobs (core/model/blob.h) are made, and checked when they come back.
#pragma once

#include "core/base/result.h"
#include "core/model/blob.h"

#include <functional>
#include <string>
#include <string_view>

namespace fff::io {

using BlobBytes = std::shared_ptr<const std::string>;

/// 64 hexadecimal digits, small letters.
std::string sha256Of(std::string_view bytes);
/// Could be one.
bool isSha256(std::string_view text);

BlobPointer makeBlob(std::string bytes, std::string mediaType = {}, std::string name = {});

/// Where the bytes are that a document names by their hash, if not with it. What comes has been
/// checked. Errors  BadArchive, args: what is wrong with them.
using BlobSource = std::function<Result<BlobBytes>(const std::string &sha256)>;

} // namespace fff::io
