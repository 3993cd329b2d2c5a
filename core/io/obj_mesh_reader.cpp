// Wavefront OBJ: vertices and faces; groups, materials, normals and textures are passed over, and
// so are curves. It says no unit. Source  Wavefront Technologies 1995, Object Files, appendix B1 of
// the Advanced Visualizer manual.
#include "core/io/mesh_text.h"

#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>

#include <array>

namespace fff::io {

namespace {

constexpr std::size_t kObjBetweenStops = 1 << 16; // lines

class ObjMesh
{
public:
    ObjMesh(std::string_view bytes, const MeshOptions &options)
        : m_builder(options), m_text(withoutByteOrderMark(bytes), m_builder, '#')
    {
        // A line of a vertex or a face has some thirty bytes, half as many vertices as faces.
        constexpr std::size_t kBytesALine = 40;
        m_builder.draft.positions.reserve(bytes.size() / kBytesALine / 3);
        m_builder.draft.triangles.reserve(
            std::min(bytes.size() / kBytesALine, options.mostTriangles));
    }

    Result<MeshDraft> read()
    {
        std::size_t lines = 0;
        do {
            const std::string_view keyword = m_text.word();
            if (keyword == "v")
                vertex();
            else if (keyword == "f" || keyword == "fo")
                face();
            if (++lines % kObjBetweenStops == 0 && !m_builder.goOn(m_text.share()))
                break;
        } while (!m_builder.failed() && m_text.nextLine());
        return m_builder.finish();
    }

private:
    void vertex()
    {
        // A weight or a colour may follow.
        m_builder.draft.positions.push_back(m_text.point());
        if (m_builder.draft.positions.size() >= MeshBuilder::kNowhere)
            m_builder.expectVertices(kNoVertex, 0, 0, m_text.where());
    }

    /// "12", "12/3", "12/3/4", "12//4", "-1": the vertex counts.
    std::uint32_t corner(std::string_view word)
    {
        const auto count = static_cast<std::int64_t>(m_builder.draft.positions.size());
        const std::int64_t number = m_text.integer(word.substr(0, word.find('/')));
        const std::int64_t index = number > 0 ? number - 1 : count + number;
        // A vertex may come behind its faces; one that never comes is counted later.
        const bool isPossible = number != 0 && index >= 0 && index < MeshBuilder::kNowhere;
        return isPossible ? static_cast<std::uint32_t>(index) : kNoVertex;
    }

    void face()
    {
        m_corners.clear();
        for (std::string_view word = m_text.word(); !word.empty(); word = m_text.word())
            m_corners.push_back(corner(word));
        if (m_corners.size() < 3)
            m_builder.fail(ErrorCode::BadValue, m_text.where(),
                           {std::to_string(m_corners.size()),
                            QT_TRANSLATE_NOOP("Error", "at least three corners of a face")});
        else
            m_builder.addPolygon(m_corners);
    }

    MeshBuilder m_builder;
    MeshText m_text;
    std::vector<std::uint32_t> m_corners;
};

/// One of the keywords, at the start of a line among the first.
bool saysObj(std::string_view head)
{
    constexpr std::array<std::string_view, 9> kKeywords = {"v ", "vn ",     "vt ",     "f ", "o ",
                                                           "g ", "mtllib ", "usemtl ", "v\t"};
    constexpr int kLooked = 200; // lines: a long comment may come first
    std::string_view rest = withoutByteOrderMark(head);
    for (int i = 0; i < kLooked && !rest.empty(); ++i) {
        const std::size_t begin = rest.find_first_not_of(" \t\r");
        const std::string_view line = rest.substr(std::min(begin, rest.size()));
        const bool isComment = line.starts_with('#') || line.starts_with('\n');
        if (std::any_of(kKeywords.begin(), kKeywords.end(),
                        [line](std::string_view keyword) { return line.starts_with(keyword); }))
            return true;
        if (!isComment && !line.empty())
            return false;
        const std::size_t end = rest.find('\n');
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return false;
}

} // namespace

const MeshFormat &objMeshFormat()
{
    static const MeshFormat format = {
        .key = "obj",
        .suffixes = {"obj"},
        .title = QT_TRANSLATE_NOOP("Format", "OBJ meshes"),
        .recognises = saysObj,
        .read = [](std::string_view bytes, const MeshOptions &options) {
            return ObjMesh(bytes, options).read();
        }};
    return format;
}

} // namespace fff::io
