// PLY: vertices and faces with whatever else programs measure, as text or as bytes of either order.
// It says no unit.
#include "core/io/loaded_document.h"
#include "core/io/mesh_bytes.h"
#include "core/io/mesh_text.h"
#include "core/io/ply_header.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

constexpr std::size_t kPlyBetweenStops = 1 << 16; // elements

/// Values one after the other, of a text.
class PlyWords
{
public:
    PlyWords(std::string_view bytes, const PlyHeader &header, MeshBuilder &builder)
        : m_text(bytes.substr(header.end), builder, 0, header.lines + 1)
    {
    }
    double next(PlyType) { return m_text.number(m_text.anyWord()); }
    double share() const { return m_text.share(); }
    std::size_t left() const { return m_text.left(); }
    std::string where() const { return m_text.where(); }

private:
    MeshText m_text;
};

/// The same, of bytes.
class PlyBytes
{
public:
    PlyBytes(std::string_view bytes, const PlyHeader &header, MeshBuilder &builder)
        : m_bytes(bytes, header.format == PlyHeader::Format::BigEndian), m_at(header.end),
          m_builder(builder)
    {
    }
    double next(PlyType type)
    {
        const std::size_t size = sizeOfPly(type);
        if (!m_bytes.has(m_at, size)) {
            m_builder.fail(ErrorCode::Truncated, where(),
                           {QT_TRANSLATE_NOOP("Error", "as many values as the file says it has")});
            return 0.0;
        }
        const std::size_t at = m_at;
        m_at += size;
        switch (type) {
        case PlyType::Int8:
            return m_bytes.at<std::int8_t>(at);
        case PlyType::UInt8:
            return m_bytes.at<std::uint8_t>(at);
        case PlyType::Int16:
            return m_bytes.at<std::int16_t>(at);
        case PlyType::UInt16:
            return m_bytes.at<std::uint16_t>(at);
        case PlyType::Int32:
            return m_bytes.at<std::int32_t>(at);
        case PlyType::UInt32:
            return m_bytes.at<std::uint32_t>(at);
        case PlyType::Float:
            return double(m_bytes.at<float>(at));
        case PlyType::Double:
            break;
        }
        return m_bytes.at<double>(at);
    }
    double share() const { return double(m_at) / double(m_bytes.size()); }
    std::size_t left() const { return m_bytes.size() - m_at; }
    std::string where() const { return byteAt(m_at); }

private:
    MeshBytes m_bytes;
    std::size_t m_at;
    MeshBuilder &m_builder;
};

template <class Source>
class PlyMesh
{
public:
    PlyMesh(std::string_view bytes, const PlyHeader &header, MeshBuilder &builder)
        : m_header(header), m_source(bytes, header, builder), m_builder(builder)
    {
    }

    void read()
    {
        for (const PlyElement &element : m_header.elements) {
            // What an element takes is known from the header: one that has nothing takes nothing.
            if (element.properties.empty())
                continue;
            if (element.name == "vertex")
                vertices(element);
            else
                others(element);
            if (m_builder.failed())
                return;
        }
    }

private:
    bool isText() const { return m_header.format == PlyHeader::Format::Text; }

    void vertices(const PlyElement &element)
    {
        const std::array places = {element.find("x"), element.find("y"), element.find("z")};
        for (const int place : places)
            if (place < 0 || element.properties[std::size_t(place)].isList) {
                m_builder.fail(ErrorCode::BadSyntax, {},
                               {"element vertex", QT_TRANSLATE_NOOP("Error", "x, y and z")});
                return;
            }
        if (!m_builder.expectVertices(element.count, element.leastBytes(isText()),
                                      m_source.left() + 1, m_source.where()))
            return;
        forEach(element, [&] {
            Vec3 p = Vec3::Zero();
            for (int i = 0; i < std::ssize(element.properties); ++i) {
                const PlyProperty &property = element.properties[std::size_t(i)];
                if (property.isList) {
                    passOver(property);
                    continue;
                }
                const double value = m_source.next(property.type);
                for (int axis = 0; axis < 3; ++axis)
                    if (places[std::size_t(axis)] == i)
                        p[axis] = value;
            }
            m_builder.draft.positions.push_back(p);
        });
    }

    /// Faces, strips of them, and what is passed over.
    void others(const PlyElement &element)
    {
        const bool isFace = element.name == "face", isStrip = element.name == "tristrips";
        int corners = element.find("vertex_indices");
        if (corners < 0)
            corners = element.find("vertex_index");
        if (isFace && corners < 0) {
            m_builder.fail(ErrorCode::BadSyntax, {},
                           {"element face", QT_TRANSLATE_NOOP("Error", "vertex_indices")});
            return;
        }
        const std::size_t least = element.leastBytes(isText());
        if (isFace ? !m_builder.expectTriangles(element.count, least, m_source.left() + 1,
                                                m_source.where())
                   : element.count > m_source.left() / least + 1) {
            m_builder.fail(ErrorCode::BadCount, m_source.where(),
                           {std::to_string(element.count), std::to_string(m_source.left() / least),
                            io::quoted(element.name)});
            return;
        }
        forEach(element, [&] {
            for (int i = 0; i < std::ssize(element.properties); ++i) {
                const PlyProperty &property = element.properties[std::size_t(i)];
                if (i != corners || !property.isList || (!isFace && !isStrip)) {
                    passOver(property);
                    continue;
                }
                list(property);
                if (m_builder.failed())
                    return;
                if (isFace)
                    m_builder.addPolygon(m_corners);
                else
                    addStrip();
            }
        });
    }

    template <class Each>
    void forEach(const PlyElement &element, Each each)
    {
        for (std::uint64_t i = 0; i < element.count && !m_builder.failed(); ++i) {
            if (i % kPlyBetweenStops == 0 && !m_builder.goOn(m_source.share()))
                return;
            each();
        }
    }

    std::uint64_t length(const PlyProperty &property)
    {
        const double count = m_source.next(property.countType);
        if (!(count >= 0.0) || count > double(m_source.left()) + 1.0) {
            m_builder.fail(ErrorCode::BadValue, m_source.where(),
                           {shownCount(count), QT_TRANSLATE_NOOP("Error", "the length of a list")});
            return 0;
        }
        return static_cast<std::uint64_t>(count);
    }
    static std::string shownCount(double count)
    {
        return std::isfinite(count) && std::abs(count) < 1e15
                   ? std::to_string(static_cast<std::int64_t>(count))
                   : std::string("nan");
    }

    void passOver(const PlyProperty &property)
    {
        const std::uint64_t count = property.isList ? length(property) : 1;
        for (std::uint64_t i = 0; i < count && !m_builder.failed(); ++i)
            m_source.next(property.type);
    }

    void list(const PlyProperty &property)
    {
        m_corners.clear();
        const std::uint64_t count = length(property);
        for (std::uint64_t i = 0; i < count && !m_builder.failed(); ++i) {
            const double index = m_source.next(property.type);
            const bool isPossible = index >= 0.0 && index < double(MeshBuilder::kNowhere);
            m_corners.push_back(isPossible ? static_cast<std::uint32_t>(index) : kNoVertex);
        }
    }

    /// Each corner makes a triangle with the two before it; −1 begins anew.
    void addStrip()
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < m_corners.size(); ++i) {
            if (m_corners[i] == kNoVertex)
                begin = i + 1;
            else if (i >= begin + 2)
                (i - begin) % 2 == 0
                    ? m_builder.addTriangle(m_corners[i - 2], m_corners[i - 1], m_corners[i])
                    : m_builder.addTriangle(m_corners[i - 1], m_corners[i - 2], m_corners[i]);
        }
    }

    const PlyHeader &m_header;
    Source m_source;
    MeshBuilder &m_builder;
    std::vector<std::uint32_t> m_corners;
};

Result<MeshDraft> readPly(std::string_view bytes, const MeshOptions &options)
{
    MeshBuilder builder(options);
    const PlyHeader header = readPlyHeader(bytes, builder);
    if (!builder.failed()) {
        if (header.format == PlyHeader::Format::Text)
            PlyMesh<PlyWords>(bytes, header, builder).read();
        else
            PlyMesh<PlyBytes>(bytes, header, builder).read();
    }
    return builder.finish();
}

} // namespace

const MeshFormat &plyMeshFormat()
{
    static const MeshFormat format = {
        .key = "ply",
        .suffixes = {"ply"},
        .title = QT_TRANSLATE_NOOP("Format", "PLY meshes"),
        .recognises =
            [](std::string_view head) {
                return head.starts_with("ply\n") || head.starts_with("ply\r");
            },
        .read = readPly,
        .claimed = [](std::string_view head, std::uint64_t) -> std::uint64_t {
            const MeshOptions options;
            MeshBuilder builder(options);
            for (const PlyElement &element : readPlyHeader(head, builder).elements)
                if (element.name == "face" && !builder.failed())
                    return element.count;
            return 0;
        }};
    return format;
}

} // namespace fff::io
