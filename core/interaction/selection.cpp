#include "core/interaction/selection.h"

#include <algorithm>
#include <utility>

namespace fff {

void Selection::follow(const Model &model)
{
    const auto isGone = [&](const SectionRef &ref) { return model.indexOf(ref) < 0; };
    if (!m_before.empty() && m_sections == m_left &&
        std::none_of(m_before.begin(), m_before.end(), isGone)) {
        m_sections = std::exchange(m_before, {});
        return;
    }
    if (std::none_of(m_sections.begin(), m_sections.end(), isGone))
        return;
    m_before = m_sections;
    std::erase_if(m_sections, isGone);
    m_left = m_sections;
}

} // namespace fff
