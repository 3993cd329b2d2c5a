// Two solids of which one moves past the other: what of them may come into each other, and what
// follows from that. Internal to assembly.
#pragma once

#include "core/assembly/solid.h"

#include <cstdint>

namespace fff {

/// Holds those prisms alone that may meet, so that it costs the work of the places where they do.
/// All answers follow from these prisms, to the last bit.
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
    bool isEmpty() const { return m_movers.empty() || m_others.empty(); }
    /// Of the prisms: who has the same and asks the same gets the same answer.
    std::uint64_t signature() const;

    /// See collisionAlong().
    std::optional<Travel> first();
    /// Whether there is no such stretch. Faster than finding the first one.
    bool isFree();
    /// How far a has to go until they are nowhere so near any more (mm, from then on); 0 when they
    /// are not on all the way.
    double wayToClear();
    /// See interpenetration().
    std::optional<Interpenetration> deepest();

    /// So many pairs of prisms were looked at.
    std::size_t pairsLookedAt() const { return m_pairs; }

private:
    /// A prism that may meet the other solid, and how it is seen along the direction.
    struct Candidate
    {
        std::array<Vec3, 3> corners;
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

    void findCandidates(const Solid &a, const Solid &b, const Vec3 &by);
    std::vector<Candidate> candidates(const Solid &solid, const Vec3 &by, const Solid &other,
                                      const Vec3 &otherBy, double sense, Window &window);
    template <typename MayMatter, typename Meet>
    void forEachMeeting(const MayMatter &mayMatter, const Meet &meet);

    Axes m_axes;
    double m_depth;
    Travel m_way;
    Vec3 m_normalA, m_normalB;
    double m_halfA, m_halfB;
    std::vector<Candidate> m_movers, m_others;
    std::size_t m_pairs = 0;
};

} // namespace fff
