#include "core/analysis/ranged_values.h"

#include "core/base/units.h"
#include "core/model/bindings.h"
#include "core/operations/driven.h"
#include "core/operations/seeded.h"
#include "core/values/number_text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace fff {

namespace {

/// Of a range: numbers in between need be told apart no finer.
constexpr double kFinestShare = 0.01;

constexpr double kDegreeDigits = 1e9; // finer than anybody types

double spokenUnit(ValueKind kind)
{
    return kind == ValueKind::Angle ? radians(1.0) : 1.0;
}

/// With as few digits as a hundredth of the range needs, so that it reads well.
double rounded(double at, double range)
{
    const double digits = -std::floor(std::log10(kFinestShare * range));
    const double scale = std::pow(10.0, std::abs(digits));
    return digits > 0.0 ? std::round(at * scale) / scale : std::round(at / scale) * scale;
}

std::optional<RangedValue> rangedNumber(const Value &value, RangedValue ranged)
{
    if (!value.range.least || !value.range.most)
        return std::nullopt;
    ranged.least = *value.range.least;
    ranged.most = *value.range.most;
    ranged.step = value.range.step.value_or(0.0);
    if (value.kind == ValueKind::Count) {
        ranged.least = std::ceil(ranged.least);
        ranged.step = std::max(1.0, std::round(ranged.step));
    }
    if (ranged.step > 0.0) // the most that can be set
        ranged.most =
            ranged.least +
            ranged.step * std::floor((ranged.most - ranged.least) / ranged.step + kSameNumber);
    if (!(ranged.least < ranged.most))
        return std::nullopt;
    return ranged;
}

std::optional<RangedValue> rangedValue(const KnownValue &known)
{
    const Value &value = known.value;
    if (!value.isShown || !known.typed || !known.typed->isConstant())
        return std::nullopt;
    RangedValue ranged{value.id, value.name, value.kind, 0.0, 1.0, 1.0, {}};
    switch (value.kind) {
    case ValueKind::Text:
        return std::nullopt;
    case ValueKind::Switch:
        return ranged;
    case ValueKind::Choice:
        ranged.choices = value.choices;
        ranged.most = static_cast<double>(value.choices.size()) - 1.0;
        return ranged.most > 0.0 ? std::optional(ranged) : std::nullopt;
    default:
        return rangedNumber(value, std::move(ranged));
    }
}

/// What a corner of the ranges may have of it: its ends, of a choice all.
std::vector<double> endsOf(const RangedValue &value)
{
    if (value.kind != ValueKind::Choice)
        return {value.settable(value.least), value.settable(value.most)};
    std::vector<double> ends;
    for (std::size_t i = 0; i < value.choices.size(); ++i)
        ends.push_back(static_cast<double>(i));
    return ends;
}

/// 0 … 1, below 1; of this value in this place, whatever other values there are.
double drawn(std::uint64_t seed, const char *what, std::size_t place, const RangedValue &value)
{
    Seeded numbers(seed, what + std::to_string(place) + '/' + value.name);
    return std::min(0.5 * (numbers.symmetric() + 1.0), std::nextafter(1.0, 0.0));
}

/// The corner of this number, counted as digits are, the last value the fastest.
TrialPlace cornerOf(const std::vector<std::vector<double>> &ends, std::size_t number)
{
    TrialPlace place(ends.size());
    for (std::size_t i = ends.size(); i-- > 0;) {
        place[i] = ends[i][number % ends[i].size()];
        number /= ends[i].size();
    }
    return place;
}

/// Besides the two where all values are least, or most.
TrialPlace drawnCorner(const std::vector<RangedValue> &values,
                       const std::vector<std::vector<double>> &ends, std::uint64_t seed,
                       std::size_t number)
{
    TrialPlace place;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto count = static_cast<double>(ends[i].size());
        place.push_back(number == 0   ? ends[i].front()
                        : number == 1 ? ends[i].back()
                                      : ends[i][static_cast<std::size_t>(
                                            count * drawn(seed, "corner ", number, values[i]))]);
    }
    return place;
}

TrialPlace drawnPlace(const std::vector<RangedValue> &values, std::uint64_t seed,
                      std::size_t number)
{
    TrialPlace place;
    for (const RangedValue &value : values) {
        const double share = drawn(seed, "place ", number, value);
        // Whole ones have the same chance each.
        const double count = std::round((value.most - value.least) / value.step) + 1.0;
        place.push_back(value.settable(value.step > 0.0
                                           ? value.least + value.step * std::floor(count * share)
                                           : value.least + (value.most - value.least) * share));
    }
    return place;
}

} // namespace

Worth RangedValue::worthAt(double at) const
{
    Worth worth;
    worth.number = at;
    if (kind == ValueKind::Choice) {
        worth.type = Worth::Type::Text;
        worth.text = choices[static_cast<std::size_t>(at)];
    } else if (kind == ValueKind::Switch) {
        worth.type = Worth::Type::Truth;
    } else {
        worth.powers = kind == ValueKind::Length  ? kLengthPowers
                       : kind == ValueKind::Angle ? kAnglePowers
                       : kind == ValueKind::Mass  ? kMassPowers
                                                  : Powers();
    }
    return worth;
}

std::string RangedValue::typedAt(double at) const
{
    // Degrees that read well are none in radians.
    if (kind == ValueKind::Angle)
        return exactNumber(std::round(degrees(at) * kDegreeDigits) / kDegreeDigits) + " °";
    return exactText(worthAt(at), kind);
}

double RangedValue::settable(double at) const
{
    if (!isNumber())
        return std::clamp(std::round(at), least, most);
    const double unit = spokenUnit(kind);
    const double spoken =
        step > 0.0 ? (least + step * std::round((at - least) / step)) / unit : at / unit;
    // A step is a multiple of what reads well, or is what somebody wants.
    const double near = step > 0.0 ? spoken : rounded(spoken, (most - least) / unit);
    return std::clamp(near * unit, least, most);
}

double RangedValue::now(const Model &model) const
{
    const Worth *worth = model.evaluation.values.worth(id);
    if (!worth)
        return least;
    if (kind != ValueKind::Choice)
        return worth->number;
    const auto found = std::find(choices.begin(), choices.end(), worth->text);
    return found == choices.end() ? 0.0 : static_cast<double>(found - choices.begin());
}

std::vector<RangedValue> rangedValues(const Model &model)
{
    std::vector<std::pair<std::string, RangedValue>> named;
    for (const ValuePointer &known : model.document.values.list) {
        std::optional<RangedValue> ranged = rangedValue(*known);
        if (ranged && !boundTo(model.document, model.evaluation.values, known->value.id).empty())
            named.emplace_back(known->folded, *std::move(ranged));
    }
    std::sort(named.begin(), named.end(),
              [](const auto &a, const auto &b) { return a.first < b.first; });
    std::vector<RangedValue> values;
    for (auto &[name, value] : named)
        values.push_back(std::move(value));
    return values;
}

TrialPlaces trialPlaces(const std::vector<RangedValue> &values, const TrialExtent &extent)
{
    TrialPlaces places;
    std::set<TrialPlace> known;
    const auto add = [&](TrialPlace place) {
        if (known.insert(place).second)
            places.all.push_back(std::move(place));
    };
    if (values.empty())
        return places;
    std::vector<std::vector<double>> ends;
    places.allCorners = 1.0;
    for (const RangedValue &value : values) {
        ends.push_back(endsOf(value));
        places.allCorners *= static_cast<double>(ends.back().size());
    }
    const bool areAll = places.allCorners <= static_cast<double>(extent.mostCorners);
    const std::size_t count =
        areAll ? static_cast<std::size_t>(places.allCorners) : extent.mostCorners;
    for (std::size_t i = 0; i < count; ++i)
        add(areAll ? cornerOf(ends, i) : drawnCorner(values, ends, extent.seed, i));
    places.corners = places.all.size();
    for (std::size_t i = 0; i < extent.random; ++i)
        add(drawnPlace(values, extent.seed, i));
    return places;
}

tl::expected<Document, Message>
placed(const Document &document, const std::vector<RangedValue> &values, const TrialPlace &place)
{
    Document next = document;
    for (std::size_t i = 0; i < values.size(); ++i) {
        Understood<Document> set =
            typeValue(std::move(next), values[i].id, values[i].typedAt(place[i]), Reading());
        if (!set)
            return tl::unexpected(std::move(set.error().message));
        next = *std::move(set);
    }
    // All are set first: what one makes wrong another may make right.
    if (std::optional<Message> wrong = newlyWrong(document, next))
        return tl::unexpected(*std::move(wrong));
    return next;
}

} // namespace fff
