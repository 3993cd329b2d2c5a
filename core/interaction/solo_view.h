// One section alone while a tool works on it: others stand back, so that none hides it.
#pragma once

#include "core/interaction/view_state.h"

#include <utility>

namespace fff {

class SoloView
{
public:
    /// All but this one stand back.
    void begin(const SectionRef &section, ViewState &view)
    {
        m_own = {section};
        m_before = std::exchange(view.isolated, m_own);
    }
    /// As it was, unless somebody has isolated something else meanwhile.
    void end(ViewState &view)
    {
        if (!m_own.empty() && view.isolated == m_own)
            view.isolated = std::move(m_before);
        m_own.clear();
    }

private:
    std::set<SectionRef> m_own, m_before;
};

} // namespace fff
