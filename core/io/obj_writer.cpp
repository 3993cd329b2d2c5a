#include "core/io/obj_writer.h"

#include "core/base/groups.h"
#include "core/fabrication/wholeness.h"

#include <QtCore/QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
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

/// Triangles whose corners name vertices of the cap, one for each side of a point in which the
/// outline touches itself.
struct Cap
{
    std::vector<Vec2> vertices;
    std::vector<std::array<int, 3>> triangles; // counter-clockwise
    std::vector<std::array<int, 2>> boundary;  // edges with the material on their left
};

/// Corners of triangles are the same vertex when triangles on shared edges lead from one to the
/// other; a point whose triangles fall into several such fans becomes several vertices.
Cap makeCap(const Triangulation &triangulation)
{
    const std::size_t count = triangulation.triangles.size();
    Groups fans(3 * count);
    std::map<std::array<int, 2>, std::size_t> edges; // directed edge of points -> its first corner
    for (std::size_t t = 0; t < count; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            edges[{triangulation.triangles[t][k], triangulation.triangles[t][(k + 1) % 3]}] =
                3 * t + k;
    const auto following = [](std::size_t corner) {
        return corner % 3 == 2 ? corner - 2 : corner + 1;
    };
    for (const auto &[edge, corner] : edges) {
        const auto opposite = edges.find({edge[1], edge[0]});
        if (opposite == edges.end())
            continue;
        fans.join(corner, following(opposite->second));
        fans.join(following(corner), opposite->second);
    }
    Cap cap;
    std::vector<int> vertexOf(3 * count, -1);
    const auto vertex = [&](std::size_t corner) {
        const std::size_t first = fans.firstOf(corner);
        if (vertexOf[first] < 0) {
            vertexOf[first] = static_cast<int>(cap.vertices.size());
            cap.vertices.push_back(triangulation.points[static_cast<std::size_t>(
                triangulation.triangles[corner / 3][corner % 3])]);
        }
        return vertexOf[first];
    };
    for (std::size_t t = 0; t < count; ++t)
        cap.triangles.push_back({vertex(3 * t), vertex(3 * t + 1), vertex(3 * t + 2)});
    for (const auto &[edge, corner] : edges)
        if (!edges.contains({edge[1], edge[0]}))
            cap.boundary.push_back({vertex(corner), vertex(following(corner))});
    return cap;
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
        const Triangulation &triangles = (*body.cut()->triangulations())[body.piece()];
        text.out += "# " + safeName(model.stockOf(section).name) + ',';
        append(text.out, body.thickness());
        text.out += " mm\n";
        text.addSlab(uniqueName(model.section(section)->name, names), makeCap(triangles),
                     body.frame(), body.thickness());
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
