#include "core/assembly/grips.h"

#include "core/assembly/cut_change.h"
#include "core/base/groups.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace fff {

namespace {

/// As many joints are passed in the time that it takes to look up one of them.
constexpr std::size_t kLookedUp = 8;

/// Beside which joints both sections are as thick, and cut, as they were.
class Untouched
{
public:
    Untouched(const Model &model, const Assembly &assembly, const CutList &cuts,
              const Grips::Before &before, const std::optional<std::vector<int>> &places)
        : m_isChanged(cuts.size(), 0), m_sides(assembly.joints.size(), 0)
    {
        const bool hasSameStocks = model.document.stocks == before.model.document.stocks;
        const std::vector<SectionPointer> &sections = model.sections(),
                                          &sectionsBefore = before.model.sections();
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
            const bool isKnown = place < before.cuts.size();
            const bool isAsThick =
                isKnown && ((hasSameStocks && sections[i] == sectionsBefore[place]) ||
                            model.stockOf(i).thickness == before.model.stockOf(place).thickness);
            if (isAsThick && cuts[i] == before.cuts[place])
                continue;
            m_isChanged[i] = 1;
            m_changed.push_back(static_cast<int>(i));
            if (isAsThick)
                findUntouched(assembly.slits[i],
                              CutChange(*cuts[i], assembly.slits[i], *before.cuts[place],
                                        before.assembly.slits[place]));
        }
    }

    /// Sections that are others than they were, ascending.
    const std::vector<int> &changed() const { return m_changed; }
    bool isChanged(std::size_t section) const { return m_isChanged[section]; }
    /// Of one whose crossing is what it was.
    bool has(const Joint &joint) const
    {
        return m_isChanged[static_cast<std::size_t>(joint.a)] +
                   m_isChanged[static_cast<std::size_t>(joint.b)] ==
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

    std::vector<int> m_changed;    // sections that are others now, ascending
    std::vector<char> m_isChanged; // of each section
    std::vector<char> m_sides;     // of each joint how many of these are the same beside it
};

/// Of each joint the index before of the one with its crossing, or −1.
std::vector<int> sameCrossings(const JointList &joints, const JointList &before,
                               const std::optional<std::vector<int>> &places)
{
    std::vector<int> same(joints.size(), -1);
    for (std::size_t a = 0; a < joints.rows().size(); ++a) {
        const std::size_t place = places ? static_cast<std::size_t>((*places)[a]) : a;
        if (joints.start(a) == joints.start(a + 1) || place >= before.rows().size())
            continue;
        const int start = static_cast<int>(before.start(place));
        const auto first = same.begin() + static_cast<std::ptrdiff_t>(joints.start(a));
        const std::vector<Joint> &row = joints.rows()[a], &rowBefore = before.rows()[place];
        if (&row == &rowBefore) {
            std::iota(first, first + std::ssize(row), start);
            continue;
        }
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
            if (k < rowBefore.size() && rowBefore[k].crossing == row[i].crossing)
                first[static_cast<std::ptrdiff_t>(i)] = start + static_cast<int>(k);
        }
    }
    return same;
}

/// Of each joint the index before of the one that holds what it holds now, or −1.
std::vector<int> knownJoints(const Untouched &untouched, const JointList &joints,
                             const JointList &before, const std::optional<std::vector<int>> &places)
{
    std::vector<int> known = sameCrossings(joints, before, places);
    const auto look = [&](const Joint &joint) {
        if (!untouched.has(joint))
            known[static_cast<std::size_t>(joint.id) - 1] = -1;
    };
    const std::vector<int> &changed = untouched.changed();
    for (std::size_t a = 0; a < joints.rows().size(); ++a) {
        const std::size_t count = joints.start(a + 1) - joints.start(a);
        if (count == 0)
            continue;
        // Few of a long row are looked up, not looked through.
        if (untouched.isChanged(a) || changed.size() > count / kLookedUp) {
            for (const Joint &joint : joints.rows()[a])
                look(joint);
        } else {
            for (const int b : changed)
                if (const Joint *joint = joints.find(static_cast<int>(a), b))
                    look(*joint);
        }
    }
    return known;
}

} // namespace

Grips Grips::find(const Model &model, const Assembly &assembly, const CutList &cuts,
                  const Before &before, const std::optional<std::vector<int>> &places)
{
    const auto side = [&](int section) {
        const auto i = static_cast<std::size_t>(section);
        const Stock &stock = model.stockOf(i);
        return GripSide{assembly.slits[i], *cuts[i], model.section(i)->frame, stock.thickness,
                        stock.clearance};
    };
    const std::vector<int> known = knownJoints(Untouched(model, assembly, cuts, before, places),
                                               assembly.joints, before.assembly.joints, places);
    Grips grips = before.grips;
    grips.m_all.resize(known.size());
    SharedList<Pointer>::Editor editor(grips.m_all);
    GripFinder finder;
    for (std::size_t i = 0; i < known.size(); ++i) {
        if (known[i] == static_cast<int>(i))
            continue;
        if (known[i] >= 0) {
            editor.set(i, before.grips.m_all[static_cast<std::size_t>(known[i])]);
            continue;
        }
        const Joint &joint = assembly.joints[i];
        editor.set(i, std::make_shared<const JointGrips>(
                          finder.find(joint, side(joint.a), side(joint.b))));
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
