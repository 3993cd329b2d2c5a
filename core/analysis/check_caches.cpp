#include "core/analysis/check_caches.h"

#include "core/analysis/gap.h"
#include "core/geometry/offset.h"

#include <algorithm>
#include <unordered_map>

namespace fff {

namespace {

/// The keys of the rest of an entry, but for the bodies.
bool isOf(const CheckCaches::OfSection &known, const CheckCaches::OfSection &now)
{
    return known.kerf == now.kerf && known.room == now.room && known.turnsFreely == now.turnsFreely;
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
        Entry &entry = m_entries[now.bodies.empty() ? nullptr : now.bodies.front()->cut().get()];
        if (entry.sizes.empty() || !isSame(entry, now)) {
            entry = {now.kerf, now.room, now.turnsFreely, {}};
            for (const BodyPointer &body : now.bodies) {
                // What has no offset is too near to the largest coordinate to have a size of its
                // own.
                const CurvedRegion outline =
                    growLoosely(body->outline(), 0.5 * now.kerf).value_or(body->outline());
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

/// Works out what is not known of this section: the box that it had before, or nothing where all is
/// known.
std::optional<Box3> refresh(const Analysis &analysis, int section, const LayoutOptions &options,
                            SharedSizes &sizes, CheckCaches &caches)
{
    const auto index = static_cast<std::size_t>(section);
    CheckCaches::OfSection &known = caches.sections[index];
    const Stock &stock = analysis.model.stockOf(index);
    CheckCaches::OfSection now;
    now.kerf = stock.kerf;
    now.room = roomOf(options.sheet.value_or(stock.sheet), options);
    now.turnsFreely = options.turnsFreely;
    const std::span<const BodyPointer> bodies = analysis.bodies.of(section);
    if (isOf(known, now) &&
        std::equal(known.bodies.begin(), known.bodies.end(), bodies.begin(), bodies.end()))
        return {};
    now.bodies.assign(bodies.begin(), bodies.end());
    Box3 before;
    for (const BodyPointer &body : known.bodies)
        before.extend(body->box());
    const bool touchesAsBefore =
        !known.bodies.empty() &&
        std::equal(now.bodies.begin(), now.bodies.end(), known.bodies.begin(), known.bodies.end(),
                   [](const BodyPointer &a, const BodyPointer &b) {
                       return a->contact() == b->contact();
                   });
    now.contactsSince = touchesAsBefore ? known.contactsSince : caches.count;
    now.sizes = sizes.of(now);
    if (known.bodies.size() != now.bodies.size()) {
        caches.gaps.clear(); // indices mean other bodies
        caches.stances.clear();
    }
    known = std::move(now);
    return before;
}

} // namespace

void refreshCaches(const Analysis &analysis, const LayoutOptions &options, CheckCaches &caches)
{
    const std::size_t count = analysis.model.sectionCount();
    if (caches.sections.size() != count) {
        caches.gaps.clear(); // indices mean other bodies, and there are others to be near
        caches.stances.clear();
    }
    caches.sections.resize(count);
    ++caches.count;
    SharedSizes sizes;
    for (std::size_t i = 0; i < count; ++i) {
        const int section = static_cast<int>(i);
        const std::optional<Box3> before = refresh(analysis, section, options, sizes, caches);
        if (!before)
            continue;
        const Box3 now = analysis.bodies.boxOf(section);
        std::erase_if(caches.gaps, [&](const CheckCaches::OfGroup &gap) {
            return isReached(gap, *before) || isReached(gap, now);
        });
    }
}

} // namespace fff
