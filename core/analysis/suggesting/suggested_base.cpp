#include "core/analysis/suggesting/suggested_base.h"

#include "core/analysis/findings/standing.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

/// Of the height that is cut off at the ground, or filled up there.
constexpr double kGroundShares[] = {0.0,   0.004, 0.009, 0.015, 0.022, 0.031,
                                    0.042, 0.056, 0.075, 0.1,   0.14,  0.2};
/// What a base has to show more for being cut off at all, and for each share of the height.
constexpr double kLossOfAny = 0.05, kLossOfGround = 1.2;
constexpr std::size_t kFirsts = 14, kKept = 8, kAskedEach = 6;
/// How much further than it has to a base may be tilted: those that come move its centre of mass.
constexpr double kTiltToCome = 1.3;

struct BaseTry
{
    std::vector<std::size_t> cuts;
    double score = 0.0; // what they show
    SuggestedGround ground = {};

    /// As of two: more of them show more, but so they would after two.
    double worth() const { return 2.0 * score / static_cast<double>(cuts.size()); }
};

double lossOn(double share)
{
    return share > 0.0 ? kLossOfAny + kLossOfGround * share : 0.0;
}

class BaseSearch
{
public:
    BaseSearch(const std::deque<SuggestedCut> &cuts, const FormSamples &samples, double thickness,
               bool allowsWeak, const std::stop_token &stop)
        : m_cuts(cuts), m_samples(samples), m_thickness(thickness), m_allowsWeak(allowsWeak),
          m_stop(stop)
    {
        const ShownForm none(samples);
        for (std::size_t i = 0; i < cuts.size(); ++i)
            m_firsts.push_back({{i}, cuts[i].preference * none.gainOf(cuts[i].shown)});
        keepBest(m_firsts, kFirsts);
    }

    /// The best that stand on this ground, of as few cuts as do.
    std::vector<BaseTry> standingOn(double level, double filled)
    {
        std::vector<BaseTry> tries = m_firsts;
        for (std::size_t size = 2; size <= kMostInBase; ++size) {
            std::vector<BaseTry> standing, others;
            for (const BaseTry &one : tries)
                extend(one, level, filled, standing, others);
            for (const auto *all : {&standing, &others})
                for (const BaseTry &one : *all)
                    m_best = std::max(m_best, one.worth());
            keepBest(standing, kAskedEach);
            if (!standing.empty() || m_stop.stop_requested())
                return standing;
            keepBest(others, kKept);
            tries = std::move(others);
        }
        return {};
    }
    /// Of all that were looked at, whether they stand or not.
    double best() const { return m_best; }

    static void keepBest(std::vector<BaseTry> &tries, std::size_t count);

private:
    /// With each cut that fits and comes later or earlier in the list.
    void extend(const BaseTry &from, double level, double filled, std::vector<BaseTry> &standing,
                std::vector<BaseTry> &others) const
    {
        if (m_stop.stop_requested())
            return;
        SuggestedGroup group(m_thickness);
        ShownForm shown(m_samples);
        for (const std::size_t i : from.cuts) {
            group.add(m_cuts[i]);
            shown.add(m_cuts[i].shown);
        }
        for (std::size_t i = 0; i < m_cuts.size(); ++i) {
            const SuggestedGroup::Fit fit = group.fitOf(m_cuts[i]);
            if (fit != SuggestedGroup::Fit::Fits &&
                !(m_allowsWeak && fit == SuggestedGroup::Fit::Weak))
                continue;
            BaseTry next = from;
            next.cuts.push_back(i);
            next.score += m_cuts[i].preference * shown.gainOf(m_cuts[i].shown);
            const auto [stability, ground] = group.stoodWith(m_cuts[i], level, filled);
            next.ground = ground;
            const bool stands = stability.standing == Standing::Stands &&
                                stability.tipAngle > kTiltToCome * kSteadyTilt;
            (stands ? standing : others).push_back(std::move(next));
        }
    }

    const std::deque<SuggestedCut> &m_cuts;
    const FormSamples &m_samples;
    double m_thickness;
    bool m_allowsWeak;
    const std::stop_token &m_stop;
    std::vector<BaseTry> m_firsts;
    double m_best = 0.0;
};

void BaseSearch::keepBest(std::vector<BaseTry> &tries, std::size_t count)
{
    std::stable_sort(tries.begin(), tries.end(),
                     [](const BaseTry &a, const BaseTry &b) { return a.score > b.score; });
    // None in too many: what is wrong with one of its neighbours is wrong with the next.
    constexpr int kMostWithOne = 2;
    std::map<std::size_t, int> used;
    std::vector<BaseTry> kept;
    for (BaseTry &one : tries) {
        if (kept.size() == count)
            break;
        if (std::any_of(one.cuts.begin(), one.cuts.end(),
                        [&](std::size_t cut) { return used[cut] >= kMostWithOne; }))
            continue;
        for (const std::size_t cut : one.cuts)
            ++used[cut];
        kept.push_back(std::move(one));
    }
    tries = std::move(kept);
}

} // namespace

std::optional<SuggestedBase>
suggestedBase(const std::deque<SuggestedCut> &cuts, const FormSamples &samples, double thickness,
              double lowest, double height, bool allowsWeak,
              const std::function<bool(const SuggestedBase &)> &accepts,
              const std::stop_token &stop)
{
    BaseSearch search(cuts, samples, thickness, allowsWeak, stop);
    std::vector<BaseTry> found;
    double best = 0.0;
    for (const double share : kGroundShares) {
        // Deeper in the ground none can be better any more.
        if (stop.stop_requested() || (best > 0.0 && best > search.best() - lossOn(share)))
            break;
        const double sunk = std::min(share * height, kNearOutline * samples.meshSize());
        for (BaseTry &one : search.standingOn(lowest + sunk, share * height - sunk)) {
            one.score = one.worth() - lossOn(share);
            best = std::max(best, one.score);
            found.push_back(std::move(one));
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const BaseTry &a, const BaseTry &b) { return a.score > b.score; });
    for (const BaseTry &one : found) {
        if (stop.stop_requested())
            break;
        if (SuggestedBase base{one.cuts, one.ground}; accepts(base))
            return base;
    }
    return {};
}

} // namespace fff
