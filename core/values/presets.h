// Settings of a design's values that have a name: "A5", "four shelves".
#pragma once

#include "core/values/evaluated_values.h"

#include <map>
#include <string>
#include <string_view>

namespace fff {

/// Whether one can say it on the command line: not empty, without "=" and blanks at its ends.
bool isPresetName(std::string_view name);
/// Null: there is none of that name, whatever its capitals.
const Preset *findPreset(const Values &values, std::string_view name);

/// What is set now of the values that are shown, but for those that are made of others. Without
/// settings where there are no such ones.
Preset takenPreset(const Values &values, std::string name);
/// In place of the one of its name, or behind the others. preset  has settings.
Values withPreset(Values values, Preset preset);
/// The values as they are where there is none of that name.
Values withoutPreset(Values values, std::string_view name);
/// Values that it does not know stay.
Values setByPreset(Values values, const Preset &preset);
/// The first of which all settings are as they are now, whatever way they were typed in; null:
/// none.
const Preset *presetInUse(const Values &values);

/// Without what a value was set to in them, which is gone or of another kind now. Presets that
/// have nothing else go, too.
void dropSettings(Values &values, ValueId id);
/// Behind the values' own ones, those of others: of names that clash with a number behind.
/// ids: what the others' values have here; settings of values that do not come along stay away.
void mergePresets(Values &values, const Values &others, const std::map<ValueId, ValueId> &ids);

} // namespace fff
