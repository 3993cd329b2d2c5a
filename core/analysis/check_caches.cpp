#include "core/analysis/check_caches.h"

#include "core/analysis/gap.h"
#include "core/geometry/offset.h"

#include <unordered_map>

namespace fff {

namespace {

/// The keys of the rest of an entry.
bool isOf(const CheckCaches::OfSection &known, const CheckCaches::OfSection &now)
{
    return known.cut == now.cut && known.frame == now.frame && known.thickness == now.thickness &&
           known.kerf == now.kerf && known.room == now.room && known.turnsFreely == now.turnsFreely;
}

// Steps of a mm and of a turn's cosine.
constexpr double kSizeSteps = 1e9;

Vec2 onGrid(const Vec2 &v)
{
    return (kSizeSteps * v).array().round() / kSizeSteps;
}

Pose onGrid(const Pose &pose)
{
    return {onGrid(pose.turn), Box2{onGrid(pose.box.min), onGrid(pose.box.max)}};
}

/// A slit that is cut deeper leaves the part as large as it was, but for rounding: on a grid it is
/// as large, and all parts may lie where they lay.
OutlineSize withoutRounding(OutlineSize size)
{
    for (Pose *pose : {&size.drawn, &size.smallest, &size.lowest})
        *pose = onGrid(*pose);
    if (size.fitting)
        size.fitting = onGrid(*size.fitting);
    return size;
}

/// The sizes of cuts that many sections share, each worked out once.
class SharedSizes
{
public:
    /// `now` has all that they follow from.
    const std::vector<std::shared_ptr<const OutlineSize>> &of(const CheckCaches::OfSection &now)
    {
        Entry &entry = m_entries[now.cut.get()];
        if (entry.sizes.empty() || !isSame(entry, now)) {
            entry = {now.kerf, now.room, now.turnsFreely, {}};
            for (const CurvedRegion &part : now.cut->parts()) {
                // What has no offset is too near to the largest coordinate to have a size of its
                // own.
                const CurvedRegion outline = growLoosely(part, 0.5 * now.kerf).value_or(part);
                entry.sizes.push_back(std::make_shared<const OutlineSize>(
                    withoutRounding(sizeOf(outline, now.room, now.turnsFreely))));
            }
        }
        return entry.sizes;
    }

private:
    struct Entry
    {
        double kerf = 0.0; // mm
        Vec2 room = Vec2::Zero();
        bool turnsFreely = true;
        std::vector<std::shared_ptr<const OutlineSize>> sizes;
    };
    static bool isSame(const Entry &entry, const CheckCaches::OfSection &now)
    {
        return entry.kerf == now.kerf && entry.room == now.room &&
               entry.turnsFreely == now.turnsFreely;
    }

    std::unordered_map<const CutSection *, Entry> m_entries;
};

/// Works out what is not known of this section. Whether there was something.
bool refresh(const Analysis &analysis, int section, const LayoutOptions &options,
             SharedSizes &sizes, CheckCaches &caches)
{
    const auto index = static_cast<std::size_t>(section);
    CheckCaches::OfSection &known = caches.sections[index];
    const Stock &stock = analysis.model.stockOf(index);
    CheckCaches::OfSection now;
    now.cut = analysis.cuts[index];
    now.frame = analysis.model.section(index)->frame;
    now.thickness = stock.thickness;
    now.kerf = stock.kerf;
    now.room = roomOf(options.sheet.value_or(stock.sheet), options);
    now.turnsFreely = options.turnsFreely;
    if (isOf(known, now))
        return false;
    for (const Slab &slab : slabsOf(analysis, section)) {
        now.contacts.push_back(contactOf(slab));
        now.box.extend(boundsOf(slab));
    }
    const bool touchesAsBefore = known.cut && now.contacts == known.contacts;
    now.contactsSince = touchesAsBefore ? known.contactsSince : caches.count;
    now.sizes = sizes.of(now);
    known = std::move(now);
    return true;
}

} // namespace

void refreshCaches(const Analysis &analysis, const LayoutOptions &options, CheckCaches &caches)
{
    const std::size_t count = analysis.model.sectionCount();
    if (caches.sections.size() != count)
        caches.gaps.clear(); // indices mean other sections, and there are others to be near
    caches.sections.resize(count);
    ++caches.count;
    SharedSizes sizes;
    for (std::size_t i = 0; i < count; ++i) {
        const Box3 before = caches.sections[i].box;
        if (!refresh(analysis, static_cast<int>(i), options, sizes, caches))
            continue;
        const Box3 &now = caches.sections[i].box;
        std::erase_if(caches.gaps, [&](const CheckCaches::OfGroup &gap) {
            return isReached(gap, before) || isReached(gap, now);
        });
    }
}

std::vector<Slab> slabsOf(const Analysis &analysis, int section)
{
    const auto index = static_cast<std::size_t>(section);
    std::vector<Slab> slabs;
    for (const CurvedRegion &part : analysis.cuts[index]->parts())
        slabs.push_back({part.region, analysis.model.section(index)->frame,
                         analysis.model.stockOf(index).thickness});
    return slabs;
}

} // namespace fff
