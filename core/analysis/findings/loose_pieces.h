// Pieces that slits cut off a section and that no joint holds to the rest, alone or with what they
// carry.
#pragma once

#include "core/analysis/finder.h"

#include <optional>
#include <vector>

namespace fff {

/// Of kLoosePieces.
struct LoosePieces
{
    int parts = 0;                    // that the section is cut into
    int loose = 0;                    // of these held by nothing
    double width = 0.0, height = 0.0; // mm, in the frame, of the largest of these
};

/// Of kSevered; its first section is the one that is cut apart, the others are what hangs on the
/// piece.
struct SeveredPiece
{
    double width = 0.0, height = 0.0; // mm, in the frame, of the piece
};

extern const FindingKind kLoosePieces; // one a section
extern const FindingKind kSevered;     // one a group
extern const ActionKind kTurnSlits;    // of one of its joints, so that they cut less through

/// Whether a group is nothing but one piece of a section that is cut into several.
bool isLoosePiece(const Bodies &bodies, const std::vector<int> &group);
/// A piece in a group of several bodies whose section has others outside of the group; nothing
/// where there is none.
std::optional<int> severedPiece(const Bodies &bodies, const std::vector<int> &group);

void findLoosePieces(const Looked &at, std::vector<Finding> &found);

} // namespace fff
