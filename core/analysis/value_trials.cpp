#include "core/analysis/value_trials.h"

#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/stages.h"
#include "core/analysis/trial.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {

void judge(std::vector<Finding> found, TriedPlace &place)
{
    doubtVerdicts(found);
    place.worst.fill(Severity::Good);
    for (const Finding &finding : found) {
        Severity &worst = place.worst[static_cast<std::size_t>(finding.subject())];
        worst = std::max(worst, finding.severity);
        if (finding.severity < Severity::Error)
            continue;
        const Message title = titleOf(finding);
        if (std::find(place.faults.begin(), place.faults.end(), title) == place.faults.end())
            place.faults.push_back(title);
    }
}

} // namespace

std::size_t ValueTrials::failing() const
{
    return static_cast<std::size_t>(std::count_if(
        places.begin(), places.end(), [](const TriedPlace &place) { return !place.holds(); }));
}

std::vector<std::pair<Message, int>> ValueTrials::faults() const
{
    std::vector<std::pair<Message, int>> counted;
    const auto count = [&counted](const Message &title) {
        const auto known = std::find_if(counted.begin(), counted.end(),
                                        [&](const auto &one) { return one.first == title; });
        if (known == counted.end())
            counted.emplace_back(title, 1);
        else
            ++known->second;
    };
    for (const TriedPlace &place : places) {
        if (!place.wrong.isEmpty())
            count({kCannotBeMade, {}});
        for (const Message &fault : place.faults)
            count(fault);
    }
    std::stable_sort(counted.begin(), counted.end(),
                     [](const auto &a, const auto &b) { return a.second > b.second; });
    return counted;
}

std::vector<std::size_t> ValueTrials::worst() const
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!places[i].holds())
            found.push_back(i);
    const auto weight = [this](std::size_t i) {
        return places[i].wrong.isEmpty() ? places[i].faults.size()
                                         : static_cast<std::size_t>(Subject::Joints) + 1;
    };
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t a, std::size_t b) { return weight(a) > weight(b); });
    return found;
}

std::vector<std::pair<std::string, Worth>> worthsAt(const std::vector<RangedValue> &values,
                                                    const TrialPlace &place)
{
    std::vector<std::pair<std::string, Worth>> worths;
    for (std::size_t i = 0; i < values.size(); ++i)
        worths.emplace_back(values[i].name, values[i].worthAt(place[i]));
    return worths;
}

std::optional<ValueTrials> tryValues(const Model &model, const CheckRules &rules,
                                     const TrialExtent &extent, Progress &progress,
                                     std::stop_token stop)
{
    ValueTrials trials;
    trials.values = rangedValues(model);
    trials.extent = extent;
    const TrialPlaces places = trialPlaces(trials.values, extent);
    trials.corners = places.corners;
    trials.allCorners = places.allCorners;
    Trials judged(stages());
    Model before = model;
    for (const TrialPlace &at : places.all) {
        progress.set(static_cast<double>(trials.places.size()) /
                     static_cast<double>(places.all.size()));
        TriedPlace &place = trials.places.emplace_back();
        place.at = at;
        place.worst.fill(Severity::Unknown);
        tl::expected<Document, Message> document = placed(model.document, trials.values, at);
        if (!document) {
            place.wrong = std::move(document.error());
            continue;
        }
        before = evaluate(*std::move(document), before);
        const std::optional<Trials::Outcome> outcome = judged.of(before, rules, stop);
        if (stop.stop_requested())
            return std::nullopt;
        if (outcome)
            judge(outcome->findings, place);
    }
    return trials;
}

} // namespace fff
