#include "core/analysis/suggesting/suggested_base.h"

#include "core/analysis/findings/standing.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <queue>
#include <utility>

namespace fff {

namespace {

/// Of the height that is cut off at the ground, or filled up there.
constexpr double kGroundShares[] = {0.0,   0.004, 0.009, 0.015, 0.022, 0.031,
                                    0.042, 0.056, 0.075, 0.1,   0.14,  0.2};
/// What a base has to show more for being cut off at all, and for each share of the height.
constexpr double kLossOfAny = 0.05, kLossOfGround = 1.2;
constexpr std::size_t kFirsts = 14, kKept = 8, kAskedEach = 8;
/// Of so many bases is looked at what may follow them, so many sections in all.
constexpr std::size_t kLookedAhead = 16, kAhead = 14;
/// How much further than it has to a base may be tilted: those that come move its centre of mass.
constexpr double kTiltToCome = 1.3;

/// Of a plane's normal, upwards: what leans by less (20°) stands on the ground by itself.
constexpr double kLeaning = 0.3420201433256687;

struct BaseTry
{
    std::vector<std::size_t> cuts;
    double score = 0.0; // what they show
    SuggestedGround ground = {};
    double loss = 0.0; // for that

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
    /// begins with the best of all cuts, or of those that stand upright
    BaseSearch(const std::deque<SuggestedCut> &cuts, const FormSamples &samples, double thickness,
               bool allowsWeak, bool isUpright, const std::stop_token &stop)
        : m_cuts(cuts), m_samples(samples), m_thickness(thickness), m_allowsWeak(allowsWeak),
          m_stop(stop)
    {
        const ShownForm none(samples);
        for (std::size_t i = 0; i < cuts.size(); ++i)
            if (!isUpright || std::abs(cuts[i].frame.normal().y()) < kLeaning)
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
    /// What it shows together with those that may follow, so far as a quick look can tell.
    double shownAhead(const BaseTry &base) const;
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

double BaseSearch::shownAhead(const BaseTry &base) const
{
    SuggestedGroup group(m_thickness);
    ShownForm shown(m_samples);
    double all = 0.0;
    const auto take = [&](std::size_t cut) {
        all += shown.gainOf(m_cuts[cut].shown);
        group.add(m_cuts[cut]);
        shown.add(m_cuts[cut].shown);
    };
    for (const std::size_t cut : base.cuts)
        take(cut);
    using Bound = std::pair<double, std::size_t>; // at most what it shows
    std::priority_queue<Bound> open;
    for (std::size_t i = 0; i < m_cuts.size(); ++i)
        open.emplace(m_cuts[i].preference * shown.gainOf(m_cuts[i].shown), i);
    while (!open.empty() && group.size() < kAhead && !m_stop.stop_requested()) {
        const std::size_t cut = open.top().second;
        open.pop();
        const double gain = m_cuts[cut].preference * shown.gainOf(m_cuts[cut].shown);
        if (!open.empty() && gain < open.top().first)
            open.emplace(gain, cut);
        else if (group.fitOf(m_cuts[cut]) == SuggestedGroup::Fit::Fits &&
                 group.isSteadyWith(m_cuts[cut], base.ground))
            take(cut);
    }
    // What is preferred counts the same here, but a base that is askew to main faces less: many
    // that come are parallel to it.
    constexpr double kAskew = 0.9;
    for (const std::size_t cut : base.cuts)
        all *= std::min(1.0, m_cuts[cut].preference / kAskew);
    return all;
}

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

/// The best base of those that begin so.
std::optional<SuggestedBase> baseOf(BaseSearch search, double meshSize, double lowest,
                                    double height,
                                    const std::function<bool(const SuggestedBase &)> &accepts,
                                    const std::stop_token &stop)
{
    std::vector<BaseTry> found;
    double best = 0.0;
    for (const double share : kGroundShares) {
        // Deeper in the ground none can be better any more.
        if (stop.stop_requested() || (best > 0.0 && best > search.best() - lossOn(share)))
            break;
        const double sunk = std::min(share * height, kNearOutline * meshSize);
        for (BaseTry &one : search.standingOn(lowest + sunk, share * height - sunk)) {
            one.loss = lossOn(share);
            one.score = one.worth() - one.loss;
            best = std::max(best, one.score);
            found.push_back(std::move(one));
        }
    }
    const auto sort = [](auto from, auto to) {
        std::stable_sort(from, to,
                         [](const BaseTry &a, const BaseTry &b) { return a.score > b.score; });
    };
    sort(found.begin(), found.end());
    const auto looked =
        found.begin() + static_cast<std::ptrdiff_t>(std::min(found.size(), kLookedAhead));
    for (auto one = found.begin(); one != looked; ++one)
        one->score = search.shownAhead(*one) - one->loss;
    sort(found.begin(), looked);
    for (const BaseTry &one : found) {
        if (stop.stop_requested())
            break;
        if (SuggestedBase base{one.cuts, one.ground}; accepts(base))
            return base;
    }
    return {};
}

} // namespace

std::optional<SuggestedBase>
suggestedBase(const std::deque<SuggestedCut> &cuts, const FormSamples &samples, double thickness,
              double lowest, double height, bool allowsWeak,
              const std::function<bool(const SuggestedBase &)> &accepts,
              const std::stop_token &stop)
{
    // What shows most may all lean, along the flat faces of a stone, and nothing stands on it.
    for (const bool isUpright : {false, true})
        if (auto base = baseOf({cuts, samples, thickness, allowsWeak, isUpright, stop},
                               samples.meshSize(), lowest, height, accepts, stop))
            return base;
    return {};
}

} // namespace fff
