#include "core/analysis/bearing_probe.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr int kMostTries = 40; // at one place
/// Of a bracket, what a step at least takes off it.
constexpr double kLeastOfBracket = 0.02;
/// A guess is followed by no more than so many times as much.
constexpr double kFarthestStep = 20.0;

StrengthRules rigid(StrengthRules rules)
{
    rules.isElastic = false;
    return rules;
}

} // namespace

BearingProbe::BearingProbe(const Analysis &analysis, const StrengthRules &rules,
                           StrengthCaches &caches, const LongWork &work)
    : m_analysis(analysis), m_rules(rigid(rules)), m_caches(caches), m_work(work),
      m_made(structureOf(analysis))
{
    m_made.structure.loads.emplace_back();
    m_bare = tried(0.0, true);
    m_stands = m_bare.stands && m_bare.isSound;
}

Strength BearingProbe::forcesUnder(double mass) const
{
    ModelStructure made = m_made;
    made.structure.loads.back().force = mass * made.structure.gravity;
    return forcesIn(m_analysis, std::move(made), m_rules, m_caches, m_work);
}

BearingProbe::Tried BearingProbe::tried(double mass, bool withStress)
{
    Strength strength = forcesUnder(mass);
    Tried tried;
    tried.stands = strength.equilibrium().balance() == Balance::Stands;
    tried.isPulled = isPulledApart(strength.equilibrium());
    tried.isSound = strength.equilibrium().isSound;
    if (!tried.stands || !withStress)
        return tried;
    Straining(m_analysis, m_rules, m_caches, m_work).stressOfWorst(1.0, strength);
    tried.use = strength.cornerUse;
    if (strength.worst >= 0)
        tried.worst =
            weakPlaceOf(m_analysis, strength.worst,
                        *strength.bodies[static_cast<std::size_t>(strength.worst)].corner);
    return tried;
}

/// From which mass on it does not stand, to half of what is asked for.
double BearingProbe::fallsBetween(double stands, double falls, bool &isPulled)
{
    constexpr double kShareStood = 1e-3; // of what it falls under, while it stood under nothing
    for (int i = 0;
         i < kMostTries && falls - stands > 0.5 * kBorneAccuracy * falls && !m_work.isStopped();
         ++i) {
        // In the first steps nobody knows its size.
        const double middle = stands > 0.0 && falls < 4.0 * stands
                                  ? 0.5 * (stands + falls)
                                  : std::sqrt(std::max(stands, kShareStood * falls) * falls);
        const Tried at = tried(middle, false);
        (at.stands ? stands : falls) = middle;
        if (!at.stands)
            isPulled = at.isPulled;
    }
    return stands;
}

Bearing BearingProbe::at(int body, const Vec2 &point, double guess)
{
    if (!m_stands)
        return {};
    MemberLoad &load = m_made.structure.loads.back();
    load.member = body;
    load.point = m_analysis.bodies.at(body).frame().toWorld(point);
    if (m_bare.use >= 1.0)
        return {0.0, BearingEnd::Cracks, m_bare.worst};

    double low = 0.0, high = 0.0; // of masses under which it holds, and does not; 0: none known
    double useAtLow = m_bare.use, useAtHigh = 0.0;
    bool isFall = false, isPulled = false;
    Tried last = m_bare, broken;
    double mass = std::min(guess, kMostBorne);
    for (int i = 0; i < kMostTries && !m_work.isStopped(); ++i) {
        Tried at = tried(mass, true);
        if (!at.isSound)
            return {};
        if (!at.stands) {
            isPulled = at.isPulled;
            // Under what it still stands it may have cracked already.
            high = fallsBetween(low, mass, isPulled);
            isFall = true;
            if (high <= low * (1.0 + kBorneAccuracy))
                break;
            mass = high;
            at = tried(mass, true);
            if (!at.stands)
                return {}; // on the very edge
            if (at.use < 1.0)
                break;
        }
        if (at.use >= 1.0) {
            high = mass;
            useAtHigh = at.use;
            isFall = false;
            broken = std::move(at);
            if (useAtHigh - 1.0 < 0.25 * kBorneAccuracy)
                break;
        } else {
            low = mass;
            useAtLow = at.use;
            last = std::move(at);
            if (mass >= kMostBorne)
                return {kMostBorne, BearingEnd::BearsAll, {}};
        }
        if (high > 0.0 && high - low <= 0.5 * kBorneAccuracy * high)
            break;
        // Nearly linear: where the line through what is known comes to 1, or a little beyond.
        if (high > 0.0) {
            const double share = (1.0 - useAtLow) / (useAtHigh - useAtLow);
            mass = low + std::clamp(share * (1.0 + (i % 2 == 0 ? kBorneAccuracy : -kBorneAccuracy)),
                                    kLeastOfBracket, 1.0 - kLeastOfBracket) *
                             (high - low);
        } else {
            const double rise = useAtLow - m_bare.use;
            const double line = rise > 0.0 ? low * (1.0 - m_bare.use) / rise : kMostBorne;
            mass = std::min(
                {kMostBorne, kFarthestStep * low,
                 std::max((1.0 + 0.25 * kBorneAccuracy) * line, (1.0 + kBorneAccuracy) * low)});
        }
    }
    if (isFall)
        return {high, isPulled ? BearingEnd::PullsOut : BearingEnd::Falls, {}};
    if (!(high > 0.0))
        return {};
    return {high, BearingEnd::Cracks, broken.worst ? broken.worst : last.worst};
}

} // namespace fff
