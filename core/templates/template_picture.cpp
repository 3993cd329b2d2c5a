#include "core/templates/template_picture.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr int kOpaque = 255;
/// What is more opaque than this share counts as drawn.
constexpr double kHalfOpaque = 0.5;

/// Shares of red, green and blue in how bright a colour is: ITU-R BT.601, of 256.
constexpr int kRedShare = 77, kGreenShare = 150, kBlueShare = 29;

std::uint8_t greyOfPixel(const std::uint8_t *p, TraceBy by)
{
    if (by == TraceBy::Opacity)
        return static_cast<std::uint8_t>(kOpaque - p[3]);
    const int bright = (kRedShare * p[0] + kGreenShare * p[1] + kBlueShare * p[2]) >> 8;
    return static_cast<std::uint8_t>(kOpaque - (kOpaque - bright) * p[3] / kOpaque);
}

/// Most of the pixels at its edge are as dark.
bool hasDarkEdge(const GreyPicture &grey, double limit)
{
    std::int64_t dark = 0, all = 0;
    const auto count = [&](int x, int y) {
        dark += grey.at(x, y) < limit ? 1 : 0;
        ++all;
    };
    for (int x = 0; x < grey.width; ++x) {
        count(x, 0);
        count(x, grey.height - 1);
    }
    for (int y = 0; y < grey.height; ++y) {
        count(0, y);
        count(grey.width - 1, y);
    }
    return 2 * dark > all;
}

} // namespace

TemplatePicture sampledPicture(const TemplatePicture &picture, std::int64_t most)
{
    const auto step = std::max(
        1, static_cast<int>(std::ceil(std::sqrt(double(picture.pixels()) / double(most)))));
    TemplatePicture sampled;
    sampled.width = (picture.width + step - 1) / step;
    sampled.height = (picture.height + step - 1) / step;
    sampled.isOpaque = picture.isOpaque;
    sampled.rgba.reserve(static_cast<std::size_t>(4 * sampled.pixels()));
    for (int y = 0; y < picture.height; y += step)
        for (int x = 0; x < picture.width; x += step) {
            const auto at = picture.rgba.begin() + 4 * (std::int64_t(y) * picture.width + x);
            sampled.rgba.insert(sampled.rgba.end(), at, at + 4);
        }
    return sampled;
}

GreyPicture greyOf(const TemplatePicture &picture, TraceBy by)
{
    GreyPicture grey{picture.width, picture.height, {}};
    grey.grey.resize(picture.rgba.size() / 4);
    for (std::size_t i = 0; i < grey.grey.size(); ++i)
        grey.grey[i] = greyOfPixel(picture.rgba.data() + 4 * i, by);
    return grey;
}

Box2 drawnBox(const TemplatePicture &picture)
{
    const bool isByOpacity = !picture.isOpaque;
    const GreyPicture grey = greyOf(picture, isByOpacity ? TraceBy::Opacity : TraceBy::Darkness);
    const double limit = kOpaque * (isByOpacity ? kHalfOpaque : suggestedThreshold(grey));
    const bool isLight = !isByOpacity && hasDarkEdge(grey, limit);
    const Vec2 middle(0.5 * picture.width, 0.5 * picture.height);
    Box2 box;
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x)
            if ((grey.at(x, y) < limit) != isLight) {
                box.extend(Vec2(x, picture.height - 1 - y) - middle);
                box.extend(Vec2(x + 1, picture.height - y) - middle);
            }
    if (box.isEmpty())
        return {-middle, middle};
    return box;
}

} // namespace fff
