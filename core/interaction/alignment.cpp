#include "core/interaction/alignment.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// More points than anyone lines up with are not looked at: of all others together, and of those
/// that move.
constexpr std::size_t kMostOthers = 20000, kMostOwn = 200;

void addPoints(const Section &section, std::vector<Vec3> &points)
{
    const auto add = [&](const Contour &contour) {
        for (int i = 0; i < contour.segmentCount(); ++i)
            points.push_back(section.frame.toWorld(contour.segment(i).p0));
    };
    points.push_back(section.frame.toWorld(section.shape->bounds().center()));
    add(section.shape->contour());
    for (const Contour &hole : section.shape->holes())
        add(hole);
}

} // namespace

Alignment::Alignment(const Model &model, const ViewState &view, const std::set<SectionRef> &moved)
{
    m_others.push_back(Vec3::Zero());
    for (const SectionPointer &section : model.sections()) {
        const SectionRef ref = section->ref();
        if (moved.contains(ref))
            addPoints(*section, m_own);
        else if (view.isPicked(ref) && m_others.size() < kMostOthers)
            addPoints(*section, m_others);
    }
    if (m_own.size() > kMostOwn)
        m_own.resize(kMostOwn);
}

std::optional<Alignment::Caught> Alignment::nearest(const Vec3 &axis, double way, double reach,
                                                    const Vec3 &before) const
{
    std::vector<std::pair<double, std::size_t>> places;
    places.reserve(m_others.size());
    for (std::size_t i = 0; i < m_others.size(); ++i)
        places.emplace_back(axis.dot(m_others[i]), i);
    std::sort(places.begin(), places.end());
    std::optional<Caught> best;
    for (const Vec3 &own : m_own) {
        const Vec3 from = own + before;
        const double at = axis.dot(from) + way;
        auto next = std::lower_bound(places.begin(), places.end(), std::pair(at, std::size_t(0)));
        if (next != places.begin())
            --next;
        for (int i = 0; i < 2 && next != places.end(); ++i, ++next) {
            const double caught = way + next->first - at;
            if (std::abs(caught - way) <= reach &&
                (!best || std::abs(caught - way) < std::abs(best->way - way)))
                best = Caught{caught, from + caught * axis, m_others[next->second]};
        }
    }
    return best;
}

} // namespace fff
