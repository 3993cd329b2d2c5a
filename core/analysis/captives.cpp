#include "core/analysis/captives.h"

#include "core/assembly/collisions.h"
#include "core/assembly/coming_away.h"
#include "core/base/groups.h"
#include "core/base/tolerances.h"

#include <algorithm>

namespace fff {

namespace {

/// Bodies whose boxes are this near may be in the way, mm.
constexpr double kNear = 2.0 * kEscape;

/// To the faces, edges and corners of a cube in the frame, unit.
void addDirections(const Frame &frame, std::vector<Vec3> &directions)
{
    for (int i = -1; i <= 1; ++i)
        for (int k = -1; k <= 1; ++k)
            for (int m = -1; m <= 1; ++m)
                if (i != 0 || k != 0 || m != 0)
                    directions.push_back(
                        (i * frame.x + k * frame.y + m * frame.normal()).normalized());
}

/// The same along the line that the planes of two bodies have, and square to it in either of them:
/// what slides out of a slit slides so.
void addDirections(const Frame &one, const Frame &other, std::vector<Vec3> &directions)
{
    const Vec3 axis = one.normal().cross(other.normal());
    if (axis.norm() <= kPracticallyParallel)
        return;
    const Vec3 along = axis.normalized();
    for (const Frame *frame : {&one, &other})
        addDirections(Frame{Vec3::Zero(), along, frame->normal().cross(along)}, directions);
}

/// The bodies that may be in the way of a group. gone: of each body whether it is not there.
std::vector<int> nearTo(const std::vector<int> &group, const Bodies &bodies,
                        const std::vector<char> &gone)
{
    Box3 reach;
    for (const int body : group)
        reach.extend(bodies.at(body).box());
    std::vector<int> near;
    for (int other = 0; other < static_cast<int>(bodies.size()); ++other) {
        const Box3 &box = bodies.at(other).box();
        if (!gone[static_cast<std::size_t>(other)] && distanceBetween(reach, box) <= kNear &&
            std::find(group.begin(), group.end(), other) == group.end() &&
            std::any_of(group.begin(), group.end(), [&](int body) {
                return distanceBetween(bodies.at(body).box(), box) <= kNear;
            }))
            near.push_back(other);
    }
    return near;
}

/// One group against all that is near to it.
class Escape
{
public:
    Escape(const std::vector<BodyPointer> &group, const std::vector<BodyPointer> &near)
    {
        std::vector<SolidPointer> solids;
        const auto add = [&](const Body &body) {
            const Result<SolidPointer> &solid = body.solid();
            m_isKnown = m_isKnown && solid;
            if (solid)
                solids.push_back(*solid);
        };
        for (const BodyPointer &body : group)
            add(*body);
        m_own = static_cast<int>(solids.size());
        for (const BodyPointer &other : near) {
            add(*other);
            addDirections(other->frame(), m_directions);
            for (const BodyPointer &body : group)
                if (distanceBetween(body->box(), other->box()) <= kNear)
                    addDirections(body->frame(), other->frame(), m_directions);
        }
        for (const BodyPointer &body : group)
            addDirections(body->frame(), m_directions);
        m_all = static_cast<int>(solids.size());
        if (m_isKnown)
            use(std::move(solids));
    }

    bool isPossible()
    {
        return !m_isKnown || m_own == m_all ||
               std::any_of(m_directions.begin(), m_directions.end(),
                           [this](const Vec3 &direction) { return isFree(direction); });
    }

private:
    /// What is in each other already may be so, as deep as it is: it stops only what goes deeper.
    void use(const std::vector<SolidPointer> &solids)
    {
        m_collisions.use(solids);
        Collisions::Depths depths;
        for (int own = 0; own < m_own; ++own)
            for (int other = m_own; other < m_all; ++other)
                if (const auto &overlap = m_collisions.overlap(own, other))
                    depths[{own, other}] = overlap->depth + Collisions::kNearParts;
        if (!depths.empty())
            m_collisions.use(solids, std::move(depths));
    }

    bool isFree(const Vec3 &direction)
    {
        const int way = m_collisions.way(direction);
        for (int own = 0; own < m_own; ++own)
            for (int other = m_own; other < m_all; ++other)
                if (m_collisions.wayUntil(own, other, way) < kEscape)
                    return false;
        return true;
    }

    Collisions m_collisions;
    std::vector<Vec3> m_directions;
    int m_own = 0, m_all = 0;
    bool m_isKnown = true;
};

std::vector<BodyPointer> pointersOf(const std::vector<int> &group, const Bodies &bodies)
{
    std::vector<BodyPointer> pointers;
    for (const int body : group)
        pointers.push_back(bodies.pointer(body));
    return pointers;
}

/// Whether groups get away, each worked out once among the same bodies.
class Escapes
{
public:
    Escapes(const Bodies &bodies, CaptiveCache &cache) : m_bodies(bodies), m_cache(cache) {}

    /// Shifted alone.
    bool isPossible(const std::vector<int> &group, const std::vector<char> &gone)
    {
        Known looked{pointersOf(group, m_bodies),
                     pointersOf(nearTo(group, m_bodies, gone), m_bodies)};
        for (const std::vector<Known> *list : {&m_asked, &m_cache.known})
            for (const Known &known : *list)
                if (known.own == looked.own && known.near == looked.near) {
                    looked.getsAway = known.getsAway;
                    return keep(std::move(looked), list != &m_asked);
                }
        looked.getsAway = Escape(looked.own, looked.near).isPossible();
        return keep(std::move(looked), true);
    }

    /// Of each of the groups, which touch each other, whether it does among all of them.
    std::vector<char> together(const std::vector<const std::vector<int> *> &groups,
                               const std::vector<char> &gone)
    {
        KnownTogether looked;
        std::vector<int> all;
        for (const std::vector<int> *group : groups) {
            looked.groups.push_back(pointersOf(*group, m_bodies));
            all.insert(all.end(), group->begin(), group->end());
        }
        looked.near = pointersOf(nearTo(all, m_bodies, gone), m_bodies);
        const auto known = std::find_if(
            m_cache.together.begin(), m_cache.together.end(), [&](const KnownTogether &one) {
                return one.groups == looked.groups && one.near == looked.near;
            });
        looked.getAway = known != m_cache.together.end()
                             ? known->getAway
                             : whatComesAway({looked.groups, looked.near});
        return m_together.emplace_back(std::move(looked)).getAway;
    }

    /// What was not asked for is forgotten.
    void finish()
    {
        m_cache.known = std::move(m_asked);
        m_cache.together = std::move(m_together);
    }

private:
    using Known = CaptiveCache::Known;
    using KnownTogether = CaptiveCache::KnownTogether;

    bool keep(Known known, bool isNew)
    {
        const bool getsAway = known.getsAway;
        if (isNew)
            m_asked.push_back(std::move(known));
        return getsAway;
    }

    const Bodies &m_bodies;
    CaptiveCache &m_cache;
    std::vector<Known> m_asked;
    std::vector<KnownTogether> m_together;
};

/// The groups that nothing has got away of yet.
class Captives
{
public:
    Captives(const Bodies &bodies, const std::vector<std::vector<int>> &groups, CaptiveCache &cache)
        : m_bodies(bodies), m_groups(groups), m_escapes(bodies, cache),
          m_isCaught(groups.size(), 0), m_gone(bodies.size(), 0)
    {
        for (std::size_t g = 1; g < groups.size(); ++g) {
            m_isCaught[g] = 1;
            if (g > kMostGroups || groups[g].size() > kMostInGroup)
                letGo(g);
        }
    }

    /// Of each group whether it is caught.
    std::vector<char> find() &&
    {
        // What gets away keeps nothing else: once it is gone, more may be free.
        while (letGoAlone() || letGoTogether()) {
        }
        m_escapes.finish();
        return std::move(m_isCaught);
    }

private:
    void letGo(std::size_t g)
    {
        m_isCaught[g] = 0;
        for (const int body : m_groups[g])
            m_gone[static_cast<std::size_t>(body)] = 1;
    }
    bool letGoAlone()
    {
        bool isMore = false;
        for (std::size_t g = 1; g < m_groups.size(); ++g)
            if (m_isCaught[g] && m_escapes.isPossible(m_groups[g], m_gone)) {
                letGo(g);
                isMore = true;
            }
        return isMore;
    }
    bool letGoTogether()
    {
        bool isMore = false;
        for (const std::vector<std::size_t> &cluster : clusters()) {
            std::vector<const std::vector<int> *> groups;
            for (const std::size_t g : cluster)
                groups.push_back(&m_groups[g]);
            const std::vector<char> free = cluster.size() > kMostTogether
                                               ? std::vector<char>(cluster.size(), 1)
                                               : m_escapes.together(groups, m_gone);
            for (std::size_t i = 0; i < cluster.size(); ++i)
                if (free[i]) {
                    letGo(cluster[i]);
                    isMore = true;
                }
        }
        return isMore;
    }
    /// Of what is caught that which may touch each other.
    std::vector<std::vector<std::size_t>> clusters() const
    {
        Groups clusters(m_groups.size());
        for (std::size_t g = 1; g < m_groups.size(); ++g)
            for (std::size_t h = g + 1; h < m_groups.size(); ++h)
                if (m_isCaught[g] && m_isCaught[h] && isNear(m_groups[g], m_groups[h]))
                    clusters.join(g, h);
        std::vector<std::vector<std::size_t>> all = clusters.all();
        std::erase_if(all, [&](const auto &cluster) { return !m_isCaught[cluster.front()]; });
        return all;
    }
    bool isNear(const std::vector<int> &group, const std::vector<int> &other) const
    {
        return std::any_of(group.begin(), group.end(), [&](int a) {
            return std::any_of(other.begin(), other.end(), [&](int b) {
                return distanceBetween(m_bodies.at(a).box(), m_bodies.at(b).box()) <= kNear;
            });
        });
    }

    const Bodies &m_bodies;
    const std::vector<std::vector<int>> &m_groups;
    Escapes m_escapes;
    std::vector<char> m_isCaught; // of each group
    std::vector<char> m_gone;     // of each body
};

} // namespace

std::vector<std::vector<int>>
withCaptives(const Analysis &analysis, std::vector<std::vector<int>> groups, CaptiveCache &cache)
{
    const std::vector<char> isCaught = Captives(analysis.bodies, groups, cache).find();
    std::vector<std::vector<int>> held;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        if (isCaught[g]) {
            std::vector<int> &first = held.front();
            first.insert(first.end(), groups[g].begin(), groups[g].end());
            std::sort(first.begin(), first.end());
        } else {
            held.push_back(std::move(groups[g]));
        }
    }
    return held;
}

} // namespace fff
