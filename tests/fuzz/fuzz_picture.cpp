// Any bytes as a picture to draw over. If this stops, a file from the net takes the window down, or
// a picture that opens has other pixels than it says, or cannot be traced.
#include "core/io/picture_file.h"
#include "core/templates/traced_picture.h"
#include "tests/fuzz/png_mutator.h"
#include "tests/fuzz/properties.h"

#include <QCoreApplication>

#include <cstring>

using namespace fff;

namespace {

/// What is decoded costs time and memory by its pixels, and a few bytes can claim any number.
constexpr std::int64_t kMostFuzzedPixels = 1 << 18, kMostSampledPixels = 1 << 12;

void requireWhole(const TemplatePicture &picture)
{
    fuzz::require(picture.width > 0 && picture.height > 0, "a picture has a pixel");
    fuzz::require(picture.pixels() <= kMostFuzzedPixels, "what is too large is refused");
    fuzz::require(std::int64_t(picture.rgba.size()) == 4 * picture.pixels(),
                  "there are as many pixels as it says");
    bool isOpaque = true;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
        isOpaque = isOpaque && picture.rgba[i] == 0xFF;
    fuzz::require(isOpaque == picture.isOpaque, "it knows whether it lets light through");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static int argc = 1;
    static char name[] = "fuzz_picture", *argv[] = {name, nullptr};
    static QCoreApplication application(argc, argv); // knows where Qt's readers are

    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    const Result<io::LoadedPicture> loaded = io::readPicture(bytes, "input", kMostFuzzedPixels);
    if (!loaded) {
        fuzz::requireClear(loaded.error());
        return 0;
    }
    requireWhole(*loaded->picture);
    fuzz::require(std::strncmp(loaded->mediaType, "image/", 6) == 0, "its kind is known");
    fuzz::require(loaded->millimetresPerPixel >= 0.0, "no pixel is smaller than nothing");
    const TemplatePicture sampled = sampledPicture(*loaded->picture, kMostSampledPixels);
    const GreyPicture grey = greyOf(sampled, TraceBy::Darkness);
    fuzz::require(traced(grey, {.threshold = suggestedThreshold(grey)}).has_value(),
                  "it can be traced");
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size,
                                               std::size_t maxSize, unsigned int seed)
{
    return fuzz::mutatePng(data, size, maxSize, seed);
}
