#include "core/operations/drivable.h"

#include "core/model/value_names.h"
#include "core/operations/driven_owner.h"

#include <algorithm>

namespace fff {

namespace {

/// In the order of DrivenPlace::Of.
const DrivenOwner *const kOwners[] = {&kDrivenStocks,  &kDrivenOperations, &kDrivenSections,
                                      &kDrivenFigures, &kDrivenLetterings, &kDrivenLoads,
                                      &kDrivenJoints,  &kDrivenDimensions};

const DrivenOwner &ownerOf(const DrivenPlace &place)
{
    return *kOwners[static_cast<std::size_t>(place.of)];
}

std::string keyOf(const SectionRef &ref)
{
    return ref.drawn.isValid() ? std::to_string(ref.drawn.value)
                               : std::to_string(ref.operation.value) + ':' + ref.key;
}

} // namespace

std::optional<DrivenNumber> drivenNumber(const Document &document, const DrivenPlace &place)
{
    return ownerOf(place).read(document, place);
}

Result<Document> withDrivenNumber(Document document, const DrivenPlace &place, const Worth &worth)
{
    const DrivenOwner &owner = ownerOf(place);
    if (!owner.read(document, place))
        return failure(ErrorCode::UnknownReference, keyOf(place), {keyOf(place)});
    return owner.write(std::move(document), place, worth);
}

std::vector<DrivenPlace> drivablePlaces(const Document &document)
{
    std::vector<DrivenPlace> places;
    for (const DrivenOwner *owner : kOwners)
        owner->list(document, places);
    std::sort(places.begin(), places.end());
    return places;
}

std::string keyOf(const DrivenPlace &place)
{
    std::string key(nameIn(kDrivenNames, place.of));
    if (place.of == DrivenPlace::Of::Joint)
        key += '/' + keyOf(place.a) + '/' + keyOf(place.b);
    else
        key += '/' + std::to_string(place.id);
    if (hasIndex(place.of))
        key += '/' + std::to_string(place.index);
    return key + '/' + place.field;
}

std::optional<DrivenPlace> placeOfKey(const Document &document, const std::string &key)
{
    const std::vector<DrivenPlace> places = drivablePlaces(document);
    const auto found = std::find_if(places.begin(), places.end(), [&key](const DrivenPlace &place) {
        return keyOf(place) == key;
    });
    return found == places.end() ? std::nullopt : std::optional(*found);
}

Message nameOf(const Document &document, const DrivenPlace &place)
{
    const std::optional<DrivenNumber> number = drivenNumber(document, place);
    const std::string name = ownerOf(place).name(document, place);
    return {{nullptr, "%1, %2"},
            {Named{name}, number ? Argument(number->label) : Argument(Named{place.field})}};
}

} // namespace fff
