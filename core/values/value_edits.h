// Edits of values. What an expression comes to is not asked here: EvaluatedValues says it of what
// an edit gives, and whoever commits it may refuse that.
#pragma once

#include "core/values/evaluated_values.h"
#include "core/values/renaming.h"

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace fff {

/// At the end of the list. id  valid, of no other one. Errors  a name that is none or that another
/// value has.
Understood<Values> addedValue(Values values, Value value);
/// Of the same id. Others that have its name in them are not rewritten. The very values where
/// nothing changed. Errors  those of addedValue(), no such value.
Understood<Values> changedValue(Values values, Value value);
/// What was typed for it, and nothing else.
Understood<Values> typedValue(Values values, ValueId id, std::string typed, const Reading &reading);
/// Also in all that is made of it, whose texts stay as they were typed around the name. Texts
/// elsewhere: renamedIn() with the folded old name. Errors  those of changedValue().
Understood<Values> renamedValue(Values values, ValueId id, const std::string &name);

struct ValueRemoval
{
    Values values;
    std::vector<ValueId> users; // which are what they were, without that name; see withoutName()
};
/// evaluated  of these values. A user that has an error keeps its text. Values as they are where
/// there is no such one.
ValueRemoval removedValue(const Values &values, ValueId id, const EvaluatedValues &evaluated);

struct ValueMerge
{
    Values values;                  // the first ones as they are, the others behind them
    std::map<ValueId, ValueId> ids; // of the others, what they have now
    Renames renames;                // of the others, for their texts elsewhere (renamedIn())
};
/// Brings values of another model along, and its presets as far as they are of these. Of names that
/// clash the other's gets a number, in all of its texts, and so does one that is no good name; all
/// others stay.
///
/// firstId  this and those behind it are free
ValueMerge mergedValues(const Values &values, const Values &others, std::int64_t firstId);

} // namespace fff
