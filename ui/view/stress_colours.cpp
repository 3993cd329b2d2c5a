#include "ui/view/stress_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff::ui {

namespace {

using Palette = std::array<QColor, kStressColours>; // at 20, 40, 60, 80, 100 %

const Palette &paletteOf(bool isForColourBlind)
{
    static const Palette hues{QColor(0x2b, 0x4c, 0xd8), QColor(0x1b, 0x8f, 0xc9),
                              QColor(0x2f, 0xa3, 0x5a), QColor(0xe0, 0xa1, 0x1b),
                              QColor(0xd2, 0x26, 0x1c)};
    static const Palette lightness{QColor(0xf0, 0xe0, 0x4a), QColor(0xf4, 0x93, 0x4a),
                                   QColor(0xcf, 0x4a, 0x79), QColor(0x84, 0x07, 0xa6),
                                   QColor(0x23, 0x04, 0x83)};
    return isForColourBlind ? lightness : hues;
}

} // namespace

QColor stressColour(double use, bool isForColourBlind)
{
    const Palette &palette = paletteOf(isForColourBlind);
    const double at =
        std::clamp((use - kFirstStressColour) / (1.0 - kFirstStressColour), 0.0, 1.0) *
        static_cast<double>(palette.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), palette.size() - 2);
    const double share = at - static_cast<double>(i);
    const auto mixed = [&](int a, int b) {
        return static_cast<int>(std::lround((1.0 - share) * a + share * b));
    };
    const QColor &a = palette[i], &b = palette[i + 1];
    return {mixed(a.red(), b.red()), mixed(a.green(), b.green()), mixed(a.blue(), b.blue())};
}

} // namespace fff::ui
