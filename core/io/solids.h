// The parts of a model as closed solids of triangles: what printers and other programs get.
#pragma once

#include "core/assembly/body.h"
#include "core/io/formats.h"
#include "core/model/model.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace fff::io {

/// Triangles whose corners name vertices of the cap, one for each side of a point in which the
/// outline touches itself.
struct Cap
{
    std::vector<Vec2> vertices;
    std::vector<std::array<int, 3>> triangles; // counter-clockwise
    std::vector<std::array<int, 2>> boundary;  // edges with the material on their left
};

/// Of a body that has a solid (haveSolids()). Curves are chords of kCutChord.
Cap capOf(const Body &body);

/// Where the parts are.
enum class Lying {
    InPlace, // in the model
    OnSheets // flat, as they are laid out to be cut, sheet above sheet
};

/// A closed mesh, seen counter-clockwise from outside; every edge belongs to two triangles. mm, Z
/// up, as programs for printers take it: the world's (x, y, z) is (x, −z, y) here.
struct PartSolid
{
    std::string name; // of its section
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Of all bodies, in their order, as designed (no kerf). `bodies` belong to the model.
/// Errors  as haveSolids().
Result<std::vector<PartSolid>> partSolids(const Model &model, const Bodies &bodies, Lying lying);

/// "--parts in-place|flat", of formats that hold solids.
/// title  that of the second one in Export
FormatOption lyingOption(const char *title);
Lying lyingOf(const FormatValues &values);

} // namespace fff::io
