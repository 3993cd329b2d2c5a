// What is engraved on a part, so that a heap of them can be put together: its number, and beside
// every slit the number of the joint, which its mate bears too. That one begins with a short bar
// (digits.h) and stands so far away that the two are not read as one.
#pragma once

#include "core/fabrication/digits.h"
#include "core/fabrication/marked_lines.h"
#include "core/fabrication/part.h"

namespace fff {

struct MarkOptions
{
    double numberHeight = 6.0; // mm, shrinking to what fits
    double jointHeight = 3.0;  // mm, the same
    double minHeight = 1.2;    // mm; smaller ones cannot be read and are left out
    double clearance = 0.4;    // mm, from a mark's box to the nearest cut or mark
};

/// Between the part's number and a joint's, in heights of the larger one.
inline constexpr double kHeightsApart = 2.0;

struct Engraving
{
    Strokes strokes;         // in the part's coordinates, mm
    std::vector<int> joints; // of each stroke: whose number it is of; 0, or none: the part's
    std::vector<Box2> boxes; // one a mark: what it takes up
    bool hasNumber = false;
    MarkedLines lines;              // that a person drew there
    std::vector<int> jointsLeftOut; // joints' numbers for which there was no room
};

/// Joint numbers stand just beyond their slits' bottoms, or beside the slits where that is taken;
/// the part's number stands where it then fits in full size, or where is most room. Upright in the
/// part's frame. Every mark's box lies inside the material and apart from the others and from what
/// is drawn on the section: the part's number by kHeightsApart of the larger of the two, joint
/// numbers by the height of one of them. Where that is too much, all become smaller; where it still
/// is, joint numbers are left out rather than set closer.
Engraving engrave(const Part &part, const std::vector<MarkPointer> &drawn,
                  const MarkOptions &options = {});

} // namespace fff
