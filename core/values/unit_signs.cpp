#include "core/values/unit_signs.h"

#include "core/base/letters.h"

namespace fff {

namespace {

constexpr double kInch = 25.4; // mm

constexpr UnitSign kUnitSigns[] = {
    {"mm", 1.0, kLengthPowers},
    {"cm", 10.0, kLengthPowers},
    {"m", 1000.0, kLengthPowers},
    {"in", kInch, kLengthPowers},
    {"inch", kInch, kLengthPowers},
    {"\"", kInch, kLengthPowers},
    {"ft", 12.0 * kInch, kLengthPowers},
    {"°", radians(1.0), kAnglePowers},
    {"deg", radians(1.0), kAnglePowers},
    {"rad", 1.0, kAnglePowers},
    {"kg", 1.0, kMassPowers},
    {"g", 1e-3, kMassPowers},
    {"oz", 0.028349523125, kMassPowers},
    {"lb", 0.45359237, kMassPowers},
    {"%", 0.01, {}},
};

} // namespace

std::span<const UnitSign> unitSigns()
{
    return kUnitSigns;
}

int findUnitSign(std::string_view piece)
{
    const std::string sign = foldedName(piece);
    for (std::size_t i = 0; i < std::size(kUnitSigns); ++i)
        if (kUnitSigns[i].sign == sign)
            return static_cast<int>(i);
    return -1;
}

} // namespace fff
