#include "core/io/ply_writer.h"

#include <QtCore/QtEndian>

#include <array>
#include <cstring>

namespace fff::io {

namespace {

template <class T>
void append(std::string &bytes, T value)
{
    std::array<char, sizeof(T)> raw{};
    qToLittleEndian(value, raw.data());
    bytes.append(raw.data(), raw.size());
}

} // namespace

std::string plyBytes(const TriangleMesh &mesh)
{
    std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " +
                        std::to_string(mesh.positions().size()) +
                        "\nproperty double x\nproperty double y\nproperty double z\n"
                        "element face " +
                        std::to_string(mesh.triangles().size()) +
                        "\nproperty list uchar uint vertex_indices\nend_header\n";
    bytes.reserve(bytes.size() + 3 * sizeof(double) * mesh.positions().size() +
                  (1 + 3 * sizeof(std::uint32_t)) * mesh.triangles().size());
    for (const Vec3 &p : mesh.positions())
        for (const double coordinate : {p.x(), p.y(), p.z()})
            append(bytes, coordinate);
    for (const Triangle &triangle : mesh.triangles()) {
        bytes.push_back(3);
        for (const std::uint32_t vertex : triangle)
            append(bytes, vertex);
    }
    return bytes;
}

} // namespace fff::io
