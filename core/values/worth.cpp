#include "core/values/worth.h"

namespace fff {

namespace {

constexpr Text kPlainNumber = FFF_TEXT("Values", "a plain number");
constexpr Text kWholeNumber = FFF_TEXT("Values", "a whole number");
constexpr Text kLengthNoun = FFF_TEXT("Values", "a length");
constexpr Text kAreaNoun = FFF_TEXT("Values", "an area");
constexpr Text kVolumeNoun = FFF_TEXT("Values", "a volume");
constexpr Text kAngleNoun = FFF_TEXT("Values", "an angle");
constexpr Text kMassNoun = FFF_TEXT("Values", "a mass");
constexpr Text kTextNoun = FFF_TEXT("Values", "a text");
constexpr Text kTruthNoun = FFF_TEXT("Values", "a yes or no");
//: of what lengths, angles and masses are multiplied and divided to: “1/width” is …
constexpr Text kOtherNoun = FFF_TEXT("Values", "no length, angle, mass or plain number");

} // namespace

Text nounOf(const Worth &worth)
{
    if (worth.type != Worth::Type::Number)
        return worth.type == Worth::Type::Text ? kTextNoun : kTruthNoun;
    if (worth.powers.isNone())
        return kPlainNumber;
    if (worth.powers == kLengthPowers)
        return kLengthNoun;
    if (worth.powers == Powers{2, 0, 0})
        return kAreaNoun;
    if (worth.powers == Powers{3, 0, 0})
        return kVolumeNoun;
    if (worth.powers == kAnglePowers)
        return kAngleNoun;
    return worth.powers == kMassPowers ? kMassNoun : kOtherNoun;
}

Text nounOf(ValueKind kind)
{
    switch (kind) {
    case ValueKind::Number:
    case ValueKind::Ratio:
        return kPlainNumber;
    case ValueKind::Length:
        return kLengthNoun;
    case ValueKind::Angle:
        return kAngleNoun;
    case ValueKind::Count:
        return kWholeNumber;
    case ValueKind::Mass:
        return kMassNoun;
    case ValueKind::Text:
    case ValueKind::Choice:
        return kTextNoun;
    case ValueKind::Switch:
        return kTruthNoun;
    }
    return {}; // not reached: every kind is above
}

} // namespace fff
