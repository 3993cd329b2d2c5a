// How well two colours are told from each other: WCAG 2.1, relative luminance and contrast ratio.
#pragma once

#include <QColor>

#include <algorithm>
#include <cmath>

namespace fff::test {

/// 0 (black) … 1 (white).
inline double luminance(const QColor &colour)
{
    const auto linear = [](double v) {
        return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

/// 1 (the same) … 21.
inline double contrast(const QColor &a, const QColor &b)
{
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

} // namespace fff::test
