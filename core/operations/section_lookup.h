// The sections that are there while operations work, one after the other.
#pragma once

#include "core/model/model.h"

#include <memory>
#include <optional>
#include <vector>

namespace fff {

/// Drawn sections and what operations made so far, as later ones changed them.
class SectionLookup
{
public:
    /// The document outlives it.
    explicit SectionLookup(const Document &document);

    /// Null when it is not there. O(log sections).
    SectionPointer find(const SectionRef &ref) const;
    /// All that are there, in the model's order.
    std::vector<SectionPointer> sections() const;

    /// What one more operation came to.
    void append(OperationResultPointer result);
    /// Null when it would be the document's sections.
    std::shared_ptr<const Listing> listing() const;

private:
    struct Block
    {
        OperationResultPointer result;
        std::size_t begin = 0; // of what it made, in m_sections
    };
    std::optional<std::size_t> placeOf(const SectionRef &ref) const;

    const Document &m_document;
    std::vector<SectionPointer> m_sections; // null: its place was taken
    std::vector<Block> m_blocks;
    bool m_isDocument = true;
};

} // namespace fff
