// Files of meshes as other programs write them, made by code that shares nothing with the readers.
#pragma once

#include "core/templates/mended_mesh.h"
#include "tests/core/io/made_archive.h"

#include <bit>
#include <cstring>

namespace fff::test {

template <class Number>
std::string bytesOf(Number value, bool isBig = false)
{
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    if (isBig != (std::endian::native == std::endian::big))
        std::reverse(raw.begin(), raw.end());
    return raw;
}

inline std::string numbersOf(const Vec3 &p)
{
    char text[100];
    std::snprintf(text, sizeof text, "%.17g %.17g %.17g", p.x(), p.y(), p.z());
    return text;
}

/// To single precision, which binary files have.
inline MeshDraft rounded(MeshDraft draft)
{
    for (Vec3 &p : draft.positions)
        for (double &coordinate : p)
            coordinate = static_cast<double>(static_cast<float>(coordinate));
    return draft;
}

inline std::string stlBytes(const MeshDraft &draft, const std::string &head = "made by a test")
{
    std::string file = head;
    file.resize(80, ' ');
    file += bytesOf(static_cast<std::uint32_t>(draft.triangles.size()));
    for (const Triangle &t : draft.triangles) {
        file.append(12, '\0');
        for (const std::uint32_t corner : t)
            for (int axis = 0; axis < 3; ++axis)
                file += bytesOf(static_cast<float>(draft.positions[corner][axis]));
        file.append(2, '\0');
    }
    return file;
}

inline std::string stlText(const MeshDraft &draft)
{
    std::string file = "solid a shape, of facet s\n";
    for (const Triangle &t : draft.triangles) {
        file += "  facet normal 0 0 0\n    outer loop\n";
        for (const std::uint32_t corner : t)
            file += "      vertex " + numbersOf(draft.positions[corner]) + "\n";
        file += "    endloop\n  endfacet\n";
    }
    return file + "endsolid a shape, of facet s\n";
}

inline std::string objText(const MeshDraft &draft)
{
    std::string file = "# made by a test\nmtllib none.mtl\no shape\n";
    for (const Vec3 &p : draft.positions)
        file += "v " + numbersOf(p) + " 1.0\n";
    file += "vt 0 0\nvn 0 0 1\nusemtl none\ns 1\n";
    for (const Triangle &t : draft.triangles)
        file += "f " + std::to_string(t[0] + 1) + "/1/1 " + std::to_string(t[1] + 1) + "//1 " +
                std::to_string(t[2] + 1) + "\n";
    return file;
}

inline std::string offText(const MeshDraft &draft)
{
    std::string file = "OFF\n# counts\n" + std::to_string(draft.positions.size()) + ' ' +
                       std::to_string(draft.triangles.size()) + " 0\n";
    for (const Vec3 &p : draft.positions)
        file += numbersOf(p) + "\n";
    for (const Triangle &t : draft.triangles)
        file += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' +
                std::to_string(t[2]) + " 255 0 0\n";
    return file;
}

inline std::string plyHead(const MeshDraft &draft, const char *format)
{
    return std::string("ply\nformat ") + format + " 1.0\ncomment made by a test\nelement vertex " +
           std::to_string(draft.positions.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
           "element face " +
           std::to_string(draft.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n";
}

inline std::string plyText(const MeshDraft &draft)
{
    std::string file = plyHead(draft, "ascii");
    for (const Vec3 &p : draft.positions)
        file += numbersOf(p) + " 128\n";
    for (const Triangle &t : draft.triangles)
        file += "3 " + std::to_string(t[0]) + ' ' + std::to_string(t[1]) + ' ' +
                std::to_string(t[2]) + " 0.5\n";
    return file;
}

inline std::string plyBytes(const MeshDraft &draft, bool isBig)
{
    std::string file = plyHead(draft, isBig ? "binary_big_endian" : "binary_little_endian");
    for (const Vec3 &p : draft.positions) {
        for (int axis = 0; axis < 3; ++axis)
            file += bytesOf(p[axis], isBig);
        file += '\x80';
    }
    for (const Triangle &t : draft.triangles) {
        file += '\x03';
        for (const std::uint32_t corner : t)
            file += bytesOf(static_cast<std::int32_t>(corner), isBig);
        file += bytesOf(0.5f, isBig);
    }
    return file;
}

inline std::string threeMfXml(const MeshDraft &draft, const std::string &unit = "millimeter",
                              const std::string &build = "<item objectid=\"1\"/>")
{
    std::string xml = "<?xml version=\"1.0\"?>\n<model unit=\"" + unit +
                      "\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
                      "<resources><object id=\"1\" type=\"model\"><mesh><vertices>\n";
    const auto attribute = [](const char *name, double value) {
        char text[64];
        std::snprintf(text, sizeof text, " %s=\"%.17g\"", name, value);
        return std::string(text);
    };
    for (const Vec3 &p : draft.positions)
        xml += "<vertex" + attribute("x", p.x()) + attribute("y", p.y()) + attribute("z", p.z()) +
               "/>\n";
    xml += "</vertices><triangles>\n";
    for (const Triangle &t : draft.triangles)
        xml += "<triangle" + attribute("v1", t[0]) + attribute("v2", t[1]) + attribute("v3", t[2]) +
               "/>\n";
    return xml + "</triangles></mesh></object></resources>\n<build>" + build + "</build></model>\n";
}

inline std::string threeMf(const std::string &xml)
{
    const std::string relations =
        "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
        "<Relationship Target=\"/3D/a.model\" Id=\"r\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    return MadeArchive::of(
        {MadeEntry::packedOf("_rels/.rels", relations), MadeEntry::packedOf("3D/a.model", xml)});
}

/// Positions as floats, then indices as 32 bits.
inline std::string gltfBuffer(const MeshDraft &draft)
{
    std::string buffer;
    for (const Vec3 &p : draft.positions)
        for (int axis = 0; axis < 3; ++axis)
            buffer += bytesOf(static_cast<float>(p[axis]));
    for (const Triangle &t : draft.triangles)
        for (const std::uint32_t corner : t)
            buffer += bytesOf(corner);
    return buffer;
}

/// uri: of its buffer; empty: that behind the JSON of a .glb. node: what else the only node has.
inline std::string gltfJson(const MeshDraft &draft, const std::string &uri,
                            const std::string &node = {})
{
    const std::string positions = std::to_string(12 * draft.positions.size());
    const std::string indices = std::to_string(12 * draft.triangles.size());
    const std::string all = std::to_string(gltfBuffer(draft).size());
    return "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
           "\"nodes\":[{\"mesh\":0" +
           node +
           "}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],"
           "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":" +
           std::to_string(draft.positions.size()) +
           "},{\"bufferView\":1,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":" +
           std::to_string(3 * draft.triangles.size()) +
           "}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":" + positions +
           "},{\"buffer\":0,\"byteOffset\":" + positions + ",\"byteLength\":" + indices +
           "}],\"buffers\":[{" + (uri.empty() ? "" : "\"uri\":\"" + uri + "\",") +
           "\"byteLength\":" + all + "}]}";
}

inline std::string gltfInOne(const MeshDraft &draft)
{
    const QByteArray buffer = QByteArray::fromStdString(gltfBuffer(draft)).toBase64();
    return gltfJson(draft, "data:application/octet-stream;base64," + buffer.toStdString());
}

inline std::string glb(std::string json, std::string binary)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) { return bytesOf(static_cast<std::uint32_t>(value)); };
    return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" +
           json + word(binary.size()) + std::string("BIN\0", 4) + binary;
}

} // namespace fff::test
