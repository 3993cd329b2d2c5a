#include "core/model/model.h"

#include "core/model/instance_key.h"

#include <algorithm>

namespace fff {

namespace {

/// In the order of the keys, in [begin, end) of the list. -1: not there.
int indexOfKey(const std::vector<SectionPointer> &sections, std::size_t begin, std::size_t end,
               const std::string &key)
{
    const auto from = sections.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = sections.begin() + static_cast<std::ptrdiff_t>(end);
    const auto it =
        std::lower_bound(from, to, key, [](const SectionPointer &s, const std::string &wanted) {
            return isKeyBefore(s->made.key, wanted);
        });
    return it != to && (*it)->made.key == key ? static_cast<int>(it - sections.begin()) : -1;
}

/// In the first ones of a list whose ids rise, or not, as a file may have them. -1: not there.
int indexOfDrawn(const std::vector<SectionPointer> &sections, std::size_t count, SectionId id)
{
    const auto end = sections.begin() + static_cast<std::ptrdiff_t>(count);
    auto it = std::lower_bound(sections.begin(), end, id,
                               [](const SectionPointer &s, SectionId i) { return s->id < i; });
    if (it == end || (*it)->id != id)
        it = std::find_if(sections.begin(), end,
                          [id](const SectionPointer &s) { return s->id == id; });
    return it == end ? -1 : static_cast<int>(it - sections.begin());
}

} // namespace

int indexOfKey(const std::vector<SectionPointer> &sections, const std::string &key)
{
    return indexOfKey(sections, 0, sections.size(), key);
}

int Model::indexOf(const SectionRef &ref) const
{
    if (!evaluation.listing)
        return ref.drawn.isValid() ? document.indexOf(ref.drawn) : -1;
    const Listing &listing = *evaluation.listing;
    if (ref.drawn.isValid())
        return indexOfDrawn(listing.sections, listing.drawn, ref.drawn);
    for (const Listing::Block &block : listing.blocks) {
        if (block.operation == ref.operation)
            return indexOfKey(listing.sections, block.begin, block.end, ref.key);
    }
    return -1;
}

const Section *Model::find(const SectionRef &ref) const
{
    const int index = indexOf(ref);
    return index < 0 ? nullptr : section(static_cast<std::size_t>(index)).get();
}

std::vector<SectionRef> Model::refs(const std::vector<int> &sections) const
{
    std::vector<SectionRef> refs;
    refs.reserve(sections.size());
    for (const int index : sections)
        refs.push_back(ref(static_cast<std::size_t>(index)));
    return refs;
}

std::string Model::nameOf(const SectionRef &ref) const
{
    const Section *section = find(ref);
    return section ? section->name : std::string();
}

const OperationResult *Model::resultOf(OperationId id) const
{
    for (const OperationResultPointer &result : evaluation.results)
        if (result->operation->id == id)
            return result.get();
    return nullptr;
}

Box3 Model::bounds() const
{
    Box3 box;
    // Of every vertex: a box round the box of a turned section would be much larger.
    for (std::size_t i = 0; i < sectionCount(); ++i)
        for (const Vec2 &p : section(i)->shape->region().outer)
            box.extend(section(i)->frame.toWorld(p));
    return box;
}

} // namespace fff
