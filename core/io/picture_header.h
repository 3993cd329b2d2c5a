// What the bytes of a picture say of it before it is decoded: whether that can be afforded, and is
// worth it. Internal to core/io.
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace fff::io {

struct PictureHeader
{
    const char *format = "";            // as Qt calls it: "png", "jpeg", "webp"
    const char *title = "";             // as people do: "PNG"
    const char *mediaType = "";         // "image/png"
    std::int64_t width = 0, height = 0; // px, as it is stored; 0: it does not say here
    bool isAnimated = false;
};

/// By the first bytes, whatever the file is called: a picture, if not one that is read here.
bool looksLikePicture(std::string_view head);

/// Walks through all parts of the file, without a look into the pixels.
///
/// name    how errors call the file
/// Errors  BadSyntax for what is no picture of these kinds; Truncated, place = name:byte N, where
///         it ends too early; BadValue for one without pixels
/// Source  PNG: ISO/IEC 15948, section 5; JPEG: ITU-T T.81, annex B; WebP: RFC 9649
Result<PictureHeader> pictureHeader(std::string_view bytes, const std::string &name);

} // namespace fff::io
