#include "core/values/formula.h"

#include <algorithm>

namespace fff {

bool Formula::means(const Formula &other) const
{
    const auto isSame = [](const FormulaNode &a, const FormulaNode &b) {
        return a.kind == b.kind && a.isFraction == b.isFraction && a.index == b.index &&
               a.number == b.number && a.firstChild == b.firstChild && a.childCount == b.childCount;
    };
    return m_names == other.m_names && m_texts == other.m_texts && m_children == other.m_children &&
           std::equal(m_nodes.begin(), m_nodes.end(), other.m_nodes.begin(), other.m_nodes.end(),
                      isSame);
}

} // namespace fff
