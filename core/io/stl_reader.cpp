// STL: loose triangles, as bytes or as text. It says no unit. Source  3D Systems 1989,
// StereoLithography Interface Specification.
#include "core/io/mesh_bytes.h"
#include "core/io/mesh_text.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <cstring>

namespace fff::io {

namespace {

constexpr std::size_t kStlHead = 80, kStlStart = 84, kStlFacet = 50;
constexpr std::size_t kStlBetweenStops = 1 << 16; // triangles

std::uint64_t stlCount(std::string_view head)
{
    return head.size() < kStlStart ? 0 : MeshBytes(head).at<std::uint32_t>(kStlHead);
}

/// A file of bytes may begin with "solid", too.
bool saysFacet(std::string_view head)
{
    constexpr std::size_t kLooked = 4096;
    std::string lower(head.substr(0, kLooked));
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const std::size_t begin = lower.find_first_not_of(" \t\r\n");
    return begin != std::string::npos && lower.compare(begin, 5, "solid") == 0 &&
           lower.find('\0') == std::string::npos &&
           (lower.find("facet") != std::string::npos ||
            lower.find("endsolid") != std::string::npos);
}

bool isStlText(std::string_view bytes)
{
    // What is as long as its count says is bytes, whatever it begins with.
    if (bytes.size() >= kStlStart && bytes.size() == kStlStart + kStlFacet * stlCount(bytes))
        return false;
    return saysFacet(bytes);
}

Result<MeshDraft> readStlBytes(std::string_view bytes, const MeshOptions &options)
{
    MeshBuilder builder(options);
    if (bytes.size() < kStlStart) {
        builder.fail(ErrorCode::Truncated, byteAt(bytes.size()),
                     {QT_TRANSLATE_NOOP("Error", "the number of triangles")});
        return builder.finish();
    }
    std::uint64_t count = stlCount(bytes);
    const std::uint64_t there = (bytes.size() - kStlStart) / kStlFacet;
    // Programs that write while they make triangles do not know how many will come.
    if (count == 0 || count == 0xFFFFFFFFu)
        count = there;
    if (count > options.mostTriangles || count > there) {
        if (count > options.mostTriangles)
            builder.expectTriangles(count, 0, bytes.size(), byteAt(kStlHead));
        builder.fail(ErrorCode::Truncated, byteAt(bytes.size()),
                     {QT_TRANSLATE_NOOP("Error", "as many triangles as the file says it has")});
        return builder.finish();
    }
    builder.expectTriangles(count, kStlFacet, bytes.size(), byteAt(kStlHead));
    VertexMerger merger(count / 2);
    const MeshBytes data(bytes);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (i % kStlBetweenStops == 0 && !builder.goOn(double(i) / double(count)))
            return builder.finish();
        const std::size_t corners = kStlStart + kStlFacet * i + 12; // behind the normal
        Triangle triangle{};
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t at = corners + 12 * c;
            const Vec3 p(data.at<float>(at), data.at<float>(at + 4), data.at<float>(at + 8));
            triangle[c] = p.allFinite() ? merger.add(p) : MeshBuilder::kNowhere;
        }
        builder.addTriangle(triangle[0], triangle[1], triangle[2]);
    }
    builder.takeVertices(merger);
    return builder.finish();
}

/// "outer loop", three vertices, "endloop", in whatever lines.
class StlText
{
public:
    StlText(std::string_view bytes, const MeshOptions &options)
        : m_builder(options), m_text(bytes, m_builder, 0), m_merger(bytes.size() / 500)
    {
    }

    Result<MeshDraft> read()
    {
        // A solid's name may be anything; it ends with its line.
        for (std::string_view word = m_text.anyWord(); !word.empty(); word = m_text.anyWord()) {
            if (is(word, "solid") || is(word, "endsolid")) {
                if (!m_text.nextLine())
                    break;
            } else if (is(word, "facet")) {
                facet();
            } else {
                m_text.failExpected(word, QT_TRANSLATE_NOOP("Error", "facet or endsolid"));
            }
            if (m_builder.failed())
                break;
            if (++m_count % kStlBetweenStops == 0 && !m_builder.goOn(m_text.share()))
                break;
        }
        m_builder.takeVertices(m_merger);
        return m_builder.finish();
    }

private:
    static bool is(std::string_view word, const char *name)
    {
        return std::equal(word.begin(), word.end(), name, name + std::strlen(name),
                          [](char a, char b) { return (a | 0x20) == b; });
    }
    void expect(const char *name, const char *expected)
    {
        if (m_builder.failed())
            return;
        if (const std::string_view word = m_text.anyWord(); !is(word, name))
            m_text.failExpected(word, expected);
    }
    void facet()
    {
        // The normal follows from the corners; programs write all kinds of things there.
        std::string_view word = m_text.anyWord();
        while (!word.empty() && !is(word, "outer"))
            word = m_text.anyWord();
        if (word.empty())
            m_text.failExpected(word, QT_TRANSLATE_NOOP("Error", "outer loop"));
        expect("loop", QT_TRANSLATE_NOOP("Error", "outer loop"));
        m_corners.clear();
        while (!m_builder.failed()) {
            word = m_text.anyWord();
            if (is(word, "endloop"))
                break;
            if (!is(word, "vertex")) {
                m_text.failExpected(word, QT_TRANSLATE_NOOP("Error", "vertex or endloop"));
                return;
            }
            const Vec3 p = m_text.point();
            m_corners.push_back(p.allFinite() ? m_merger.add(p) : MeshBuilder::kNowhere);
        }
        if (m_corners.size() == 3)
            m_builder.addTriangle(m_corners[0], m_corners[1], m_corners[2]);
        else
            m_builder.fail(ErrorCode::BadValue, m_text.where(),
                           {std::to_string(m_corners.size()),
                            QT_TRANSLATE_NOOP("Error", "three corners of a triangle")});
        expect("endfacet", QT_TRANSLATE_NOOP("Error", "endfacet"));
    }

    MeshBuilder m_builder;
    MeshText m_text;
    VertexMerger m_merger;
    std::vector<std::uint32_t> m_corners;
    std::size_t m_count = 0;
};

Result<MeshDraft> readStl(std::string_view bytes, const MeshOptions &options)
{
    return isStlText(bytes) ? StlText(bytes, options).read() : readStlBytes(bytes, options);
}

} // namespace

const MeshFormat &stlMeshFormat()
{
    static const MeshFormat format = {
        .key = "stl",
        .suffixes = {"stl"},
        .title = QT_TRANSLATE_NOOP("Format", "STL meshes"),
        .recognises =
            [](std::string_view head) {
                return saysFacet(head) || (head.size() >= kStlStart &&
                                           head.size() == kStlStart + kStlFacet * stlCount(head));
            },
        .read = readStl,
        .claimed = [](std::string_view head, std::uint64_t size) -> std::uint64_t {
            if (size < kStlStart ||
                (saysFacet(head) && size != kStlStart + kStlFacet * stlCount(head)))
                return 0;
            return (size - kStlStart) / kStlFacet;
        }};
    return format;
}

} // namespace fff::io
