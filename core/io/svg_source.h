// An SVG file as text: its elements by name and id, what they say of themselves with the style
// rules applied, and the first thing wrong with it. Internal to io.
#pragma once

#include "core/base/result.h"

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

namespace fff::io {

/// The element's name without "svg:"; other name spaces stay in front.
std::string localName(const pugi::xml_node &node);

/// The first error is the one that counts; what is read after it is harmless.
class SvgSource
{
public:
    /// bytes outlive this; name: how places call the file, may be empty.
    SvgSource(std::string_view bytes, std::string name);

    /// False, with an error, for what is no XML or no drawing.
    bool parse();

    std::string_view bytes() const { return m_bytes; }
    const std::string &name() const { return m_name; }
    pugi::xml_node root() const { return m_document.document_element(); }
    /// Nothing where no element has this id.
    pugi::xml_node named(const std::string &id) const;
    /// Whether this program wrote it (core/io/svg_writer.h).
    bool isCuttingFile() const { return m_isCuttingFile; }

    /// As the style attribute says, then the rules of a style element, then the attribute of its
    /// own.
    std::string property(const pugi::xml_node &node, const char *name) const;
    /// User units. An error for what is no length.
    double length(const pugi::xml_node &node, const char *name, double percentOf,
                  double otherwise = 0.0);
    /// One more element, or so many points: an error when there are too many. Elements count, too:
    /// copies of copies of nothing would take as long.
    void count(const pugi::xml_node &node, std::size_t points);

    void fail(ErrorCode code, const pugi::xml_node &node, std::vector<std::string> args = {});
    const std::optional<Error> &error() const { return m_error; }

private:
    using Styles = std::map<std::string, std::string>;

    std::string placeAt(std::ptrdiff_t offset) const;
    void index();

    std::string m_converted;  // of a file in UTF-16
    std::string_view m_bytes; // UTF-8
    std::string m_name;
    pugi::xml_document m_document;
    std::map<std::string, pugi::xml_node> m_byId;
    std::map<std::string, Styles> m_rules;
    bool m_isCuttingFile = false;
    std::size_t m_points = 0;
    std::optional<Error> m_error;
};

} // namespace fff::io
