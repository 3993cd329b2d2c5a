#include "core/assembly/grips.h"

#include "core/assembly/cut_change.h"
#include "core/base/groups.h"

#include <algorithm>
#include <unordered_map>

namespace fff {

namespace {

/// Beside which joints both sections are as thick, and cut, as they were.
class Untouched
{
public:
    Untouched(const Model &model, const Assembly &assembly,
              const std::vector<CutSectionPointer> &cuts, const Grips::Before &before,
              const std::optional<std::vector<int>> &places)
        : m_changed(cuts.size(), 0), m_sides(assembly.joints.size(), 0)
    {
        const bool hasSameStocks = model.document.stocks == before.model.document.stocks;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
            const bool isKnown = place < before.cuts.size();
            const bool isAsThick =
                isKnown && ((hasSameStocks && model.section(i) == before.model.section(place)) ||
                            model.stockOf(i).thickness == before.model.stockOf(place).thickness);
            if (isAsThick && cuts[i] == before.cuts[place])
                continue;
            m_changed[i] = 1;
            if (isAsThick)
                findUntouched(assembly.slits[i],
                              CutChange(*cuts[i], assembly.slits[i], *before.cuts[place],
                                        before.assembly.slits[place]));
        }
    }

    /// Of one whose crossing is what it was.
    bool has(const Joint &joint) const
    {
        return m_changed[static_cast<std::size_t>(joint.a)] +
                   m_changed[static_cast<std::size_t>(joint.b)] ==
               m_sides[static_cast<std::size_t>(joint.id) - 1];
    }

private:
    void findUntouched(const std::vector<Slit> &slits, const CutChange &change)
    {
        if (change.isEverywhere())
            return;
        for (std::size_t from = 0, to = 0; from < slits.size(); from = to) {
            bool isTouched = false;
            for (; to < slits.size() && slits[to].joint == slits[from].joint; ++to)
                // What is looked at of a joint lies along its axis.
                isTouched = isTouched || slits[to].role != SlitRole::Slit || !slits[to].isOpen ||
                            change.isNear(to, 0.5 * slits[to].width + 2.0 * kGripWall);
            if (!isTouched)
                ++m_sides[static_cast<std::size_t>(slits[from].joint) - 1];
        }
    }

    std::vector<char> m_changed; // of each section whether it is another one
    std::vector<char> m_sides;   // of each joint how many of these are the same beside it
};

/// Of each joint the index before of the one that holds what it holds now, or −1.
std::vector<int> knownJoints(const Untouched &untouched, const JointList &joints,
                             const JointList &before, const std::optional<std::vector<int>> &places)
{
    std::vector<int> known(joints.size(), -1);
    for (std::size_t a = 0; a < joints.rows().size(); ++a) {
        const std::size_t place = places ? static_cast<std::size_t>((*places)[a]) : a;
        if (place >= before.rows().size())
            continue;
        const std::vector<Joint> &row = joints.rows()[a], &rowBefore = before.rows()[place];
        std::unordered_map<const Crossing *, std::size_t> byCrossing;
        if (row.size() != rowBefore.size())
            for (std::size_t k = 0; k < rowBefore.size(); ++k)
                byCrossing.emplace(rowBefore[k].crossing.get(), k);
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::size_t k = i;
            if (row.size() != rowBefore.size()) {
                const auto found = byCrossing.find(row[i].crossing.get());
                k = found == byCrossing.end() ? rowBefore.size() : found->second;
            }
            if (k < rowBefore.size() && rowBefore[k].crossing == row[i].crossing &&
                untouched.has(row[i]))
                known[joints.start(a) + i] = static_cast<int>(before.start(place) + k);
        }
    }
    return known;
}

} // namespace

Grips Grips::find(const Model &model, const Assembly &assembly,
                  const std::vector<CutSectionPointer> &cuts, const Before &before,
                  const std::optional<std::vector<int>> &places)
{
    const auto side = [&](int section) {
        const auto i = static_cast<std::size_t>(section);
        const Stock &stock = model.stockOf(i);
        return GripSide{assembly.slits[i], *cuts[i], model.section(i)->frame, stock.thickness,
                        stock.clearance};
    };
    const std::vector<int> known = knownJoints(Untouched(model, assembly, cuts, before, places),
                                               assembly.joints, before.assembly.joints, places);
    Grips grips;
    grips.m_blocks.reserve((known.size() + kInBlock - 1) / kInBlock);
    GripFinder finder;
    for (std::size_t first = 0; first < known.size(); first += kInBlock) {
        const std::size_t last = std::min(first + kInBlock, known.size());
        const std::size_t index = grips.m_blocks.size();
        bool isSame = before.grips.hasBlock(index, last - first);
        for (std::size_t i = first; isSame && i < last; ++i)
            isSame = known[i] == static_cast<int>(i);
        if (isSame) {
            grips.m_blocks.push_back(before.grips.m_blocks[index]);
            continue;
        }
        Block block;
        block.reserve(last - first);
        for (std::size_t i = first; i < last; ++i) {
            if (known[i] >= 0) {
                block.push_back(before.grips.pointer(known[i]));
                continue;
            }
            const Joint &joint = assembly.joints[i];
            block.push_back(std::make_shared<const JointGrips>(
                finder.find(joint, side(joint.a), side(joint.b))));
        }
        grips.m_blocks.push_back(std::make_shared<const Block>(std::move(block)));
    }
    return grips;
}

std::vector<int> sectionsOf(const Bodies &bodies, const std::vector<int> &group)
{
    std::vector<int> sections;
    sections.reserve(group.size());
    for (const int body : group) // which come in the order of their sections
        sections.push_back(bodies.sectionOf(body));
    sections.erase(std::unique(sections.begin(), sections.end()), sections.end());
    return sections;
}

std::vector<std::vector<int>> heldGroups(const Bodies &bodies, const JointList &joints,
                                         const Grips &grips)
{
    Groups held(bodies.size());
    for (const Joint &joint : joints) {
        if (joint.kind == JointKind::None)
            continue;
        for (const Grip &grip : grips.of(joint).held)
            held.join(static_cast<std::size_t>(bodies.firstOf(joint.a) + grip.a),
                      static_cast<std::size_t>(bodies.firstOf(joint.b) + grip.b));
    }
    struct Sized
    {
        std::size_t sections = 0;
        std::vector<int> bodies;
    };
    std::vector<Sized> sized;
    for (const std::vector<std::size_t> &group : held.all()) {
        std::vector<int> members(group.begin(), group.end());
        const std::size_t sections = sectionsOf(bodies, members).size();
        sized.push_back({sections, std::move(members)});
    }
    std::stable_sort(sized.begin(), sized.end(), [](const Sized &x, const Sized &y) {
        return std::pair(x.sections, x.bodies.size()) > std::pair(y.sections, y.bodies.size());
    });
    std::vector<std::vector<int>> groups;
    for (Sized &group : sized)
        groups.push_back(std::move(group.bodies));
    return groups;
}

} // namespace fff
