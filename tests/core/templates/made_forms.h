// Ten forms such as people bring, made by code: round and square ones, some that stand and some
// that roll, of one shell and of several that run into each other.
#pragma once

#include "tests/core/templates/made_meshes.h"

#include <array>
#include <vector>

namespace fff::test {

/// About the y axis; profile (radius, y) from the lowest to the highest point, both at radius 0.
inline MeshDraft revolved(const std::vector<Vec2> &profile, int columns)
{
    MeshDraft draft;
    const std::uint32_t bottom = addPoint(draft, {0.0, profile.front().y(), 0.0});
    for (std::size_t i = 1; i + 1 < profile.size(); ++i)
        for (int j = 0; j < columns; ++j) {
            const double around = -2.0 * std::numbers::pi * j / columns;
            addPoint(draft, {profile[i].x() * std::cos(around), profile[i].y(),
                             profile[i].x() * std::sin(around)});
        }
    const std::uint32_t top = addPoint(draft, {0.0, profile.back().y(), 0.0});
    const int rings = static_cast<int>(profile.size()) - 2;
    const auto index = [columns](int i, int j) {
        return 1 + static_cast<std::uint32_t>(i * columns + j % columns);
    };
    for (int j = 0; j < columns; ++j) {
        draft.triangles.push_back({bottom, index(0, j + 1), index(0, j)});
        for (int i = 0; i + 1 < rings; ++i)
            addQuad(draft, index(i, j), index(i, j + 1), index(i + 1, j + 1), index(i + 1, j));
        draft.triangles.push_back({top, index(rings - 1, j), index(rings - 1, j + 1)});
    }
    return draft;
}

inline MeshDraft mapped(MeshDraft draft, const std::function<Vec3(const Vec3 &)> &map)
{
    for (Vec3 &p : draft.positions)
        p = map(p);
    return draft;
}

inline MeshDraft ellipsoid(const Vec3 &middle, const Vec3 &radii)
{
    return mapped(sphere(1.0, 24, 36),
                  [&](const Vec3 &p) { return Vec3(middle + radii.cwiseProduct(p)); });
}

/// A round rod with rounded ends.
inline MeshDraft rod(const Vec3 &from, const Vec3 &to, double radius)
{
    const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), to - from);
    const double half = 0.5 * (to - from).norm();
    return mapped(sphere(radius, 24, 24), [&](const Vec3 &p) {
        const Vec3 stretched = p + Vec3(0.0, 0.0, p.z() > 0.0 ? half : -half);
        return Vec3(0.5 * (from + to) + turn * stretched);
    });
}

inline MeshDraft joined(const std::vector<MeshDraft> &parts)
{
    MeshDraft all;
    for (const MeshDraft &part : parts)
        append(all, part);
    return all;
}

inline MeshDraft vase()
{
    std::vector<Vec2> profile{{0.0, 0.0}};
    for (int i = 0; i <= 40; ++i) {
        const double up = i / 40.0;
        profile.emplace_back(34.0 + 26.0 * std::sin(4.0 * up) + 10.0 * up * up, 200.0 * up);
    }
    profile.emplace_back(0.0, 200.0);
    return revolved(profile, 64);
}

inline MeshDraft bottle()
{
    return revolved({{0, 0},
                     {36, 0},
                     {40, 4},
                     {40, 120},
                     {38, 134},
                     {30, 150},
                     {19, 164},
                     {14, 178},
                     {13, 220},
                     {16, 222},
                     {16, 234},
                     {0, 234}},
                    64);
}

/// A tube that winds outwards in an upright plane and gets wider.
inline MeshDraft snailShell()
{
    constexpr int kRows = 120, kColumns = 24;
    MeshDraft draft;
    const auto middle = [](double turn) {
        const double r = 8.0 * std::exp(0.16 * turn);
        return Vec3(r * std::cos(turn), r * std::sin(turn), -2.0 * turn);
    };
    const double last = 4.6 * std::numbers::pi;
    for (int i = 0; i < kRows; ++i) {
        const double turn = last * i / (kRows - 1.0);
        const Vec3 at = middle(turn), out = Vec3(std::cos(turn), std::sin(turn), 0.0);
        const double width = 4.6 * std::exp(0.16 * turn);
        for (int j = 0; j < kColumns; ++j) {
            const double around = 2.0 * std::numbers::pi * j / kColumns;
            addPoint(draft,
                     at + width * (std::cos(around) * out + std::sin(around) * Vec3::UnitZ()));
        }
    }
    const auto index = [](int i, int j) {
        return static_cast<std::uint32_t>(i * kColumns + j % kColumns);
    };
    for (int i = 0; i + 1 < kRows; ++i)
        for (int j = 0; j < kColumns; ++j)
            addQuad(draft, index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1));
    const std::uint32_t inner = addPoint(draft, middle(0.0)), outer = addPoint(draft, middle(last));
    for (int j = 0; j < kColumns; ++j) {
        draft.triangles.push_back({inner, index(0, j), index(0, j + 1)});
        draft.triangles.push_back({outer, index(kRows - 1, j + 1), index(kRows - 1, j)});
    }
    return draft;
}

inline MeshDraft animal()
{
    return joined({ellipsoid({0, 95, 0}, {75, 34, 30}), rod({52, 6, 16}, {48, 90, 14}, 11),
                   rod({52, 6, -16}, {48, 90, -14}, 11), rod({-54, 6, 16}, {-48, 90, 14}, 12),
                   rod({-54, 6, -16}, {-48, 90, -14}, 12), rod({60, 105, 0}, {92, 150, 0}, 16),
                   ellipsoid({106, 158, 0}, {30, 17, 16}), rod({-70, 105, 0}, {-105, 130, 0}, 7)});
}

inline MeshDraft bracket()
{
    return joined({box({0, 0, -50}, {120, 24, 50}), box({0, 0, -50}, {26, 130, 50}),
                   box({10, 10, -16}, {72, 80, 16})});
}

inline MeshDraft fish()
{
    return joined({ellipsoid({0, 50, 0}, {95, 44, 26}), ellipsoid({-105, 52, 0}, {34, 42, 9}),
                   ellipsoid({10, 92, 0}, {40, 22, 7}), ellipsoid({20, 14, 0}, {22, 16, 8})});
}

inline MeshDraft chair()
{
    MeshDraft all = box({-50, 80, -50}, {50, 98, 50});
    for (const double x : {-50.0, 32.0})
        for (const double z : {-50.0, 32.0})
            append(all, box({x, 0, z}, {x + 18, 90, z + 18}));
    append(all, box({-50, 90, -50}, {-34, 200, 50}));
    return all;
}

inline MeshDraft dumbbell()
{
    return joined({ellipsoid({-80, 45, 0}, {45, 45, 45}), ellipsoid({80, 45, 0}, {45, 45, 45}),
                   rod({-70, 45, 0}, {70, 45, 0}, 18)});
}

struct MadeForm
{
    const char *name;
    MeshDraft draft;
    bool isUpright = true; // y upwards, else z
};

inline std::array<MadeForm, 10> madeForms()
{
    return {MadeForm{"head", head(60, 90), false},
            MadeForm{"vase", vase()},
            MadeForm{"shell", snailShell()},
            MadeForm{"animal", animal()},
            MadeForm{"bracket", bracket()},
            MadeForm{"torus", torus(80.0, 30.0, 72, 36), false},
            MadeForm{"fish", fish()},
            MadeForm{"chair", chair()},
            MadeForm{"bottle", bottle()},
            MadeForm{"dumbbell", dumbbell()}};
}

} // namespace fff::test
