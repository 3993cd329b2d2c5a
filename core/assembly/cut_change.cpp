#include "core/assembly/cut_change.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

bool cutsTheSame(const Slit &x, const Slit &y)
{
    return x.inner == y.inner && x.mouth == y.mouth && x.width == y.width && x.isOpen == y.isOpen &&
           x.role == y.role && (x.form == y.form || (x.form && y.form && *x.form == *y.form));
}

} // namespace

CutChange::CutChange(const CutSection &now, const std::vector<Slit> &slitsNow,
                     const CutSection &before, const std::vector<Slit> &slitsBefore)
    : m_slits(slitsNow)
{
    if (now.parts().size() != 1 || before.parts().size() != 1 || now.failure() ||
        before.failure() || now.waste() != before.waste())
        return;
    m_isEverywhere = false;
    m_isChanged.assign(slitsNow.size(), char(false));
    // Of lists of the same length those at the same places; of others what is between the equal
    // ones at their begins and at their ends.
    if (slitsNow.size() == slitsBefore.size()) {
        for (std::size_t i = 0; i < slitsNow.size(); ++i)
            if (!cutsTheSame(slitsNow[i], slitsBefore[i])) {
                m_isChanged[i] = true;
                add(slitsNow[i]);
                add(slitsBefore[i]);
            }
    } else {
        const auto [n, b] = std::mismatch(slitsNow.begin(), slitsNow.end(), slitsBefore.begin(),
                                          slitsBefore.end(), cutsTheSame);
        const auto [rn, rb] =
            std::mismatch(slitsNow.rbegin(), std::make_reverse_iterator(n), slitsBefore.rbegin(),
                          std::make_reverse_iterator(b), cutsTheSame);
        std::fill(m_isChanged.begin() + (n - slitsNow.begin()),
                  m_isChanged.begin() + (rn.base() - slitsNow.begin()), char(true));
        for (auto it = n; it != rn.base(); ++it)
            add(*it);
        for (auto it = b; it != rb.base(); ++it)
            add(*it);
    }
    m_runs.fill(m_boxes.size(), [&](std::size_t i) { return m_boxes[i]; });
}

void CutChange::add(const Slit &slit)
{
    // Of the rectangle.
    const Vec2 along = (slit.mouth - slit.inner).normalized().cwiseAbs();
    const Vec2 half = 0.5 * slit.width * Vec2(along.y(), along.x());
    Box2 box{slit.inner.cwiseMin(slit.mouth) - half, slit.inner.cwiseMax(slit.mouth) + half};
    if (slit.form)
        for (const Polygon &outline : slit.outlines(kCutChord))
            box.extend(bounds(outline));
    m_boxes.push_back(box);
}

bool CutChange::isNear(std::size_t slit, double beside) const
{
    if (m_isEverywhere || m_isChanged[slit])
        return true;
    if (m_boxes.empty())
        return false;
    // By squares: most slits are told without a root.
    const Vec2 &from = m_slits[slit].inner;
    const Vec2 normal = perpendicular(m_slits[slit].mouth - from), half = 0.5 * normal.cwiseAbs();
    const double limit = beside * beside * normal.squaredNorm();
    const auto reaches = [&](const Box2 &box) {
        const double away = std::abs(normal.dot(box.center() - from)) - half.dot(box.size());
        return !(away > 0.0 && away * away > limit);
    };
    return m_runs.any(reaches, [&](std::size_t i) { return reaches(m_boxes[i]); });
}

} // namespace fff
