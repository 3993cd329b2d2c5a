// A model: a document and what its operations make of it. All sections, drawn and generated, in one
// order: the drawn ones as in the document, then those of each operation.
#pragma once

#include "core/model/document.h"

namespace fff {

/// A section that an operation made. `section->id` is not valid: `ref` names it.
struct GeneratedSection
{
    SectionRef ref;
    SectionPointer section;
};

struct Evaluation
{
    std::vector<GeneratedSection> sections;
};

struct Model
{
    Document document;
    Evaluation evaluation;

    std::size_t sectionCount() const
    {
        return document.sections.size() + evaluation.sections.size();
    }
    const SectionPointer &section(std::size_t index) const;
    SectionRef ref(std::size_t index) const;
    /// Index of the section, or -1 when it does not exist now.
    int indexOf(const SectionRef &ref) const;
    /// Of sections by their indices.
    std::vector<SectionRef> refs(const std::vector<int> &sections) const;
    /// What the section is called; empty when it does not exist now.
    std::string nameOf(const SectionRef &ref) const;
    const Stock &stockOf(std::size_t index) const { return document.stockOf(*section(index)); }
    /// Mid-plane boxes of all sections together. Empty for an empty model.
    Box3 bounds() const;
};

} // namespace fff
