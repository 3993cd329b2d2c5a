#include "core/fabrication/digits.h"

#include <array>
#include <cassert>
#include <string>

namespace fff {

namespace {

using Stroke = std::vector<Vec2>;

constexpr double kDigitWidth = 0.6;
constexpr double kDigitGap = 0.25;
constexpr double kUnderline = 0.25; // below the digits
constexpr double kBar = 0.45;       // length of what a joint's number begins with

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

double bottomOf(const std::string &text)
{
    return isAmbiguous(text) ? kUnderline : 0.0;
}

Vec2 sizeOf(const std::string &text)
{
    const auto count = static_cast<double>(text.size());
    return {count * (kDigitWidth + kDigitGap) - kDigitGap, 1.0 + bottomOf(text)};
}

std::string textOf(int number)
{
    assert(number >= 0 && "parts and joints are counted from 1");
    return std::to_string(number);
}

} // namespace

Vec2 strokedSize(int number)
{
    return sizeOf(textOf(number));
}

void appendNumber(int number, const Vec2 &corner, double scale, Strokes &strokes)
{
    const std::string text = textOf(number);
    const double bottom = bottomOf(text);
    double left = 0.0;
    for (const char c : text) {
        for (const Stroke &stroke : digits()[static_cast<std::size_t>(c - '0')]) {
            strokes.start();
            for (const Vec2 &p : stroke)
                strokes.add(corner + scale * (p + Vec2(left, bottom)));
        }
        left += kDigitWidth + kDigitGap;
    }
    if (bottom > 0.0) {
        strokes.start();
        strokes.add(corner);
        strokes.add(corner + Vec2(scale * sizeOf(text).x(), 0.0));
    }
}

Vec2 strokedJointSize(int number)
{
    return strokedSize(number) + Vec2(kBar + kDigitGap, 0.0);
}

void appendJointNumber(int number, const Vec2 &corner, double scale, Strokes &strokes)
{
    const double middle = bottomOf(textOf(number)) + 0.5;
    strokes.start();
    strokes.add(corner + scale * Vec2(0.0, middle));
    strokes.add(corner + scale * Vec2(kBar, middle));
    appendNumber(number, corner + scale * Vec2(kBar + kDigitGap, 0.0), scale, strokes);
}

} // namespace fff
