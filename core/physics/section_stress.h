// Stresses within a section by the formulas of beams: on the cuts of a piece, for the forces on it.
#pragma once

#include "core/physics/cut_forces.h"
#include "core/physics/section_cuts.h"

#include <optional>
#include <vector>

namespace fff {

/// Why the number of a neck is to be taken with care.
struct NeckDoubts
{
    bool isStubby = false;     // not long enough for a beam
    bool isNearForce = false;  // a force acts nearer than the neck is long
    bool isNearCorner = false; // another re-entrant corner is nearer than that
    bool isNarrow = false;     // l < 3 t: plate bending is that of a bar
    bool isCurved = false;     // R < 2 l; Winkler's factor is in the stress
    bool isRedundant = false;  // forces act beside the holes that the cut crosses: statics does not
                               // tell what each chord of it carries ("redundant in plane")
    bool mayBuckle = false;    // axial compression above a third of Euler's load
};

/// Forces and stresses on one neck.
struct NeckStress
{
    SampleKind kind = SampleKind::Grid;
    Vec2 begin = Vec2::Zero(), end = Vec2::Zero(); // mm, (u, v)
    double length = 0.0;                           // l, mm: effective
    bool isShadowed = false; // by a slit, and that is worse than all of the chord
    /// A force acts on the end of the piece that it cuts off, which is less deep than half of l: it
    /// goes straight to its support, not as in a beam. Or it goes through a foot, or a load that is
    /// spread, wider than l. Not among the worst.
    bool isLocal = false;
    /// A line of the grid next to where a refined one has been looked for, which stands for it. Not
    /// among the worst either.
    bool isCovered = false;
    bool counts() const { return !isLocal && !isCovered; }
    CutForces forces;
    NominalStress stress;
    double neckUse = 0.0, cornerUse = 0.0; // stress / strength, without and with the notch factor
    NeckDoubts doubts;
};

struct StressOptions
{
    NotchRule notch;
    int refined =
        3; // of the worst lines of the grid so many are turned and moved to where it is worst
};

/// The sides of all cuts for forces that act at certain places. Valid as long as these stay (and
/// the cuts live); the forces themselves may change.
struct CutShares
{
    ForceSites sites;
    PlusSitesList cuts;          // of each cut
    std::vector<PlusSites> nets; // of each slit's net cut
};

/// Finite, and no more than any sheet is loaded with; others count as none.
bool isUsableForce(const AppliedForce &force);
std::vector<AppliedForce> usableForces(const std::vector<AppliedForce> &forces);
/// A sheet there may be.
bool isUsableSheet(const SheetMaterial &sheet);

/// `thickness` of the sheet, mm.
CutShares cutShares(const SectionCuts &cuts, const std::vector<AppliedForce> &forces,
                    double thickness);

struct SectionStress
{
    /// False where the numbers are not to be relied on: there is no neck that counts (but in what
    /// lies on the ground with all of it, which strains nothing), the piece hangs together by
    /// points, a force or the sheet is no number, or one that no sheet has.
    bool isWorkedOut = false;
    std::vector<NeckStress> necks; // all samples, then the refined ones
    int worstNeck = -1;            // of `necks` that count, by neckUse; −1 without any
    int worstCorner = -1;          // by cornerUse
    /// What is left over of all forces with the weight; zero in equilibrium. Each cut would have it
    /// between its two sides. The moment is about the middle of the piece's bounds.
    SideForce imbalance;
    double imbalanceShare = 0.0; // of its largest force, or moment: for a verdict
};

/// Stresses on all samples.
///
/// `forces` with the weight are in equilibrium; if they are not, that is reported and the plus
/// side's are taken, not a mean of both (which would hide it). Forces that are no numbers
/// count as none, and it is then not worked out.
/// O(forces + samples · (log forces + forces near the cut)), and some cuts more for what is
/// refined.
SectionStress stressOf(const SectionCuts &cuts, const CutShares &shares,
                       const std::vector<AppliedForce> &forces, const SheetMaterial &sheet,
                       const StressOptions &options = {});
SectionStress stressOf(const SectionCuts &cuts, const std::vector<AppliedForce> &forces,
                       const SheetMaterial &sheet, const StressOptions &options = {});

/// The same on a given line: of the stretch of material on it that contains the middle between p0
/// and p1. Nothing if that is not in the material, or for what no sheet is made of.
std::optional<NeckStress> stressOnLine(const PieceShape &shape,
                                       const std::vector<AppliedForce> &forces,
                                       const SheetMaterial &sheet, const Vec2 &p0, const Vec2 &p1,
                                       const NotchRule &notch = {});

} // namespace fff
