// The pixels of a template, once its file is read.
#pragma once

#include "core/model/template.h"
#include "core/templates/traced_picture.h"

#include <cstdint>
#include <vector>

namespace fff {

/// So many pixels of one picture, and of all pictures of a document: four bytes each.
inline constexpr std::int64_t kMostPicturePixels = 64'000'000, kMostPixelsOfAll = 128'000'000;

/// Immutable.
struct TemplatePicture
{
    int width = 0, height = 0; // px
    /// Red, green, blue and how opaque, which the colours are not multiplied with; row by row from
    /// the top.
    std::vector<std::uint8_t> rgba;
    bool isOpaque = true; // all of it

    std::int64_t pixels() const { return std::int64_t(width) * height; }
};

/// Every so many-th pixel of every so many-th row, so that there are at most about that many:
/// enough for a look at its tones while a person waits.
TemplatePicture sampledPicture(const TemplatePicture &picture, std::int64_t most);

/// What of a picture is traced.
enum class TraceBy {
    Darkness, // as seen on white paper
    Opacity,  // what is opaque, whatever its colour
};

/// Black where it is darkest, or most opaque. O(pixels).
GreyPicture greyOf(const TemplatePicture &picture, TraceBy by);

/// The box of what is drawn in it, pixels about its middle, y upwards: of what is opaque where
/// parts of it are not, else of what is as unlike its edge as suggestedThreshold() tells. The whole
/// picture where that is nothing. O(pixels).
Box2 drawnBox(const TemplatePicture &picture);

} // namespace fff
