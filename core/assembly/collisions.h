// What was found out about solids that move past each other, kept for as long as they stay the
// same where they may meet: who plans again after an edit asks mostly what has been asked before.
#pragma once

#include "core/assembly/prism_pair.h"
#include "core/base/tolerances.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace fff {

class Encounter;

/// Solids are named by their places in the list, directions by numbers from way(). Every answer is
/// the one that solid.h gives, whatever was asked before. Not for several threads at once.
class Collisions
{
public:
    /// How deep two solids (a < b) may be in each other, mm, where that is not kTouchingDepth: what
    /// is pressed into a slit.
    using Depths = std::map<std::pair<int, int>, double>;

    /// From now on about these, of which none may be null. What is known of pairs that were there
    /// before stays known, as far as it was of use since then; of a solid that has changed, where
    /// its pair does not meet the change. O(what is known).
    void use(std::vector<SolidPointer> solids, Depths depths = {});

    std::size_t size() const { return m_solids.size(); }
    const Solid &solid(int index) const { return *m_solids[static_cast<std::size_t>(index)]; }
    double depth(int a, int b) const { return m_depths.empty() ? kTouchingDepth : pressed(a, b); }

    /// A unit vector that something moves along.
    int way(const Vec3 &direction) { return m_ways.number(direction); }
    /// Where to a solid was moved before it goes that way, mm.
    int lift(const Vec3 &by) { return m_lifts.number(by); }
    static constexpr int kNotLifted = -1;

    bool comesFree(int a, int b, int way, int lift = kNotLifted);
    /// How far a comes along the way before it is in b, mm; endless: it comes free.
    double wayUntil(int a, int b, int way);
    /// How far a has to go until it is nowhere nearer to b than kNearParts, mm, from then on; 0
    /// when it is not on all the way.
    double wayToClear(int a, int b, int way, int lift = kNotLifted);
    /// As they are (overlap_depth.h); a < b.
    const std::optional<Interpenetration> &overlap(int a, int b);

    /// From now on these two may be that deep in each other, mm.
    void press(int a, int b, double depth);

    /// So near they still touch; beyond, a way is over. mm
    static constexpr double kNearParts = 0.02;

    /// What has been done since it was made.
    struct Work
    {
        std::size_t encounters = 0; // pairs of solids that were looked at
        std::size_t answers = 0;    // of these, so many whose prisms were not known
        std::size_t prismPairs = 0; // for these
    };
    const Work &work() const { return m_work; }

private:
    /// Numbers of vectors, by their very bits.
    class Numbers
    {
    public:
        int number(const Vec3 &vector);
        const Vec3 &vector(int number) const { return m_vectors.at(number); }
        bool isInUse(int number) const { return m_vectors.contains(number); }
        /// Forgets what nobody has asked for since this was called last.
        void forgetOld();

    private:
        struct Entry
        {
            int number = 0;
            bool isInUse = true;
        };
        std::map<std::array<double, 3>, Entry> m_numbers;
        std::unordered_map<int, Vec3> m_vectors;
        int m_next = 0;
    };
    /// A solid that stays the same one while it changes. Numbers are never given twice.
    struct Name
    {
        int number = 0;
        int version = 0; // of what it looks like
    };
    struct Question
    {
        int a = 0, b = 0, way = -1, lift = kNotLifted; // a and b: Name::number
        double depth = 0.0;
        bool operator==(const Question &) const = default;
    };
    struct Hash
    {
        std::size_t operator()(const Question &question) const;
    };
    template <typename Answer>
    struct Known
    {
        int versionA = -1, versionB = -1;       // that it was last found right for
        std::optional<std::uint64_t> signature; // Encounter::signature(); none: never the same
        Answer answer{};
    };
    template <typename Answer>
    using Answers = std::unordered_map<Question, Known<Answer>, Hash>;

    double pressed(int a, int b) const;
    void name(const std::vector<SolidPointer> &solids);
    Question question(int a, int b, int way, int lift) const;
    Vec3 liftedBy(int lift) const;
    std::pair<int, int> versions(int a, int b) const;
    bool haveMet(const Question &question, int a, int b);
    void keepMet(int a, int b, const PrismIndices &prisms);
    /// What is known, or else what `work` finds out of the encounter that `meet` makes.
    template <typename Answer, typename Meet, typename Find>
    const Answer &answer(Answers<Answer> &known, const Question &question, int a, int b,
                         const Meet &meet, const Find &find);

    std::vector<SolidPointer> m_solids;
    std::vector<Name> m_names; // of the solids
    int m_nextNumber = 0, m_nextVersion = 0;
    Depths m_depths;
    Numbers m_ways, m_lifts;
    Answers<bool> m_isFree;
    Answers<double> m_until, m_clear;
    Answers<std::optional<Interpenetration>> m_overlaps, m_measured; // m_measured: of whole ones
    /// Prisms of two solids (a < b) that met on some way, the last ones first. They are asked first
    /// when the two go another way: mostly the same ones hold them.
    std::map<std::pair<int, int>, std::vector<PrismIndices>> m_met;
    Work m_work;
};

} // namespace fff
