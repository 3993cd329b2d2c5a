#include "core/assembly/cut_change.h"

#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// With more of them it costs more to say what stays than to look at all of it.
constexpr std::size_t kMostChanged = 8;

bool cutsTheSame(const Slit &x, const Slit &y)
{
    return x.inner == y.inner && x.mouth == y.mouth && x.width == y.width && x.isOpen == y.isOpen &&
           x.role == y.role && (x.form == y.form || (x.form && y.form && *x.form == *y.form));
}

} // namespace

CutChange::CutChange(const CutSection &now, const std::vector<Slit> &slitsNow,
                     const CutSection &before, const std::vector<Slit> &slitsBefore)
{
    if (now.parts().size() != 1 || before.parts().size() != 1 || now.failure() ||
        before.failure() || now.waste() != before.waste())
        return;
    // Of lists of the same length those at the same places; of others what is between the equal
    // ones at their begins and at their ends.
    std::vector<const Slit *> changed;
    const auto add = [&](auto from, auto to) {
        for (; from != to && changed.size() <= 2 * kMostChanged; ++from)
            changed.push_back(&*from);
    };
    if (slitsNow.size() == slitsBefore.size()) {
        for (std::size_t i = 0; i < slitsNow.size() && changed.size() <= 2 * kMostChanged; ++i)
            if (!cutsTheSame(slitsNow[i], slitsBefore[i])) {
                changed.push_back(&slitsNow[i]);
                changed.push_back(&slitsBefore[i]);
            }
    } else {
        const auto [n, b] = std::mismatch(slitsNow.begin(), slitsNow.end(), slitsBefore.begin(),
                                          slitsBefore.end(), cutsTheSame);
        const auto [rn, rb] =
            std::mismatch(slitsNow.rbegin(), std::make_reverse_iterator(n), slitsBefore.rbegin(),
                          std::make_reverse_iterator(b), cutsTheSame);
        add(n, rn.base());
        add(b, rb.base());
    }
    if (changed.size() > 2 * kMostChanged)
        return;
    m_isEverywhere = false;
    for (const Slit *slit : changed) {
        Box2 box = bounds(slit->outline());
        for (const Polygon &outline : slit->outlines(kCutChord))
            box.extend(bounds(outline));
        m_boxes.push_back(box);
    }
}

bool CutChange::isNear(const Slit &slit, double beside) const
{
    if (m_isEverywhere)
        return true;
    const Vec2 normal = perpendicular((slit.mouth - slit.inner).normalized());
    return std::any_of(m_boxes.begin(), m_boxes.end(), [&](const Box2 &box) {
        const double away = std::abs(normal.dot(box.center() - slit.inner));
        return away <= beside + normal.cwiseAbs().dot(0.5 * box.size());
    });
}

} // namespace fff
