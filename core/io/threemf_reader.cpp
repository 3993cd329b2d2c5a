// 3MF: a ZIP of XML with a unit; objects of triangles, and objects of objects, placed by the list
// of what is to be built. Source  3MF Consortium, Core Specification 1.3, sections 2 to 4;
// Production Extension 1.1, which puts objects into files of their own.
#include "core/io/archive.h"
#include "core/io/loaded_document.h"
#include "core/io/placed_meshes.h"

#include <QtCore/QCoreApplication>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <map>
#include <memory>

namespace fff::io {

namespace {

/// Elements and attributes take many times their length in memory; as many as the most triangles of
/// an archive's largest entry have.
constexpr std::size_t kMostXmlMarks = 60'000'000;

struct ThreeMfUnit
{
    const char *name;
    double millimetres;
};
constexpr std::array<ThreeMfUnit, 6> kThreeMfUnits = {{{"micron", 1e-3},
                                                       {"millimeter", 1.0},
                                                       {"centimeter", 10.0},
                                                       {"inch", 25.4},
                                                       {"foot", 304.8},
                                                       {"meter", 1000.0}}};

const char *localOf(const char *name)
{
    const char *colon = std::strchr(name, ':');
    return colon ? colon + 1 : name;
}

pugi::xml_node childOf(const pugi::xml_node &node, const char *name)
{
    for (const pugi::xml_node &child : node.children())
        if (std::strcmp(localOf(child.name()), name) == 0)
            return child;
    return {};
}

class ThreeMf
{
public:
    ThreeMf(std::vector<ArchiveEntry> entries, const MeshOptions &options)
        : m_entries(std::move(entries)), m_builder(options)
    {
    }

    Result<MeshDraft> read()
    {
        Part *root = part(rootName());
        if (!root)
            return m_builder.finish();
        const pugi::xml_node model = root->document.document_element();
        const double unit = unitOf(model, *root);
        m_builder.draft.unit = unit;
        Eigen::Affine3d scaled = Eigen::Affine3d::Identity();
        scaled.linear() *= unit;
        for (const pugi::xml_node &item : childOf(model, "build").children())
            if (std::strcmp(localOf(item.name()), "item") == 0)
                place(item, *root, scaled, 0);
        return m_builder.finish();
    }

private:
    struct Part
    {
        const ArchiveEntry *entry = nullptr;
        pugi::xml_document document;
        std::map<std::string, pugi::xml_node> objects; // by their id
        std::map<std::string, MeshDraft> meshes;       // that were asked for
    };

    const ArchiveEntry *entry(std::string name) const
    {
        while (name.starts_with('/'))
            name.erase(0, 1);
        for (const ArchiveEntry &one : m_entries)
            if (one.name == name)
                return &one;
        return nullptr;
    }

    /// That of the relation of the package, else the first that is called so.
    std::string rootName() const
    {
        if (const ArchiveEntry *relations = entry("_rels/.rels")) {
            pugi::xml_document document;
            document.load_buffer(relations->bytes.data(), relations->bytes.size());
            for (const pugi::xml_node &one : document.document_element().children())
                if (std::string_view(one.attribute("Type").value()).ends_with("/3dmodel"))
                    return one.attribute("Target").value();
        }
        for (const ArchiveEntry &one : m_entries)
            if (one.name.ends_with(".model"))
                return one.name;
        return "3D/3dmodel.model";
    }

    std::string whereIn(const Part &of, std::ptrdiff_t offset) const
    {
        const std::string &bytes = of.entry->bytes;
        const auto end = bytes.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(bytes));
        return io::quoted(of.entry->name) + ":" +
               std::to_string(1 + std::count(bytes.begin(), end, '\n'));
    }
    void fail(ErrorCode code, const Part &of, const pugi::xml_node &node,
              std::vector<std::string> args)
    {
        m_builder.fail(code, whereIn(of, node.offset_debug()), std::move(args));
    }

    Part *part(const std::string &name)
    {
        const ArchiveEntry *found = entry(name);
        if (!found) {
            m_builder.fail(ErrorCode::BadArchive, {},
                           {QT_TRANSLATE_NOOP("Error", "there is no 3D model in this file")});
            return nullptr;
        }
        std::unique_ptr<Part> &known = m_parts[found->name];
        if (known)
            return known.get();
        known = std::make_unique<Part>();
        known->entry = found;
        const std::string &bytes = found->bytes;
        const auto marks = static_cast<std::size_t>(
            std::count_if(bytes.begin(), bytes.end(), [](char c) { return c == '<' || c == '='; }));
        if (marks > kMostXmlMarks) {
            m_builder.fail(ErrorCode::BadCount, io::quoted(found->name),
                           {std::to_string(marks), std::to_string(kMostXmlMarks),
                            QT_TRANSLATE_NOOP("Error", "elements and attributes")});
            return nullptr;
        }
        const pugi::xml_parse_result parsed =
            known->document.load_buffer(bytes.data(), bytes.size());
        if (!parsed) {
            m_builder.fail(
                ErrorCode::BadSyntax, whereIn(*known, parsed.offset),
                {io::quoted(std::string_view(bytes).substr(std::min<std::size_t>(
                     std::size_t(std::max<std::ptrdiff_t>(parsed.offset, 0)), bytes.size()))),
                 QT_TRANSLATE_NOOP("Error", "XML")});
            return nullptr;
        }
        const pugi::xml_node model = known->document.document_element();
        if (std::strcmp(localOf(model.name()), "model") != 0) {
            fail(ErrorCode::BadSyntax, *known, model,
                 {io::quoted(model.name()), QT_TRANSLATE_NOOP("Error", "a 3D model")});
            return nullptr;
        }
        for (const pugi::xml_node &object : childOf(model, "resources").children())
            if (std::strcmp(localOf(object.name()), "object") == 0)
                known->objects.emplace(object.attribute("id").value(), object);
        return known.get();
    }

    double unitOf(const pugi::xml_node &model, const Part &of)
    {
        const std::string unit = model.attribute("unit").as_string("millimeter");
        for (const ThreeMfUnit &known : kThreeMfUnits)
            if (unit == known.name)
                return known.millimetres;
        fail(ErrorCode::BadValue, of, model,
             {io::quoted(unit), QT_TRANSLATE_NOOP("Error", "a unit such as millimeter")});
        return 1.0;
    }

    double number(const pugi::xml_node &node, const char *name, const Part &of)
    {
        const std::string_view text = node.attribute(name).value();
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size())
            return value;
        fail(ErrorCode::BadSyntax, of, node,
             {io::quoted(text), QT_TRANSLATE_NOOP("Error", "a number")});
        return 0.0;
    }

    /// Twelve numbers, a column of the map after the other; none where nothing is said.
    Eigen::Affine3d transform(const pugi::xml_node &node, const Part &of)
    {
        Eigen::Affine3d map = Eigen::Affine3d::Identity();
        const std::string_view text = node.attribute("transform").value();
        if (text.empty())
            return map;
        std::array<double, 12> numbers{};
        const char *at = text.data(), *const end = text.data() + text.size();
        for (double &value : numbers) {
            while (at < end && *at == ' ')
                ++at;
            const auto [next, error] = std::from_chars(at, end, value);
            if (error != std::errc()) {
                fail(ErrorCode::BadSyntax, of, node,
                     {io::quoted(text), QT_TRANSLATE_NOOP("Error", "twelve numbers")});
                return map;
            }
            at = next;
        }
        for (int i = 0; i < 12; ++i)
            map.matrix()(i % 3, i / 3) = numbers[std::size_t(i)];
        return map;
    }

    /// What a build item, or a component of an object, refers to.
    void place(const pugi::xml_node &node, Part &of, const Eigen::Affine3d &outer, int depth)
    {
        if (m_builder.failed() || !m_builder.goOn(0.5))
            return;
        Part *where = &of;
        for (const pugi::xml_attribute &attribute : node.attributes())
            if (std::strcmp(localOf(attribute.name()), "path") == 0)
                where = part(attribute.value());
        if (!where)
            return;
        const std::string id = node.attribute("objectid").value();
        const auto found = where->objects.find(id);
        if (found == where->objects.end())
            return fail(ErrorCode::UnknownReference, of, node, {io::quoted(id)});
        // What names others many times over comes to more than any file has bytes.
        if (++m_placed > kMostPlaced)
            return fail(ErrorCode::BadCount, of, node,
                        {std::to_string(m_placed), std::to_string(kMostPlaced),
                         QT_TRANSLATE_NOOP("Error", "placed objects")});
        if (depth > kMostNested)
            return fail(ErrorCode::BadValue, of, node,
                        {io::quoted(id),
                         QT_TRANSLATE_NOOP("Error", "an object that does not contain itself")});
        const Eigen::Affine3d map = outer * transform(node, of);
        const pugi::xml_node object = found->second;
        if (const pugi::xml_node mesh = childOf(object, "mesh"))
            addPlaced(m_builder, meshOf(id, mesh, *where), map);
        for (const pugi::xml_node &one : childOf(object, "components").children())
            if (std::strcmp(localOf(one.name()), "component") == 0)
                place(one, *where, map, depth + 1);
    }

    const MeshDraft &meshOf(const std::string &id, const pugi::xml_node &mesh, Part &of)
    {
        const auto [known, isNew] = of.meshes.try_emplace(id);
        MeshDraft &draft = known->second;
        if (!isNew)
            return draft;
        for (const pugi::xml_node &vertex : childOf(mesh, "vertices").children()) {
            const double x = number(vertex, "x", of), y = number(vertex, "y", of),
                         z = number(vertex, "z", of);
            draft.positions.emplace_back(x, y, z);
        }
        for (const pugi::xml_node &triangle : childOf(mesh, "triangles").children()) {
            Triangle corners{};
            const std::array<const char *, 3> names = {"v1", "v2", "v3"};
            for (std::size_t i = 0; i < 3; ++i) {
                const double index = number(triangle, names[i], of);
                corners[i] = index >= 0.0 && index < double(kNoVertex)
                                 ? static_cast<std::uint32_t>(index)
                                 : kNoVertex;
            }
            draft.triangles.push_back(corners);
            if (m_builder.failed())
                break;
        }
        return draft;
    }

    static constexpr int kMostPlaced = 20'000;

    std::vector<ArchiveEntry> m_entries;
    MeshBuilder m_builder;
    std::map<std::string, std::unique_ptr<Part>> m_parts; // by the entry's name
    int m_placed = 0;
};

Result<MeshDraft> readThreeMf(std::string_view bytes, const MeshOptions &options)
{
    Result<std::vector<ArchiveEntry>> entries = unpacked(bytes, options.name);
    if (!entries)
        return tl::unexpected(entries.error());
    return ThreeMf(*std::move(entries), options).read();
}

} // namespace

const MeshFormat &threeMfMeshFormat()
{
    static const MeshFormat format = {.key = "3mf",
                                      .suffixes = {"3mf"},
                                      .title = QT_TRANSLATE_NOOP("Format", "3MF meshes"),
                                      .recognises = isArchive,
                                      .read = readThreeMf};
    return format;
}

} // namespace fff::io
