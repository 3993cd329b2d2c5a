#include "core/analysis/bearable_mass.h"

#include "core/analysis/straining.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

namespace fff {

namespace {

constexpr double kMassAccuracy = 1e-4; // share of a mass that is looked for
constexpr double kLeastStep = 1e-3;    // share of the bracket that a step of it takes off
constexpr int kMostSteps = 40;         // of that search
/// Of the worst use, a share: bodies that have less are looked at again only where the search ends.
constexpr double kNearWorst = 0.5;
constexpr int kMostRounds = 8; // of searches; each adds a body that had been passed over

/// Where a use that rises reaches 1, as a factor on the weights; 0 when it has before any of them.
std::optional<double> scaleAtOne(const std::function<std::optional<double>(double)> &useAt)
{
    double low = 0.0, high = 1.0;
    std::optional<double> atLow = useAt(low), atHigh = useAt(high);
    if (!atLow || *atLow >= 1.0)
        return atLow ? std::optional(0.0) : std::nullopt;
    while (atHigh && *atHigh < 1.0) {
        if (high >= kMostScale)
            return {};
        low = high;
        atLow = atHigh;
        // Nearly linear: a little beyond where the line from here gets to 1.
        high =
            std::min(kMostScale, std::max(2.0 * high, *atHigh > 0.0 ? 1.05 * high / *atHigh : 0.0));
        atHigh = useAt(high);
    }
    if (!atHigh)
        return {}; // it does not stand under so much
    for (int i = 0; i < kMostSteps && high - low > kMassAccuracy * high; ++i) {
        const double share = (1.0 - *atLow) / (*atHigh - *atLow);
        // Where the line says, but never only at one end for ever.
        const double middle =
            low + std::clamp(i % 3 == 2 ? 0.5 : share, kLeastStep, 1.0 - kLeastStep) * (high - low);
        const auto at = useAt(middle);
        if (!at)
            return {};
        if (std::abs(*at - 1.0) < kMassAccuracy)
            return middle;
        (*at < 1.0 ? low : high) = middle;
        (*at < 1.0 ? atLow : atHigh) = at;
    }
    return 0.5 * (low + high);
}

class Search
{
public:
    Search(const Analysis &analysis, const Strength &strength, const StrengthRules &rules,
           StrengthCaches &caches, const LongWork &work)
        : m_straining(analysis, rules, caches, work), m_strength(strength),
          m_all(analysis.bodies.size())
    {
        std::iota(m_all.begin(), m_all.end(), 0);
        look(strength);
    }

    /// Where the larger of these uses is 1, and in which body.
    std::optional<std::pair<double, int>> find(double BodyStrength::*use)
    {
        for (int round = 0; round < kMostRounds; ++round) {
            const auto scale = scaleAtOne([&](double at) { return worstAt(at, use); });
            if (!scale)
                return {};
            // All bodies under so much: one that had been passed over may be worse.
            const auto strained = strainedBy(*scale, m_all);
            if (!strained)
                return {};
            const std::size_t before = m_looked.size();
            look(*strained);
            if (m_looked.size() == before || *scale == 0.0)
                return std::pair(*scale, worstOf(*strained, use));
            m_known.clear();
        }
        m_isLost = true;
        return {};
    }
    /// A search was given up.
    bool isLost() const { return m_isLost; }

    /// From which factor on it does not stand; nothing where it does under all.
    std::optional<std::pair<double, bool>> falls() const
    {
        double low = 1.0, high = kMostScale;
        if (balanceUnder(high).equilibrium().balance() == Balance::Stands)
            return {};
        for (int i = 0;
             i < kMostSteps && high - low > kMassAccuracy * high && !m_straining.isStopped(); ++i) {
            const double middle = std::sqrt(low * high);
            const bool stands = balanceUnder(middle).equilibrium().balance() == Balance::Stands;
            (stands ? low : high) = middle;
        }
        return std::pair(high, isPulledApart(balanceUnder(high).equilibrium()));
    }

private:
    Strength balanceUnder(double scale) const
    {
        Strength scaled;
        scaled.made = m_strength.made;
        m_straining.balance(scale, scaled);
        return scaled;
    }

    std::optional<Strength> strainedBy(double scale, std::span<const int> bodies) const
    {
        Strength scaled = balanceUnder(scale);
        if (scaled.equilibrium().balance() != Balance::Stands)
            return {};
        m_straining.stress(scale, bodies, scaled);
        return scaled;
    }

    std::optional<double> worstAt(double scale, double BodyStrength::*use)
    {
        if (m_straining.isStopped())
            return {};
        auto known = m_known.find(scale);
        if (known == m_known.end()) {
            const std::vector<int> looked(m_looked.begin(), m_looked.end());
            known = m_known.emplace(scale, strainedBy(scale, looked)).first;
        }
        if (!known->second)
            return {};
        const int body = worstOf(*known->second, use);
        return body < 0 ? 0.0 : known->second->bodies[static_cast<std::size_t>(body)].*use;
    }

    static int worstOf(const Strength &strained, double BodyStrength::*use)
    {
        int worst = -1;
        for (std::size_t i = 0; i < strained.bodies.size(); ++i)
            if (strained.bodies[i].*use >
                (worst < 0 ? 0.0 : strained.bodies[static_cast<std::size_t>(worst)].*use))
                worst = static_cast<int>(i);
        return worst;
    }

    /// From now on at those that are strained nearly as much as the worst.
    void look(const Strength &strained)
    {
        for (std::size_t i = 0; i < strained.bodies.size(); ++i) {
            const BodyStrength &body = strained.bodies[i];
            if ((body.neckUse > 0.0 && body.neckUse >= kNearWorst * strained.neckUse) ||
                (body.cornerUse > 0.0 && body.cornerUse >= kNearWorst * strained.cornerUse))
                m_looked.insert(static_cast<int>(i));
        }
    }

    Straining m_straining;
    const Strength &m_strength;
    std::vector<int> m_all;
    std::set<int> m_looked;
    bool m_isLost = false;
    std::map<double, std::optional<Strength>> m_known; // by the scale
};

} // namespace

double placedMass(const Structure &structure)
{
    double sum = 0.0; // N
    for (const MemberLoad &load : structure.loads)
        sum += load.force.norm();
    return sum / structure.gravity.norm();
}

BearableMass bearableMass(const Analysis &analysis, const Strength &strength,
                          const StrengthRules &rules, StrengthCaches &caches, const LongWork &work)
{
    const Structure &structure = strength.made.structure;
    const double placed = placedMass(structure);
    if (!(placed > 0.0) || strength.equilibrium().balance() != Balance::Stands)
        return {};
    Search search(analysis, strength, rules, caches, work);
    BearableMass bearable;
    if (const auto found = search.find(&BodyStrength::cornerUse)) {
        bearable.cracksFrom = found->first * placed;
        bearable.cracksIn = found->second;
    }
    if (const auto found = search.find(&BodyStrength::neckUse)) {
        bearable.breaksAt = found->first * placed;
        bearable.breaksIn = found->second;
    }
    if (!bearable.breaksAt) {
        if (const auto found = search.falls()) {
            bearable.fallsFrom = found->first * placed;
            bearable.isPulledOut = found->second;
        }
    }
    bearable.isFound = !search.isLost();
    return bearable;
}

} // namespace fff
