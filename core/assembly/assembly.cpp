#include "core/assembly/assembly.h"

#include "core/assembly/crossing.h"
#include "core/assembly/slits.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <list>
#include <numeric>
#include <unordered_map>

namespace fff {

namespace {

// More than the joints of any model we know, drawn a few hundred times over: about 30 MB.
constexpr std::size_t kMaxCrossings = 65536;

/// Addresses name shapes here only together with a weak pointer that still holds: they get reused.
struct CrossingKey
{
    const Shape *shapeA, *shapeB;
    Frame frameA, frameB;

    bool operator==(const CrossingKey &) const = default;
};

struct CrossingHash
{
    std::size_t operator()(const CrossingKey &key) const noexcept
    {
        std::size_t seed = 0;
        const auto mix = [&seed](std::size_t h) {
            seed ^= h + 0x9e3779b97f4a7c15ull + (seed << 6) + (seed >> 2);
        };
        mix(std::hash<const Shape *>()(key.shapeA));
        mix(std::hash<const Shape *>()(key.shapeB));
        for (const Frame *frame : {&key.frameA, &key.frameB})
            for (const Vec3 *v : {&frame->origin, &frame->x, &frame->y})
                for (const double c : *v)
                    mix(std::hash<double>()(c));
        return seed;
    }
};

} // namespace

struct CrossingCache::Data
{
    struct Entry
    {
        CrossingKey key;
        std::weak_ptr<const Shape> shapeA, shapeB;
        std::shared_ptr<const Crossing> crossing;
    };
    std::list<Entry> entries; // most recently used first
    std::unordered_map<CrossingKey, std::list<Entry>::iterator, CrossingHash> index;

    std::shared_ptr<const Crossing> find(const Section &a, const Section &b);
};

std::shared_ptr<const Crossing> CrossingCache::Data::find(const Section &a, const Section &b)
{
    const CrossingKey key{a.shape.get(), b.shape.get(), a.frame, b.frame};
    const auto known = index.find(key);
    if (known != index.end()) {
        Entry &entry = *known->second;
        if (!entry.shapeA.expired() && !entry.shapeB.expired()) {
            entries.splice(entries.begin(), entries, known->second);
            return entry.crossing;
        }
        entries.erase(known->second);
        index.erase(known);
    }
    auto crossing =
        std::make_shared<const Crossing>(findCrossing(*a.shape, a.frame, *b.shape, b.frame));
    entries.push_front({key, a.shape, b.shape, crossing});
    index.emplace(key, entries.begin());
    if (entries.size() > kMaxCrossings) {
        index.erase(entries.back().key);
        entries.pop_back();
    }
    return crossing;
}

CrossingCache::CrossingCache() : m_data(std::make_unique<Data>()) {}
CrossingCache::~CrossingCache() = default;
CrossingCache::CrossingCache(CrossingCache &&) noexcept = default;
CrossingCache &CrossingCache::operator=(CrossingCache &&) noexcept = default;

namespace {

/// Drawn sections by their id, all others by their place behind them.
bool isLower(const Model &model, int a, int b)
{
    const SectionRef refA = model.ref(static_cast<std::size_t>(a));
    const SectionRef refB = model.ref(static_cast<std::size_t>(b));
    return refA.drawn.isValid() && refB.drawn.isValid() ? refA.drawn < refB.drawn : a < b;
}

void addSlits(std::vector<Slit> slits, int joint, int guest, std::vector<Slit> &all)
{
    for (Slit &slit : slits) {
        slit.joint = joint;
        slit.guest = guest;
        all.push_back(slit);
    }
}

} // namespace

Assembly assemble(const Model &model, CrossingCache &cache)
{
    const std::size_t count = model.sectionCount();
    std::vector<Box3> boxes;
    boxes.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        boxes.push_back(worldBounds(*model.section(i)->shape, model.section(i)->frame));

    Assembly assembly;
    assembly.slits.resize(count);
    for (const auto &[a, b] : meetingPairs(boxes)) {
        const Section &sectionA = *model.section(static_cast<std::size_t>(a));
        const Section &sectionB = *model.section(static_cast<std::size_t>(b));
        std::shared_ptr<const Crossing> crossing = cache.data().find(sectionA, sectionB);
        if (crossing->overlaps.empty())
            continue;
        const Stock &stockA = model.document.stockOf(sectionA);
        const Stock &stockB = model.document.stockOf(sectionB);
        JointSlits slits =
            cutSlits(*crossing, {sectionA, stockA.thickness, stockA.clearance},
                     {sectionB, stockB.thickness, stockB.clearance}, isLower(model, a, b));
        Joint joint;
        joint.id = static_cast<int>(assembly.joints.size()) + 1;
        joint.a = a;
        joint.b = b;
        joint.kind = slits.kind;
        joint.crossing = std::move(crossing);
        joint.meets = std::move(slits.meets);
        addSlits(std::move(slits.a), joint.id, b, assembly.slits[static_cast<std::size_t>(a)]);
        addSlits(std::move(slits.b), joint.id, a, assembly.slits[static_cast<std::size_t>(b)]);
        assembly.joints.push_back(std::move(joint));
    }
    return assembly;
}

std::vector<std::vector<int>> connectedGroups(std::size_t sectionCount,
                                              const std::vector<Joint> &joints)
{
    std::vector<int> leader(sectionCount);
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&leader](int i) {
        while (leader[i] != i)
            i = leader[i] = leader[leader[i]];
        return i;
    };
    for (const Joint &joint : joints) {
        if (joint.kind == JointKind::None)
            continue; // they collide, nothing holds
        const int a = find(joint.a), b = find(joint.b);
        leader[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::vector<int>> groups;
    std::unordered_map<int, std::size_t> groupOf;
    for (int i = 0; i < static_cast<int>(sectionCount); ++i) {
        const auto [it, isNew] = groupOf.try_emplace(find(i), groups.size());
        if (isNew)
            groups.emplace_back();
        groups[it->second].push_back(i);
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const auto &x, const auto &y) { return x.size() > y.size(); });
    return groups;
}

} // namespace fff
