#include "core/interaction/click_selection.h"

#include <algorithm>

namespace fff {

void ClickSelection::click(const Model &model, const std::vector<Hit> &hits, const Vec2 &position,
                           double reach, bool adds, Selection &selection)
{
    const bool isSamePlace = m_place && (*m_place - position).norm() <= reach;
    m_place = position;
    if (hits.empty()) {
        if (!adds)
            selection.select({});
        return;
    }

    std::vector<Taken> all;
    for (const Hit &hit : hits) {
        const SectionRef section = model.ref(static_cast<std::size_t>(hit.section));
        const Taken operation{section.operation, {}};
        if (!adds && section.operation.isValid() &&
            std::find(all.begin(), all.end(), operation) == all.end())
            all.push_back(operation);
        all.push_back({{}, section});
    }
    std::size_t taken = 0;
    const auto last = std::find(all.begin(), all.end(), m_taken);
    if (isSamePlace && last != all.end())
        taken = static_cast<std::size_t>(last - all.begin() + 1) % all.size();
    else if (all[0].operation.isValid() && all[0].operation == operationInFocus(selection))
        taken = 1;
    m_taken = all[taken];
    if (m_taken.operation.isValid()) {
        selection.selectOperation(m_taken.operation);
        return;
    }
    std::vector<SectionRef> sections;
    if (adds)
        sections = selection.sections();
    if (std::find(sections.begin(), sections.end(), m_taken.section) == sections.end())
        sections.push_back(m_taken.section);
    selection.select(std::move(sections));
}

} // namespace fff
