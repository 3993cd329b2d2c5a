#include "core/io/stl_writer.h"

#include "core/io/solids.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QtEndian>

#include <array>
#include <cstdint>
#include <utility>

namespace fff::io {

namespace {

constexpr std::size_t kHeadOfStl = 80, kBytesOfFacet = 50;

template <class T>
void put(std::string &bytes, T value)
{
    std::array<char, sizeof(T)> raw{};
    qToLittleEndian(value, raw.data());
    bytes.append(raw.data(), raw.size());
}

using Corner = std::array<float, 3>;

Corner inFile(const Vec3 &p)
{
    // Adding 0 turns −0 into 0.
    return {static_cast<float>(p.x()) + 0.0F, static_cast<float>(p.y()) + 0.0F,
            static_cast<float>(p.z()) + 0.0F};
}

/// As programs for printers have it.
Vec3 upright(const Vec3 &p)
{
    return {p.x(), -p.z(), p.y()};
}

class StlFacets
{
public:
    explicit StlFacets(std::size_t most)
    {
        m_bytes = "FlatFitFab " FFF_VERSION ", millimetres, Z up";
        m_bytes.resize(kHeadOfStl, ' ');
        m_bytes.reserve(kHeadOfStl + sizeof(std::uint32_t) + kBytesOfFacet * most);
        put(m_bytes, std::uint32_t(0));
    }
    void add(const Vec3 &p, const Vec3 &q, const Vec3 &r)
    {
        const Vec3 normal = (q - p).cross(r - p);
        const double length = normal.norm();
        for (const Vec3 &v : {length > 0.0 ? Vec3(normal / length) : normal, p, q, r})
            for (const float coordinate : inFile(v))
                put(m_bytes, coordinate);
        put(m_bytes, std::uint16_t(0));
        ++m_count;
    }
    std::string take()
    {
        qToLittleEndian(m_count, m_bytes.data() + kHeadOfStl);
        return std::move(m_bytes);
    }

private:
    std::string m_bytes;
    std::uint32_t m_count = 0;
};

} // namespace

std::string stlBytes(const TriangleMesh &mesh)
{
    StlFacets text(mesh.triangles().size());
    for (const auto &[a, b, c] : mesh.triangles())
        text.add(upright(mesh.positions()[a]), upright(mesh.positions()[b]),
                 upright(mesh.positions()[c]));
    return text.take();
}

Result<std::string> writeStl(const Model &model, const Bodies &bodies, Lying lying)
{
    const Result<std::vector<PartSolid>> solids = partSolids(model, bodies, lying);
    if (!solids)
        return tl::unexpected(solids.error());
    std::size_t count = 0;
    for (const PartSolid &solid : *solids)
        count += solid.triangles.size();
    StlFacets text(count);
    for (const PartSolid &solid : *solids)
        for (const auto &[a, b, c] : solid.triangles) {
            const Vec3 &p = solid.vertices[a], &q = solid.vertices[b], &r = solid.vertices[c];
            // What falls together in seven digits: its neighbours close the gap.
            if (inFile(p) != inFile(q) && inFile(q) != inFile(r) && inFile(r) != inFile(p))
                text.add(p, q, r);
        }
    return text.take();
}

const Format &stlFormat()
{
    static const Format format = {
        .key = "stl",
        .suffixes = {"stl"},
        .title = QT_TRANSLATE_NOOP("Format", "STL, solids in place"),
        .titleOfSkin = QT_TRANSLATE_NOOP("Format", "STL, skin as a mesh"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "the parts to print"),
        .options = {lyingOption(QT_TRANSLATE_NOOP("Format", "STL, solids lying flat"))},
        .writeSolids =
            [](const Model &model, const Bodies &bodies, const FormatValues &values) {
                return writeStl(model, bodies, lyingOf(values));
            },
        .writeSkin = stlBytes};
    return format;
}

} // namespace fff::io
