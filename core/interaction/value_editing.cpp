#include "core/interaction/value_editing.h"

#include "core/operations/driven.h"
#include "core/values/expression_words.h"
#include "core/values/presets.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace fff {

namespace {

//: %1 is the name of a value
constexpr Text kAddValue = FFF_TEXT("Step", "Add %1");
//: %1 is the name of a value
constexpr Text kSetValue = FFF_TEXT("Step", "Set %1");
//: %1 is the name a value had, %2 the one that it has now
constexpr Text kRenameValue = FFF_TEXT("Step", "Rename %1 to %2");
//: %1 is the name of a value
constexpr Text kDeleteValue = FFF_TEXT("Step", "Delete %1");
//: %1 is the name of a preset of values, such as A5
constexpr Text kKeepPreset = FFF_TEXT("Step", "Keep the preset %1");
//: %1 is the name of a preset of values, such as A5
constexpr Text kTakePreset = FFF_TEXT("Step", "Set to %1");
//: %1 is the name of a preset of values, such as A5
constexpr Text kDeletePreset = FFF_TEXT("Step", "Delete the preset %1");
constexpr Text kNoPresetName =
    FFF_TEXT("Hint", "A preset needs a name, without “=” and blanks at its ends.");
constexpr Text kNothingToKeep =
    FFF_TEXT("Hint", "Others can adjust no value yet, so there is nothing to keep.");
//: %1 is the name of a preset of values, such as A5
constexpr Text kPresetReplaced =
    FFF_TEXT("Hint", "“%1” is what is set now, in place of what it was.");
//: %1 is what somebody took for the name of a preset
constexpr Text kNoSuchPreset = FFF_TEXT("Hint", "There is no preset named “%1”.");
constexpr Text kHandOn = FFF_TEXT("Step", "Share for adjusting");
constexpr Text kHandedOn = FFF_TEXT(
    "Hint", "This is what others see. Save the file and give it to them; it opens like this.");
constexpr Text kEditDesign = FFF_TEXT("Step", "Edit the design");
//: %n numbers were made of a value that is removed
constexpr Text kNowNumbers =
    FFF_TEXT_OF_MANY("Hint", "%n that were made of it are plain numbers now.");
//: %n presets set nothing but a value that is removed
constexpr Text kPresetsGone =
    FFF_TEXT_OF_MANY("Hint", "%n presets that set nothing else are gone with it.");

tl::unexpected<Hint> refusedWith(Message why)
{
    Hint hint(std::move(why));
    hint.isRefusal = true;
    return tl::unexpected(std::move(hint));
}

SectionEdit checkedEdit(const Document &before, Understood<Document> next, Step step)
{
    if (!next)
        return refusedWith(next.error().message);
    if (std::optional<Message> wrong = newlyWrong(before, *next))
        return refusedWith(*std::move(wrong));
    return EditedSections{*std::move(next), std::move(step)};
}

Step stepAt(const Document &document, const DrivenPlace &place)
{
    return {kSetValue, {nameOf(document, place)}};
}

} // namespace

SectionEdit valueAdded(const Document &document, Value value)
{
    Step step{kAddValue, {Named{value.name}}};
    return checkedEdit(document, addValue(document, std::move(value)), std::move(step));
}

SectionEdit valueChanged(const Document &document, Value value, std::string merges)
{
    Step step{kSetValue, {Named{value.name}}};
    step.merges = std::move(merges);
    return checkedEdit(document, changeValue(document, std::move(value)), std::move(step));
}

SectionEdit valueRenamed(const Document &document, ValueId id, const std::string &name)
{
    const Value *known = document.values.find(id);
    Step step{kRenameValue, {Named{known ? known->name : std::string()}, Named{name}}};
    return checkedEdit(document, renameValue(document, id, name), std::move(step));
}

SectionEdit valueRemoved(const Document &document, ValueId id)
{
    const Value *known = document.values.find(id);
    if (!known)
        return refused(expression_words::kNoSuchValue);
    RemovedValue removed = removeValue(document, id);
    EditedSections edit{std::move(removed.document), {kDeleteValue, {Named{known->name}}}};
    const auto presets = [](const Document &of) {
        return static_cast<int>(of.values.presets.size());
    };
    if (const int gone = presets(document) - presets(edit.document); gone > 0)
        edit.note = Hint(Message{kPresetsGone, {}, gone});
    else if (removed.users > 0)
        edit.note = Hint(Message{kNowNumbers, {}, removed.users});
    return edit;
}

SectionEdit presetKept(const Document &document, const std::string &name)
{
    if (!isPresetName(name))
        return refused(kNoPresetName);
    Preset preset = takenPreset(document.values, name);
    if (preset.settings.empty())
        return refused(kNothingToKeep);
    EditedSections edit{document, {kKeepPreset, {Named{name}}}};
    if (findPreset(document.values, name))
        edit.note = Hint(Message{kPresetReplaced, {Named{name}}});
    edit.document.values = withPreset(document.values, std::move(preset));
    return edit;
}

SectionEdit presetTaken(const Document &document, const std::string &name)
{
    const Preset *preset = findPreset(document.values, name);
    if (!preset)
        return refused(kNoSuchPreset, {Named{name}});
    Document next = document;
    next.values = setByPreset(document.values, *preset);
    return checkedEdit(document, std::move(next), {kTakePreset, {Named{preset->name}}});
}

SectionEdit presetRemoved(const Document &document, const std::string &name)
{
    const Preset *preset = findPreset(document.values, name);
    if (!preset)
        return refused(kNoSuchPreset, {Named{name}});
    EditedSections edit{document, {kDeletePreset, {Named{preset->name}}}};
    edit.document.values = withoutPreset(document.values, name);
    return edit;
}

SectionEdit numberBound(const Document &document, const DrivenPlace &place, std::string typed,
                        const Reading &reading)
{
    auto next = bound(document, place, std::move(typed), reading);
    if (!next)
        return refusedWith(next.error());
    return EditedSections{*std::move(next), stepAt(document, place)};
}

SectionEdit numberReleased(const Document &document, const DrivenPlace &place)
{
    return EditedSections{withoutBinding(document, place), stepAt(document, place)};
}

SectionEdit handedOn(const Document &document, bool isHandedOn)
{
    EditedSections edit{document, {isHandedOn ? kHandOn : kEditDesign}};
    edit.document.opensForAdjusting = isHandedOn;
    if (isHandedOn)
        edit.note = Hint(kHandedOn);
    return edit;
}

bool hasShownValue(const Values &values)
{
    return std::any_of(values.list.begin(), values.list.end(),
                       [](const ValuePointer &known) { return known->value.isShown; });
}

std::string freeValueName(const Values &values, const std::string &wanted)
{
    std::string name = wanted;
    for (int number = 2; values.find(std::string_view(name)); ++number)
        name = wanted + std::to_string(number);
    return name;
}

} // namespace fff
