#include "core/io/ply_header.h"

#include "core/io/loaded_document.h"
#include "core/io/mesh_text.h"

#include <QtCore/QCoreApplication>

#include <array>

namespace fff::io {

namespace {

struct PlyTypeName
{
    std::string_view name;
    PlyType type;
};

constexpr std::array<PlyTypeName, 16> kPlyTypes = {{{"char", PlyType::Int8},
                                                    {"int8", PlyType::Int8},
                                                    {"uchar", PlyType::UInt8},
                                                    {"uint8", PlyType::UInt8},
                                                    {"short", PlyType::Int16},
                                                    {"int16", PlyType::Int16},
                                                    {"ushort", PlyType::UInt16},
                                                    {"uint16", PlyType::UInt16},
                                                    {"int", PlyType::Int32},
                                                    {"int32", PlyType::Int32},
                                                    {"uint", PlyType::UInt32},
                                                    {"uint32", PlyType::UInt32},
                                                    {"float", PlyType::Float},
                                                    {"float32", PlyType::Float},
                                                    {"double", PlyType::Double},
                                                    {"float64", PlyType::Double}}};

class PlyHeaderReader
{
public:
    PlyHeaderReader(std::string_view bytes, MeshBuilder &builder)
        : m_builder(builder), m_text(bytes, builder, 0)
    {
    }

    PlyHeader read()
    {
        if (const std::string_view word = m_text.word(); word != "ply")
            m_text.failExpected(word, "ply");
        while (!m_builder.failed() && !line())
            ;
        if (!m_builder.failed() && !m_hasFormat)
            m_text.failExpected("end_header", QT_TRANSLATE_NOOP("Error", "the format"));
        m_text.nextLine();
        m_header.end = m_text.offset();
        m_header.lines = m_lines;
        return std::move(m_header);
    }

private:
    /// Whether it was the last one.
    bool line()
    {
        if (!m_text.nextLine()) {
            m_text.failExpected({}, "end_header");
            return true;
        }
        ++m_lines;
        const std::string_view keyword = m_text.word();
        if (keyword == "end_header")
            return true;
        if (keyword == "format")
            format();
        else if (keyword == "element")
            element();
        else if (keyword == "property")
            property();
        else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info")
            m_text.failExpected(keyword, QT_TRANSLATE_NOOP("Error", "element or end_header"));
        return false;
    }

    void format()
    {
        using Format = PlyHeader::Format;
        const std::string_view word = m_text.word();
        m_hasFormat = true;
        if (word == "ascii")
            m_header.format = Format::Text;
        else if (word == "binary_little_endian")
            m_header.format = Format::LittleEndian;
        else if (word == "binary_big_endian")
            m_header.format = Format::BigEndian;
        else
            m_text.failExpected(word, QT_TRANSLATE_NOOP("Error", "ascii or binary"));
    }

    void element()
    {
        PlyElement element;
        element.name = m_text.word();
        element.count = m_text.count(m_text.word());
        m_header.elements.push_back(std::move(element));
    }

    PlyType typeOf(std::string_view word)
    {
        for (const PlyTypeName &known : kPlyTypes)
            if (known.name == word)
                return known.type;
        m_text.failExpected(word, QT_TRANSLATE_NOOP("Error", "a type such as float or int"));
        return PlyType::Float;
    }

    void property()
    {
        if (m_header.elements.empty())
            return m_text.failExpected("property", QT_TRANSLATE_NOOP("Error", "an element first"));
        PlyProperty property;
        const std::string_view word = m_text.word();
        property.isList = word == "list";
        if (property.isList)
            property.countType = typeOf(m_text.word());
        property.type = typeOf(property.isList ? m_text.word() : word);
        property.name = m_text.word();
        m_header.elements.back().properties.push_back(std::move(property));
    }

    MeshBuilder &m_builder;
    MeshText m_text;
    PlyHeader m_header;
    bool m_hasFormat = false;
    std::size_t m_lines = 1;
};

} // namespace

std::size_t sizeOfPly(PlyType type)
{
    switch (type) {
    case PlyType::Int8:
    case PlyType::UInt8:
        return 1;
    case PlyType::Int16:
    case PlyType::UInt16:
        return 2;
    case PlyType::Int32:
    case PlyType::UInt32:
    case PlyType::Float:
        return 4;
    case PlyType::Double:
        break;
    }
    return 8;
}

int PlyElement::find(std::string_view property) const
{
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property)
            return static_cast<int>(i);
    return -1;
}

std::size_t PlyElement::leastBytes(bool isText) const
{
    std::size_t sum = 0;
    for (const PlyProperty &property : properties)
        sum += isText ? 2 : sizeOfPly(property.isList ? property.countType : property.type);
    return std::max<std::size_t>(sum, 1);
}

PlyHeader readPlyHeader(std::string_view bytes, MeshBuilder &builder)
{
    return PlyHeaderReader(bytes, builder).read();
}

} // namespace fff::io
