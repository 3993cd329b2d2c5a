#include "core/fabrication/digits.h"

#include <array>
#include <cassert>
#include <string>

namespace fff {

namespace {

constexpr double kDigitWidth = 0.6;
constexpr double kDigitGap = 0.25;
constexpr double kUnderline = 0.25; // below the digits

// Each in a box of kDigitWidth x 1. A 1 has a foot and a 7 a bar, so that they differ also when
// turned and when badly burnt.
const std::array<std::vector<Stroke>, 10> &digits()
{
    static const std::array<std::vector<Stroke>, 10> strokes{{
        {{{0.2, 0.0},
          {0.4, 0.0},
          {0.6, 0.2},
          {0.6, 0.8},
          {0.4, 1.0},
          {0.2, 1.0},
          {0.0, 0.8},
          {0.0, 0.2},
          {0.2, 0.0}}},
        {{{0.1, 0.8}, {0.3, 1.0}, {0.3, 0.0}}, {{0.1, 0.0}, {0.5, 0.0}}},
        {{{0.0, 0.8}, {0.2, 1.0}, {0.4, 1.0}, {0.6, 0.8}, {0.6, 0.6}, {0.0, 0.0}, {0.6, 0.0}}},
        {{{0.0, 1.0},
          {0.6, 1.0},
          {0.3, 0.6},
          {0.4, 0.6},
          {0.6, 0.4},
          {0.6, 0.2},
          {0.4, 0.0},
          {0.2, 0.0},
          {0.0, 0.2}}},
        {{{0.45, 0.0}, {0.45, 1.0}, {0.0, 0.3}, {0.6, 0.3}}},
        {{{0.6, 1.0},
          {0.0, 1.0},
          {0.0, 0.6},
          {0.4, 0.6},
          {0.6, 0.4},
          {0.6, 0.2},
          {0.4, 0.0},
          {0.2, 0.0},
          {0.0, 0.2}}},
        {{{0.5, 1.0},
          {0.2, 0.8},
          {0.0, 0.45},
          {0.0, 0.2},
          {0.2, 0.0},
          {0.4, 0.0},
          {0.6, 0.2},
          {0.6, 0.35},
          {0.4, 0.55},
          {0.2, 0.55},
          {0.0, 0.35}}},
        {{{0.0, 1.0}, {0.6, 1.0}, {0.2, 0.0}}, {{0.22, 0.5}, {0.58, 0.5}}},
        {{{0.2, 0.55},
          {0.05, 0.7},
          {0.05, 0.85},
          {0.2, 1.0},
          {0.4, 1.0},
          {0.55, 0.85},
          {0.55, 0.7},
          {0.4, 0.55},
          {0.2, 0.55},
          {0.0, 0.35},
          {0.0, 0.2},
          {0.2, 0.0},
          {0.4, 0.0},
          {0.6, 0.2},
          {0.6, 0.35},
          {0.4, 0.55}}},
        {{{0.1, 0.0},
          {0.4, 0.2},
          {0.6, 0.55},
          {0.6, 0.8},
          {0.4, 1.0},
          {0.2, 1.0},
          {0.0, 0.8},
          {0.0, 0.65},
          {0.2, 0.45},
          {0.4, 0.45},
          {0.6, 0.65}}},
    }};
    return strokes;
}

/// Reads as some number upside down, too. 0 and 8 alone read as themselves.
bool isAmbiguous(const std::string &text)
{
    return text.find_first_not_of("0689") == std::string::npos &&
           text.find_first_of("69") != std::string::npos;
}

} // namespace

StrokedNumber strokedNumber(int number)
{
    assert(number >= 0 && "parts and joints are counted from 1");
    const std::string text = std::to_string(number);
    const double bottom = isAmbiguous(text) ? kUnderline : 0.0;
    StrokedNumber result;
    double left = 0.0;
    for (const char c : text) {
        for (Stroke stroke : digits()[static_cast<std::size_t>(c - '0')]) {
            for (Vec2 &p : stroke)
                p += Vec2(left, bottom);
            result.strokes.push_back(std::move(stroke));
        }
        left += kDigitWidth + kDigitGap;
    }
    result.size = {left - kDigitGap, 1.0 + bottom};
    if (bottom > 0.0)
        result.strokes.push_back({Vec2(0.0, 0.0), Vec2(result.size.x(), 0.0)});
    return result;
}

} // namespace fff
