// How much a model bears at one place of one of its bodies, and what ends it.
#pragma once

#include "core/analysis/straining.h"
#include "core/analysis/weak_place.h"

#include <optional>

namespace fff {

enum class BearingEnd {
    Cracks,   // a corner or a neck reaches what its sheet bears, without the safety factor
    Falls,    // it topples, slides, or moves within itself
    PullsOut, // a joint is pulled open, and what hangs on it moves
    BearsAll, // more than kMostBorne
    NotWorkedOut,
};

/// Of one place.
struct Bearing
{
    double mass = 0.0; // kg, besides all that hangs on the model already
    BearingEnd end = BearingEnd::NotWorkedOut;
    std::optional<WeakPlace> cracks; // where, when it does
};

/// kg: nobody asks for more.
inline constexpr double kMostBorne = 1000.0;
/// Masses are exact to this share.
inline constexpr double kBorneAccuracy = 2e-3;

/// Tries masses, one after the other, at any place. The structure and its factors stay; they are
/// made anew where other feet press or other slits hold. Bodies are rigid.
class BearingProbe
{
public:
    /// All of these outlive it.
    BearingProbe(const Analysis &analysis, const StrengthRules &rules, StrengthCaches &caches,
                 const LongWork &work);

    /// Without another mass. Where it does not hold itself, nothing can be said of more.
    bool stands() const { return m_stands; }
    /// Nor where it breaks as it is.
    bool breaks() const { return m_stands && m_bare.use >= 1.0; }

    /// point  of the body, frame coordinates, mm
    /// guess  kg, above 0: about what it may be
    Bearing at(int body, const Vec2 &point, double guess);

private:
    /// With such a mass.
    struct Tried
    {
        bool stands = false, isPulled = false, isSound = true;
        double use = 0.0; // of the worst corner
        std::optional<WeakPlace> worst;
    };
    Strength forcesUnder(double mass) const;
    Tried tried(double mass, bool withStress);
    double fallsBetween(double stands, double falls, bool &isPulled);

    const Analysis &m_analysis;
    StrengthRules m_rules;
    StrengthCaches &m_caches;
    LongWork m_work;
    ModelStructure m_made; // the last load is the one that is tried
    Tried m_bare;
    bool m_stands = false;
};

} // namespace fff
