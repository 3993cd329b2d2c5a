// Suggested sections that stand together, and whether another one fits among them: a quick look, at
// what planning and checks would refuse anyway.
#pragma once

#include "core/analysis/suggesting/suggested_cut.h"
#include "core/analysis/suggesting/suggested_ground.h"
#include "core/assembly/stability.h"

#include <optional>
#include <vector>

namespace fff {

class SuggestedGroup
{
public:
    /// thickness  mm, of all sections
    explicit SuggestedGroup(double thickness) : m_thickness(thickness) {}

    enum class Fit {
        Fits,
        Weak,     // so near to an edge that little material stays beside a slit
        Loose,    // it crosses none of them
        InTheWay, // and stays so, whoever else comes
    };
    /// It is in the way where it lies along another one, crosses one at a slant or by less than a
    /// slit holds, runs near to a slit that is there, or would have to slide in two directions at
    /// once. O(sections · their vertices).
    Fit fitOf(const SuggestedCut &cut) const;
    /// The cut outlives the group.
    void add(const SuggestedCut &cut);

    std::size_t size() const { return m_members.size(); }
    struct Stood
    {
        Stability stability;
        SuggestedGround ground; // with feet in so wide a circle that it stands steadily
    };
    /// How it stands with one more, without looking at whether that fits, when all below `level`
    /// (world, mm) is cut off, and what comes no lower than `filled` mm above that is filled up
    /// where that helps.
    Stood stoodWith(const SuggestedCut &cut, double level, double filled) const;
    /// Whether it stands steadily with one more on ground that is known.
    bool isSteadyWith(const SuggestedCut &cut, const SuggestedGround &ground) const;

private:
    struct Segment
    {
        Vec3 from = Vec3::Zero(), to = Vec3::Zero(); // world, mm
    };
    struct Member
    {
        const SuggestedCut *cut = nullptr;
        Box3 box;
        std::vector<Segment> slits;
    };
    struct Crossed
    {
        std::size_t member = 0;
        Segment segment;
        Vec3 direction = Vec3::UnitX();
    };
    struct Crossings
    {
        std::vector<Crossed> all;
        bool isWeak = false;
    };
    /// Where it crosses others; none where it is in the way.
    std::optional<Crossings> crossed(const SuggestedCut &cut) const;
    bool crossOne(const SuggestedCut &cut, const Box3 &box, std::size_t member,
                  Crossings &found) const;
    bool liesAlong(const SuggestedCut &cut, const SuggestedCut &other) const;
    SuggestedGroup with(const SuggestedCut &cut) const;
    Vec3 centreOfMass() const;
    SuggestedGround groundAt(double level, double filled) const;
    Stability stability(const SuggestedGround &ground) const;

    double m_thickness;
    std::vector<Member> m_members;
};

} // namespace fff
