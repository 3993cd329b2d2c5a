#include "core/interaction/sheet_editing.h"

#include "core/model/edit_words.h"
#include "core/model/sheet_edits.h"
#include "core/model/step.h"

#include <algorithm>
#include <string>
#include <utility>

namespace fff {

namespace {

//: %1 is the name of a section: its part lies elsewhere on the sheet
constexpr Text kPlaceOnSheet = FFF_TEXT("Step", "Place %1 on its sheet");
//: %1 is the name of a section: its part stays where it lies on the sheet
constexpr CountedText kPinOnSheet{FFF_TEXT("Step", "Pin %1"),
                                  FFF_TEXT_OF_MANY("Step", "Pin %n parts")};
constexpr CountedText kUnpinOnSheet{FFF_TEXT("Step", "Unpin %1"),
                                    FFF_TEXT_OF_MANY("Step", "Unpin %n sections")};
constexpr Text kUnpinAll = FFF_TEXT("Step", "Unpin all parts");
//: how parts may be turned on their sheet; %1 is the name of a section
constexpr CountedText kTurnOnSheet{FFF_TEXT("Step", "Change rotation of %1"),
                                   FFF_TEXT_OF_MANY("Step", "Change rotation of %n sections")};

std::vector<std::string> namesOnSheets(const Model &model, std::span<const SectionRef> sections)
{
    std::vector<std::string> names;
    for (const SectionRef &section : sections)
        names.push_back(model.nameOf(section));
    return names;
}

SectionEdit editedSheets(Result<Document> next, Step step)
{
    if (!next)
        return refused(hints::kEditFailed);
    return EditedSections{*std::move(next), std::move(step)};
}

bool areAllThere(const Model &model, std::span<const SectionRef> sections)
{
    return std::all_of(sections.begin(), sections.end(),
                       [&](const SectionRef &one) { return model.find(one) != nullptr; });
}

std::string placeMergeKey(const PinnedPlace &place)
{
    return "sheet " + std::to_string(place.section.drawn.value) + ' ' +
           std::to_string(place.section.operation.value) + ' ' + place.section.key + ' ' +
           std::to_string(place.body);
}

} // namespace

SectionEdit placedOnSheet(const Model &model, const PinnedPlace &place, PlacingBy by)
{
    if (!model.find(place.section))
        return refused(hints::kEditFailed);
    Step step{kPlaceOnSheet, {Named{model.nameOf(place.section)}}};
    if (by == PlacingBy::Key)
        step.merges = placeMergeKey(place);
    return editedSheets(setPin(model.document, place), std::move(step));
}

SectionEdit pinnedOnSheets(const Model &model, const std::vector<PinnedPlace> &places)
{
    Result<Document> next = model.document;
    std::vector<SectionRef> sections;
    for (const PinnedPlace &place : places) {
        sections.push_back(place.section);
        if (next)
            next = setPin(*std::move(next), place);
    }
    if (places.empty() || !areAllThere(model, sections))
        return refused(hints::kEditFailed);
    return editedSheets(std::move(next), ofSections(kPinOnSheet, namesOnSheets(model, sections)));
}

SectionEdit unpinned(const Model &model, std::span<const SectionRef> sections)
{
    return editedSheets(withoutPins(model.document, sections),
                        ofSections(kUnpinOnSheet, namesOnSheets(model, sections)));
}

SectionEdit allUnpinned(const Model &model)
{
    Document next = model.document;
    next.pins.clear();
    return editedSheets(std::move(next), kUnpinAll);
}

SectionEdit turnedOnSheets(const Model &model, std::span<const SectionRef> sections,
                           std::optional<nest::Turning> turning)
{
    if (sections.empty() || !areAllThere(model, sections))
        return refused(hints::kEditFailed);
    Result<Document> next = model.document;
    for (const SectionRef &section : sections)
        if (next)
            next = setTurning(*std::move(next), section, turning);
    return editedSheets(std::move(next), ofSections(kTurnOnSheet, namesOnSheets(model, sections)));
}

} // namespace fff
