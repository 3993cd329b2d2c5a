// Which pieces the slits of a joint hold together, and where a slit holds nothing. All that speaks
// of what is connected asks here, so that it speaks of the pieces that are cut.
#pragma once

#include "core/assembly/assembly.h"
#include "core/assembly/body.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// Over so much of its depth, mm, a slit has to have what is in it between two walls of one piece,
/// or it does not hold it: less is a notch that lets it turn out, and no more than a kerf or a
/// burr.
inline constexpr double kGripDepth = 0.5;
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
    Shallow,    // it holds, but over less than kGripDepth
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
    Vec2 missing = Vec2::Zero(); // OneWall: unit, frame coordinates, to where no wall is
    bool operator==(const LooseSlit &other) const
    {
        return why == other.why && isInA == other.isInA && slit == other.slit &&
               depth == other.depth && missing == other.missing;
    }
};

struct JointGrips
{
    std::vector<Grip> held;         // pairs of pieces that hold each other, by (a, b)
    std::optional<LooseSlit> loose; // where there are none: why
};

/// What the slits of a joint hold.
///
/// A slit of one section grips a piece of the other over the depth, along the joint's axis, at
/// which that piece has material on the axis while one and the same piece of its own section stands
/// kGripWall beside both of its walls. The walls of an oblique slit touch the other section beside
/// the axis only, with an edge each, half the width of its own slit away: there it has to have
/// material, too, but for what kGripPlay allows. Two pieces hold each other where each grips the
/// other so over kGripDepth, all slits of the joint together: then each keeps the other from moving
/// along its own normal and from turning, and the bottoms of the slits from one way of the axis. In
/// a mortise, and of tabs, the slit of the one section has walls all round, and is enough.
///
/// a, b       cuts of the joint's sections with these slits; frames, where they are
/// Source     what keeps a slit joint together is that each part stands in the other's slot: J.
///            McCrae et al. 2014, FlatFitFab, "slits"; the measure is ours.
JointGrips gripsOf(const Joint &joint, const std::vector<Slit> &slitsOfA,
                   const std::vector<Slit> &slitsOfB, const CutSection &a, const CutSection &b,
                   const Frame &frameOfA, const Frame &frameOfB);

/// Those of all joints of a model, by the joints' rows. Immutable; copies share what is the same.
class Grips
{
public:
    const JointGrips &of(const Joint &joint) const;

    /// What was found for another model.
    struct Before
    {
        const Assembly &assembly;
        const std::vector<CutSectionPointer> &cuts;
        const Grips &grips;
    };
    /// cuts    belong to the model, one a section
    /// before  with the places of the sections in that model (placesBefore()): joints beside which
    ///         their sections are cut as they were are not looked at again
    static Grips find(const Model &model, const Assembly &assembly,
                      const std::vector<CutSectionPointer> &cuts, const Before &before,
                      const std::optional<std::vector<int>> &places = std::nullopt);

private:
    struct Known
    {
        std::shared_ptr<const Crossing> crossing;
        JointGrips grips;
    };
    using KnownPointer = std::shared_ptr<const Known>;
    SharedRows<KnownPointer> m_rows;   // as the joints'
    std::vector<std::size_t> m_starts; // how many joints come before those of a row
};

/// The sections of these bodies (indices into the list, ascending), each once, ascending.
std::vector<int> sectionsOf(const Bodies &bodies, const std::vector<int> &group);

/// Bodies that joints hold together, as indices into the list; the group with the most sections
/// first, then the one with the most bodies, then by the first of them.
std::vector<std::vector<int>> heldGroups(const Bodies &bodies, const JointList &joints,
                                         const Grips &grips);

} // namespace fff
