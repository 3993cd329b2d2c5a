// A model: a document and what its operations make of it. All sections, drawn and generated, in one
// order: the drawn ones as in the document, then those of each operation.
#pragma once

#include "core/model/document.h"
#include "core/model/evaluation.h"

namespace fff {

struct Model
{
    Document document;
    Evaluation evaluation;

    /// All sections that are there: drawn ones, as operations changed them and without those whose
    /// place operations take, and what these make.
    const std::vector<SectionPointer> &sections() const
    {
        return evaluation.listing ? evaluation.listing->sections : document.sections;
    }
    std::size_t sectionCount() const { return sections().size(); }
    const SectionPointer &section(std::size_t index) const { return sections()[index]; }
    SectionRef ref(std::size_t index) const { return section(index)->ref(); }
    /// So many of the sections, the first ones, are drawn.
    std::size_t drawnCount() const
    {
        return evaluation.listing ? evaluation.listing->drawn : document.sections.size();
    }
    /// Index of the section, or -1 when it does not exist now. O(log sections).
    int indexOf(const SectionRef &ref) const;
    /// Null when it does not exist now.
    const Section *find(const SectionRef &ref) const;
    /// Of sections by their indices.
    std::vector<SectionRef> refs(const std::vector<int> &sections) const;
    /// What the section is called; empty when it does not exist now.
    std::string nameOf(const SectionRef &ref) const;
    const Stock &stockOf(std::size_t index) const { return document.stockOf(*section(index)); }
    /// What the operation came to; null when there is none of this id, or it is off.
    const OperationResult *resultOf(OperationId id) const;
    /// Mid-plane boxes of all sections together. Empty for an empty model.
    Box3 bounds() const;
};

} // namespace fff
