#include "core/interaction/view_history.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Scales that differ by less than this part look the same, and so do shifts of a pixel's part.
constexpr double kSameScale = 1e-3, kSameShift = 0.5;

bool looksTheSame(const Camera &a, const Camera &b)
{
    Vec3 shift = a.target - b.target;
    if (!a.isPerspective()) // how deep its target lies is not to be seen
        shift -= a.backward().dot(shift) * a.backward();
    return a.projection == b.projection &&
           a.orientation.angularDistance(b.orientation) < kSameView &&
           std::abs(a.millimetresPerPixel / b.millimetresPerPixel - 1.0) < kSameScale &&
           shift.norm() < kSameShift * a.millimetresPerPixel;
}

} // namespace

void ViewHistory::leave(const Camera &from, Change change)
{
    const bool goesOn = change == Change::Wheel && m_last == Change::Wheel;
    m_last = change;
    if (goesOn || (!m_views.empty() && looksTheSame(m_views.back(), from)))
        return;
    m_views.push_back(from);
    if (m_views.size() > kCapacity)
        m_views.pop_front();
}

bool ViewHistory::canGoBack(const Camera &current) const
{
    return std::any_of(m_views.begin(), m_views.end(),
                       [&](const Camera &view) { return !looksTheSame(view, current); });
}

std::optional<Camera> ViewHistory::takeBack(const Camera &current)
{
    m_last.reset();
    while (!m_views.empty()) {
        const Camera view = m_views.back();
        m_views.pop_back();
        if (!looksTheSame(view, current))
            return view;
    }
    return {};
}

void ViewHistory::clear()
{
    m_views.clear();
    m_last.reset();
}

} // namespace fff
