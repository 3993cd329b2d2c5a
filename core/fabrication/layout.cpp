#include "core/fabrication/layout.h"

#include "core/base/tolerances.h"
#include "core/fabrication/open_sheets.h"
#include "core/fabrication/sheet_supply.h"

#include <algorithm>
#include <array>
#include <memory>

namespace fff {

namespace {

/// Less used height than this is no reason to turn parts away from how they are drawn, mm.
constexpr double kWorthTurning = 1.0;

enum class Turning { AsDrawn, Smallest, Lowest };
enum class Order { Tallest, Largest, Longest };

/// A part that is to be put on a sheet.
struct Item
{
    int part = 0;
    const OutlineSize *size = nullptr;
};

/// The ways in which a part may lie.
class Poses
{
public:
    static constexpr std::size_t kMost = 2;

    void add(const Pose &pose) { m_poses[m_count++] = pose; }
    const Pose *begin() const { return m_poses.data(); }
    const Pose *end() const { return m_poses.data() + m_count; }
    bool isEmpty() const { return m_count == 0; }
    std::size_t count() const { return m_count; }
    const Pose &lying() const { return m_poses[0]; }
    void putLyingFirst()
    {
        if (m_count == 2 && m_poses[1].size().y() < m_poses[0].size().y())
            std::swap(m_poses[0], m_poses[1]);
    }
    bool operator==(const Poses &other) const
    {
        return std::equal(begin(), end(), other.begin(), other.end(),
                          [](const Pose &a, const Pose &b) { return a.turn == b.turn; });
    }

private:
    std::array<Pose, kMost> m_poses;
    std::size_t m_count = 0;
};

/// That of its turning and a quarter turn more, lying first.
Poses posesOf(const OutlineSize &size, Turning turning, const Vec2 &room)
{
    Poses poses;
    if (size.fitting) {
        poses.add(*size.fitting);
        return poses;
    }
    const auto add = [&](const Pose &pose) {
        for (const Pose &candidate : {pose, quarterMore(pose)})
            if (fits(candidate.size(), room))
                poses.add(candidate);
    };
    if (turning != Turning::AsDrawn)
        add(turning == Turning::Smallest ? size.smallest : size.lowest);
    if (poses.isEmpty())
        add(size.drawn);
    poses.putLyingFirst();
    return poses;
}

/// One try: all items of a stock on sheets, or those put so far.
struct Packing
{
    struct Put
    {
        std::size_t sheet = 0;
        Placement placement;
    };

    std::vector<Put> puts;
    std::vector<double> heights; // used, of each sheet
    double height = 0.0;         // of all together

    /// Whether it is better, or can become it: neither sheets nor heights get less.
    bool isBetterThan(const Packing &other) const
    {
        if (heights.size() != other.heights.size())
            return heights.size() < other.heights.size();
        return height < other.height - kWorthTurning;
    }
};

double sortKey(const Pose &lying, Order order)
{
    const Vec2 size = lying.size();
    switch (order) {
    case Order::Tallest:
        return size.y();
    case Order::Largest:
        return size.x() * size.y();
    case Order::Longest:
        return size.x();
    }
    return 0.0; // not reached: every order is above
}

/// The ways in which each item may lie, and the order in which they are put.
struct Plan
{
    std::shared_ptr<const std::vector<Poses>> poses; // of each item
    std::vector<std::size_t> order;

    bool operator==(const Plan &other) const
    {
        return order == other.order && (poses == other.poses || *poses == *other.poses);
    }
};

std::vector<std::size_t> sorted(const std::vector<Poses> &poses, Order by)
{
    std::vector<std::pair<double, std::size_t>> keys;
    keys.reserve(poses.size());
    for (std::size_t i = 0; i < poses.size(); ++i)
        keys.emplace_back(-sortKey(poses[i].lying(), by), i);
    if (!std::is_sorted(keys.begin(), keys.end())) // parts of a row are alike
        std::sort(keys.begin(), keys.end());
    std::vector<std::size_t> order;
    order.reserve(keys.size());
    for (const auto &[key, index] : keys)
        order.push_back(index);
    return order;
}

/// Nothing when it cannot become better than the best so far.
std::optional<Packing> pack(const std::vector<Item> &items, const Plan &plan, const Vec2 &size,
                            const LayoutOptions &options, const std::optional<Packing> &best)
{
    // Boxes and room both get the spacing on two sides: so it is between boxes and nowhere else.
    const Vec2 gap = Vec2::Constant(options.spacing);
    const Vec2 room = size - Vec2::Constant(2.0 * options.margin) + gap;
    Packing packing;
    packing.puts.reserve(items.size());
    OpenSheets sheets(room);
    for (const std::size_t index : plan.order) {
        const Poses &poses = (*plan.poses)[index];
        std::array<Vec2, Poses::kMost> boxes;
        std::transform(poses.begin(), poses.end(), boxes.begin(),
                       [&gap](const Pose &pose) -> Vec2 { return pose.size() + gap; });
        const OpenSheets::Place place = sheets.put({boxes.data(), poses.count()});
        packing.heights.resize(sheets.count(), 0.0);
        double &height = packing.heights[place.sheet];
        packing.height += std::max(0.0, place.on.top - height);
        height = std::max(height, place.on.top);
        if (best && !packing.isBetterThan(*best))
            return std::nullopt;
        const Vec2 corner = Vec2::Constant(options.margin) + place.on.corner;
        const Pose &pose = poses.begin()[place.box];
        packing.puts.push_back(
            {place.sheet, {items[index].part, pose.turn, corner - pose.box.min}});
    }
    return packing;
}

/// Tries that differ, each once.
std::vector<Plan> plansFor(const std::vector<Item> &items, Turning turning, const Vec2 &room)
{
    std::vector<Poses> poses;
    poses.reserve(items.size());
    for (const Item &item : items)
        poses.push_back(posesOf(*item.size, turning, room));
    const auto shared = std::make_shared<const std::vector<Poses>>(std::move(poses));
    std::vector<Plan> plans;
    for (const Order by : {Order::Tallest, Order::Largest, Order::Longest}) {
        Plan plan{shared, sorted(*shared, by)};
        if (std::find(plans.begin(), plans.end(), plan) == plans.end())
            plans.push_back(std::move(plan));
    }
    return plans;
}

std::vector<Sheet> sheetsOf(const Packing &packing, const Sheet &empty)
{
    std::vector<Sheet> sheets(packing.heights.size(), empty);
    for (std::size_t i = 0; i < sheets.size(); ++i)
        sheets[i].index = static_cast<int>(i);
    for (const Packing::Put &put : packing.puts)
        sheets[put.sheet].placements.push_back(put.placement);
    return sheets;
}

std::vector<Sheet> pack(const std::vector<Item> &items, const Sheet &empty,
                        const LayoutOptions &options)
{
    const Vec2 room = roomOf(empty.size, options);
    std::vector<Turning> turnings{Turning::AsDrawn};
    if (options.turnsFreely)
        turnings.insert(turnings.end(), {Turning::Smallest, Turning::Lowest});
    std::optional<Packing> best;
    std::vector<Plan> tried;
    for (const Turning turning : turnings) {
        for (Plan &plan : plansFor(items, turning, room)) {
            // Parts that are best turned as they are drawn are tried once.
            if (std::find(tried.begin(), tried.end(), plan) != tried.end())
                continue;
            if (auto packing = pack(items, plan, empty.size, options, best))
                best = std::move(packing);
            tried.push_back(std::move(plan));
        }
    }
    return sheetsOf(*best, empty);
}

/// Whether the same items were laid out on the same sheets.
bool isOf(const LayoutCache::OfStock &known, const std::vector<Item> &items, const Sheet &empty,
          const LayoutOptions &options)
{
    if (!known.sheets || known.stock != empty.stock || known.sheet != empty.size ||
        known.options != options || known.parts.size() != items.size())
        return false;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (known.parts[i] != items[i].part || !haveSamePoses(*known.sizes[i], *items[i].size))
            return false;
    return true;
}

LayoutCache::OfStock laidOut(const std::vector<Item> &items, const std::vector<SizedPart> &parts,
                             const Sheet &empty, const LayoutOptions &options)
{
    LayoutCache::OfStock made{empty.stock, empty.size, options, {}, {}, {}};
    for (const Item &item : items) {
        made.parts.push_back(item.part);
        made.sizes.push_back(parts[static_cast<std::size_t>(item.part)].size);
    }
    made.sheets = std::make_shared<const std::vector<Sheet>>(pack(items, empty, options));
    return made;
}

} // namespace

Vec2 roomOf(const Vec2 &sheet, const LayoutOptions &options)
{
    return sheet - Vec2::Constant(2.0 * options.margin);
}

Layout layOutBySize(const std::vector<SizedPart> &parts, const Model &model,
                    const LayoutOptions &options)
{
    LayoutCache cache;
    return layOutBySize(parts, model, options, cache);
}

Layout layOutBySize(const std::vector<SizedPart> &parts, const Model &model,
                    const LayoutOptions &options, LayoutCache &cache)
{
    Layout layout;
    cache.stocks.resize(model.document.stocks.size());
    for (std::size_t k = 0; k < cache.stocks.size(); ++k) {
        const Stock &stock = *model.document.stocks[k];
        const Sheet empty{stock.id, options.sheet.value_or(stock.sheet), {}, 0};
        std::vector<Item> items;
        std::vector<Sheet> oversized;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i].stock != stock.id)
                continue;
            const OutlineSize &size = *parts[i].size;
            if (!size.isTooLarge) {
                items.push_back({static_cast<int>(i), &size});
                continue;
            }
            Sheet own{stock.id, size.drawn.size() + Vec2::Constant(2.0 * options.margin), {}, 0};
            own.placements.push_back({static_cast<int>(i), size.drawn.turn,
                                      Vec2::Constant(options.margin) - size.drawn.box.min});
            oversized.push_back(std::move(own));
            layout.oversized.push_back(static_cast<int>(i));
        }
        if (!items.empty()) {
            if (!isOf(cache.stocks[k], items, empty, options))
                cache.stocks[k] = laidOut(items, parts, empty, options);
            const std::vector<Sheet> &sheets = *cache.stocks[k].sheets;
            layout.sheets.insert(layout.sheets.end(), sheets.begin(), sheets.end());
        }
        std::move(oversized.begin(), oversized.end(), std::back_inserter(layout.sheets));
    }
    return layout;
}

namespace {

std::vector<SizedPart> sized(const std::vector<Part> &parts, const Model &model,
                             const LayoutOptions &options)
{
    std::vector<SizedPart> result;
    result.reserve(parts.size());
    for (const Part &part : parts) {
        const Stock *stock = model.document.find(part.stock);
        if (!stock) {
            result.push_back({part.stock, std::make_shared<const OutlineSize>()});
            continue;
        }
        const Vec2 room = roomOf(options.sheet.value_or(stock->sheet), options);
        result.push_back({part.stock, std::make_shared<const OutlineSize>(
                                          sizeOf(part.outline, room, options.turnsFreely))});
    }
    return result;
}

} // namespace

Layout layOut(const std::vector<Part> &parts, const Model &model, const LayoutOptions &options)
{
    return layOutBySize(sized(parts, model, options), model, options);
}

double usedShare(const Layout &layout, const std::vector<SizedPart> &parts)
{
    double used = 0.0, whole = 0.0;
    for (const Sheet &sheet : layout.sheets) {
        whole += areaOf(sheet);
        for (const Placement &placement : sheet.placements)
            used += parts[static_cast<std::size_t>(placement.part)].size->area;
    }
    return whole > 0.0 ? used / whole : 0.0;
}

double usedShare(const Layout &layout, const std::vector<Part> &parts)
{
    std::vector<SizedPart> areas;
    for (const Part &part : parts) {
        OutlineSize size;
        size.area = part.outline.outer.signedArea();
        for (const Contour &hole : part.outline.holes)
            size.area += hole.signedArea();
        areas.push_back({part.stock, std::make_shared<const OutlineSize>(size)});
    }
    return usedShare(layout, areas);
}

} // namespace fff
