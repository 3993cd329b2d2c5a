// The skin of a model: the form that its sections suggest, as a surface over their contours.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/section.h"
#include "core/templates/triangle_mesh.h"

#include <vector>

namespace fff {

/// Contours that follow each other round a place over which there is no patch.
struct OpenPlace
{
    enum class Why {
        NoForm, // they come back along themselves, or are too many to say what is between them
        Folded, // a patch would fold over itself
        Bulging // a patch would stand out from among them, or go far beyond them
    };
    Why why = Why::NoForm;
    std::vector<int> sections; // whose contours: indices into those of the skin, ascending
};

struct Skin
{
    TriangleMeshPointer mesh; // mm, faces outwards; null where there is no patch
    int patches = 0;
    int open = 0;                  // places over which there is none
    std::vector<OpenPlace> places; // those of them, in the order of their sections
};

/// Why a skin without a mesh is none: NoSkin.
Error noSkin(const Skin &skin);

/// A patch over each cycle of contours that cross each other at their edges, and tubes between
/// outlines that only follow each other. Neighbours share the points of the contour between them,
/// so a skin without open cycles is closed. Holes of sections are covered.
///
///   contours   chords of kDrawChord; where outlines miss each other by up to kSkinReach, both bend
///              off to the middle
///   order      which section comes first changes the order of triangles, nothing else
///
/// Errors  Cancelled. O(pairs of sections that meet · chords + triangles).
Result<Skin> skinOf(const std::vector<SectionPointer> &sections, const LongWork &work = {});

} // namespace fff
