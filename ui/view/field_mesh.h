// A field of stress over the solid that it is of, as arrays to be uploaded: over its faces and,
// with what they have at its edge, over its walls, since of a thin part one sees little else. Knows
// no OpenGL.
#pragma once

#include "ui/view/bent_slab.h"
#include "ui/view/scene.h"

namespace fff::ui {

struct FieldMesh
{
    std::vector<SlabVertex> vertices;  // as of a slab; flag: 127 on a wall
    std::vector<float> shares;         // of each: of what the sheet bears
    std::vector<VertexMotion> motions; // of each, of what is bent; else empty
    std::vector<std::uint32_t> triangles;
};

/// Of what is bent, its own mesh. Else the field's triangles over both faces, and the slab's walls
/// so far as they are this body's: there the use is that of the nearest place on the field's edge.
/// Walls that other slabs cover have none, and triangles that are strained less than `least` all
/// over are left out.
FieldMesh fieldMesh(const SceneSection &section, const StressField &field, double least = 0.0);

} // namespace fff::ui
