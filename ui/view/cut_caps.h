// The faces that a plane cuts through slabs, as plain arrays. Knows no OpenGL.
#pragma once

#include "ui/view/slab_mesh.h"

#include "core/geometry/frame.h"
#include "core/interaction/view_state.h"

namespace fff::ui {

struct CutCaps
{
    std::vector<std::array<float, 3>> triangles; // world, mm, three corners each
    std::vector<SlabEdge> edges;                 // the cap's outline; world, mm
};

/// Adds the section of the plane through the slab over these regions (ui/view/slab_mesh.h), of a
/// thickness in mm. Every prism over a triangle is cut on its own: no search for outlines, so
/// nothing can go wrong with them.
void addCap(CutCaps &caps, std::span<const Region> regions,
            std::span<const Triangulation> triangulations, const Frame &frame, double thickness,
            const ClipPlane &plane);

} // namespace fff::ui
