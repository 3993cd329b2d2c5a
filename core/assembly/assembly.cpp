#include "core/assembly/assembly.h"

#include "core/assembly/crossing.h"
#include "core/assembly/found_joint.h"
#include "core/assembly/kept_joint.h"
#include "core/assembly/realigned.h"
#include "core/model/changes.h"

#include <algorithm>
#include <map>
#include <optional>

namespace fff {

namespace {

bool isSameGeometry(const Section &a, const Section &b)
{
    return a.ref() == b.ref() && a.shape == b.shape && a.stock == b.stock && a.frame == b.frame;
}

/// Of which sections other joints are wanted now than before.
std::vector<char> otherwiseWanted(const Model &model, const Model &previous)
{
    std::vector<char> is(model.sectionCount(), char(false));
    const auto &now = model.document.jointOverrides, &before = previous.document.jointOverrides;
    if (now == before)
        return is;
    const auto mark = [&](const JointOverridePointer &joint) {
        for (const SectionRef &ref : {joint->a, joint->b})
            if (const int index = model.indexOf(ref); index >= 0)
                is[static_cast<std::size_t>(index)] = true;
    };
    for (const auto &[these, those] : {std::pair(&now, &before), {&before, &now}})
        for (const JointOverridePointer &joint : *these)
            if (std::find(those->begin(), those->end(), joint) == those->end())
                mark(joint);
    return is;
}

/// By which a section's neighbours are found. One that tabs are wanted of reaches as far as to the
/// other side of a slab on whose face it ends (cutTabs): half of the strip is no more than both
/// thicknesses, one from either box.
class Boxes
{
public:
    explicit Boxes(const Model &model)
        : m_model(model), m_hasTabs(model.sectionCount(), char(false))
    {
        for (const JointOverridePointer &joint : model.document.jointOverrides) {
            if (joint->kind != JointKind::Tabs)
                continue;
            for (const SectionRef &ref : {joint->a, joint->b})
                if (const int index = model.indexOf(ref); index >= 0)
                    m_hasTabs[static_cast<std::size_t>(index)] = true;
        }
    }

    Box3 of(std::size_t index) const
    {
        const Section &section = *m_model.section(index);
        Box3 box = worldBounds(*section.shape, section.frame);
        if (m_hasTabs[index]) {
            const double reach = m_model.stockOf(index).thickness + kEdgeReach;
            box.min.array() -= reach;
            box.max.array() += reach;
        }
        return box;
    }

private:
    const Model &m_model;
    std::vector<char> m_hasTabs;
};

/// Of each section its index in the model before, or −1; nothing: the same.
using Places = std::optional<std::vector<int>>;

/// What one model has of another: which of its sections differ.
class Difference
{
public:
    Difference(const Model &model, const Model &previous, const Places &places);

    const std::vector<int> &changed() const { return m_changed; }
    /// Then looking at everything once is faster than at each of them.
    bool isLarge() const
    {
        return m_changed.size() > 8 && m_changed.size() > m_isChanged.size() / 8;
    }
    /// Also for sections that are not there any more.
    bool isChanged(int index) const
    {
        const auto i = static_cast<std::size_t>(index);
        return i >= m_isChanged.size() || m_isChanged[i];
    }
    /// Of a section that has another shape and all else as it was; null: it has not, or nobody has
    /// looked where.
    const ShapeChange *reshaped(int index) const
    {
        const auto it = m_reshaped.find(index);
        return it == m_reshaped.end() ? nullptr : &it->second;
    }

private:
    void findReshaped(const Model &model, const Model &previous, const Places &places,
                      const std::vector<char> &isWantedOtherwise);

    std::vector<int> m_changed; // ascending
    std::vector<char> m_isChanged;
    std::map<int, ShapeChange> m_reshaped;
};

Difference::Difference(const Model &model, const Model &previous, const Places &places)
    : m_isChanged(model.sectionCount(), char(false))
{
    // Sections of a stock that became another one have other slits.
    const bool hasSameStocks = model.document.stocks == previous.document.stocks;
    const auto hasSameStock = [&](const Section &section) {
        const Stock *before = previous.document.find(section.stock);
        const Stock &now = model.document.stockOf(section);
        return before && (before == &now || cutsTheSameSlits(*before, now));
    };
    const std::vector<char> isWantedOtherwise = otherwiseWanted(model, previous);
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
        bool isSame = place < previous.sectionCount() && !isWantedOtherwise[i];
        if (isSame) {
            const SectionPointer &now = model.section(i), &before = previous.section(place);
            isSame = (now == before || isSameGeometry(*now, *before)) &&
                     (hasSameStocks || hasSameStock(*now));
        }
        if (!isSame) {
            m_isChanged[i] = true;
            m_changed.push_back(static_cast<int>(i));
        }
    }
    if (!isLarge() && hasSameStocks)
        findReshaped(model, previous, places, isWantedOtherwise);
}

void Difference::findReshaped(const Model &model, const Model &previous, const Places &places,
                              const std::vector<char> &isWantedOtherwise)
{
    for (const int index : m_changed) {
        const auto i = static_cast<std::size_t>(index);
        const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
        if (place >= previous.sectionCount() || isWantedOtherwise[i])
            continue;
        const Section &now = *model.section(i), &before = *previous.section(place);
        if (now.ref() == before.ref() && now.stock == before.stock && now.frame == before.frame)
            m_reshaped.emplace(index, ShapeChange(*now.shape, *before.shape));
    }
}

/// The joints of those pairs that have one; those that the edit does not come near as they were.
std::vector<FoundJoint> findJoints(const Model &model, const Assembly &before,
                                   const Difference &difference,
                                   const std::vector<std::pair<int, int>> &pairs)
{
    std::vector<FoundJoint> found;
    found.reserve(pairs.size());
    for (const auto &[a, b] : pairs) {
        const ShapeChange *ofA = difference.reshaped(a), *ofB = difference.reshaped(b);
        const bool mayBeKept =
            (ofA || !difference.isChanged(a)) && (ofB || !difference.isChanged(b));
        std::optional<FoundJoint> joint =
            mayBeKept ? keptJoint(model, before, a, b, ofA, ofB) : std::nullopt;
        if (!joint)
            joint = findJoint(model, a, b);
        if (joint)
            found.push_back(*std::move(joint));
    }
    return found;
}

/// Pairs of sections of which one differs at least, whose boxes meet, in their order.
std::vector<std::pair<int, int>> pairsToLookAt(const Difference &difference,
                                               const std::vector<Box3> &boxes)
{
    std::vector<std::pair<int, int>> pairs;
    if (difference.isLarge()) {
        pairs = meetingPairs(boxes);
        std::erase_if(pairs, [&](const auto &pair) {
            return !difference.isChanged(pair.first) && !difference.isChanged(pair.second);
        });
        return pairs;
    }
    for (const int i : difference.changed()) {
        const Box3 &box = boxes[static_cast<std::size_t>(i)];
        for (int j = 0; j < static_cast<int>(boxes.size()); ++j) {
            // Two that both differ are looked at from the lower one.
            if (j != i && (j > i || !difference.isChanged(j)) &&
                box.intersects(boxes[static_cast<std::size_t>(j)]))
                pairs.emplace_back(std::min(i, j), std::max(i, j));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Sections whose joints and slits may differ: those that changed, and their mates before and now.
std::vector<int> concernedSections(const Difference &difference, const Assembly &before,
                                   std::size_t count, const std::vector<FoundJoint> &found)
{
    std::vector<char> isConcerned(count, char(false));
    const auto add = [&](int section) {
        if (static_cast<std::size_t>(section) < count)
            isConcerned[static_cast<std::size_t>(section)] = true;
    };
    for (const int index : difference.changed())
        add(index);
    for (const FoundJoint &item : found) {
        add(item.joint.a);
        add(item.joint.b);
    }
    // Those behind it are in its row.
    const auto addMatesBefore = [&](std::size_t index) {
        for (const Joint &joint : before.joints.rows()[index])
            add(joint.b);
        for (std::size_t mate = 0; mate < std::min(count, index); ++mate)
            if (before.boxes[mate].intersects(before.boxes[index]) &&
                before.joints.find(static_cast<int>(mate), static_cast<int>(index)))
                add(static_cast<int>(mate));
    };
    if (difference.isLarge()) {
        for (const Joint &joint : before.joints) {
            for (const auto &[index, mate] : {std::pair(joint.a, joint.b), {joint.b, joint.a}}) {
                if (difference.isChanged(index))
                    add(mate);
            }
        }
    } else {
        for (const int index : difference.changed()) {
            if (static_cast<std::size_t>(index) < before.boxes.size())
                addMatesBefore(static_cast<std::size_t>(index));
        }
    }
    for (std::size_t gone = count; gone < before.boxes.size(); ++gone)
        addMatesBefore(gone);
    std::vector<int> concerned;
    for (std::size_t i = 0; i < count; ++i)
        if (isConcerned[i])
            concerned.push_back(static_cast<int>(i));
    return concerned;
}

/// What stays of a row and what is new, both in the order of their mates; no mate is in both.
template <class T>
std::vector<T> renewed(const std::vector<T> &row, std::vector<T> added, int T::*mate,
                       const Difference &difference)
{
    if (row.empty())
        return added;
    std::vector<T> result;
    result.reserve(row.size() + added.size());
    auto next = added.begin();
    for (const T &item : row) {
        if (difference.isChanged(item.*mate))
            continue;
        for (; next != added.end() && (*next).*mate < item.*mate; ++next)
            result.push_back(std::move(*next));
        result.push_back(item);
    }
    std::move(next, added.end(), std::back_inserter(result));
    return result;
}

/// Replaces the joints of the sections that are concerned. Whether another joint got a new id.
bool renewJoints(const Difference &difference, const std::vector<int> &concerned,
                 const std::vector<FoundJoint> &found, std::size_t count, JointList &joints)
{
    static const std::vector<Joint> none;
    std::vector<JointList::NewRow> rows;
    auto next = found.begin(); // they are in the order of the rows
    for (const int a : concerned) {
        const auto index = static_cast<std::size_t>(a);
        const bool isKnown = index < joints.rows().size();
        const std::vector<Joint> &before = isKnown ? joints.rows()[index] : none;
        std::vector<Joint> added;
        for (; next != found.end() && next->joint.a == a; ++next)
            added.push_back(next->joint);
        const bool hasAdded = !added.empty();
        std::vector<Joint> row = renewed(difference.isChanged(a) ? none : before, std::move(added),
                                         &Joint::b, difference);
        if (hasAdded || row.size() != before.size())
            rows.push_back({index, std::move(row)});
    }
    return joints.replace(count, std::move(rows));
}

/// Replaces the slits of the sections that are concerned; where joints got new ids, all that name
/// them. Rows that come out as they were stay.
void renewSlits(const Difference &difference, const std::vector<int> &concerned,
                const std::vector<FoundJoint> &found, const JointList &joints, bool hasNewIds,
                SharedRows<Slit> &slits)
{
    static const std::vector<Slit> none;
    const auto idOf = [&joints](int host, int guest) {
        return joints.find(std::min(host, guest), std::max(host, guest))->id;
    };
    std::vector<std::size_t> placeOf(slits.size(), 0); // of those concerned among them
    for (std::size_t place = 0; place < concerned.size(); ++place)
        placeOf[static_cast<std::size_t>(concerned[place])] = place;
    std::vector<std::vector<Slit>> added(concerned.size());
    std::size_t inRow = 0; // they come in the order of the rows
    for (auto it = found.begin(); it != found.end(); ++it) {
        const FoundJoint &item = *it;
        const std::vector<Joint> &row = joints.rows()[static_cast<std::size_t>(item.joint.a)];
        if (it == found.begin() || std::prev(it)->joint.a != item.joint.a)
            inRow = 0;
        while (row[inRow].b != item.joint.b)
            ++inRow;
        const int id = row[inRow].id;
        for (const auto &[index, list] :
             {std::pair(item.joint.a, &item.slitsOfA), std::pair(item.joint.b, &item.slitsOfB)}) {
            std::vector<Slit> &slitsOf = added[placeOf[static_cast<std::size_t>(index)]];
            for (const Slit &slit : *list) {
                slitsOf.push_back(slit);
                slitsOf.back().joint = id;
            }
        }
    }
    SharedRows<Slit>::Editor editor(slits);
    const auto renew = [&](std::size_t index, std::vector<Slit> row) {
        for (Slit &slit : row)
            if (hasNewIds)
                slit.joint = idOf(static_cast<int>(index), slit.guest);
        if (row != slits[index])
            editor.set(index, std::move(row));
    };
    for (std::size_t place = 0; place < concerned.size(); ++place) {
        const int host = concerned[place];
        const auto index = static_cast<std::size_t>(host);
        const std::vector<Slit> &before = difference.isChanged(host) ? none : slits[index];
        renew(index, renewed(before, std::move(added[place]), &Slit::guest, difference));
    }
    for (std::size_t index = 0; hasNewIds && index < slits.size(); ++index)
        if (!std::binary_search(concerned.begin(), concerned.end(), static_cast<int>(index)))
            renew(index, slits[index]);
}

/// Those that were there are in the order in which they were.
bool isAscending(const std::vector<int> &places)
{
    int last = -1;
    for (const int place : places) {
        if (place >= 0 && place < last)
            return false;
        last = std::max(last, place);
    }
    return true;
}

} // namespace

Assembly assemble(const Model &model)
{
    return assemble(model, Model(), Assembly());
}

Assembly assemble(const Model &model, const Model &previous, const Assembly &last)
{
    Places places = placesBefore(model, previous);
    Realigned moved;
    if (places) {
        // Where sections changed their order, nothing is kept.
        if (!isAscending(*places))
            std::fill(places->begin(), places->end(), -1);
        moved = realigned(last, *places);
    }
    const Assembly &before = places ? moved.assembly : last;
    const std::size_t count = model.sectionCount();
    const Difference difference(model, previous, places);
    Assembly assembly = before;
    assembly.boxes.resize(count);
    assembly.slits.resize(count);
    const Boxes boxes(model);
    for (const int i : difference.changed())
        assembly.boxes[static_cast<std::size_t>(i)] = boxes.of(static_cast<std::size_t>(i));
    const std::vector<FoundJoint> found =
        findJoints(model, before, difference, pairsToLookAt(difference, assembly.boxes));
    const std::vector<int> concerned = concernedSections(difference, before, count, found);
    const bool hasNewIds =
        renewJoints(difference, concerned, found, count, assembly.joints) || moved.hasNewIds;
    renewSlits(difference, concerned, found, assembly.joints, hasNewIds, assembly.slits);
    return assembly;
}

} // namespace fff
