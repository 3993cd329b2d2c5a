// The one place where a Message becomes words.
#pragma once

#include "core/base/message.h"
#include "core/geometry/vector.h"

#include <QString>

#include <functional>

namespace fff {

/// How words say lengths and masses.
struct UnitWords
{
    std::function<QString(double millimetres)> length;    // "45.4 mm"
    std::function<QString(double millimetres)> width;     // "2.70 mm", of slits and tools
    std::function<QString(const Vec2 &millimetres)> size; // "420 × 297 mm"
    std::function<QString(double kilograms)> mass;        // "115.7 g"
};
/// Millimetres and grams, numbers as the locale writes them.
UnitWords metricUnits();

enum class NameStyle {
    Plain,
    Bold, // rich text: what a person called something stands out, and is escaped
};

/// In the person's language; empty for an empty message.
QString messageText(const Message &message, const UnitWords &units = metricUnits(),
                    NameStyle names = NameStyle::Plain);
QString messageText(const Text &text);
/// What stands in a place of a message.
QString argumentText(const Argument &argument, const UnitWords &units = metricUnits(),
                     NameStyle names = NameStyle::Plain);

} // namespace fff
