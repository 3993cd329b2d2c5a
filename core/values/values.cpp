#include "core/values/values.h"

#include "core/base/letters.h"

#include <algorithm>

namespace fff {

ValuePointer makeValue(Value value)
{
    Understood<Typed> typed = Typed::read(value.typed, value.kind, value.reading);
    std::string folded = foldedName(value.name);
    return std::make_shared<const KnownValue>(
        KnownValue{std::move(value), std::move(folded), std::move(typed)});
}

int Values::indexOf(ValueId id) const
{
    const auto found = std::find_if(list.begin(), list.end(), [id](const ValuePointer &known) {
        return known->value.id == id;
    });
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

int Values::indexOf(std::string_view name) const
{
    const std::string folded = foldedName(name);
    const auto found = std::find_if(list.begin(), list.end(), [&folded](const ValuePointer &known) {
        return known->folded == folded;
    });
    return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

const Value *Values::find(ValueId id) const
{
    const int index = indexOf(id);
    return index < 0 ? nullptr : &list[static_cast<std::size_t>(index)]->value;
}

const Value *Values::find(std::string_view name) const
{
    const int index = indexOf(name);
    return index < 0 ? nullptr : &list[static_cast<std::size_t>(index)]->value;
}

bool Values::operator==(const Values &other) const
{
    return std::equal(list.begin(), list.end(), other.list.begin(), other.list.end(),
                      [](const ValuePointer &a, const ValuePointer &b) {
                          return a == b || a->value == b->value;
                      }) &&
           std::equal(
               presets.begin(), presets.end(), other.presets.begin(), other.presets.end(),
               [](const PresetPointer &a, const PresetPointer &b) { return a == b || *a == *b; });
}

Message sentenceOf(const Value &value, const ExpressionError &error)
{
    return {{nullptr, "%1: %2"}, {Named{value.name}, error.message}};
}

} // namespace fff
