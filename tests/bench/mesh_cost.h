// What meshes to draw over cost, by their size.
#pragma once

#include "tests/bench/kernel.h"

#include <optional>
#include <string>
#include <vector>

namespace fff::bench {

/// CPU time of one thread in milliseconds, of the shortest of the runs.
struct MeshCost
{
    std::string name;
    std::size_t size = 0;  // triangles
    double stl = 0.0;      // a binary STL to a mended mesh
    double obj = 0.0;      // an OBJ to the same
    double first = 0.0;    // a cut that looks at every triangle
    double tree = 0.0;     // the boxes over the triangles
    double cut = 0.0;      // a cut through these, as the plane moves
    double guide = 0.0;    // of its loops as contours
    double magnetic = 0.0; // drawn to four sections
    double pulled = 0.0; // the same with all that is cut and drawn of it, where it was known before
    double pulledCut = 0.0; // a cut of that as the plane moves
    double slices = 0.0;    // a hundred slices as sections, from the document to the model
    double kernel = 0.0;    // as in Measurement
};

/// Rings of some 62,500, 250,000 and 1,000,000 triangles, and one of 100,000.
std::vector<MeshCost> meshCosts(int runs, const std::optional<Kernel> &kernel);

/// In kernels where they were run, and beside each cost how many times that of the size before it
/// is.
std::string meshTable(const std::vector<MeshCost> &costs);

} // namespace fff::bench
