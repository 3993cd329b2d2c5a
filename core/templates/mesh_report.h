// What was found in a mesh and mended, as counts and as what a person is told of it.
#pragma once

#include "core/base/message.h"

#include <cstddef>
#include <vector>

namespace fff {

struct MeshReport
{
    // Faces that were left out.
    std::size_t wrongIndices = 0; // a corner that there is no vertex for
    std::size_t notFinite = 0;    // a corner whose place is no number, or beyond all measure
    std::size_t degenerate = 0;   // the same corner twice
    std::size_t duplicates = 0;   // the same corners as another one
    // Faces that were turned over: they looked the other way than most of their shell.
    std::size_t flipped = 0;
    bool wasInsideOut = false; // all of it was turned over
    // What is as it was.
    std::size_t openEdges = 0;     // of one face: the edge of a hole, or of a surface
    std::size_t crowdedEdges = 0;  // of three faces and more
    std::size_t oneSidedEdges = 0; // between faces that cannot look the same way: a Möbius strip
    std::size_t shells = 0;        // that hang together by edges

    bool operator==(const MeshReport &) const = default;

    bool isClosed() const { return openEdges == 0; }
    bool isInOrder() const;
    /// A sentence for each thing that is not in order; empty when all is.
    std::vector<Message> messages() const;
};

} // namespace fff
