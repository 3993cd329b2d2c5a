// Pictures from files, as pixels.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/templates/template_picture.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace fff::io {

struct LoadedPicture
{
    TemplatePicturePointer picture;
    const char *mediaType = ""; // "image/png"
    /// How large it is meant to be, mm a pixel; 0: the file does not say, or says what every file
    /// says. Scans say it.
    double millimetresPerPixel = 0.0;
    bool isAnimated = false; // this is the first of several
};

/// Not too large to be afforded. Errors  BadCount above mostPixels.
Result<void> checkedPixels(std::int64_t width, std::int64_t height, const std::string &name,
                           std::int64_t mostPixels = kMostPicturePixels);

/// A picture as PNG, JPEG or, where the platform reads it, WebP, upright as its camera was held,
/// in the colours of screens. What is larger than mostPixels is refused before memory is taken for
/// it.
///
/// name    how errors call the file
/// Errors  those of pictureHeader(); BadCount above mostPixels; BadArchive for one that is damaged;
///         Unsupported where the platform does not read its kind; Cancelled
Result<LoadedPicture> readPicture(std::string_view bytes, const std::string &name,
                                  std::int64_t mostPixels = kMostPicturePixels,
                                  const LongWork &work = {});

} // namespace fff::io
