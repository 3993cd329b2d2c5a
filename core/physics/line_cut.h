// Straight cuts through a piece: what of a line is material, and what each cut parts.
#pragma once

#include "core/physics/section_outline.h"

#include <optional>
#include <vector>

namespace fff {

/// A stretch of a line in the material, between two points of the boundary.
struct Chord
{
    double from = 0.0, to = 0.0; // along the line, mm
    OutlinePoint begin, end;

    double length() const { return to - from; }
};

/// Chords of one line that part a piece in two: from the outer ring to the outer ring, over the
/// holes in between. The part to the left of the line is the minus side, that to its right the plus
/// side; cut sides see an outward normal of the minus side m = direction turned by −90°.
struct LineCut
{
    CutLine line;
    std::vector<Chord> chords; // at least one, in their order along the line
    AreaMoment plus;           // of the plus side, about the outline's base
    AreaMoment minus;
    std::vector<char> isHoleLeft;         // by ring − 1: its first vertex is on the minus side
    std::vector<OutlineCrossing> crossed; // of holes, in the order of ring and way around

    Vec2 normal() const { return {line.direction.y(), -line.direction.x()}; }
};

/// All cuts on the line whose sides have an area; see SectionOutline::crossings for `zero`. Robust
/// against vertices on the line. O(edges near the line + holes).
/// Whether a vertex lies on the line.
bool cutsOn(const SectionOutline &outline, const CutLine &line, int zero,
            std::vector<LineCut> &cuts);

/// A chord of one of the cuts of a line.
struct CutChord
{
    LineCut cut;
    int chord = 0;
};

/// The shortest chord that contains the place `along` of the line, within `slack` mm. Where
/// vertices lie on the line it may be moved by nothing to either side, as is shorter.
std::optional<CutChord> cutAt(const SectionOutline &outline, const CutLine &line, double along,
                              double slack);
/// The shortest chord that begins at the line's own point, which lies on the boundary.
std::optional<CutChord> cutFrom(const SectionOutline &outline, const CutLine &line);

/// Where a point of the material is held to the boundary, so that its side of a cut costs no
/// search: the straight way to `anchor` stays in the material.
struct HeldPoint
{
    Vec2 at = Vec2::Zero();
    OutlinePoint anchor;
};

HeldPoint held(const SectionOutline &outline, const Vec2 &point);
/// On the plus side; a point outside of the material counts as its anchor. O(crossings of holes).
bool isOnPlusSide(const LineCut &cut, const HeldPoint &point);

} // namespace fff
