#include "core/assembly/cycles.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <set>

namespace fff {

bool areParallel(const Vec3 &a, const Vec3 &b)
{
    return a.cross(b).norm() < kPracticallyParallel;
}

namespace {

bool areParallel(const Joint &a, const Joint &b)
{
    return fff::areParallel(a.crossing->axis.direction, b.crossing->axis.direction);
}

/// One of the joints that hold whose axis is parallel to most others', if it is to more than half
/// of them; else some other one. Null when there is none. Source  R. Boyer, J. Moore 1981, MJRTY: a
/// fast majority vote algorithm.
const Joint *commonest(const JointList &joints)
{
    const Joint *common = nullptr;
    int lead = 0;
    for (const Joint &joint : joints) {
        if (joint.kind == JointKind::None)
            continue;
        if (lead == 0)
            common = &joint;
        lead += areParallel(joint, *common) ? 1 : -1;
    }
    return common;
}

/// Looks for rings through one joint after the other.
class Rings
{
public:
    Rings(std::size_t sectionCount, const JointList &joints) : m_edges(sectionCount)
    {
        for (const Joint &joint : joints) {
            if (joint.kind == JointKind::None)
                continue;
            m_edges[static_cast<std::size_t>(joint.a)].push_back({joint.b, &joint});
            m_edges[static_cast<std::size_t>(joint.b)].push_back({joint.a, &joint});
        }
        m_from.resize(2 * sectionCount);
        m_via.resize(2 * sectionCount);
        leaveOutEnds();
    }

    /// From one of its sections to the other without it, as few joints as possible, with an axis
    /// that is not parallel to the joint's among them; empty when there is no such way.
    std::vector<int> through(const Joint &joint)
    {
        constexpr int kUnseen = -1;
        if (isEnd(joint.a) || isEnd(joint.b))
            return {};
        std::fill(m_from.begin(), m_from.end(), kUnseen);
        // A section is passed once before and once after the first axis of another direction.
        const auto state = [](int section, bool isOther) {
            return 2 * section + (isOther ? 1 : 0);
        };
        std::vector<int> open{state(joint.a, false)};
        m_from[static_cast<std::size_t>(open.front())] = open.front();
        m_via[static_cast<std::size_t>(open.front())] = nullptr;
        const int goal = state(joint.b, true);
        for (std::size_t next = 0; next < open.size(); ++next) {
            const int here = open[next];
            if (here == goal)
                return ringTo(goal);
            for (const Edge &edge : m_edges[static_cast<std::size_t>(here / 2)]) {
                if (edge.joint == &joint || edge.joint == m_via[static_cast<std::size_t>(here)])
                    continue; // no ring goes back the way it came
                if (isEnd(edge.to))
                    continue;
                const int there = state(edge.to, here % 2 == 1 || !areParallel(*edge.joint, joint));
                int &from = m_from[static_cast<std::size_t>(there)];
                if (from == kUnseen) {
                    from = here;
                    m_via[static_cast<std::size_t>(there)] = edge.joint;
                    open.push_back(there);
                }
            }
        }
        return {};
    }

private:
    struct Edge
    {
        int to;
        const Joint *joint;
    };

    bool isEnd(int section) const { return m_degrees[static_cast<std::size_t>(section)] < 2; }

    /// Sections that one joint holds are in no ring, and then neither are those which only such
    /// ones hold besides: without them the ribs of a spine cost nothing.
    void leaveOutEnds()
    {
        std::vector<int> ends;
        for (const std::vector<Edge> &edges : m_edges) {
            m_degrees.push_back(static_cast<int>(edges.size()));
            if (edges.size() == 1)
                ends.push_back(static_cast<int>(m_degrees.size()) - 1);
        }
        while (!ends.empty()) {
            const int end = ends.back();
            ends.pop_back();
            for (const Edge &edge : m_edges[static_cast<std::size_t>(end)])
                if (--m_degrees[static_cast<std::size_t>(edge.to)] == 1)
                    ends.push_back(edge.to);
        }
    }

    /// Empty when a section is in it twice.
    std::vector<int> ringTo(int goal) const
    {
        std::vector<int> ring{goal / 2};
        for (int at = goal; m_from[static_cast<std::size_t>(at)] != at;) {
            at = m_from[static_cast<std::size_t>(at)];
            ring.push_back(at / 2);
        }
        const std::set<int> sections(ring.begin(), ring.end());
        return sections.size() == ring.size() ? ring : std::vector<int>();
    }

    std::vector<std::vector<Edge>> m_edges; // of each section
    std::vector<int> m_degrees;             // of each section: joints to those that are no ends
    std::vector<int> m_from;                // of each state the one before it
    std::vector<const Joint *> m_via;       // and the joint between them
};

/// Beginning with the lowest section, on to the lower one of its neighbours.
std::vector<int> inOrder(std::vector<int> ring)
{
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    if (ring.back() < ring[1])
        std::reverse(ring.begin() + 1, ring.end());
    return ring;
}

} // namespace

std::vector<std::vector<int>> cyclesOf(std::size_t sectionCount, const JointList &joints)
{
    const Joint *common = commonest(joints);
    const auto isOdd = [common](const Joint &joint) {
        return joint.kind != JointKind::None && !areParallel(joint, *common);
    };
    if (std::none_of(joints.begin(), joints.end(), isOdd))
        return {};
    Rings rings(sectionCount, joints);
    std::set<std::vector<int>> found;
    for (const Joint &joint : joints) {
        if (!isOdd(joint))
            continue;
        if (std::vector<int> ring = rings.through(joint); !ring.empty())
            found.insert(inOrder(std::move(ring)));
    }
    std::vector<std::vector<int>> all(found.begin(), found.end());
    std::stable_sort(all.begin(), all.end(),
                     [](const auto &a, const auto &b) { return a.size() < b.size(); });
    return all;
}

} // namespace fff
