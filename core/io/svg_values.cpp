#include "core/io/svg_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace fff::io {

namespace {

constexpr double kPixelsPerInch = 96.0;

bool isBlank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

struct Unit
{
    std::string_view sign;
    double pixels;
    bool isTrue;
};

constexpr std::array<Unit, 8> kUnits{{{"mm", kPixelsPerInch / 25.4, true},
                                      {"cm", kPixelsPerInch / 2.54, true},
                                      {"in", kPixelsPerInch, true},
                                      {"pt", kPixelsPerInch / 72.0, true},
                                      {"pc", kPixelsPerInch / 6.0, true},
                                      {"Q", kPixelsPerInch / 101.6, true},
                                      {"px", 1.0, false},
                                      {"", 1.0, false}}};

const Unit *unitOf(std::string_view sign)
{
    const auto found = std::find_if(kUnits.begin(), kUnits.end(),
                                    [sign](const Unit &unit) { return unit.sign == sign; });
    return found == kUnits.end() ? nullptr : &*found;
}

std::string_view withoutComments(std::string_view text, std::string &kept)
{
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "/*") {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
        } else {
            kept.push_back(text[i++]);
        }
    }
    return kept;
}

} // namespace

void SvgNumbers::skip()
{
    while (!m_rest.empty() && isBlank(m_rest.front()))
        m_rest.remove_prefix(1);
    if (m_rest.empty() || m_rest.front() != ',')
        return;
    m_rest.remove_prefix(1);
    while (!m_rest.empty() && isBlank(m_rest.front()))
        m_rest.remove_prefix(1);
}

std::optional<double> SvgNumbers::number()
{
    skip();
    std::string_view text = m_rest;
    if (text.starts_with('+'))
        text.remove_prefix(1);
    if (text.starts_with('i') || text.starts_with('n') || text.starts_with("-i") ||
        text.starts_with("-n") || text.starts_with('I') || text.starts_with('N'))
        return std::nullopt; // from_chars would take "inf" and "nan"
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // What is too small for a double is 0, what is too large is nothing.
    const std::string_view read = text.substr(0, static_cast<std::size_t>(end - text.data()));
    const bool isTiny = error == std::errc::result_out_of_range &&
                        (read.find("e-") != read.npos || read.find("E-") != read.npos);
    if ((error != std::errc() && !isTiny) || !std::isfinite(value))
        return std::nullopt;
    m_rest = text.substr(static_cast<std::size_t>(end - text.data()));
    return value;
}

std::optional<bool> SvgNumbers::flag()
{
    skip();
    if (m_rest.empty() || (m_rest.front() != '0' && m_rest.front() != '1'))
        return std::nullopt;
    const bool isSet = m_rest.front() == '1';
    m_rest.remove_prefix(1);
    return isSet;
}

char SvgNumbers::letter()
{
    skip();
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (m_rest.empty() || !isLetter(m_rest.front()))
        return 0;
    const char c = m_rest.front();
    m_rest.remove_prefix(1);
    return c;
}

bool SvgNumbers::isAtEnd()
{
    skip();
    return m_rest.empty();
}

std::optional<double> svgLength(std::string_view text, double percentOf)
{
    SvgNumbers numbers(text);
    const std::optional<double> number = numbers.number();
    const std::string_view sign = trimmed(numbers.rest());
    if (!number)
        return std::nullopt;
    if (sign == "%")
        return *number / 100.0 * percentOf;
    const Unit *unit = unitOf(sign);
    return unit ? std::optional(*number * unit->pixels) : std::nullopt;
}

bool isTrueLength(std::string_view text)
{
    SvgNumbers numbers(text);
    const bool isNumber = numbers.number().has_value();
    const Unit *unit = unitOf(trimmed(numbers.rest()));
    return isNumber && unit && unit->isTrue;
}

std::optional<SvgTransform> svgTransform(std::string_view text)
{
    SvgTransform all = SvgTransform::Identity();
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        if (text.front() == ',') {
            text.remove_prefix(1);
            continue;
        }
        const std::size_t open = text.find('('), close = text.find(')');
        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return std::nullopt;
        const std::string_view name = trimmed(text.substr(0, open));
        SvgNumbers numbers(text.substr(open + 1, close - open - 1));
        std::vector<double> v;
        while (const std::optional<double> number = numbers.number())
            v.push_back(*number);
        if (!numbers.isAtEnd())
            return std::nullopt;
        text.remove_prefix(close + 1);
        const auto radiansOf = [](double d) { return d * std::numbers::pi / 180.0; };
        SvgTransform next = SvgTransform::Identity();
        if (name == "matrix" && v.size() == 6)
            next.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0.0, 0.0, 1.0;
        else if (name == "translate" && (v.size() == 1 || v.size() == 2))
            next.translate(Vec2(v[0], v.size() == 2 ? v[1] : 0.0));
        else if (name == "scale" && (v.size() == 1 || v.size() == 2))
            next.scale(Vec2(v[0], v.back()));
        else if (name == "rotate" && v.size() == 1)
            next.rotate(radiansOf(v[0]));
        else if (name == "rotate" && v.size() == 3)
            next.translate(Vec2(v[1], v[2])).rotate(radiansOf(v[0])).translate(Vec2(-v[1], -v[2]));
        else if (name == "skewX" && v.size() == 1)
            next.matrix()(0, 1) = std::tan(radiansOf(v[0]));
        else if (name == "skewY" && v.size() == 1)
            next.matrix()(1, 0) = std::tan(radiansOf(v[0]));
        else
            return std::nullopt;
        all = all * next;
    }
    return all;
}

std::optional<SvgViewBox> svgViewBox(std::string_view text)
{
    SvgNumbers numbers(text);
    std::array<double, 4> v{};
    for (double &value : v) {
        const std::optional<double> number = numbers.number();
        if (!number)
            return std::nullopt;
        value = *number;
    }
    if (!(v[2] > 0.0 && v[3] > 0.0))
        return std::nullopt;
    return SvgViewBox{{v[0], v[1]}, {v[2], v[3]}};
}

SvgTransform fitted(const SvgViewBox &box, const Vec2 &size, std::string_view aspect)
{
    Vec2 scale = size.cwiseQuotient(box.size);
    const auto has = [aspect](std::string_view word) {
        return aspect.find(word) != std::string_view::npos;
    };
    Vec2 at(0.5, 0.5); // where what is left over goes
    if (has("none")) {
        at = Vec2::Zero();
    } else {
        scale.setConstant(has("slice") ? scale.maxCoeff() : scale.minCoeff());
        at.x() = has("xMin") ? 0.0 : has("xMax") ? 1.0 : 0.5;
        at.y() = has("YMin") ? 0.0 : has("YMax") ? 1.0 : 0.5;
    }
    const Vec2 shift = at.cwiseProduct(size - scale.cwiseProduct(box.size));
    SvgTransform transform = SvgTransform::Identity();
    transform.translate(shift).scale(scale).translate(Vec2(-box.origin));
    return transform;
}

std::map<std::string, std::string> svgDeclarations(std::string_view text)
{
    std::map<std::string, std::string> declarations;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string_view one = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos)
            continue;
        std::string_view value = trimmed(one.substr(colon + 1));
        if (const std::size_t important = value.find('!'); important != std::string_view::npos)
            value = trimmed(value.substr(0, important));
        declarations[std::string(trimmed(one.substr(0, colon)))] = std::string(value);
    }
    return declarations;
}

std::map<std::string, std::map<std::string, std::string>> svgRules(std::string_view text)
{
    std::map<std::string, std::map<std::string, std::string>> rules;
    std::string kept;
    text = withoutComments(text, kept);
    while (true) {
        const std::size_t open = text.find('{');
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos)
            return rules;
        std::string_view names = text.substr(0, open);
        const auto declarations = svgDeclarations(text.substr(open + 1, close - open - 1));
        while (!names.empty()) {
            const std::size_t end = std::min(names.find(','), names.size());
            for (const auto &[key, value] : declarations)
                rules[std::string(trimmed(names.substr(0, end)))][key] = value;
            names.remove_prefix(std::min(end + 1, names.size()));
        }
        text.remove_prefix(close + 1);
    }
}

} // namespace fff::io
