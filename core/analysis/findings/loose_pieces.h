// Pieces that slits cut off a section and that no joint holds to the rest, alone or with what they
// carry.
#pragma once

#include "core/analysis/finder.h"

#include <vector>

namespace fff {

/// Of kLoosePieces.
struct LoosePieces
{
    int parts = 0;                    // that the section is cut into
    int loose = 0;                    // of these held by nothing
    double width = 0.0, height = 0.0; // mm, in the frame, of the largest of these
    bool isBySlits = true;            // false: as it is drawn
};

/// Of kSevered; its first sections are those that are cut apart, the others are what hangs on their
/// pieces.
struct SeveredPiece
{
    double width = 0.0, height = 0.0; // mm, in the frame, of the first piece
    int sections = 1;                 // that are cut apart
};

extern const FindingKind kLoosePieces; // one a section
extern const FindingKind kSevered;     // one a group
extern const ActionKind kTurnSlits;    // of one of its joints, so that they cut less through

/// Whether a group is nothing but one piece of a section that is cut into several.
bool isLoosePiece(const Bodies &bodies, const std::vector<int> &group);
/// The pieces in a group of several bodies whose sections have others outside of the group.
std::vector<int> severedPieces(const Bodies &bodies, const std::vector<int> &group);

void findLoosePieces(const Looked &at, std::vector<Finding> &found);

} // namespace fff
