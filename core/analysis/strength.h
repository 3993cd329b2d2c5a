// Whether a model holds: forces between its bodies, stresses within them, under what hangs on it.
#pragma once

#include "core/analysis/bending_bodies.h"
#include "core/analysis/strength_rules.h"
#include "core/physics/equilibrium.h"
#include "core/physics/section_stress.h"

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace fff {

enum class HoldVerdict {
    Holds,        // the worst corner times the safety factor is within what the sheet bears
    BarelyHolds,  // only the worst neck is
    Breaks,       // not even that
    PullsOut,     // a joint is pulled open, and what hangs on it moves
    Unstable,     // it does not stand, or moves within itself
    NotRated,     // nothing breaks of which that is known; of some sheet it is not
    NotWorkedOut, // forces or stresses could not be computed
};

/// Of one body, the worst of the envelope.
struct BodyStrength
{
    bool isWorkedOut = false;               // forces and stresses are there
    std::optional<double> strength;         // MPa, of its sheet; none: not rated
    std::optional<NeckStress> neck, corner; // the worst without and with the notch factor; none
                                            // where nothing strains it
    /// stress / strength; 0 where that is not known.
    double neckUse = 0.0, cornerUse = 0.0;
    bool isPinched = false;       // it hangs together by less than can be cut
    std::optional<Neck> thinnest; // the thinnest that parts it in two
    std::vector<NeckStress> lines; // all that are strained noticeably, of each the worst; where the
                                   // strength is known
};

struct Strength
{
    ModelStructure made;
    std::vector<Equilibrium> envelope;     // never empty; the first is that of the support as given
    bool standsUnpushed = false;           // it does not stand, but would without its pushes
    bool isElastic = false;                // these are of bodies that bend
    std::vector<int> stiff;                // bodies that should, but were taken for rigid
    bool isBendingLost = false;            // they should, but no forces were found that agree
    std::vector<BodyStrength> bodies;      // by their places in the list
    int worst = -1;                        // body, by cornerUse; −1: none is strained
    int worstNeck = -1;                    // body, by neckUse
    double neckUse = 0.0, cornerUse = 0.0; // the largest of all
    HoldVerdict verdict = HoldVerdict::NotWorkedOut;

    const Equilibrium &equilibrium() const { return envelope.front(); }
};

struct BentBody;
/// On which sides of the cuts of a body the forces on it act, as long as they act where they did.
struct KeptShares
{
    std::shared_ptr<const SectionCuts> cuts;
    std::vector<AppliedForce> forces; // where; how large they are has no part in it
    double thickness = 0.0;           // mm
    CutShares shares;
};

/// What stays the same from one model to the next. Not for several threads at once.
struct StrengthCaches
{
    std::map<BodyPointer, std::shared_ptr<const SectionCuts>> cuts;
    std::map<BodyPointer, std::shared_ptr<const KeptShares>> shares; // of no more bodies than cuts
    /// The last of those with these cuts: bodies that are alike share them, too.
    std::map<const SectionCuts *, std::shared_ptr<const KeptShares>> lastShares;
    /// The same by a hash of their shapes: bodies that are alike in their frames share them.
    std::unordered_multimap<std::size_t, std::shared_ptr<const SectionCuts>> alike;
    EquilibriumCache equilibria;
    BendingBodies::Cache bending;
    PlateMeshes meshes;
    std::map<BodyPointer, std::shared_ptr<const BentBody>> bent; // see bentModel()
};

/// The lower one of those that are known, of what lasts its share, MPa.
std::optional<double> strengthOf(const Stock &stock, const StrengthRules &rules = {});

/// work: bodies that bend take long; once it is stopped what comes back is of no use.
Strength strengthOf(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                    const LongWork &work = {});
/// The forces of a structure of the model, whatever acts on it.
Strength forcesIn(const Analysis &analysis, ModelStructure made, const StrengthRules &rules,
                  StrengthCaches &caches, const LongWork &work = {});
/// The two halves of it: forces without stresses or verdict, and these.
Strength forcesIn(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                  const LongWork &work = {});
void addStresses(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                 Strength &strength, const LongWork &work = {});

/// A joint of what does not stand is pulled open.
bool isPulledApart(const Equilibrium &equilibrium);

} // namespace fff
