#include "core/model/sheet_edits.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

namespace fff {

namespace {

auto keyOf(const PinnedPlace &pin)
{
    return std::tie(pin.section, pin.body);
}

auto keyOf(const SectionTurning &one)
{
    return std::tie(one.section);
}

template <class Wish>
bool comesBefore(const Wish &a, const Wish &b)
{
    return keyOf(a) < keyOf(b);
}

/// In its place, or in place of the one that is there.
template <class Wish>
void putWish(std::vector<Wish> &all, const Wish &wish)
{
    const auto place = std::lower_bound(all.begin(), all.end(), wish, comesBefore<Wish>);
    if (place != all.end() && keyOf(*place) == keyOf(wish))
        *place = wish;
    else
        all.insert(place, wish);
}

template <class Wish>
void settleWishes(std::vector<Wish> &all)
{
    std::stable_sort(all.begin(), all.end(), comesBefore<Wish>);
    all.erase(std::unique(all.begin(), all.end(),
                          [](const Wish &a, const Wish &b) { return keyOf(a) == keyOf(b); }),
              all.end());
}

std::optional<Error> unknownSection(const Document &document, const SectionRef &section)
{
    if (!section.drawn.isValid() || document.find(section.drawn))
        return std::nullopt;
    const std::string id = std::to_string(section.drawn.value);
    return Error{ErrorCode::UnknownReference, id, {id}};
}

std::optional<Error> nonsenseOf(const PinnedPlace &place)
{
    const auto bad = [](const char *what, const std::string &found, const char *expected) {
        return Error{ErrorCode::BadValue, what, {found, expected}};
    };
    if (place.sheet < -kMostSpares || place.sheet >= kMostPinnedSheets)
        return bad("sheet", std::to_string(place.sheet), "the number of a sheet");
    if (place.body < 0 || place.body >= kMostPinnedBodies)
        return bad("body", std::to_string(place.body), "the number of a part");
    if (!(std::abs(place.turn.norm() - 1.0) <= kPinnedTurnError))
        return bad("turn", "", "an angle");
    if (!place.offset.allFinite() || place.offset.cwiseAbs().maxCoeff() > kMaxCoordinate)
        return bad("offset", "", "a place on the sheet");
    return std::nullopt;
}

} // namespace

const PinnedPlace *pinOf(const Document &document, const SectionRef &section, int body)
{
    PinnedPlace wanted;
    wanted.section = section;
    wanted.body = body;
    const auto found = std::lower_bound(document.pins.begin(), document.pins.end(), wanted,
                                        comesBefore<PinnedPlace>);
    return found != document.pins.end() && keyOf(*found) == keyOf(wanted) ? &*found : nullptr;
}

Result<Document> setPin(Document document, const PinnedPlace &place)
{
    if (auto why = unknownSection(document, place.section))
        return tl::unexpected(*std::move(why));
    if (auto why = nonsenseOf(place))
        return tl::unexpected(*std::move(why));
    putWish(document.pins, place);
    return document;
}

Document withoutPins(Document document, std::span<const SectionRef> sections)
{
    std::erase_if(document.pins, [&](const PinnedPlace &pin) {
        return std::find(sections.begin(), sections.end(), pin.section) != sections.end();
    });
    return document;
}

Result<Document> setTurning(Document document, const SectionRef &section,
                            std::optional<nest::Turning> turning)
{
    if (auto why = unknownSection(document, section))
        return tl::unexpected(*std::move(why));
    if (turning)
        putWish(document.turnings, {section, *turning});
    else
        std::erase_if(document.turnings,
                      [&](const SectionTurning &one) { return one.section == section; });
    return document;
}

std::optional<nest::Turning> turningOf(const Document &document, const Section &section)
{
    const auto wanted = [&](const SectionRef &ref) -> std::optional<nest::Turning> {
        const SectionTurning key{ref, {}};
        const auto found = std::lower_bound(document.turnings.begin(), document.turnings.end(), key,
                                            comesBefore<SectionTurning>);
        const bool isIt = found != document.turnings.end() && found->section == ref;
        return isIt ? std::optional(found->turning) : std::nullopt;
    };
    if (document.turnings.empty())
        return std::nullopt;
    if (const auto own = wanted(section.ref()))
        return own;
    for (const CopyOf *copy = section.copyOf ? &*section.copyOf : nullptr; copy;
         copy = copy->before.get())
        if (const auto before = wanted(copy->section))
            return before;
    return std::nullopt;
}

void forgetSheetWishes(Document &document, const std::function<bool(const SectionRef &)> &isGone)
{
    const auto isOfGone = [&](const auto &wish) { return isGone(wish.section); };
    std::erase_if(document.pins, isOfGone);
    std::erase_if(document.turnings, isOfGone);
}

void renameSheetWishes(Document &document,
                       const std::function<SectionRef(const SectionRef &)> &follow)
{
    for (PinnedPlace &pin : document.pins)
        pin.section = follow(pin.section);
    for (SectionTurning &one : document.turnings)
        one.section = follow(one.section);
    settleWishes(document.pins);
    settleWishes(document.turnings);
}

} // namespace fff
