#include "core/analysis/narrowed_ranges.h"

#include "core/model/bindings.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace fff {

namespace {

/// What is left of the ranges. A choice has those that are not left out.
struct Box
{
    TrialPlace least, most;
    std::vector<std::set<double>> leftOut; // of choices

    bool contains(const TrialPlace &place) const
    {
        for (std::size_t i = 0; i < place.size(); ++i)
            if (place[i] < least[i] || place[i] > most[i] || leftOut[i].contains(place[i]))
                return false;
        return true;
    }
};

Box wholeBox(const std::vector<RangedValue> &values)
{
    Box box;
    for (const RangedValue &value : values) {
        box.least.push_back(value.least);
        box.most.push_back(value.most);
    }
    box.leftOut.resize(values.size());
    return box;
}

/// Share of the ranges that is left, of one value.
double shareOf(const RangedValue &value, const Box &box, std::size_t i)
{
    if (value.kind == ValueKind::Choice)
        return 1.0 - static_cast<double>(box.leftOut[i].size()) /
                         static_cast<double>(value.choices.size());
    return (box.most[i] - box.least[i]) / (value.most - value.least);
}

class BoxCutting
{
public:
    BoxCutting(const ValueTrials &trials, const TrialPlace &now)
        : m_values(trials.values), m_now(now)
    {
        for (const TriedPlace &place : trials.places)
            (place.holds() ? m_good : m_bad).push_back(place.at);
    }

    std::optional<Box> found() const
    {
        Box box = wholeBox(m_values);
        while (firstIn(m_bad, box)) {
            std::optional<Box> best;
            Score most;
            for (const TrialPlace &place : m_bad)
                if (box.contains(place))
                    for (std::size_t i = 0; i < m_values.size(); ++i)
                        tryCuts(box, i, place[i], best, most);
            if (!best)
                return std::nullopt;
            box = *std::move(best);
        }
        if (!firstIn(m_good, box))
            return std::nullopt;
        return box;
    }

    const TrialPlace *firstGood(const Box &box) const { return firstIn(m_good, box); }

private:
    using Score = std::tuple<bool, int, double>; // keeps `now`, places that hold, share

    static const TrialPlace *firstIn(const std::vector<TrialPlace> &places, const Box &box)
    {
        const auto found = std::find_if(places.begin(), places.end(), [&](const TrialPlace &place) {
            return box.contains(place);
        });
        return found == places.end() ? nullptr : &*found;
    }

    /// All that leave the number out.
    void tryCuts(const Box &box, std::size_t i, double bad, std::optional<Box> &best,
                 Score &most) const
    {
        if (m_values[i].kind == ValueKind::Switch)
            return; // it has no range
        if (m_values[i].kind == ValueKind::Choice) {
            Box cut = box;
            cut.leftOut[i].insert(bad);
            take(std::move(cut), i, best, most);
            return;
        }
        Box above = box, below = box;
        bool isAbove = false, isBelow = false;
        for (const TrialPlace &place : m_good) {
            if (!box.contains(place))
                continue;
            if (place[i] > bad) {
                above.least[i] = isAbove ? std::min(above.least[i], place[i]) : place[i];
                isAbove = true;
            } else if (place[i] < bad) {
                below.most[i] = isBelow ? std::max(below.most[i], place[i]) : place[i];
                isBelow = true;
            }
        }
        if (isAbove)
            take(std::move(above), i, best, most);
        if (isBelow)
            take(std::move(below), i, best, most);
    }

    void take(Box cut, std::size_t i, std::optional<Box> &best, Score &most) const
    {
        const auto kept = std::count_if(m_good.begin(), m_good.end(), [&](const TrialPlace &place) {
            return cut.contains(place);
        });
        const Score score{cut.contains(m_now), static_cast<int>(kept),
                          shareOf(m_values[i], cut, i)};
        if (kept == 0 || (best && score <= most))
            return;
        best = std::move(cut);
        most = score;
    }

    const std::vector<RangedValue> &m_values;
    const TrialPlace &m_now;
    std::vector<TrialPlace> m_good, m_bad;
};

} // namespace

std::optional<NarrowedRanges> narrowedRanges(const ValueTrials &trials, const TrialPlace &now)
{
    const BoxCutting cutting(trials, now);
    const std::optional<Box> box = cutting.found();
    if (!box)
        return std::nullopt;
    NarrowedRanges narrowed;
    if (!box->contains(now))
        narrowed.moves = *cutting.firstGood(*box);
    for (std::size_t i = 0; i < trials.values.size(); ++i) {
        NarrowedRange &range =
            narrowed.ranges.emplace_back(NarrowedRange{box->least[i], box->most[i], {}});
        for (std::size_t k = 0; k < trials.values[i].choices.size(); ++k)
            if (!box->leftOut[i].contains(static_cast<double>(k)))
                range.choices.push_back(trials.values[i].choices[k]);
    }
    return narrowed;
}

tl::expected<Document, Message> withRanges(const Document &document, const ValueTrials &trials,
                                           const NarrowedRanges &ranges)
{
    tl::expected<Document, Message> next = document;
    if (ranges.moves)
        next = placed(document, trials.values, *ranges.moves);
    for (std::size_t i = 0; next && i < trials.values.size(); ++i) {
        const RangedValue &ranged = trials.values[i];
        const NarrowedRange &range = ranges.ranges[i];
        const Value *known = next->values.find(ranged.id);
        if (!known || ranged.kind == ValueKind::Switch)
            continue;
        Value value = *known;
        if (ranged.kind == ValueKind::Choice)
            value.choices = range.choices;
        if (ranged.isNumber() && range.least != ranged.least)
            value.range.least = range.least;
        if (ranged.isNumber() && range.most != ranged.most)
            value.range.most = range.most;
        Understood<Document> changed = changeValue(*std::move(next), std::move(value));
        if (changed)
            next = *std::move(changed);
        else
            next = tl::unexpected(std::move(changed.error().message));
    }
    return next;
}

} // namespace fff
