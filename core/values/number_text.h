// Numbers as texts: exact ones that are read as the same again, and rounded ones to be engraved.
#pragma once

#include "core/base/message.h"
#include "core/values/worth.h"

#include <string>

namespace fff {

/// With a point and as many digits as it takes to be read as the same number again.
std::string exactNumber(double value);

/// What is typed for a worth of that kind so that it is just that: "49.4 mm", "30 °", "7".
std::string exactText(const Worth &worth, ValueKind kind);

/// How results are written where people read them without the program: on a part.
struct NumberStyle
{
    double lengthUnit = 1.0; // mm
    std::string lengthSign = "mm";
    int digits = 2; // after the point, at most
    char point = '.';
};

/// "49.4 mm", "30°", "250 g", "1.2 kg"; texts as they are; "yes", "no".
std::string shownText(const Worth &worth, const NumberStyle &style = {});

/// The same as what stands in a message, in the units of whoever reads it.
Argument argumentOf(const Worth &worth);

} // namespace fff
