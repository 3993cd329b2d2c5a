// What is selected, and how it comes back when Undo brings back what was deleted.
#pragma once

#include "core/model/model.h"

#include <vector>

namespace fff {

class Selection
{
public:
    const std::vector<SectionRef> &sections() const { return m_sections; }
    bool isEmpty() const { return m_sections.empty(); }
    void select(std::vector<SectionRef> sections)
    {
        if (sections != m_sections)
            m_before.clear();
        m_sections = std::move(sections);
    }

    /// Sections went or came. Those that went are not selected, but are again when they come back,
    /// if nobody has chosen something else meanwhile.
    void follow(const Model &model);
    /// Another document: ids of the one before name other sections.
    void forget() { m_before.clear(); }

private:
    std::vector<SectionRef> m_sections;
    std::vector<SectionRef> m_before, m_left; // before sections of it went, and what stayed
};

} // namespace fff
