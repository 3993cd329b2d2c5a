#include "core/operations/section_lookup.h"

#include "core/model/instance_key.h"

#include <algorithm>

namespace fff {

SectionLookup::SectionLookup(const Document &document)
    : m_document(document), m_sections(document.sections)
{
}

std::optional<std::size_t> SectionLookup::placeOf(const SectionRef &ref) const
{
    if (ref.drawn.isValid()) {
        const int index = m_document.indexOf(ref.drawn);
        return index < 0 ? std::nullopt : std::optional(static_cast<std::size_t>(index));
    }
    for (const Block &block : m_blocks) {
        if (block.result->operation->id != ref.operation)
            continue;
        const int index = indexOfKey(block.result->sections, ref.key);
        return index < 0 ? std::nullopt
                         : std::optional(block.begin + static_cast<std::size_t>(index));
    }
    return std::nullopt;
}

SectionPointer SectionLookup::find(const SectionRef &ref) const
{
    const std::optional<std::size_t> place = placeOf(ref);
    return place ? m_sections[*place] : nullptr;
}

std::vector<SectionPointer> SectionLookup::sections() const
{
    std::vector<SectionPointer> there;
    there.reserve(m_sections.size());
    std::copy_if(m_sections.begin(), m_sections.end(), std::back_inserter(there),
                 [](const SectionPointer &section) { return section != nullptr; });
    return there;
}

void SectionLookup::append(OperationResultPointer result)
{
    for (const auto &[ref, section] : result->changed) {
        if (const std::optional<std::size_t> place = placeOf(ref))
            m_sections[*place] = section;
        m_isDocument = false;
    }
    const std::size_t begin = m_sections.size();
    m_sections.insert(m_sections.end(), result->sections.begin(), result->sections.end());
    m_isDocument = m_isDocument && result->sections.empty();
    m_blocks.push_back({std::move(result), begin});
}

std::shared_ptr<const Listing> SectionLookup::listing() const
{
    if (m_isDocument)
        return nullptr;
    auto listing = std::make_shared<Listing>();
    listing->sections.reserve(m_sections.size());
    std::size_t next = 0;
    const auto take = [&](std::size_t end) {
        for (; next < end; ++next)
            if (m_sections[next])
                listing->sections.push_back(m_sections[next]);
    };
    take(m_document.sections.size());
    listing->drawn = listing->sections.size();
    for (const Block &block : m_blocks) {
        const std::size_t begin = listing->sections.size();
        take(block.begin + block.result->sections.size());
        listing->blocks.push_back({block.result->operation->id, begin, listing->sections.size()});
    }
    return listing;
}

} // namespace fff
