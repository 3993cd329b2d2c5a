// Bodies of few flat faces, for tests of what is built of sheets.
#pragma once

#include "tests/core/templates/made_meshes.h"

#include <algorithm>
#include <map>
#include <vector>

namespace fff::test {

/// The faces of the convex hull, by all planes that have no point before them:
/// each as a fan. Of so few points that their cube is nothing.
inline MeshDraft hullOf(const std::vector<Vec3> &points)
{
    MeshDraft draft;
    draft.positions = points;
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::vector<std::uint32_t>> known;
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j < count; ++j)
            for (std::uint32_t k = 0; k < count; ++k) {
                const Vec3 normal = (points[j] - points[i]).cross(points[k] - points[i]);
                if (normal.norm() < 1e-9)
                    continue;
                std::vector<std::uint32_t> face;
                bool isOutside = true;
                for (std::uint32_t m = 0; m < count; ++m) {
                    const double height = normal.normalized().dot(points[m] - points[i]);
                    isOutside = isOutside && height < 1e-6;
                    if (std::abs(height) < 1e-6)
                        face.push_back(m);
                }
                if (!isOutside || std::find(known.begin(), known.end(), face) != known.end())
                    continue;
                known.push_back(face);
                Vec3 middle = Vec3::Zero();
                for (const std::uint32_t m : face)
                    middle += points[m] / static_cast<double>(face.size());
                const Vec3 x = (points[face[0]] - middle).normalized();
                const Vec3 y = normal.normalized().cross(x);
                std::sort(face.begin(), face.end(), [&](std::uint32_t a, std::uint32_t b) {
                    const auto turn = [&](std::uint32_t m) {
                        const Vec3 p = points[m] - middle;
                        return std::atan2(y.dot(p), x.dot(p));
                    };
                    return turn(a) < turn(b);
                });
                for (std::size_t m = 1; m + 1 < face.size(); ++m)
                    draft.triangles.push_back({face[0], face[m], face[m + 1]});
            }
    return draft;
}

inline MeshDraft tetrahedron()
{
    return hullOf({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}});
}

inline MeshDraft octahedron()
{
    return hullOf({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
}

inline MeshDraft icosahedron()
{
    const double g = std::numbers::phi;
    std::vector<Vec3> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g})
            points.insert(points.end(), {Vec3(0, a, b), Vec3(a, b, 0), Vec3(b, 0, a)});
    return hullOf(points);
}

inline MeshDraft dodecahedron()
{
    const double g = std::numbers::phi, h = 1.0 / g;
    std::vector<Vec3> points;
    for (const double a : {-1.0, 1.0})
        for (const double b : {-1.0, 1.0}) {
            points.insert(points.end(),
                          {Vec3(0, a * h, b * g), Vec3(a * h, b * g, 0), Vec3(b * g, 0, a * h)});
            for (const double c : {-1.0, 1.0})
                points.emplace_back(a, b, c);
        }
    return hullOf(points);
}

/// Of so many sides, each end a fan of triangles about its middle.
inline MeshDraft prism(int sides)
{
    MeshDraft draft;
    const std::uint32_t low = addPoint(draft, {0, -0.7, 0}), high = addPoint(draft, {0, 0.7, 0});
    for (int i = 0; i < sides; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / sides;
        for (const double y : {-0.7, 0.7})
            addPoint(draft, {std::cos(turn), y, -std::sin(turn)});
    }
    const auto at = [sides](int i, int level) {
        return 2 + 2 * static_cast<std::uint32_t>(i % sides) + static_cast<std::uint32_t>(level);
    };
    for (int i = 0; i < sides; ++i) {
        addQuad(draft, at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1));
        draft.triangles.push_back({low, at(i + 1, 0), at(i, 0)});
        draft.triangles.push_back({high, at(i, 1), at(i + 1, 1)});
    }
    return draft;
}

/// A polygon, counter-clockwise, along z. Its ends are cut into triangles by
/// ears.
inline MeshDraft extruded(const std::vector<Vec2> &outline, double depth)
{
    MeshDraft draft;
    const auto count = static_cast<std::uint32_t>(outline.size());
    for (const double z : {0.0, depth})
        for (const Vec2 &p : outline)
            addPoint(draft, {p.x(), p.y(), z});
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t next = (i + 1) % count;
        addQuad(draft, i, next, count + next, count + i);
    }
    std::vector<std::uint32_t> left(count);
    for (std::uint32_t i = 0; i < count; ++i)
        left[i] = i;
    const auto turns = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        return cross(outline[b] - outline[a], outline[c] - outline[b]);
    };
    while (left.size() > 2)
        for (std::size_t i = 0; i < left.size(); ++i) {
            const std::uint32_t a = left[(i + left.size() - 1) % left.size()], b = left[i],
                                c = left[(i + 1) % left.size()];
            const bool isEar = turns(a, b, c) > 0.0 &&
                               std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
                                   return p != a && p != b && p != c && turns(a, b, p) >= 0.0 &&
                                          turns(b, c, p) >= 0.0 && turns(c, a, p) >= 0.0;
                               });
            if (!isEar)
                continue;
            draft.triangles.push_back({a, c, b});
            draft.triangles.push_back({count + a, count + b, count + c});
            left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
            break;
        }
    return draft;
}

/// An icosahedron whose triangles are in four each, on a ball: 80 faces.
inline MeshDraft icosphere()
{
    const MeshDraft coarse = icosahedron();
    MeshDraft draft;
    draft.positions = coarse.positions;
    for (Vec3 &p : draft.positions)
        p.normalize();
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto known = middles.find(std::minmax(a, b));
        if (known != middles.end())
            return known->second;
        const Vec3 p = (draft.positions[a] + draft.positions[b]).normalized();
        return middles[std::minmax(a, b)] = addPoint(draft, p);
    };
    for (const auto &[a, b, c] : coarse.triangles) {
        const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Triangle &t :
             {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
            draft.triangles.push_back(t);
    }
    return draft;
}

} // namespace fff::test
