// glTF 2.0 and GLB: nodes place meshes, in metres and with Y upwards. What moves, materials and
// pictures are passed over. Source  Khronos Group 2021, glTF 2.0 Specification, sections 3 and 4.
#include "core/io/gltf_accessor.h"
#include "core/io/json_syntax.h"
#include "core/io/mesh_bytes.h"
#include "core/io/placed_meshes.h"

#include <QtCore/QCoreApplication>

#include <algorithm>

namespace fff::io {

namespace {

constexpr double kGltfMetre = 1000.0; // mm
constexpr std::uint32_t kGlbMagic = 0x46546C67u, kGlbJson = 0x4E4F534Au, kGlbBinary = 0x004E4942u;
constexpr std::size_t kGlbHead = 12, kGlbChunkHead = 8;
constexpr std::int64_t kMostGltfIndex = 100'000'000;
constexpr std::int64_t kGltfTriangles = 4, kGltfStrip = 5, kGltfFan = 6; // modes

/// That change what is in buffers; all others change how it looks.
bool isKnownExtension(const std::string &name)
{
    return name == "KHR_mesh_quantization" || name.starts_with("KHR_materials") ||
           name == "KHR_texture_transform" || name == "KHR_lights_punctual" ||
           name == "KHR_texture_basisu" || name == "EXT_texture_webp";
}

/// Of a list that may be missing.
std::vector<JsonCursor> listOf(const JsonCursor &of, const char *name)
{
    const JsonCursor list = of.member(name);
    return list.exists() ? list.items() : std::vector<JsonCursor>();
}

struct GlbParts
{
    std::string_view json, binary;
};

class GltfMesh
{
public:
    GltfMesh(const JsonCursor &root, std::string_view binary, Problems &problems,
             const MeshOptions &options)
        : m_root(root), m_buffers(root, binary, options), m_problems(problems), m_builder(options)
    {
    }

    Result<MeshDraft> read()
    {
        m_builder.draft.unit = kGltfMetre;
        for (const JsonCursor &extension : listOf(m_root, "extensionsRequired"))
            if (const std::string name = extension.text(); !isKnownExtension(name))
                extension.fail(ErrorCode::Unsupported, {io::quoted(name)});
        m_nodes = listOf(m_root, "nodes");
        m_meshes = listOf(m_root, "meshes");
        Eigen::Affine3d scaled = Eigen::Affine3d::Identity();
        scaled.linear() *= kGltfMetre;
        for (const std::int64_t node : roots())
            place(node, scaled, 0);
        if (m_problems.failed())
            return tl::unexpected(*m_problems.error);
        if (m_error)
            return tl::unexpected(*m_error);
        return m_builder.finish();
    }

private:
    bool goesOn() { return !m_problems.failed() && !m_error && m_builder.goOn(0.5); }

    /// Nodes of the scene that is shown; where there is no scene, those that are in no other.
    std::vector<std::int64_t> roots() const
    {
        std::vector<std::int64_t> found;
        const std::vector<JsonCursor> scenes = listOf(m_root, "scenes");
        if (!scenes.empty()) {
            const JsonCursor shown = m_root.member("scene");
            const auto scene = static_cast<std::size_t>(
                shown.exists() ? shown.integer(0, std::ssize(scenes) - 1) : 0);
            for (const JsonCursor &node : listOf(scenes[scene], "nodes"))
                found.push_back(node.integer(0, kMostGltfIndex));
            return found;
        }
        std::vector<bool> isInside(m_nodes.size(), false);
        for (const JsonCursor &node : m_nodes)
            for (const JsonCursor &child : listOf(node, "children"))
                if (const std::int64_t index = child.integer(0, kMostGltfIndex);
                    index < std::ssize(m_nodes))
                    isInside[std::size_t(index)] = true;
        for (std::size_t i = 0; i < isInside.size(); ++i)
            if (!isInside[i])
                found.push_back(static_cast<std::int64_t>(i));
        return found;
    }

    static std::vector<double> numbersOf(const JsonCursor &list, std::size_t count)
    {
        std::vector<double> numbers;
        for (const JsonCursor &item : list.items())
            numbers.push_back(item.number());
        if (numbers.size() != count) {
            list.failExpected(QT_TRANSLATE_NOOP("Error", "as many numbers as belong there"));
            numbers.assign(count, 0.0);
        }
        return numbers;
    }

    static Eigen::Affine3d transform(const JsonCursor &node)
    {
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        if (const JsonCursor matrix = node.member("matrix"); matrix.exists()) {
            const std::vector<double> m = numbersOf(matrix, 16); // a column after the other
            for (int i = 0; i < 16; ++i)
                if (i % 4 < 3)
                    map.matrix()(i % 4, i / 4) = m[std::size_t(i)];
            return map;
        }
        if (const JsonCursor move = node.member("translation"); move.exists()) {
            const std::vector<double> t = numbersOf(move, 3);
            map.translate(Vec3(t[0], t[1], t[2]));
        }
        if (const JsonCursor turn = node.member("rotation"); turn.exists()) {
            const std::vector<double> q = numbersOf(turn, 4);
            const Eigen::Quaterniond quaternion(q[3], q[0], q[1], q[2]);
            if (quaternion.squaredNorm() > 0.0)
                map.rotate(quaternion.normalized());
        }
        if (const JsonCursor size = node.member("scale"); size.exists()) {
            const std::vector<double> s = numbersOf(size, 3);
            map.scale(Vec3(s[0], s[1], s[2]));
        }
        return map;
    }

    void place(std::int64_t index, const Eigen::Affine3d &outer, int depth)
    {
        if (!goesOn())
            return;
        if (index >= std::ssize(m_nodes))
            return m_root.member("nodes").fail(ErrorCode::UnknownReference,
                                               {std::to_string(index)});
        const JsonCursor &node = m_nodes[std::size_t(index)];
        if (depth > kMostNested || ++m_placed > kMostGltfPlaced)
            return node.fail(ErrorCode::BadValue,
                             {std::to_string(index),
                              QT_TRANSLATE_NOOP("Error", "a node that is not within itself")});
        const Eigen::Affine3d map = outer * transform(node);
        if (const JsonCursor mesh = node.member("mesh"); mesh.exists()) {
            const std::int64_t which = mesh.integer(0, kMostGltfIndex);
            if (which >= std::ssize(m_meshes))
                return mesh.fail(ErrorCode::UnknownReference, {std::to_string(which)});
            addPlaced(m_builder, meshAt(which), map);
        }
        for (const JsonCursor &child : listOf(node, "children"))
            place(child.integer(0, kMostGltfIndex), map, depth + 1);
    }

    const MeshDraft &meshAt(std::int64_t index)
    {
        const auto [known, isNew] = m_known.try_emplace(index);
        if (isNew)
            for (const JsonCursor &one : listOf(m_meshes[std::size_t(index)], "primitives"))
                if (goesOn())
                    primitive(one, known->second);
        return known->second;
    }

    void primitive(const JsonCursor &of, MeshDraft &draft)
    {
        const JsonCursor mode = of.member("mode");
        const std::int64_t kind = mode.exists() ? mode.integer(0, kGltfFan) : kGltfTriangles;
        if (kind < kGltfTriangles)
            return; // points and lines
        const JsonCursor place = of.member("attributes").member("POSITION");
        if (!place.exists())
            return; // by an extension alone, which was not required
        const std::vector<double> numbers =
            m_buffers.numbers(place.integer(0, kMostGltfIndex), 3, m_error);
        const std::size_t first = draft.positions.size(), count = numbers.size() / 3;
        for (std::size_t i = 0; i < count; ++i)
            draft.positions.emplace_back(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
        std::vector<std::uint32_t> corners;
        const auto add = [&](double index) {
            corners.push_back(index >= 0.0 && index < double(count)
                                  ? static_cast<std::uint32_t>(first + std::size_t(index))
                                  : kNoVertex);
        };
        if (const JsonCursor indices = of.member("indices"); indices.exists())
            for (const double index :
                 m_buffers.numbers(indices.integer(0, kMostGltfIndex), 1, m_error))
                add(index);
        else
            for (std::size_t i = 0; i < count; ++i)
                add(double(i));
        for (std::size_t i = 2; i < corners.size(); kind == kGltfTriangles ? i += 3 : ++i) {
            const bool isOdd = kind == kGltfStrip && i % 2 == 1;
            const std::uint32_t a = kind == kGltfFan ? corners[0] : corners[i - 2];
            draft.triangles.push_back(isOdd ? Triangle{corners[i - 1], a, corners[i]}
                                            : Triangle{a, corners[i - 1], corners[i]});
        }
    }

    static constexpr int kMostGltfPlaced = 100'000;

    JsonCursor m_root;
    GltfBuffers m_buffers;
    Problems &m_problems;
    MeshBuilder m_builder;
    std::optional<Error> m_error; // of a file beside
    std::vector<JsonCursor> m_nodes, m_meshes;
    std::map<std::int64_t, MeshDraft> m_known;
    int m_placed = 0;
};

bool isGlb(std::string_view bytes)
{
    return bytes.size() >= 4 && MeshBytes(bytes).at<std::uint32_t>(0) == kGlbMagic;
}

GlbParts partsOfGlb(std::string_view bytes, Problems &problems)
{
    const MeshBytes data(bytes);
    GlbParts parts;
    std::size_t at = kGlbHead;
    constexpr const char *kChunk = QT_TRANSLATE_NOOP("Error", "a chunk of a GLB file");
    if (!data.has(0, kGlbHead) || data.at<std::uint32_t>(4) != 2) {
        problems.fail(ErrorCode::BadValue, byteAt(4),
                      {data.has(4, 4) ? std::to_string(data.at<std::uint32_t>(4)) : std::string(),
                       QT_TRANSLATE_NOOP("Error", "version 2 of GLB")});
        return parts;
    }
    while (at < bytes.size()) {
        if (!data.has(at, kGlbChunkHead) ||
            !data.has(at + kGlbChunkHead, data.at<std::uint32_t>(at))) {
            problems.fail(ErrorCode::Truncated, byteAt(at), {kChunk});
            return parts;
        }
        const std::size_t length = data.at<std::uint32_t>(at);
        const std::uint32_t type = data.at<std::uint32_t>(at + 4);
        const std::string_view chunk = bytes.substr(at + kGlbChunkHead, length);
        if (type == kGlbJson && parts.json.empty())
            parts.json = chunk;
        else if (type == kGlbBinary && parts.binary.empty())
            parts.binary = chunk;
        at += kGlbChunkHead + length;
    }
    // Padded, by some programs with what JSON does not allow there.
    while (!parts.json.empty() && (parts.json.back() == '\0' || parts.json.back() == ' '))
        parts.json.remove_suffix(1);
    if (parts.json.empty())
        problems.fail(ErrorCode::Truncated, byteAt(kGlbHead), {kChunk});
    return parts;
}

Result<MeshDraft> readGltf(std::string_view bytes, const MeshOptions &options)
{
    Problems problems{options.name};
    const GlbParts parts = isGlb(bytes) ? partsOfGlb(bytes, problems) : GlbParts{bytes, {}};
    const QJsonDocument json =
        problems.failed() ? QJsonDocument() : parseJson(parts.json, problems);
    const JsonCursor root(json.isObject() ? QJsonValue(json.object()) : QJsonValue(), "$",
                          problems);
    if (!problems.failed() && !root.isObject())
        root.failExpected(QT_TRANSLATE_NOOP("Error", "a glTF file"));
    if (!problems.failed() && !root.member("asset").member("version").text().starts_with("2"))
        root.member("asset").member("version").failExpected(
            QT_TRANSLATE_NOOP("Error", "version 2 of glTF"));
    if (problems.failed())
        return tl::unexpected(*problems.error);
    return GltfMesh(root, parts.binary, problems, options).read();
}

} // namespace

const MeshFormat &gltfMeshFormat()
{
    static const MeshFormat format = {
        .key = "gltf",
        .suffixes = {"glb", "gltf"},
        .title = QT_TRANSLATE_NOOP("Format", "glTF meshes"),
        .recognises =
            [](std::string_view head) {
                const std::size_t begin = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
                return isGlb(head) || (begin != std::string_view::npos && head[begin] == '{');
            },
        .read = readGltf};
    return format;
}

} // namespace fff::io
