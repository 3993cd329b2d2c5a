#include "core/values/value_edits.h"

#include "core/base/letters.h"
#include "core/values/expression_words.h"
#include "core/values/presets.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace fff {

namespace {

std::size_t place(int index)
{
    return static_cast<std::size_t>(index);
}

Understood<void> checkFreeName(const Values &values, const Value &value)
{
    const int other = values.indexOf(value.name);
    if (other >= 0 && values.list[place(other)]->value.id != value.id)
        return misunderstood(expression_words::kNamedTwice, {0, value.name.size()},
                             {quoted(value.name, {0, value.name.size()})});
    return checkName(value.name);
}

ValuePointer renamed(const ValuePointer &known, const Renames &renames)
{
    Value value = known->value;
    value.typed = renamedIn(value.typed, value.kind, renames);
    if (const auto own = renames.find(known->folded); own != renames.end())
        value.name = own->second;
    return value == known->value ? known : makeValue(std::move(value));
}

} // namespace

Understood<Values> addedValue(Values values, Value value)
{
    assert(value.id.isValid() && values.indexOf(value.id) < 0 && "ids are never used again");
    if (const auto checked = checkFreeName(values, value); !checked)
        return tl::unexpected(checked.error());
    values.list.push_back(makeValue(std::move(value)));
    return values;
}

Understood<Values> changedValue(Values values, Value value)
{
    const int index = values.indexOf(value.id);
    if (index < 0)
        return misunderstood(expression_words::kNoSuchValue, {});
    ValuePointer &known = values.list[place(index)];
    if (known->value == value)
        return values;
    if (value.name != known->value.name)
        if (const auto checked = checkFreeName(values, value); !checked)
            return tl::unexpected(checked.error());
    const bool isOtherKind = value.kind != known->value.kind;
    const ValueId id = value.id;
    known = makeValue(std::move(value));
    if (isOtherKind)
        dropSettings(values, id);
    return values;
}

Understood<Values> typedValue(Values values, ValueId id, std::string typed, const Reading &reading)
{
    const Value *known = values.find(id);
    if (!known)
        return misunderstood(expression_words::kNoSuchValue, {});
    Value value = *known;
    value.typed = std::move(typed);
    value.reading = reading;
    return changedValue(std::move(values), std::move(value));
}

Understood<Values> renamedValue(Values values, ValueId id, const std::string &name)
{
    const Value *known = values.find(id);
    if (!known)
        return misunderstood(expression_words::kNoSuchValue, {});
    Value value = *known;
    value.name = name;
    if (const auto checked = checkFreeName(values, value); !checked)
        return tl::unexpected(checked.error());
    const Renames renames{{foldedName(known->name), name}};
    for (ValuePointer &each : values.list)
        each = renamed(each, renames);
    return values;
}

ValueRemoval removedValue(const Values &values, ValueId id, const EvaluatedValues &evaluated)
{
    ValueRemoval removal{values, {}};
    const int index = values.indexOf(id);
    if (index < 0)
        return removal;
    const std::string name = values.list[place(index)]->folded;
    const Names names = evaluated.names();
    for (ValuePointer &known : removal.values.list) {
        if (known->value.id == id || !known->typed)
            continue;
        const std::vector<std::string> &used = known->typed->names();
        if (std::find(used.begin(), used.end(), name) == used.end())
            continue;
        removal.users.push_back(known->value.id);
        Value value = known->value;
        value.typed = withoutName(*known->typed, name, names);
        if (value.typed != known->value.typed)
            known = makeValue(std::move(value));
    }
    removal.values.list.erase(removal.values.list.begin() + index);
    dropSettings(removal.values, id);
    return removal;
}

ValueMerge mergedValues(const Values &values, const Values &others, std::int64_t firstId)
{
    ValueMerge merge{values, {}, {}};
    std::set<std::string> taken, free;
    for (const ValuePointer &known : values.list)
        taken.insert(known->folded);
    // Names that stay are nobody else's, and no expression of the others means a new one by them.
    for (const ValuePointer &known : others.list) {
        free.insert(known->folded);
        if (known->typed)
            free.insert(known->typed->names().begin(), known->typed->names().end());
    }
    for (const ValuePointer &known : others.list) {
        if (!taken.contains(known->folded) && checkName(known->value.name))
            continue;
        const std::string name = freeName(known->value.name, [&](const std::string &folded) {
            return taken.contains(folded) || free.contains(folded);
        });
        taken.insert(foldedName(name));
        merge.renames.try_emplace(known->folded, name);
    }
    for (const ValuePointer &known : others.list) {
        Value value = renamed(known, merge.renames)->value;
        value.id = ValueId{firstId++};
        merge.ids[known->value.id] = value.id;
        merge.values.list.push_back(makeValue(std::move(value)));
    }
    mergePresets(merge.values, others, merge.ids);
    return merge;
}

} // namespace fff
