// What has numbers that can be driven: internal to drivable.cpp and the files driven_*.cpp.
#pragma once

#include "core/operations/drivable.h"

#include <string>
#include <vector>

namespace fff {

/// A kind of things with such numbers: the functions of drivable.h for places of it.
struct DrivenOwner
{
    std::optional<DrivenNumber> (*read)(const Document &document, const DrivenPlace &place);
    /// Of a place that can be read.
    Result<Document> (*write)(Document document, const DrivenPlace &place, const Worth &worth);
    void (*list)(const Document &document, std::vector<DrivenPlace> &places);
    /// What a person calls the thing.
    std::string (*name)(const Document &document, const DrivenPlace &place);
};

extern const DrivenOwner kDrivenStocks, kDrivenOperations, kDrivenSections, kDrivenFigures,
    kDrivenLetterings, kDrivenLoads, kDrivenJoints, kDrivenDimensions;

inline Worth worthOf(ValueKind kind, double number)
{
    Worth worth;
    worth.type = kind == ValueKind::Switch ? Worth::Type::Truth : Worth::Type::Number;
    worth.powers = kind == ValueKind::Length  ? kLengthPowers
                   : kind == ValueKind::Angle ? kAnglePowers
                   : kind == ValueKind::Mass  ? kMassPowers
                                              : Powers();
    worth.isBare = kind == ValueKind::Number;
    worth.number = number;
    return worth;
}
inline Worth worthOf(std::string text)
{
    Worth worth;
    worth.type = Worth::Type::Text;
    worth.text = std::move(text);
    return worth;
}

/// The line of a table that has this key; null: none.
template <class Fields>
auto fieldNamed(const Fields &fields, const std::string &key) -> decltype(&*std::begin(fields))
{
    for (const auto &field : fields)
        if (key == field.key)
            return &field;
    return nullptr;
}

} // namespace fff
