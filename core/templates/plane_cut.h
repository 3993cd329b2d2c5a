// The loops in which a plane cuts a mesh: what a section's contour may follow.
#pragma once

#include "core/templates/mesh_tree.h"

#include "core/base/message.h"

namespace fff {

struct CutLoop
{
    /// A stretch that closes what is open in the mesh: from a point over so many chords; the last
    /// one may end at the loop's first point.
    struct Bridge
    {
        std::size_t from = 0, chords = 1;
        bool operator==(const Bridge &) const = default;
    };

    std::vector<Vec3> points; // on the plane to 1e-9 of the mesh's size; the first not repeated
    std::vector<Bridge> bridges = {};
    bool isHole = false;
    /// All triangles along it look to the same side.
    bool isOriented = false;
    double area = 0.0; // that it encloses, by itself; not below 0

    bool isClosed() const { return bridges.empty(); } // by the mesh itself
    void reverse();
};

struct PlaneCut
{
    CutPlane plane;
    std::vector<CutLoop> loops; // largest first

    /// Of what is cut: loops less holes.
    double area() const;
    std::size_t bridges() const;
    /// What there is to be said of it; empty where all is in order.
    std::vector<Message> messages() const;
};

/// Loops run counter-clockwise seen from the normal's tip, holes clockwise. A hole is what the mesh
/// runs around that way, in another loop; where its triangles do not agree, what lies in an odd
/// number of loops. Of meshes that cross themselves, or have shells in each other, they bound all
/// that the mesh winds round (non-zero): no two loops without bridges have material in common.
///
/// A plane on which faces lie touches two cuts, that just above and that just below it; the larger
/// one is taken, so that a mesh that stands on the plane has its footprint, and a plane that is
/// turned over cuts the same. A plane that only touches a vertex or an edge cuts nothing.
///
/// tree  of this mesh, for the second cut and all after it; without it every triangle is looked at.
///       The loops are the same.
/// Source  loops through perturbed vertices: H. Edelsbrunner, E. Mücke 1990, Simulation of
///         Simplicity, ACM Transactions on Graphics 9(1).
PlaneCut planeCut(const TriangleMesh &mesh, const CutPlane &plane, const MeshTree *tree = nullptr);

} // namespace fff
