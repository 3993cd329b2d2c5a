// A mesh of few faces as a box of flat sheets: a section for each flat piece, cut back where two
// meet, and fingers along their edges.
#pragma once

#include "core/assembly/tabs.h"
#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/templates/mesh_facets.h"

#include <string>
#include <vector>

namespace fff {

/// More pieces nobody cuts and joins by hand.
inline constexpr std::size_t kMostFacets = 500;
/// Of an area below this, mm², nothing is left to hold: as in slices.
inline constexpr double kSmallestFacet = 25.0;

/// Two sections that share an edge and have no joint there.
struct BareEdge
{
    SectionId a, b; // a < b
    NoTabs why = NoTabs::TooOblique;
};

struct FacetModel
{
    Document document;
    std::vector<SectionId> sections; // in the order of the pieces
    std::size_t joints = 0;          // pairs that have fingers, as a person's wish
    std::vector<BareEdge> bare;
    int tooSmall = 0; // pieces of which no section was made
};

/// Sections are added to the document, called `name` and a number, of its current stock. The mesh
/// is the outside of what is built: the mid-plane of a sheet lies half its thickness behind the
/// mesh, and its normal looks outwards. Along an edge where two sheets would go through each other,
/// both are cut back, square, to the plane half-way between them, so that they meet in one line;
/// where they lean away from each other both end at the mesh's edge. Where the angle lets them have
/// fingers (assembly/fingers.h), they are cut back as far as these need, which beyond a right angle
/// is up to 0.3 thicknesses more, and the joint is one of tabs. Sheets that share a vertex alone
/// are cut back to the plane between them, where each lies behind the other one's.
///
/// mesh    coordinates in the world, mm; outwards as its triangles are wound
/// name    of the mesh
/// Errors  EmptyContour where no piece is large enough; BadCount, args = how many pieces there are,
///         kMostFacets; Cancelled.
Result<FacetModel> facetModel(Document document, const TriangleMesh &mesh, const std::string &name,
                              const LongWork &work = {});

} // namespace fff
