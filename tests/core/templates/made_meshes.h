// Meshes made by code, plain and nasty, for tests of everything that is drawn over a mesh.
#pragma once

#include "core/templates/mended_mesh.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace fff::test {

inline std::uint32_t addPoint(MeshDraft &draft, const Vec3 &p)
{
    draft.positions.push_back(p);
    return static_cast<std::uint32_t>(draft.positions.size() - 1);
}

/// a b c d counter-clockwise from outside.
inline void addQuad(MeshDraft &draft, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                    std::uint32_t d)
{
    draft.triangles.push_back({a, b, c});
    draft.triangles.push_back({a, c, d});
}

inline void append(MeshDraft &draft, const MeshDraft &other)
{
    const auto first = static_cast<std::uint32_t>(draft.positions.size());
    draft.positions.insert(draft.positions.end(), other.positions.begin(), other.positions.end());
    for (const Triangle &t : other.triangles)
        draft.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

inline MeshDraft moved(MeshDraft draft, const Vec3 &by)
{
    for (Vec3 &p : draft.positions)
        p += by;
    return draft;
}

inline MeshDraft turnedOver(MeshDraft draft)
{
    for (Triangle &t : draft.triangles)
        std::swap(t[1], t[2]);
    return draft;
}

/// Closed in both directions: rows × columns points, 2 × rows × columns triangles. The surface
/// looks outwards where its first direction, then its second turn counter-clockwise from outside.
inline MeshDraft wrapped(int rows, int columns, const std::function<Vec3(double u, double v)> &at)
{
    MeshDraft draft;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            draft.positions.push_back(
                at(2.0 * std::numbers::pi * i / rows, 2.0 * std::numbers::pi * j / columns));
    const auto index = [&](int i, int j) {
        return static_cast<std::uint32_t>((i % rows) * columns + j % columns);
    };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            addQuad(draft, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
    return draft;
}

/// About the z axis; minor < major.
inline MeshDraft torus(double major, double minor, int rows, int columns)
{
    return wrapped(rows, columns, [=](double u, double v) {
        const double r = major + minor * std::cos(v);
        return Vec3(r * std::cos(u), r * std::sin(u), minor * std::sin(v));
    });
}

/// A ball whose surface `radius(direction)` away from the middle, rows − 1 rings between two poles
/// on the z axis: 2 × columns × (rows − 1) triangles.
inline MeshDraft ball(int rows, int columns, const std::function<double(const Vec3 &)> &radius)
{
    MeshDraft draft;
    const auto at = [&](double polar, double around) {
        const Vec3 way(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                       std::cos(polar));
        return Vec3(radius(way) * way);
    };
    const std::uint32_t top = addPoint(draft, at(0.0, 0.0));
    for (int i = 1; i < rows; ++i)
        for (int j = 0; j < columns; ++j)
            addPoint(draft, at(std::numbers::pi * i / rows, 2.0 * std::numbers::pi * j / columns));
    const std::uint32_t bottom = addPoint(draft, at(std::numbers::pi, 0.0));
    const auto index = [&](int i, int j) {
        return 1 + static_cast<std::uint32_t>((i - 1) * columns + j % columns);
    };
    for (int j = 0; j < columns; ++j) {
        draft.triangles.push_back({top, index(1, j), index(1, j + 1)});
        for (int i = 1; i + 1 < rows; ++i)
            addQuad(draft, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
        draft.triangles.push_back({index(rows - 1, j), bottom, index(rows - 1, j + 1)});
    }
    return draft;
}

inline MeshDraft sphere(double radius, int rows, int columns)
{
    return ball(rows, columns, [radius](const Vec3 &) { return radius; });
}

/// Like a head: brow, nose, chin and ears; some 90 mm high, looking along +x, z upwards.
inline MeshDraft head(int rows, int columns)
{
    const auto bump = [](const Vec3 &way, const Vec3 &at, double width) {
        return std::exp(-(way - at.normalized()).squaredNorm() / (width * width));
    };
    return ball(rows, columns, [bump](const Vec3 &way) {
        double r = 40.0 - 6.0 * way.y() * way.y() + 5.0 * way.z() * way.z();
        r += 9.0 * bump(way, {1.0, 0.0, -0.1}, 0.18) + 4.0 * bump(way, {1.0, 0.0, 0.35}, 0.4);
        r += 5.0 * bump(way, {0.8, 0.0, -0.7}, 0.3);
        r += 5.0 * (bump(way, {0.0, 1.0, 0.0}, 0.2) + bump(way, {0.0, -1.0, 0.0}, 0.2));
        return r - 3.0 * bump(way, {0.9, 0.0, -0.45}, 0.25);
    });
}

/// From low to high, twelve triangles.
inline MeshDraft box(const Vec3 &low, const Vec3 &high)
{
    MeshDraft draft;
    for (int i = 0; i < 8; ++i)
        addPoint(draft, {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                         i & 4 ? high.z() : low.z()});
    addQuad(draft, 0, 2, 3, 1);
    addQuad(draft, 4, 5, 7, 6);
    addQuad(draft, 0, 1, 5, 4);
    addQuad(draft, 2, 6, 7, 3);
    addQuad(draft, 0, 4, 6, 2);
    addQuad(draft, 1, 3, 7, 5);
    return draft;
}

inline MeshDraft cube(double side)
{
    return box(Vec3::Constant(-0.5 * side), Vec3::Constant(0.5 * side));
}

/// Two cubes that have an edge in common, of four faces: along z at the origin.
inline MeshDraft cubesAtAnEdge(double side)
{
    MeshDraft draft = box({-side, -side, 0.0}, {0.0, 0.0, side});
    append(draft, box({0.0, 0.0, 0.0}, {side, side, side}));
    return draft;
}

/// Two balls that go through each other.
inline MeshDraft crossingBalls(double radius, int rows, int columns)
{
    MeshDraft draft = sphere(radius, rows, columns);
    append(draft, moved(sphere(radius, rows, columns), {0.9 * radius, 0.1 * radius, 0.2 * radius}));
    return draft;
}

/// A ball without the faces of which `isGone` says true for the middle.
inline MeshDraft without(MeshDraft draft, const std::function<bool(const Vec3 &)> &isGone)
{
    std::erase_if(draft.triangles, [&](const Triangle &t) {
        return isGone((draft.positions[t[0]] + draft.positions[t[1]] + draft.positions[t[2]]) /
                      3.0);
    });
    return draft;
}

/// A band that turns over once: it has one side.
inline MeshDraft moebiusBand(double radius, double width, int columns)
{
    MeshDraft draft;
    for (int j = 0; j < columns; ++j) {
        const double around = 2.0 * std::numbers::pi * j / columns;
        for (const double side : {-0.5, 0.5}) {
            const double r = radius + side * width * std::cos(0.5 * around);
            addPoint(draft, {r * std::cos(around), r * std::sin(around),
                             side * width * std::sin(0.5 * around)});
        }
    }
    const auto index = [columns](int j, int side) {
        const bool isOver = j == columns;
        return static_cast<std::uint32_t>(2 * (j % columns) + (isOver ? 1 - side : side));
    };
    for (int j = 0; j < columns; ++j)
        addQuad(draft, index(j, 0), index(j + 1, 0), index(j + 1, 1), index(j, 1));
    return draft;
}

/// What is known to be in order.
inline TriangleMeshPointer meshOf(MeshDraft draft)
{
    return mended(std::move(draft)).value().mesh;
}

} // namespace fff::test
