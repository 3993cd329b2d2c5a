// Two solids of which one moves past the other: what of them may come into each other, and what
// follows from that. Internal to assembly.
#pragma once

#include "core/assembly/prism_pair.h"

#include <cstdint>

namespace fff {

/// Whether these two meet on the way of an Encounter.
bool prismsMeet(const Solid &a, const Solid &b, const PrismIndices &prisms, const Vec3 &direction,
                double depth, const Vec3 &by);

/// Holds those prisms alone that may meet, so that it costs the work of the places where they do.
/// Both solids have to outlive it.
/// All answers follow from these prisms, to the last bit.
///
/// Depth is measured between prisms: the least that one of them would have to move to come free of
/// the other. A contact, and two faces that slide on each other, are none.
/// Source  separating axes of convex polytopes, each with the stretch of the way in which it does
///         not separate (C. Ericson 2005, Real-Time Collision Detection, 5.5.8).
class Encounter
{
public:
    /// a     moves along `direction` (unit) from where it is, or from `by` (mm) off there, on and
    /// on depth mm that one has to be in the other; below 0 it is enough to come as near as that
    Encounter(const Solid &a, const Solid &b, const Vec3 &direction, double depth,
              const Vec3 &by = Vec3::Zero());
    /// Both as they are.
    Encounter(const Solid &a, const Solid &b, double depth);

    /// Nothing of them may meet.
    bool isEmpty()
    {
        complete();
        return m_movers.empty() || m_others.empty();
    }
    /// All prisms that may meet are known. Who found two that do has not looked for the rest.
    bool isComplete() const { return m_isComplete; }
    /// Of the prisms: who has the same and asks the same gets the same answer.
    std::uint64_t signature();

    /// Where `a` is too deep in `b`: the first stretch of its way from 0 on, as far as the prism
    /// that it was found in tells. Nothing when it comes free of b.
    std::optional<Travel> first();
    /// Whether there is no such stretch. Faster than finding the first one.
    bool isFree() { return !meeting(); }
    /// Two that meet.
    std::optional<PrismIndices> meeting();
    /// How far a has to go until they are nowhere so near any more (mm, from then on); 0 when they
    /// are not on all the way.
    double wayToClear();
    /// Two prisms that are in each other deeper than the depth, and how deep.
    struct Meeting
    {
        PrismIndices prisms;
        double depth = 0.0; // mm
    };
    std::vector<Meeting> meetings();

    /// So many pairs of prisms were looked at.
    std::size_t pairsLookedAt() const { return m_pairCount; }

private:
    /// A prism that may meet the other solid, and how it is seen along the direction.
    struct Candidate
    {
        PairedPrism prism;
        std::size_t triangle = 0; // of its solid
        Extent u, v, along;
    };
    /// Of what the candidates of one solid take up, seen along the direction.
    struct Window
    {
        Extent u, v, along;
    };
    struct Axes
    {
        Vec3 along, u, v;
    };

    void findMovers();
    template <typename Visit>
    void findOthers(const Visit &visit);
    void complete();
    template <typename Visit>
    Travel forEachCandidate(const Solid &solid, const Vec3 &by, const Solid &other,
                            const Vec3 &otherBy, double sense, const Visit &visit) const;
    template <typename Rank, typename MayMatter, typename Meet>
    void forEachMeeting(const Rank &rank, const MayMatter &mayMatter, const Meet &meet);

    const Solid &m_a, &m_b;
    Vec3 m_by;
    Axes m_axes;
    double m_depth;
    Travel m_way;
    PrismPairs m_pairs;
    std::vector<Candidate> m_movers, m_others;
    Window m_window;          // in which the next ones are looked for
    bool m_isComplete = true; // as long as nothing of them may meet
    std::size_t m_pairCount = 0;
};

} // namespace fff
