#include "core/values/number_text.h"

#include "core/base/units.h"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace fff {

namespace {

constexpr double kRightlyWritten = 1e15; // beyond it digits after the point say nothing

// Of what a person chose: the words are those that are read again.
constexpr const char *kYes = "yes", *kNo = "no";

std::string fixedNumber(double value, int digits)
{
    std::array<char, 400> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                            std::chars_format::fixed, digits);
    std::string text(buffer.data(), error == std::errc() ? end : buffer.data());
    if (text.find('.') != text.npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.')
            text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

/// A number of that unit that is read as the very value; empty: there is none beside it.
std::string exactIn(double value, double unit)
{
    const double near = value / unit;
    for (const double number :
         {near, std::nextafter(near, HUGE_VAL), std::nextafter(near, -HUGE_VAL)})
        if (number * unit == value)
            return exactNumber(number);
    return {};
}

std::string exactQuantity(const Worth &worth)
{
    if (worth.powers == kLengthPowers)
        return exactNumber(worth.number) + " mm";
    if (worth.powers == kAnglePowers) {
        const std::string inDegrees = exactIn(worth.number, radians(1.0));
        return inDegrees.empty() ? exactNumber(worth.number) + " rad" : inDegrees + " °";
    }
    if (worth.powers == kMassPowers) {
        const std::string inGrams =
            std::abs(worth.number) < 1.0 ? exactIn(worth.number, 1e-3) : std::string();
        return inGrams.empty() ? exactNumber(worth.number) + " kg" : inGrams + " g";
    }
    return exactNumber(worth.number);
}

} // namespace

std::string exactNumber(double value)
{
    std::array<char, 400> buffer{};
    const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                            std::chars_format::fixed);
    return error == std::errc() ? std::string(buffer.data(), end) : std::string("0");
}

std::string exactText(const Worth &worth, ValueKind kind)
{
    if (worth.type == Worth::Type::Truth)
        return worth.number != 0.0 ? kYes : kNo;
    if (worth.type == Worth::Type::Number)
        return exactQuantity(worth);
    if (kind != ValueKind::Text)
        return worth.text;
    std::string text; // braces and "=" begin something where a text is typed
    for (const char c : worth.text)
        text += c == '{' || c == '}' ? std::string(2, c) : std::string(1, c);
    return text.starts_with('=') ? "{\"=\"}" + text.substr(1) : text;
}

std::string shownText(const Worth &worth, const NumberStyle &style)
{
    if (worth.type == Worth::Type::Text)
        return worth.text;
    if (worth.type == Worth::Type::Truth)
        return worth.number != 0.0 ? kYes : kNo;
    const auto written = [&style](double number) {
        const int digits = std::abs(number) < kRightlyWritten ? style.digits : 0;
        std::string text = fixedNumber(number, digits);
        if (const std::size_t point = text.find('.'); point != text.npos)
            text[point] = style.point;
        return text;
    };
    if (worth.powers == kLengthPowers)
        return written(worth.number / style.lengthUnit) + ' ' + style.lengthSign;
    if (worth.powers == kAnglePowers)
        return written(degrees(worth.number)) + "°";
    if (worth.powers == kMassPowers)
        return std::abs(worth.number) < 1.0 ? written(1e3 * worth.number) + " g"
                                            : written(worth.number) + " kg";
    return written(worth.number);
}

Argument argumentOf(const Worth &worth)
{
    if (worth.type != Worth::Type::Number)
        return Named{shownText(worth)};
    if (worth.powers == kLengthPowers)
        return lengthOf(worth.number);
    if (worth.powers == kMassPowers)
        return massOf(worth.number);
    const auto rounded = [](double value) {
        constexpr double kShown = 1e4; // four digits after the point say enough
        const double times = kShown * value;
        return std::abs(times) < kRightlyWritten ? std::round(times) / kShown : value;
    };
    if (worth.powers == kAnglePowers)
        return Message{{nullptr, "%1°"}, {Decimal{rounded(degrees(worth.number))}}};
    return Decimal{rounded(worth.number)};
}

} // namespace fff
