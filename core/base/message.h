// What a person is told, without the words: a text and what stands in its places. Whoever shows it
// translates it (core/session/message_text.h).
#pragma once

#include "core/base/result.h"
#include "core/base/text.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace fff {

struct Argument;

struct Message
{
    Text text;
    std::vector<Argument> arguments; // of %1, %2, …
    std::optional<int> count = {};   // of %n

    bool isEmpty() const { return !text.source; }
};

bool operator==(const Message &a, const Message &b);

/// Two sentences.
inline constexpr Text kOneAfterOther{nullptr, "%1 %2"};

/// What a person called it: a section, an operation, a file.
struct Named
{
    std::string name;
    bool operator==(const Named &) const = default;
};
/// "Body, Fin and Tail"; of many only how many sections they are.
struct NamedSections
{
    std::vector<std::string> names;
    bool operator==(const NamedSections &) const = default;
};
/// A number as such, without a unit.
struct Decimal
{
    double value = 0.0;
    std::optional<int> digits = {}; // after the point; none: as few as say it exactly
    bool operator==(const Decimal &) const = default;
};
/// A quantity, written as the person wants it: in the units and with the digits of its kind.
struct Quantity
{
    enum class Kind {
        Length,  // mm
        Width,   // mm, of slits and tools: finer
        Mass,    // kg
        Force,   // N
        Angle,   // radians; whole degrees, rounded down: what is promised must hold
        Percent, // a share of 1
    };
    Kind kind = Kind::Length;
    double value = 0.0;
    bool operator==(const Quantity &) const = default;
};
/// Two lengths, mm.
struct WidthAndHeight
{
    double width = 0.0, height = 0.0;
    bool operator==(const WidthAndHeight &) const = default;
};

/// An Error stands for its sentence.
struct Argument : std::variant<int, Decimal, Named, NamedSections, Text, Message, Quantity,
                               WidthAndHeight, Error>
{
    using variant::variant;
};

inline Quantity lengthOf(double mm)
{
    return {Quantity::Kind::Length, mm};
}
inline Quantity widthOf(double mm)
{
    return {Quantity::Kind::Width, mm};
}
inline Quantity massOf(double kg)
{
    return {Quantity::Kind::Mass, kg};
}
inline Quantity forceOf(double newtons)
{
    return {Quantity::Kind::Force, newtons};
}
inline Quantity angleOf(double radians)
{
    return {Quantity::Kind::Angle, radians};
}
inline Quantity percentOf(double share)
{
    return {Quantity::Kind::Percent, share};
}

} // namespace fff
