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

Alignment::Alignment(const Model &model, const ViewState &view, const std::set<SectionRef> &moved,
                     const std::set<SectionRef> &along)
{
    m_others.push_back(Vec3::Zero());
    for (const SectionPointer &section : model.sections()) {
        const SectionRef ref = section->ref();
        if (moved.contains(ref))
            addPoints(*section, m_own);
        else if (!along.contains(ref) && view.isPicked(ref) && m_others.size() < kMostOthers)
            addPoints(*section, m_others);
    }
    if (m_own.size() > kMostOwn)
        m_own.resize(kMostOwn);
}

Alignment::Alignment(const Model &model, const ViewState &view, std::vector<Vec3> own)
    : Alignment(model, view, std::set<SectionRef>(), {})
{
    m_own = std::move(own);
}

Alignment::Line::Line(const Alignment &alignment, const Vec3 &axis)
    : m_axis(axis), m_own(alignment.m_own)
{
    m_others.reserve(alignment.m_others.size());
    for (const Vec3 &other : alignment.m_others)
        m_others.emplace_back(axis.dot(other), other);
    std::sort(m_others.begin(), m_others.end(),
              [](const auto &a, const auto &b) { return a.first < b.first; });
}

std::optional<Alignment::Caught> Alignment::Line::nearest(double way, double reach,
                                                          const Vec3 &before) const
{
    std::optional<Caught> best;
    for (const Vec3 &own : m_own) {
        const Vec3 from = own + before;
        const double at = m_axis.dot(from) + way;
        auto next = std::lower_bound(m_others.begin(), m_others.end(), at,
                                     [](const auto &a, double b) { return a.first < b; });
        if (next != m_others.begin())
            --next;
        for (int i = 0; i < 2 && next != m_others.end(); ++i, ++next) {
            const double caught = way + next->first - at;
            if (std::abs(caught - way) <= reach &&
                (!best || std::abs(caught - way) < std::abs(best->way - way)))
                best = Caught{caught, from + caught * m_axis, next->second};
        }
    }
    return best;
}

} // namespace fff
