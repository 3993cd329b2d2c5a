// The values that whoever adjusts a model can set within bounds, and places in those bounds.
#pragma once

#include "core/model/model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fff {

/// A shown number with both ends, a shown choice or switch, of which something of the model is
/// made. One that is itself made of others is none: it is not set.
struct RangedValue
{
    ValueId id;
    std::string name;
    ValueKind kind = ValueKind::Length;
    /// mm, radians, kg or plain; of a choice and a switch, which one it is, from 0 on.
    double least = 0.0, most = 0.0;
    double step = 0.0;                // from the least on; 0: any number. Of counts, choices 1
    std::vector<std::string> choices; // of a choice

    bool isNumber() const { return kind != ValueKind::Choice && kind != ValueKind::Switch; }
    Worth worthAt(double at) const;
    /// What is typed for that.
    std::string typedAt(double at) const;
    /// The nearest that can be set: on a step, or a number that reads well.
    double settable(double at) const;
    /// Where the value is now; the least where it has no worth.
    double now(const Model &model) const;
};

/// By their names, whatever the order in which they are listed.
std::vector<RangedValue> rangedValues(const Model &model);

/// How many places are tried, and which: the same seed, the same places.
struct TrialExtent
{
    std::uint64_t seed = 1;
    std::size_t mostCorners = 64; // where there are more, so many of them are drawn
    std::size_t random = 50;
};

/// One number a value, in their order.
using TrialPlace = std::vector<double>;

struct TrialPlaces
{
    std::vector<TrialPlace> all; // each once, corners first
    std::size_t corners = 0;     // of them
    double allCorners = 0.0;     // that there are; a choice has all of its choices there
};

/// They hang on names and ranges alone.
TrialPlaces trialPlaces(const std::vector<RangedValue> &values, const TrialExtent &extent);

/// The model's document with the values set to that. Errors  what would be wrong there.
tl::expected<Document, Message>
placed(const Document &document, const std::vector<RangedValue> &values, const TrialPlace &place);

} // namespace fff
