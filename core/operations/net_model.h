// A mesh of few faces as nets to fold: flat sections of thin sheet, with lines to fold them along.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/templates/mesh_nets.h"

#include <string>
#include <vector>

namespace fff {

/// Nets stay this far from the edges of a sheet, and from each other where they lie, mm.
inline constexpr double kNetMargin = 10.0;
/// What is thicker than this, mm, does not fold along a scored line,
inline constexpr double kThickestFolded = 3.0;
/// and of what is no thicker than this flaps are glued; edges of thicker sheet are glued as they are.
inline constexpr double kThickestFlap = 1.5;
/// mm, of what is thin enough for flaps; 0 else.
double usualFlap(const Stock &stock);

struct NetModel
{
    Document document;
    std::vector<SectionId> sections; // a net each, the one with the largest facet first
    int folds = 0;
    int seams = 0; // edges to be joined, each with its number on both sides
};

/// Sections are added to the document, called `name`, "net" and a number, of its current stock,
/// whose sheet they keep within. They lie on the ground in a row along X from `corner` on, their
/// outside up. Lines to fold along are scored, dashed where a fold rises to who sees it; the
/// numbers of seams are engraved beside them.
///
/// mesh    coordinates in the world, mm; outwards as its triangles are wound
/// flap    mm, width of the flaps to glue along seams; 0: none
/// Errors  EmptyContour where there is no flat piece; BadCount, args = how many pieces there are,
///         kMostFacets; BadValue, place "thickness", args: mm, kThickestFolded; those of meshNets()
Result<NetModel> netModel(Document document, const TriangleMesh &mesh, const std::string &name,
                          const Vec3 &corner, double flap, const LongWork &work = {});

} // namespace fff
