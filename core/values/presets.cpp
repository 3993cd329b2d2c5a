#include "core/values/presets.h"

#include "core/base/letters.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fff {

namespace {

auto placeIn(const Values &values, std::string_view name)
{
    return std::find_if(values.presets.begin(), values.presets.end(),
                        [folded = foldedName(name)](const PresetPointer &preset) {
                            return foldedName(preset->name) == folded;
                        });
}

std::optional<Worth> worthOf(const Understood<Typed> &typed)
{
    const Names none = [](std::string_view) -> const Worth * { return nullptr; };
    if (!typed || !typed->isConstant())
        return std::nullopt;
    const Understood<Worth> worth = typed->worth(none);
    return worth ? std::optional(*worth) : std::nullopt;
}

/// Typed alike, or in another unit.
bool isSet(const Values &values, const Setting &setting)
{
    const int index = values.indexOf(setting.value);
    if (index < 0)
        return false;
    const KnownValue &known = *values.list[static_cast<std::size_t>(index)];
    if (known.value.typed == setting.typed && known.value.reading == setting.reading)
        return true;
    const std::optional<Worth> now = worthOf(known.typed);
    return now && now == worthOf(Typed::read(setting.typed, known.value.kind, setting.reading));
}

std::string freePresetName(const Values &values, const std::string &wanted)
{
    std::string name = wanted;
    for (int number = 2; findPreset(values, name); ++number)
        name = wanted + ' ' + std::to_string(number);
    return name;
}

} // namespace

bool isPresetName(std::string_view name)
{
    constexpr auto isBlankEnd = [](char c) { return c == ' ' || c == '\t' || c == '\n'; };
    return !name.empty() && name.find('=') == name.npos && !isBlankEnd(name.front()) &&
           !isBlankEnd(name.back());
}

const Preset *findPreset(const Values &values, std::string_view name)
{
    const auto found = placeIn(values, name);
    return found == values.presets.end() ? nullptr : found->get();
}

Preset takenPreset(const Values &values, std::string name)
{
    Preset preset{std::move(name), {}};
    for (const ValuePointer &known : values.list)
        if (known->value.isShown && known->typed && known->typed->isConstant())
            preset.settings.push_back({known->value.id, known->value.typed, known->value.reading});
    std::sort(preset.settings.begin(), preset.settings.end(),
              [](const Setting &a, const Setting &b) { return a.value < b.value; });
    return preset;
}

Values withPreset(Values values, Preset preset)
{
    const auto place = placeIn(values, preset.name) - values.presets.begin();
    auto pointer = std::make_shared<const Preset>(std::move(preset));
    if (place == std::ssize(values.presets))
        values.presets.push_back(std::move(pointer));
    else
        values.presets[static_cast<std::size_t>(place)] = std::move(pointer);
    return values;
}

Values withoutPreset(Values values, std::string_view name)
{
    if (const auto place = placeIn(values, name); place != values.presets.end())
        values.presets.erase(place);
    return values;
}

Values setByPreset(Values values, const Preset &preset)
{
    for (const Setting &setting : preset.settings) {
        const int index = values.indexOf(setting.value);
        if (index < 0 || isSet(values, setting))
            continue;
        ValuePointer &known = values.list[static_cast<std::size_t>(index)];
        Value value = known->value;
        value.typed = setting.typed;
        value.reading = setting.reading;
        known = makeValue(std::move(value));
    }
    return values;
}

const Preset *presetInUse(const Values &values)
{
    const auto isAsNow = [&values](const PresetPointer &preset) {
        return std::all_of(preset->settings.begin(), preset->settings.end(),
                           [&values](const Setting &one) { return isSet(values, one); });
    };
    const auto found = std::find_if(values.presets.begin(), values.presets.end(), isAsNow);
    return found == values.presets.end() ? nullptr : found->get();
}

void dropSettings(Values &values, ValueId id)
{
    const auto isOf = [id](const Setting &setting) { return setting.value == id; };
    for (PresetPointer &pointer : values.presets) {
        if (std::none_of(pointer->settings.begin(), pointer->settings.end(), isOf))
            continue;
        Preset next = *pointer;
        std::erase_if(next.settings, isOf);
        pointer = std::make_shared<const Preset>(std::move(next));
    }
    std::erase_if(values.presets,
                  [](const PresetPointer &preset) { return preset->settings.empty(); });
}

void mergePresets(Values &values, const Values &others, const std::map<ValueId, ValueId> &ids)
{
    for (const PresetPointer &pointer : others.presets) {
        Preset next{{}, {}};
        for (Setting setting : pointer->settings)
            if (const auto here = ids.find(setting.value); here != ids.end()) {
                setting.value = here->second;
                next.settings.push_back(std::move(setting));
            }
        if (next.settings.empty())
            continue;
        std::sort(next.settings.begin(), next.settings.end(),
                  [](const Setting &a, const Setting &b) { return a.value < b.value; });
        next.name = freePresetName(values, pointer->name);
        values.presets.push_back(std::make_shared<const Preset>(std::move(next)));
    }
}

} // namespace fff
