#include "core/physics/force_sites.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {

/// What a cut touches it meets, for all rounding, mm.
constexpr double kMeetingSlack = 1e-5;

bool isBefore(const ForceSite &a, const ForceSite &b)
{
    const OutlinePoint &p = a.held.anchor, &q = b.held.anchor;
    return p.ring != q.ring ? p.ring < q.ring : p.isBefore(q);
}

Box2 boxOf(const ForceSite &site)
{
    Box2 box;
    const auto add = [&box](const HeldPoint &point) {
        box.extend(point.at);
        box.extend(point.anchor.at);
    };
    add(site.held);
    const Vec2 around(site.radius, site.radius);
    for (const Vec2 &middle : {site.at, site.held.at})
        box.extend(Box2{middle - around, middle + around});
    if (site.hasWalls)
        for (const SlitWall &wall : site.walls) {
            add(wall.root);
            add(wall.mouth);
        }
    return box;
}

/// The cut, from its first chord to its last one, comes into the box.
bool meets(const LineCut &cut, const Box2 &box)
{
    const Vec2 middle = 0.5 * (box.min + box.max), half = 0.5 * box.size();
    const Vec2 direction = cut.line.direction.cwiseAbs();
    const double width = half.x() * direction.y() + half.y() * direction.x() + kMeetingSlack;
    if (std::abs(cut.line.across(middle)) > width)
        return false;
    const double along = cut.line.along(middle), reach = half.dot(direction) + kMeetingSlack;
    return along + reach >= cut.chords.front().from && along - reach <= cut.chords.back().to;
}

} // namespace

const PlusSites::Near *PlusSitesView::nearAt(int place) const
{
    const auto found = std::lower_bound(near.begin(), near.end(), place,
                                        [](const auto &n, int p) { return n.place < p; });
    return found != near.end() && found->place == place ? &*found : nullptr;
}

void PlusSites::setNear(int place, const PlusShare &share)
{
    const auto found = std::lower_bound(near.begin(), near.end(), place,
                                        [](const Near &n, int p) { return n.place < p; });
    if (found != near.end() && found->place == place)
        found->plus = share;
    else
        near.insert(found, {place, share});
}

void PlusSitesList::add(const PlusSites &sites)
{
    m_runs.insert(m_runs.end(), sites.runs.begin(), sites.runs.end());
    m_near.insert(m_near.end(), sites.near.begin(), sites.near.end());
    m_ends.push_back({m_runs.size(), m_near.size()});
}

ForceSites::ForceSites(const SectionOutline &outline, const std::vector<AppliedForce> &forces,
                       double thickness)
{
    const std::vector<ForceSite> sites = forceSites(outline, forces, thickness);
    m_forces.resize(sites.size());
    std::iota(m_forces.begin(), m_forces.end(), 0);
    const auto siteOf = [&](int force) -> const ForceSite & {
        return sites[static_cast<std::size_t>(force)];
    };
    std::stable_sort(m_forces.begin(), m_forces.end(),
                     [&](int a, int b) { return isBefore(siteOf(a), siteOf(b)); });
    m_sites.reserve(sites.size());
    for (const int force : m_forces)
        m_sites.push_back(siteOf(force));
    for (const ForceSite &site : m_sites)
        m_siteBoxes.push_back(boxOf(site));
    m_boxes.fill(m_sites.size(), [this](std::size_t i) { return m_siteBoxes[i]; });
}

PlusSites ForceSites::onPlusSide(const LineCut &cut) const
{
    PlusSites plus;
    onPlusSide(cut, plus);
    return plus;
}

void ForceSites::onPlusSide(const LineCut &cut, PlusSites &plus) const
{
    plus.runs.clear();
    plus.near.clear();
    for (int begin = 0; begin < size();) {
        const int ring = at(begin).held.anchor.ring;
        const auto next = std::partition_point(
            m_sites.begin() + begin, m_sites.end(),
            [ring](const ForceSite &site) { return site.held.anchor.ring == ring; });
        const int end = static_cast<int>(next - m_sites.begin());
        addRuns(cut, ring, begin, end, plus);
        begin = end;
    }
    addNear(cut, plus);
}

/// Of the sites that are held to one ring.
void ForceSites::addRuns(const LineCut &cut, int ring, int begin, int end, PlusSites &plus) const
{
    // The first place that is not before a point of the ring.
    const auto placeOf = [&](const OutlinePoint &point) {
        const auto first = std::partition_point(
            m_sites.begin() + begin, m_sites.begin() + end,
            [&point](const ForceSite &site) { return site.held.anchor.isBefore(point); });
        return static_cast<int>(first - m_sites.begin());
    };
    const auto add = [&plus](int from, int to) {
        if (from < to)
            plus.runs.push_back({from, to});
    };
    if (ring == 0) {
        const int from = placeOf(cut.chords.front().begin), to = placeOf(cut.chords.back().end);
        if (cut.chords.back().end.isBefore(cut.chords.front().begin)) {
            add(begin, to);
            add(from, end);
        } else {
            add(from, to);
        }
        return;
    }
    bool isLeft = cut.isHoleLeft[static_cast<std::size_t>(ring - 1)] != 0;
    int from = begin;
    for (const OutlineCrossing &crossing : cut.crossed) {
        if (crossing.point.ring != ring)
            continue;
        // One that lies on the crossing is before it.
        const auto beyond = std::partition_point(
            m_sites.begin() + from, m_sites.begin() + end, [&crossing](const ForceSite &site) {
                return !crossing.point.isBefore(site.held.anchor);
            });
        const int to = static_cast<int>(beyond - m_sites.begin());
        if (!isLeft)
            add(from, to);
        isLeft = crossing.isToLeft;
        from = to;
    }
    if (!isLeft)
        add(from, end);
}

void ForceSites::addNear(const LineCut &cut, PlusSites &plus) const
{
    m_boxes.any(
        [&cut](const Box2 &box) { return meets(cut, box); },
        [&](std::size_t place) {
            if (meets(cut, m_siteBoxes[place]))
                plus.near.push_back({static_cast<int>(place), plusShare(cut, m_sites[place])});
            return false;
        });
}

} // namespace fff
