#include "core/analysis/captives.h"

#include "core/assembly/collisions.h"
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

/// Whether groups get away, each worked out once among the same bodies.
class Escapes
{
public:
    Escapes(const Bodies &bodies, CaptiveCache &cache) : m_bodies(bodies), m_cache(cache) {}

    bool isPossible(const std::vector<int> &group, const std::vector<char> &gone)
    {
        Known looked{pointers(group), pointers(nearTo(group, m_bodies, gone))};
        for (const std::vector<Known> *list : {&m_asked, &m_cache.known})
            for (const Known &known : *list)
                if (known.own == looked.own && known.near == looked.near) {
                    looked.getsAway = known.getsAway;
                    return keep(std::move(looked), list != &m_asked);
                }
        looked.getsAway = Escape(looked.own, looked.near).isPossible();
        return keep(std::move(looked), true);
    }
    /// What was not asked for is forgotten.
    void finish() { m_cache.known = std::move(m_asked); }

private:
    using Known = CaptiveCache::Known;

    bool keep(Known known, bool isNew)
    {
        const bool getsAway = known.getsAway;
        if (isNew)
            m_asked.push_back(std::move(known));
        return getsAway;
    }
    std::vector<BodyPointer> pointers(const std::vector<int> &bodies) const
    {
        std::vector<BodyPointer> pointers;
        for (const int body : bodies)
            pointers.push_back(m_bodies.pointer(body));
        return pointers;
    }

    const Bodies &m_bodies;
    CaptiveCache &m_cache;
    std::vector<Known> m_asked;
};

} // namespace

std::vector<std::vector<int>>
withCaptives(const Analysis &analysis, std::vector<std::vector<int>> groups, CaptiveCache &cache)
{
    const auto isLooked = [&](std::size_t g) {
        return g > 0 && g <= kMostGroups && groups[g].size() <= kMostInGroup;
    };
    std::vector<char> isCaught(groups.size(), 0), gone(analysis.bodies.size(), 0);
    const auto letGo = [&](std::size_t g) {
        isCaught[g] = 0;
        for (const int body : groups[g])
            gone[static_cast<std::size_t>(body)] = 1;
    };
    for (std::size_t g = 0; g < groups.size(); ++g)
        isCaught[g] = isLooked(g) ? 1 : 0;
    for (std::size_t g = 1; g < groups.size(); ++g)
        if (!isLooked(g))
            letGo(g);
    Escapes escapes(analysis.bodies, cache);
    // What gets away keeps nothing else: once it is gone, more may be free.
    for (bool isMore = true; isMore;) {
        isMore = false;
        for (std::size_t g = 1; g < groups.size(); ++g)
            if (isCaught[g] && escapes.isPossible(groups[g], gone)) {
                letGo(g);
                isMore = true;
            }
    }
    escapes.finish();
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
