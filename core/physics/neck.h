// What of a chord counts as the cross-section of a member: its effective length, and what about it
// the beam formulas do not see.
#pragma once

#include "core/physics/line_cut.h"

#include <optional>
#include <vector>

namespace fff {

/// A slit cut into a piece, mm.
struct SlitLine
{
    Vec2 root = Vec2::Zero();     // middle of its inner end
    Vec2 opening = Vec2::UnitX(); // unit: the way in which it opens
    double depth = 0.0, width = 0.0;

    bool operator==(const SlitLine &) const = default;
};

/// A vertex of the boundary with more than 200° of material around it.
struct ReentrantCorner
{
    int ring = 0, vertex = 0;
    Vec2 at = Vec2::Zero();
};

/// One piece, prepared for cuts. Immutable; knows nothing of forces.
struct PieceShape
{
    /// `region`: its material, slits already cut out, mm, in the section's frame.
    explicit PieceShape(const Region &region, std::vector<SlitLine> slits = {});

    SectionOutline outline;
    std::vector<SlitLine> slits;
    std::vector<std::optional<CutChord>>
        netCuts; // of each slit, from its root on, away from its mouth
    std::vector<ReentrantCorner> corners;
    BoxRuns slitZones; // of each slit what of the piece it may shadow
    BoxRuns cornerBoxes;
    double size = 0.0; // diagonal of its bounds
};

/// The cross-section of the member that a chord cuts.
///
/// Of the two outward normals at the chord's ends the medial axis has the half: the section runs
/// along v̄ = (n_end − n_begin), normalised, and is l = chord · cos ∠(chord, v̄) long. Where the
/// boundary turns little from edge to edge it is a curve, and the normal changes along its edges;
/// at a corner the normal is the chord's own where that lies between those of the two edges, else
/// the nearer one; at a re-entrant one also each of them, whichever is most opposite to the other
/// end's.
///
/// Beside a slit's wall the material above the slit's root is shadowed for what comes around the
/// root: only what lies below a line at 45° from the root's corner counts, so that l grows by as
/// much as the line is away from the wall. What the slit itself takes in knows of no shadow.
///
/// Source  the product's mechanics, 2.5, 2.7 and 2.9; Winkler's curved bar of rectangular section,
///         R the radius of its middle, k = (q − i) l / (6 (R − q) i) with i = R − l/2 and
///         q = l / ln((R + l/2) / i).
struct Neck
{
    Vec2 begin = Vec2::Zero(), end = Vec2::Zero(); // of the chord
    Vec2 across = Vec2::UnitX();                   // v̄, unit, from begin to end
    double length = 0.0;                           // l, mm
    double straight = 1.0;                         // cosine of the angle between chord and v̄
    double bend = 1.0; // Winkler's factor of the bending stress in the plane, at least 1
    double halfOpening =
        0.0; // mm: half of what the holes at its ends reach over, normal to the cut
    double zonePlus = 0.0, zoneMinus = 0.0; // mm: how far the holes that the cut crosses reach to
                                            // its plus and its minus side
    bool isSameSide = false;  // both ends face the same way: it cuts off a sliver, not a member
    bool isNetOnPlus = false; // that slit's net cut is on the plus side of this one
    bool isOnNetPlus = false; // this cut is on the plus side of that one
    int shadowSlit = -1;      // of PieceShape::slits, whose shadow leaves the least; −1: none
    Vec2 shadowBegin = Vec2::Zero(), shadowEnd = Vec2::Zero(); // what that leaves of the chord
    double shadowLength = 0.0;                                 // l of it, mm
    bool isAtCorner = false;                                   // an end lies on a re-entrant corner
    bool isNearCorner = false;                                 // another corner is nearer than l
    bool isStubby = false; // a side of the cut is less deep than l
    bool isCap = false;    // a side is less deep than half of l
    bool isCurved = false; // R < 2 l

    Vec2 middle() const { return 0.5 * (begin + end); }
    Vec2 normal() const { return {across.y(), -across.x()}; } // out of the minus side
};

/// Whether beam formulas apply at all: it is at least 0.05 mm long, leans by no more than 45°, and
/// its ends are on two sides of a member.
bool counts(const Neck &neck);

Neck neckOf(const PieceShape &shape, const LineCut &cut, int chord);
/// The two halves of it. From where to where it is, how long, how it leans, and whether its ends
/// face the same way, which is all that counts() asks for; and what takes longer.
Neck leaningNeck(const PieceShape &shape, const CutLine &line, const Chord &chord);
void measure(const PieceShape &shape, const LineCut &cut, int chord, Neck &neck);

} // namespace fff
