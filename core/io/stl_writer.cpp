#include "core/io/stl_writer.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QtEndian>

#include <array>

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

void putVector(std::string &bytes, const Vec3 &v)
{
    for (const double coordinate : {v.x(), -v.z(), v.y()})
        put(bytes, static_cast<float>(coordinate) + 0.0F); // adding 0 turns −0 into 0
}

} // namespace

std::string stlBytes(const TriangleMesh &mesh)
{
    std::string bytes = "FlatFitFab " FFF_VERSION ", millimetres, Z up";
    bytes.resize(kHeadOfStl, ' ');
    bytes.reserve(kHeadOfStl + sizeof(std::uint32_t) + kBytesOfFacet * mesh.triangles().size());
    put(bytes, static_cast<std::uint32_t>(mesh.triangles().size()));
    for (const auto &[a, b, c] : mesh.triangles()) {
        const Vec3 &p = mesh.positions()[a], &q = mesh.positions()[b], &r = mesh.positions()[c];
        const Vec3 normal = (q - p).cross(r - p);
        const double length = normal.norm();
        putVector(bytes, length > 0.0 ? Vec3(normal / length) : normal);
        for (const Vec3 &corner : {p, q, r})
            putVector(bytes, corner);
        put(bytes, std::uint16_t(0));
    }
    return bytes;
}

const Format &stlFormat()
{
    static const Format format = {.key = "stl",
                                  .suffixes = {"stl"},
                                  .titleOfSkin = QT_TRANSLATE_NOOP("Format", "STL, skin as a mesh"),
                                  .help = QT_TRANSLATE_NOOP("CommandLine", "its skin as a mesh"),
                                  .writeSkin = stlBytes};
    return format;
}

} // namespace fff::io
