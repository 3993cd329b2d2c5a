#include "core/physics/link_chains.h"

#include <algorithm>

namespace fff {

namespace {

class ChainFinder
{
public:
    explicit ChainFinder(const Structure &structure)
        : m_structure(structure), m_open(structure.members.size()),
          m_hasFeet(structure.members.size(), false)
    {
        const std::size_t members = structure.members.size();
        m_found.links.resize(structure.links.size());
        m_found.isBalanced.assign(members, false);
        m_found.rest.assign(members, WrenchVector::Zero());
        for (std::size_t i = 0; i < members; ++i)
            m_found.rest[i].head<3>() = structure.members[i].mass * structure.gravity;
        for (const MemberLoad &load : structure.loads) {
            WrenchVector wrench;
            wrench << load.force, load.moment;
            act(load.member, load.point, wrench);
        }
        for (std::size_t j = 0; j < structure.links.size(); ++j)
            for (const int member : {structure.links[j].a, structure.links[j].b})
                m_open[at(member)].push_back(static_cast<int>(j));
        for (const Foot &foot : structure.feet)
            m_hasFeet[at(foot.member)] = true;
    }

    LinkChains find() &&
    {
        findKnown();
        for (const std::vector<int> &open : m_open) {
            for (const int link : open) {
                if (m_found.links[at(link)].chain >= 0)
                    continue;
                LinkChains::Link &first = m_found.links[at(link)];
                first.chain = static_cast<int>(m_found.points.size());
                first.side = 1.0;
                m_found.points.push_back(m_structure.links[at(link)].point);
                follow(link, m_structure.links[at(link)].a);
                follow(link, m_structure.links[at(link)].b);
            }
        }
        return std::move(m_found);
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    void act(int member, const Vec3 &point, const WrenchVector &wrench)
    {
        m_found.rest[at(member)] +=
            movedTo(m_structure.members[at(member)].centroid, point, wrench);
    }
    double signOn(int member, int link) const
    {
        return m_structure.links[at(link)].a == member ? 1.0 : -1.0;
    }
    int across(int member, int link) const
    {
        const Link &of = m_structure.links[at(link)];
        return of.a == member ? of.b : of.a;
    }
    bool isHeldBy(int member, std::size_t links) const
    {
        return !m_hasFeet[at(member)] && m_open[at(member)].size() == links;
    }

    /// From the ends inwards.
    void findKnown()
    {
        std::vector<int> ends;
        for (int i = 0; i < static_cast<int>(m_open.size()); ++i)
            if (isHeldBy(i, 1))
                ends.push_back(i);
        while (!ends.empty()) {
            const int end = ends.back();
            ends.pop_back();
            if (!isHeldBy(end, 1))
                continue; // the other one of the last two
            const int link = m_open[at(end)].front();
            const Vec3 &point = m_structure.links[at(link)].point;
            const WrenchVector carried =
                -movedTo(point, m_structure.members[at(end)].centroid, m_found.rest[at(end)]);
            const int next = across(end, link);
            m_found.links[at(link)].rest = signOn(end, link) * carried;
            act(end, point, carried);
            act(next, point, -carried);
            m_found.isBalanced[at(end)] = true;
            m_open[at(end)].clear();
            std::erase(m_open[at(next)], link);
            if (isHeldBy(next, 1))
                ends.push_back(next);
        }
    }

    /// On from a link of a chain through `member`, as long as that is held by two.
    void follow(int link, int member)
    {
        while (isHeldBy(member, 2) && !m_found.isBalanced[at(member)]) {
            const std::vector<int> &both = m_open[at(member)];
            const int next = both.front() == link ? both.back() : both.front();
            if (m_found.links[at(next)].chain >= 0)
                return; // it is a ring
            const Vec3 &point = m_structure.links[at(next)].point;
            const LinkChains::Link &from = m_found.links[at(link)];
            const double sign = signOn(member, link), nextSign = signOn(member, next);
            LinkChains::Link &to = m_found.links[at(next)];
            to.chain = from.chain;
            to.side = -nextSign * sign * from.side;
            to.rest =
                -nextSign * (sign * movedTo(point, m_structure.links[at(link)].point, from.rest) +
                             movedTo(point, m_structure.members[at(member)].centroid,
                                     m_found.rest[at(member)]));
            m_found.isBalanced[at(member)] = true;
            member = across(member, next);
            link = next;
        }
    }

    const Structure &m_structure;
    LinkChains m_found;
    std::vector<std::vector<int>> m_open; // of each member, links of which nothing is known
    std::vector<bool> m_hasFeet;
};

} // namespace

WrenchVector movedTo(const Vec3 &to, const Vec3 &from, const WrenchVector &wrench)
{
    WrenchVector moved = wrench;
    const Vec3 force = wrench.head<3>();
    moved.tail<3>() += (from - to).cross(force);
    return moved;
}

LinkChains linkChains(const Structure &structure)
{
    return ChainFinder(structure).find();
}

} // namespace fff
