// A model as mechanics sees it: bodies, what their slits hold, the ground, what hangs on them.
#pragma once

#include "core/analysis/analysis.h"
#include "core/model/placed_loads.h"
#include "core/physics/neck.h"
#include "core/physics/structure.h"

#include <array>
#include <vector>

namespace fff {

/// Which overlap of which joint a link is, and the slits of its two bodies, frame coordinates.
struct LinkPlace
{
    int joint = 0; // its id
    int overlap = 0;
    std::array<SlitLine, 2> slits; // of a and b; depth 0 where there is none, root: where the
                                   // link's point is
    bool isThrough = false;        // of a mortise: comes out to either side
};

struct ModelStructure
{
    Structure structure;                 // a member is a body, by its place in the list
    std::vector<LinkPlace> links;        // of each link
    double weights = 0.0, pushes = 0.0;  // kg and N that act on it, copies and all
    std::vector<int> pushLoads;          // loads of the structure that are of pushes
    std::vector<PlacedLoad> besideLoads; // those on no material: the nearest body of their section
                                         // bears them
};

/// Members, links, feet and loads.
///
/// A link is an overlap of a joint where two bodies grip each other (grips.h). Its slits are as
/// deep as the other section is in them. A slit without clearance is tight. Nothing holds a link
/// against being pulled apart: grip is 0. Feet are those of groups of bodies that are above the
/// ground and touch it (stability.h). A load acts wherever it is placed
/// (placed_loads.h), at the points over which it is spread. Units
/// mm, kg, N, MPa; Y up, gravity 9.81 m/s².
ModelStructure structureOf(const Analysis &analysis);

/// MPa; of a stock of which it is not known a usual one: it only shares out what several bear
/// together.
double modulusOf(const Stock &stock);
/// A vector of the world as (u, v, n) of a section's frame.
Vec3 inFrame(const Frame &frame, const Vec3 &v);

/// All slits that a body has, for the stresses in it: those that end in its material.
std::vector<SlitLine> slitsOf(const Analysis &analysis, int body);

} // namespace fff
