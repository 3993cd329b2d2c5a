#include "core/interaction/click_selection.h"

#include <algorithm>

namespace fff {

std::vector<SectionRef> ClickSelection::click(const Model &model, const std::vector<Hit> &hits,
                                              const Vec2 &position, double reach, bool adds,
                                              const std::vector<SectionRef> &before)
{
    const bool isSamePlace = m_place && (*m_place - position).norm() <= reach;
    m_place = position;
    if (hits.empty())
        return adds ? before : std::vector<SectionRef>();

    std::size_t taken = 0;
    for (std::size_t i = 0; isSamePlace && i < hits.size(); ++i) {
        if (model.ref(static_cast<std::size_t>(hits[i].section)) == m_taken)
            taken = (i + 1) % hits.size();
    }
    m_taken = model.ref(static_cast<std::size_t>(hits[taken].section));
    if (!adds)
        return {m_taken};
    std::vector<SectionRef> selection = before;
    if (std::find(selection.begin(), selection.end(), m_taken) == selection.end())
        selection.push_back(m_taken);
    return selection;
}

} // namespace fff
