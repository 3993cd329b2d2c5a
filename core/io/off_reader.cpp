// OFF: vertices and polygons as text. It says no unit. Source  Geomview manual, "OFF Files".
#include "core/io/mesh_text.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>

namespace fff::io {

namespace {

constexpr std::size_t kOffBetweenStops = 1 << 16; // lines
/// "0 0 0" and a line's end; "3 0 1 2" and one.
constexpr std::size_t kOffVertexBytes = 6, kOffFaceBytes = 4;

/// "OFF", with letters for what vertices have besides in front of it: "STCN4nOFF" at most.
bool isOffWord(std::string_view word)
{
    if (!word.ends_with("OFF"))
        return false;
    word.remove_suffix(3);
    return word.find_first_not_of("STCN4n") == std::string_view::npos;
}

class OffMesh
{
public:
    OffMesh(std::string_view bytes, const MeshOptions &options)
        : m_builder(options), m_text(withoutByteOrderMark(bytes), m_builder, '#')
    {
    }

    Result<MeshDraft> read()
    {
        std::string_view word = m_text.anyWord();
        if (!isOffWord(word)) {
            m_text.failExpected(word, "OFF");
            return m_builder.finish();
        }
        // Vertices with a fourth coordinate, or with as many as the next line says.
        if (word.find_first_of("4n") != std::string_view::npos)
            m_builder.fail(ErrorCode::Unsupported, m_text.where(), {quoted(word)});
        word = m_text.anyWord();
        if (word == "BINARY")
            m_builder.fail(ErrorCode::Unsupported, m_text.where(), {"OFF BINARY"});
        const std::uint64_t vertices =
            counted(word, QT_TRANSLATE_NOOP("Error", "the number of vertices"));
        const std::uint64_t faces =
            counted(m_text.anyWord(), QT_TRANSLATE_NOOP("Error", "the number of faces"));
        const std::string where = m_text.where();
        m_text.word(); // the number of edges, which nobody needs and not everybody writes
        if (m_builder.expectVertices(vertices, kOffVertexBytes, m_text.left() + 1, where))
            readVertices(vertices);
        if (m_builder.expectTriangles(faces, kOffFaceBytes, m_text.left() + 1, where))
            readFaces(faces);
        return m_builder.finish();
    }

private:
    std::uint64_t counted(std::string_view word, const char *expected)
    {
        if (word.empty())
            m_text.failExpected(word, expected);
        return m_builder.failed() ? 0 : m_text.count(word);
    }

    void readVertices(std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count && !m_builder.failed(); ++i) {
            m_text.nextLine(); // past what else the line before has
            const double x = m_text.number(m_text.anyWord());
            const double y = m_text.number(m_text.word()), z = m_text.number(m_text.word());
            m_builder.draft.positions.emplace_back(x, y, z);
            if (i % kOffBetweenStops == 0)
                m_builder.goOn(m_text.share());
        }
    }

    void readFaces(std::uint64_t count)
    {
        for (std::uint64_t i = 0; i < count && !m_builder.failed(); ++i) {
            m_text.nextLine();
            const std::uint64_t corners =
                counted(m_text.anyWord(), QT_TRANSLATE_NOOP("Error", "the corners of a face"));
            m_corners.clear();
            for (std::uint64_t c = 0; c < corners && !m_builder.failed(); ++c) {
                const std::int64_t index = m_text.integer(m_text.word());
                m_corners.push_back(index >= 0 && index < MeshBuilder::kNowhere
                                        ? static_cast<std::uint32_t>(index)
                                        : kNoVertex);
            }
            if (!m_builder.failed())
                m_builder.addPolygon(m_corners); // of one or two corners: points and lines
            if (i % kOffBetweenStops == 0)
                m_builder.goOn(m_text.share());
        }
    }

    MeshBuilder m_builder;
    MeshText m_text;
    std::vector<std::uint32_t> m_corners;
};

std::string_view firstOffWord(std::string_view head)
{
    const std::string_view text = withoutByteOrderMark(head);
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    return text.substr(begin, text.find_first_of(" \t\r\n", begin) - begin);
}

} // namespace

const MeshFormat &offMeshFormat()
{
    static const MeshFormat format = {
        .key = "off",
        .suffixes = {"off"},
        .title = QT_TRANSLATE_NOOP("Format", "OFF meshes"),
        .recognises = [](std::string_view head) { return isOffWord(firstOffWord(head)); },
        .read = [](std::string_view bytes,
                   const MeshOptions &options) { return OffMesh(bytes, options).read(); }};
    return format;
}

} // namespace fff::io
