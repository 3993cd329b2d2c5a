// Pieces that slits cut off a section and that no joint holds.
#pragma once

#include "core/analysis/finder.h"

namespace fff {

/// Of kLoosePieces.
struct LoosePieces
{
    int parts = 0;                    // that the section is cut into
    int loose = 0;                    // of these held by nothing
    double width = 0.0, height = 0.0; // mm, in the frame, of the largest of these
};

extern const FindingKind kLoosePieces; // one a section
extern const ActionKind kTurnSlits;    // of one of its joints, so that they cut less through

/// Whether a group is nothing but one piece of a section that is cut into several.
bool isLoosePiece(const Bodies &bodies, const std::vector<int> &group);

void findLoosePieces(const Looked &at, std::vector<Finding> &found);

} // namespace fff
