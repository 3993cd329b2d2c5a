// The edges of a network of contours as curves of a mesh.
#pragma once

#include "core/skin/contour_network.h"
#include "core/skin/skin_curve.h"

namespace fff {

/// Of each edge a curve along it. Its points are those of the contour's chords and some between;
/// its ends are the corners, towards which it bends off where the outlines miss each other. Its
/// normals lean out of the section's plane as the corners' do. Corners are the mesh's first
/// vertices.
std::vector<SkinCurve> networkCurves(const ContourNetwork &network, GrowingMesh &mesh);

/// A whole outline from a place on it and back there, where it is the same vertex again; its
/// normals lie in the section's plane.
SkinCurve ringCurve(const SkinOutline &outline, double start, GrowingMesh &mesh);

/// Of an edge as one walks along it.
SkinCurve walked(const std::vector<SkinCurve> &curves, HalfEdge half);

} // namespace fff
