#include "core/physics/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fff {

namespace {

bool isMember(const Structure &structure, int member)
{
    return member >= 0 && member < static_cast<int>(structure.members.size());
}

/// Disjoint sets of members (R. Tarjan 1975, with path halving).
class MemberSets
{
public:
    explicit MemberSets(std::size_t count) : m_parents(count)
    {
        std::iota(m_parents.begin(), m_parents.end(), 0);
    }
    int root(int member)
    {
        while (m_parents[member] != member)
            member = m_parents[member] = m_parents[m_parents[member]];
        return member;
    }
    /// The lesser index stays the root.
    void join(int a, int b)
    {
        const int first = root(a), second = root(b);
        m_parents[std::max(first, second)] = std::min(first, second);
    }

private:
    std::vector<int> m_parents;
};

} // namespace

bool isSound(const Structure &structure, const Link &link)
{
    return isMember(structure, link.a) && isMember(structure, link.b) && link.a != link.b &&
           link.point.allFinite() && link.axis.allFinite() && link.axis.norm() > 0.0 &&
           link.normalA.allFinite() && link.normalB.allFinite();
}

bool isSound(const Structure &structure, const Foot &foot)
{
    return isMember(structure, foot.member) && foot.point.allFinite();
}

bool isSound(const Structure &structure, const MemberLoad &load)
{
    return isMember(structure, load.member) && load.point.allFinite() && load.force.allFinite() &&
           load.moment.allFinite();
}

bool isSound(const Member &member)
{
    return member.centroid.allFinite() && std::isfinite(member.mass) && member.mass >= 0.0;
}

bool isSound(const Structure &structure)
{
    const auto isGood = [&structure](const auto &thing) { return isSound(structure, thing); };
    return structure.gravity.allFinite() && structure.up.allFinite() && structure.up.norm() > 0.0 &&
           std::isfinite(structure.size) && structure.size > 0.0 &&
           std::isfinite(structure.thickness) &&
           std::all_of(structure.members.begin(), structure.members.end(),
                       [](const Member &member) { return isSound(member); }) &&
           std::all_of(structure.links.begin(), structure.links.end(), isGood) &&
           std::all_of(structure.feet.begin(), structure.feet.end(), isGood) &&
           std::all_of(structure.loads.begin(), structure.loads.end(), isGood);
}

std::vector<Component> components(const Structure &structure)
{
    const int count = static_cast<int>(structure.members.size());
    MemberSets sets(structure.members.size());
    for (const Link &link : structure.links) {
        if (isSound(structure, link))
            sets.join(link.a, link.b);
    }
    std::vector<Component> found;
    std::vector<int> componentOf(structure.members.size());
    for (int i = 0; i < count; ++i) {
        if (sets.root(i) == i) {
            componentOf[i] = static_cast<int>(found.size());
            found.emplace_back();
        }
        componentOf[i] = componentOf[sets.root(i)];
        found[componentOf[i]].members.push_back(i);
    }
    for (int i = 0; i < static_cast<int>(structure.links.size()); ++i) {
        if (isSound(structure, structure.links[i]))
            found[componentOf[structure.links[i].a]].links.push_back(i);
    }
    for (int i = 0; i < static_cast<int>(structure.feet.size()); ++i) {
        if (isSound(structure, structure.feet[i]))
            found[componentOf[structure.feet[i].member]].feet.push_back(i);
    }
    for (int i = 0; i < static_cast<int>(structure.loads.size()); ++i) {
        if (isSound(structure, structure.loads[i]))
            found[componentOf[structure.loads[i].member]].loads.push_back(i);
    }
    return found;
}

} // namespace fff
