// What the slits of one joint hold, and where a slit holds nothing.
#pragma once

#include "core/assembly/cut_section.h"
#include "core/assembly/joint.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// Over so much of its depth, mm, a slit has to have what is in it between two walls of one piece,
/// or it does not hold it: less is no more than a kerf or a burr.
inline constexpr double kLeastGripDepth = 0.5;
/// mm that cutting may take off between a wall and what it holds.
inline constexpr double kGripLoss = 0.05;
/// The same for what is `thickness` mm thick in a slit with so much play (mm, below 0: none), of
/// which more has to be in: tilted, a plate of thickness t that is in by d reaches at most
/// √(t² + d²) from wall to wall, and turns out where that is not more than the slit is wide, with
/// what cutting took off.
double gripDepth(double thickness, double play);
/// So far from its slit, mm, a wall has to have material; less burns away.
inline constexpr double kGripWall = 0.05;
/// By so much, mm, what is in a slit may move across it before a wall of an oblique slit stops it.
inline constexpr double kGripPlay = 0.1;

/// Two pieces, and over which depth each has the other between two walls of its slits.
struct Grip
{
    int a = 0, b = 0;            // pieces of the joint's a and b, as CutSection::parts() has them
    double inA = 0.0, inB = 0.0; // mm, of the slits in a, and of those in b

    bool operator==(const Grip &) const = default;
};

/// Why a slit holds nothing.
enum class NoGrip {
    OneWall,    // material stands on one of its sides only
    CutThrough, // what stands on its two sides are two pieces
    Shallow,    // it holds, but over less than gripDepth()
    NoWall,     // material stands on neither of its sides
    Empty,      // nothing of the other section is in it
};

/// A slit that holds nothing, in a joint that is held by no other slit of the same section.
struct LooseSlit
{
    NoGrip why = NoGrip::OneWall;
    bool isInA = true;           // whose it is
    int slit = 0;                // which of the joint's in that section
    double depth = 0.0;          // mm: of the larger of what its walls hold
    double needed = 0.0;         // mm: what would hold
    Vec2 missing = Vec2::Zero(); // OneWall: unit, frame coordinates, to where no wall is
    bool operator==(const LooseSlit &other) const
    {
        return why == other.why && isInA == other.isInA && slit == other.slit &&
               depth == other.depth && needed == other.needed && missing == other.missing;
    }
};

struct JointGrips
{
    std::vector<Grip> held;         // pairs of pieces that hold each other, by (a, b)
    std::optional<LooseSlit> loose; // where there are none: why
};

/// A section of a joint.
struct GripSide
{
    const std::vector<Slit> &slits;
    const CutSection &cut; // with these
    const Frame &frame;
    double thickness = 3.0; // mm
    double clearance = 0.0; // mm, of its slits
};

/// What the slits of a joint hold.
///
/// A slit of one section grips a piece of the other over the depth, along the joint's axis, at
/// which that piece has material on the axis while one and the same piece of its own section stands
/// kGripWall beside both of its walls. The walls of an oblique slit touch the other section beside
/// the axis only, with an edge each, half the width of its own slit away: there it has to have
/// material, too, but for what kGripPlay allows. Two pieces hold each other where each grips the
/// other so over gripDepth(), all slits of the joint together: then each keeps the other from
/// moving along its own normal and from turning, and the bottoms of the slits from one way of the
/// axis. In a mortise, and of tabs, the slit of the one section has walls all round, and is enough.
///
/// Source     what keeps a slit joint together is that each part stands in the other's slot: J.
///            McCrae et al. 2014, FlatFitFab, "slits"; the measure is ours.
///
/// Keeps its memory from one joint to the next. Not for several threads at once.
class GripFinder
{
public:
    GripFinder();
    ~GripFinder();
    GripFinder(const GripFinder &) = delete;
    GripFinder &operator=(const GripFinder &) = delete;

    JointGrips find(const Joint &joint, const GripSide &a, const GripSide &b);

private:
    struct Memory;
    std::unique_ptr<Memory> m_memory;
};

} // namespace fff
