#include "core/io/obj_writer.h"

#include "core/fabrication/wholeness.h"
#include "core/io/solids.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

namespace fff::io {

namespace {

constexpr double kDecimals = 1e7; // coordinates are whole multiples of one over this

void append(std::string &out, double value)
{
    const double rounded = std::round(value * kDecimals) / kDecimals;
    std::array<char, 64> buffer{};
    // Adding 0 turns -0 into 0.
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded + 0.0,
                                   std::chars_format::fixed);
    out.append(1, ' ').append(buffer.data(), end.ptr);
}

class ObjText
{
public:
    void addSlab(const std::string &name, const Cap &cap, const Frame &frame, double thickness)
    {
        out += "o " + name + "\ng " + name + '\n';
        const Vec3 up = 0.5 * thickness * frame.normal();
        const int count = static_cast<int>(cap.vertices.size());
        for (const Vec3 &offset : {up, Vec3(-up)})
            for (const Vec2 &p : cap.vertices)
                vertex(frame.toWorld(p) + offset);
        for (const auto &[a, b, c] : cap.triangles) {
            face({a, b, c});
            face({count + c, count + b, count + a});
        }
        for (const auto &[a, b] : cap.boundary)
            face({count + a, count + b, b, a});
        m_first += 2 * count;
    }

    std::string out;

private:
    void vertex(const Vec3 &p)
    {
        out += 'v';
        for (const double c : p)
            append(out, c);
        out += '\n';
    }
    void face(std::initializer_list<int> corners)
    {
        out += 'f';
        for (const int corner : corners)
            out += ' ' + std::to_string(m_first + corner);
        out += '\n';
    }

    int m_first = 1; // number of the next vertex in the file
};

/// One word, never empty.
std::string safeName(const std::string &name)
{
    std::string safe;
    for (const char c : name) {
        const bool isPlain = static_cast<unsigned char>(c) > 0x20 && c != '\x7f' && c != '#' &&
                             c != '\\' && c != '/' && c != ':';
        safe += isPlain ? c : '_';
    }
    return safe.empty() ? "section" : safe;
}

std::string uniqueName(const std::string &name, std::set<std::string> &taken)
{
    std::string result = safeName(name);
    for (int i = 2; !taken.insert(result).second; ++i)
        result = safeName(name) + '_' + std::to_string(i);
    return result;
}

} // namespace

Result<std::string> writeObj(const Model &model, const Bodies &bodies)
{
    if (const Result<void> known = haveSolids(model, bodies); !known)
        return tl::unexpected(known.error());
    ObjText text;
    text.out = "# FlatFitFab " FFF_VERSION ", millimetres, Y up\n";
    std::set<std::string> names;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Body &body = bodies[i];
        const auto section = static_cast<std::size_t>(bodies.sectionOf(static_cast<int>(i)));
        text.out += "# " + safeName(model.stockOf(section).name) + ',';
        append(text.out, body.thickness());
        text.out += " mm\n";
        text.addSlab(uniqueName(model.section(section)->name, names), capOf(body), body.frame(),
                     body.thickness());
    }
    return std::move(text.out);
}

std::string writeObj(const TriangleMesh &mesh)
{
    std::string out = "# FlatFitFab " FFF_VERSION ", millimetres, Y up\no skin\n";
    for (const Vec3 &p : mesh.positions()) {
        out += 'v';
        for (const double c : p)
            append(out, c);
        out += '\n';
    }
    for (const Triangle &triangle : mesh.triangles()) {
        out += 'f';
        for (const std::uint32_t corner : triangle)
            out += ' ' + std::to_string(corner + 1);
        out += '\n';
    }
    return out;
}

const Format &objFormat()
{
    static const Format format = {
        .key = "obj",
        .suffixes = {"obj"},
        .title = QT_TRANSLATE_NOOP("Format", "OBJ, solids in place"),
        .titleOfSkin = QT_TRANSLATE_NOOP("Format", "OBJ, skin as a mesh"),
        .help = QT_TRANSLATE_NOOP("CommandLine", "the solids in place"),
        .writeSolids = [](const Model &model, const Bodies &bodies,
                          const FormatValues &) { return writeObj(model, bodies); },
        .writeSkin = [](const TriangleMesh &mesh) { return writeObj(mesh); }};
    return format;
}

} // namespace fff::io
