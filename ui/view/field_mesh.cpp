#include "ui/view/field_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace fff::ui {

namespace {

constexpr std::int8_t kWallFlag = 127;

/// The edge of a field, and what is known there.
class FieldEdge
{
public:
    explicit FieldEdge(const StressField &field) : m_field(field)
    {
        for (const auto &[from, to] : boundaryOf(field)) {
            const Vec2 &a = pointAt(from), &b = pointAt(to);
            m_sides.push_back({from, to, a.cwiseMin(b), a.cwiseMax(b)});
        }
    }

    /// Of both faces; nothing where the edge is farther than `reach`, mm.
    std::optional<std::array<float, 2>> useNear(const Vec2 &place, double reach) const
    {
        double nearest = reach;
        std::optional<std::array<float, 2>> use;
        for (const Side &side : m_sides) {
            const Vec2 beyond = (side.min - place).cwiseMax(place - side.max).cwiseMax(0.0);
            if (beyond.squaredNorm() > nearest * nearest)
                continue;
            const Vec2 from = pointAt(side.from), way = pointAt(side.to) - from;
            const double square = way.squaredNorm();
            const double share =
                square > 0.0 ? std::clamp(way.dot(place - from) / square, 0.0, 1.0) : 0.0;
            const double away = (from + share * way - place).norm();
            if (away > nearest)
                continue;
            nearest = away;
            const auto at = [&](int face) {
                const auto &of = m_field.use[static_cast<std::size_t>(face)];
                return std::lerp(of[static_cast<std::size_t>(side.from)],
                                 of[static_cast<std::size_t>(side.to)], static_cast<float>(share));
            };
            use = {at(0), at(1)};
        }
        return use;
    }

private:
    struct Side
    {
        int from = 0, to = 0; // points of the field
        Vec2 min, max;
    };
    const Vec2 &pointAt(int i) const { return m_field.points[static_cast<std::size_t>(i)]; }

    const StressField &m_field;
    std::vector<Side> m_sides;
};

void addFaces(FieldMesh &mesh, const StressField &field)
{
    const auto count = static_cast<std::uint32_t>(field.points.size());
    for (const std::size_t face : {0u, 1u}) {
        const auto up = static_cast<std::int8_t>(face == 0 ? 127 : -127);
        for (std::size_t i = 0; i < count; ++i) {
            mesh.vertices.push_back(
                {{static_cast<float>(field.points[i].x()), static_cast<float>(field.points[i].y()),
                  face == 0 ? 1.0f : -1.0f},
                 {0, 0, up, 0}});
            mesh.shares.push_back(field.use[face][i]);
        }
    }
    for (const auto &t : field.triangles) {
        for (const int i : t)
            mesh.triangles.push_back(static_cast<std::uint32_t>(i));
        for (const int i : {t[0], t[2], t[1]})
            mesh.triangles.push_back(count + static_cast<std::uint32_t>(i));
    }
}

void addWalls(FieldMesh &mesh, const SceneSection &section, const StressField &field)
{
    const SlabMesh slab = meshOf(section);
    const FieldEdge edge(field);
    // Another piece of the section is a slit away, which is at least as wide as this.
    const double reach = 0.5 * section.thickness;
    constexpr std::uint32_t kNew = std::numeric_limits<std::uint32_t>::max(), kOff = kNew - 1;
    std::vector<std::uint32_t> placed(slab.vertices.size(), kNew);
    const auto place = [&](std::uint32_t i) {
        if (placed[i] != kNew)
            return placed[i];
        const SlabVertex &vertex = slab.vertices[i];
        const auto use = edge.useNear(Vec2(vertex.position[0], vertex.position[1]), reach);
        placed[i] = use ? static_cast<std::uint32_t>(mesh.vertices.size()) : kOff;
        if (use) {
            mesh.vertices.push_back(vertex);
            mesh.shares.push_back((*use)[vertex.position[2] > 0.0f ? 0 : 1]);
        }
        return placed[i];
    };
    const std::size_t end = slab.coverStarts.empty() ? 0 : slab.coverStarts.front();
    for (std::size_t i = 0; i + 2 < end; i += 3) {
        if (slab.vertices[slab.triangles[i]].normal[3] != kWallFlag)
            continue;
        const std::uint32_t a = place(slab.triangles[i]), b = place(slab.triangles[i + 1]),
                            c = place(slab.triangles[i + 2]);
        if (a != kOff && b != kOff && c != kOff)
            mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
    }
}

/// Most of most models: no need to have the graphics card find out with each picture.
void leaveOutLess(FieldMesh &mesh, double least)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        float most = 0.0f;
        for (std::size_t k = 0; k < 3; ++k)
            most = std::max(most, mesh.shares[mesh.triangles[i + k]]);
        if (static_cast<double>(most) < least)
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            mesh.triangles[kept++] = mesh.triangles[i + k];
    }
    mesh.triangles.resize(kept);
}

} // namespace

FieldMesh fieldMesh(const SceneSection &section, const StressField &field, double least)
{
    FieldMesh mesh;
    if (section.bent) {
        mesh.vertices = section.bent->flat.vertices;
        mesh.motions = section.bent->motions;
        mesh.triangles = section.bent->flat.triangles;
        const auto count = static_cast<std::uint32_t>(field.points.size());
        for (const std::uint32_t on : section.bent->onFace)
            mesh.shares.push_back(field.use[on / count][on % count]);
    } else {
        addFaces(mesh, field);
        if (static_cast<double>(field.most) >= least)
            addWalls(mesh, section, field);
    }
    leaveOutLess(mesh, least);
    return mesh;
}

} // namespace fff::ui
