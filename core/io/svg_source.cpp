#include "core/io/svg_source.h"

#include "core/io/loaded_document.h"
#include "core/io/svg_reader.h"
#include "core/io/svg_values.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QStringDecoder>
#include <algorithm>
#include <cstring>

namespace fff::io {

namespace {

/// What stands there, on that line, short.
std::string shownAt(std::string_view bytes, std::ptrdiff_t offset)
{
    const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
    const std::string_view rest = bytes.substr(std::min(from, bytes.size()));
    return quoted(rest.substr(0, rest.find_first_of("\r\n")));
}

/// Of a file in UTF-16, which its first bytes tell; empty for all others.
std::string fromUtf16(std::string_view bytes)
{
    using namespace std::string_view_literals;
    const bool isLittle = bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("<\0"sv);
    const bool isBig = bytes.starts_with("\xfe\xff"sv) || bytes.starts_with("\0<"sv);
    if (!isLittle && !isBig)
        return {};
    QStringDecoder decoder(isLittle ? QStringDecoder::Utf16LE : QStringDecoder::Utf16BE);
    const QString text =
        decoder(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    return text.toStdString();
}

} // namespace

std::string localName(const pugi::xml_node &node)
{
    const std::string name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string::npos || name.substr(0, colon) == "svg"
               ? name.substr(colon == std::string::npos ? 0 : colon + 1)
               : name;
}

SvgSource::SvgSource(std::string_view bytes, std::string name)
    : m_converted(fromUtf16(bytes)), m_bytes(m_converted.empty() ? bytes : m_converted),
      m_name(std::move(name))
{
}

std::string SvgSource::placeAt(std::ptrdiff_t offset) const
{
    const auto end = m_bytes.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(m_bytes));
    const std::string line = std::to_string(1 + std::count(m_bytes.begin(), end, '\n'));
    return m_name.empty() ? line : m_name + ":" + line;
}

void SvgSource::fail(ErrorCode code, const pugi::xml_node &node, std::vector<std::string> args)
{
    if (!m_error)
        m_error = Error{code, placeAt(node.offset_debug()), std::move(args)};
}

void SvgSource::index()
{
    struct Walker : pugi::xml_tree_walker
    {
        std::map<std::string, pugi::xml_node> *ids = nullptr;
        std::string styles;
        bool isOurs = false;
        bool for_each(pugi::xml_node &node) override
        {
            if (const pugi::xml_attribute id = node.attribute("id"))
                ids->emplace(id.value(), node);
            if (localName(node) == "style")
                styles += node.text().get();
            isOurs = isOurs || std::strcmp(node.name(), "fff:cutting") == 0;
            return true;
        }
    };
    Walker walker;
    walker.ids = &m_byId;
    m_document.traverse(walker);
    m_rules = svgRules(walker.styles);
    m_isCuttingFile = walker.isOurs;
}

bool SvgSource::parse()
{
    const auto marks = static_cast<std::size_t>(
        std::count_if(m_bytes.begin(), m_bytes.end(), [](char c) { return c == '<' || c == '='; }));
    if (marks > kMostSvgMarks) {
        m_error = Error{ErrorCode::BadCount,
                        m_name,
                        {std::to_string(marks), std::to_string(kMostSvgMarks),
                         QT_TRANSLATE_NOOP("Error", "elements and attributes")}};
        return false;
    }
    const unsigned options = pugi::parse_default | pugi::parse_ws_pcdata_single;
    const pugi::xml_parse_result parsed =
        m_converted.empty()
            ? m_document.load_buffer(m_bytes.data(), m_bytes.size(), options)
            : m_document.load_buffer(m_bytes.data(), m_bytes.size(), options, pugi::encoding_utf8);
    if (!parsed)
        m_error = Error{ErrorCode::BadSyntax,
                        placeAt(parsed.offset),
                        {shownAt(m_bytes, parsed.offset), QT_TRANSLATE_NOOP("Error", "XML")}};
    else if (localName(root()) != "svg")
        fail(ErrorCode::BadSyntax, root(),
             {quoted(root().name()), QT_TRANSLATE_NOOP("Error", "an SVG drawing")});
    else
        index();
    return !m_error;
}

pugi::xml_node SvgSource::named(const std::string &id) const
{
    const auto found = m_byId.find(id);
    return found == m_byId.end() ? pugi::xml_node() : found->second;
}

std::string SvgSource::property(const pugi::xml_node &node, const char *name) const
{
    const Styles own = svgDeclarations(node.attribute("style").value());
    if (const auto found = own.find(name); found != own.end())
        return found->second;
    const auto ruled = [&](const std::string &selector) -> const std::string * {
        const auto rule = m_rules.find(selector);
        if (rule == m_rules.end())
            return nullptr;
        const auto found = rule->second.find(name);
        return found == rule->second.end() ? nullptr : &found->second;
    };
    if (const std::string id = node.attribute("id").value(); !id.empty())
        if (const std::string *value = ruled("#" + id))
            return *value;
    std::string classes = node.attribute("class").value();
    const std::string *last = nullptr;
    for (std::size_t from = 0; from < classes.size();) {
        const std::size_t end = std::min(classes.find_first_of(" \t\r\n", from), classes.size());
        if (const std::string *value = ruled("." + classes.substr(from, end - from)))
            last = value;
        from = end + 1;
    }
    if (!last)
        last = ruled(localName(node));
    return last ? *last : node.attribute(name).value();
}

double SvgSource::length(const pugi::xml_node &node, const char *name, double percentOf,
                         double otherwise)
{
    const pugi::xml_attribute attribute = node.attribute(name);
    if (!attribute || std::strcmp(attribute.value(), "auto") == 0)
        return otherwise;
    const std::optional<double> value = svgLength(attribute.value(), percentOf);
    if (!value)
        fail(ErrorCode::BadValue, node,
             {quoted(attribute.value()), QT_TRANSLATE_NOOP("Error", "a length")});
    return value.value_or(otherwise);
}

void SvgSource::count(const pugi::xml_node &node, std::size_t points)
{
    m_points += points;
    if (m_points > kMostSvgPoints)
        fail(ErrorCode::BadCount, node,
             {std::to_string(m_points), std::to_string(kMostSvgPoints),
              QT_TRANSLATE_NOOP("Error", "points")});
}

} // namespace fff::io
