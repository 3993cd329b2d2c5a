// Values with names, of which a design is made: 40 mm, or what other values make of them.
#pragma once

#include "core/base/ids.h"
#include "core/values/typed.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

using ValueId = Id<struct ValueTag>;

/// mm, radians, kg or plain, as the kind is. Steps are counted from the least.
struct ValueRange
{
    std::optional<double> least, most, step;

    bool operator==(const ValueRange &) const = default;
};

struct Value
{
    ValueId id;
    std::string name; // checkName(); no two alike but for capitals
    ValueKind kind = ValueKind::Length;
    std::string typed; // a number or an expression, as it was typed
    Reading reading;
    ValueRange range;                 // of numbers
    std::vector<std::string> choices; // of ValueKind::Choice
    std::string note;
    std::string group;    // the heading that it stands under; empty: none
    bool isShown = false; // to whoever adjusts the design

    bool operator==(const Value &) const = default;
};

/// A value and what is known of it alone.
struct KnownValue
{
    Value value;
    std::string folded;      // the name
    Understood<Typed> typed; // or what cannot be read
};
using ValuePointer = std::shared_ptr<const KnownValue>;

/// Reads what was typed, once.
ValuePointer makeValue(Value value);

/// What is typed for a value when a preset is chosen: a number, a text or a choice, of no names.
struct Setting
{
    ValueId value;
    std::string typed;
    Reading reading;

    bool operator==(const Setting &) const = default;
};

/// A set of settings with a name, such as "A5"; edits are in presets.h.
struct Preset
{
    std::string name;
    std::vector<Setting> settings; // ascending by value, each once; not empty

    bool operator==(const Preset &) const = default;
};
using PresetPointer = std::shared_ptr<const Preset>;

/// As they are listed; the order says nothing about what is made of what. A value itself, cheap to
/// copy; edits are in value_edits.h.
struct Values
{
    std::vector<ValuePointer> list;
    std::vector<PresetPointer> presets; // no two names alike but for capitals

    /// In the list, or -1. O(values)
    int indexOf(ValueId id) const;
    int indexOf(std::string_view name) const;
    /// Null: there is none.
    const Value *find(ValueId id) const;
    const Value *find(std::string_view name) const;

    /// The same objects.
    bool isSame(const Values &other) const
    {
        return list == other.list && presets == other.presets;
    }
    /// The same values.
    bool operator==(const Values &other) const;
};

/// One sentence with the value's name before it.
Message sentenceOf(const Value &value, const ExpressionError &error);

} // namespace fff
