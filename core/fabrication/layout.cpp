#include "core/fabrication/layout.h"

#include "core/base/tolerances.h"
#include "core/fabrication/skyline.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>
#include <array>

namespace fff {

namespace {

/// Less used height than this is no reason to turn parts away from how they are drawn, mm.
constexpr double kWorthTurning = 1.0;

enum class Turning { AsDrawn, Smallest, Lowest };
enum class Order { Tallest, Largest, Longest };

/// A part's box after a turn.
struct Pose
{
    Vec2 turn = Vec2::UnitX();
    Box2 box;

    Vec2 size() const { return box.size(); }
};

struct Item
{
    int part = 0;
    const Contour *outline = nullptr;
    Turns turns;
    std::optional<Vec2> fitting; // the turn, where it fits neither as drawn nor by a quarter turn
};

Pose poseOf(const Item &item, const Vec2 &turn)
{
    return {turn, turnedBounds(*item.outline, turn)};
}

/// The same a quarter turn further.
Pose quarterMore(const Pose &pose)
{
    Pose next{perpendicular(pose.turn), {}};
    next.box.extend(perpendicular(pose.box.min));
    next.box.extend(perpendicular(pose.box.max));
    return next;
}

bool fits(const Vec2 &size, const Vec2 &room)
{
    return (size.array() <= room.array() + kClipGrid).all();
}

bool hasCurves(const CurvedRegion &outline)
{
    for (int i = 0; i < outline.outer.segmentCount(); ++i)
        if (!outline.outer.segment(i).isStraight(kClipGrid))
            return true;
    return false;
}

/// The ways in which a part may lie: that of its turning and a quarter turn more, lying first.
std::vector<Pose> posesOf(const Item &item, Turning turning, const Vec2 &room)
{
    if (item.fitting)
        return {poseOf(item, *item.fitting)};
    std::vector<Pose> poses;
    const auto add = [&](const Vec2 &turn) {
        const Pose pose = poseOf(item, turn);
        for (const Pose &candidate : {pose, quarterMore(pose)})
            if (fits(candidate.size(), room))
                poses.push_back(candidate);
    };
    if (turning != Turning::AsDrawn)
        add(turning == Turning::Smallest ? item.turns.smallest : item.turns.lowest);
    if (poses.empty())
        add(Vec2::UnitX());
    std::stable_sort(poses.begin(), poses.end(),
                     [](const Pose &a, const Pose &b) { return a.size().y() < b.size().y(); });
    return poses;
}

/// One try: all items of a stock on sheets.
struct Packing
{
    std::vector<Sheet> sheets;
    double height = 0.0; // used, of all sheets together

    bool isBetterThan(const Packing &other) const
    {
        if (sheets.size() != other.sheets.size())
            return sheets.size() < other.sheets.size();
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
    std::vector<std::vector<Pose>> poses; // one list an item
    std::vector<std::size_t> order;

    void sort(Order by)
    {
        order.resize(poses.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return sortKey(poses[a].front(), by) > sortKey(poses[b].front(), by);
        });
    }
};

/// Gives up, with one sheet too many, when it takes more sheets than `most`.
Packing pack(const std::vector<Item> &items, const Plan &plan, const Sheet &empty,
             const LayoutOptions &options, std::size_t most)
{
    // Boxes and room both get the spacing on two sides: so it is between boxes and nowhere else.
    const Vec2 gap = Vec2::Constant(options.spacing);
    const Vec2 room = empty.size - Vec2::Constant(2.0 * options.margin) + gap;
    Packing packing;
    std::vector<Skyline> skylines;
    for (const std::size_t index : plan.order) {
        const Pose *pose = nullptr;
        Skyline::Place best;
        std::size_t sheet = 0;
        for (; !pose; ++sheet) {
            if (sheet == skylines.size()) {
                if (packing.sheets.size() == most) {
                    packing.sheets.push_back(empty);
                    return packing;
                }
                skylines.emplace_back(room);
                packing.sheets.push_back(empty);
            }
            best.top = std::numeric_limits<double>::infinity();
            for (const Pose &candidate : plan.poses[index]) {
                const Skyline::Place place = skylines[sheet].find(candidate.size() + gap);
                if (place.top < best.top) {
                    best = place;
                    pose = &candidate;
                }
            }
        }
        --sheet;
        skylines[sheet].put(pose->size() + gap, best);
        const Vec2 corner = Vec2::Constant(options.margin) + best.corner;
        packing.sheets[sheet].placements.push_back(
            {items[index].part, pose->turn, corner - pose->box.min});
    }
    for (const Skyline &skyline : skylines)
        packing.height += skyline.height();
    return packing;
}

Packing bestPacking(const std::vector<Item> &items, const Sheet &empty,
                    const LayoutOptions &options)
{
    const Vec2 room = empty.size - Vec2::Constant(2.0 * options.margin);
    Packing best;
    bool isFirst = true;
    for (const Turning turning : {Turning::AsDrawn, Turning::Smallest, Turning::Lowest}) {
        if (turning != Turning::AsDrawn && !options.turnsFreely)
            break;
        Plan plan;
        for (const Item &item : items)
            plan.poses.push_back(posesOf(item, turning, room));
        for (const Order order : {Order::Tallest, Order::Largest, Order::Longest}) {
            plan.sort(order);
            Packing packing =
                pack(items, plan, empty, options, isFirst ? items.size() : best.sheets.size());
            if (isFirst || packing.isBetterThan(best))
                best = std::move(packing);
            isFirst = false;
        }
    }
    return best;
}

/// Whether it fits the room, and what it needs to know to be turned.
bool prepare(Item &item, const Part &part, const Vec2 &room, bool turnsFreely)
{
    item.outline = &part.outline.outer;
    const Polygon hull =
        turnsFreely ? convexHull(part.outline.region.outer) : Polygon(); // of chords
    if (hull.size() >= 3)
        item.turns = findTurns(hull);
    if (!posesOf(item, Turning::AsDrawn, room).empty())
        return true;
    if (hull.size() < 3)
        return false;
    const double bulge = hasCurves(part.outline) ? 2.0 * kCutChord : 0.0; // beyond the chords
    item.fitting = findFittingTurn(hull, room - Vec2::Constant(bulge));
    return item.fitting.has_value();
}

} // namespace

Layout layOut(const std::vector<Part> &parts, const Model &model, const LayoutOptions &options)
{
    Layout layout;
    for (const auto &stock : model.document.stocks) {
        const Sheet empty{stock->id, options.sheet.value_or(stock->sheet), {}};
        const Vec2 room = empty.size - Vec2::Constant(2.0 * options.margin);
        std::vector<Item> items;
        std::vector<Sheet> oversized;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (parts[i].stock != stock->id)
                continue;
            Item item;
            item.part = static_cast<int>(i);
            if (prepare(item, parts[i], room, options.turnsFreely)) {
                items.push_back(std::move(item));
                continue;
            }
            const Pose pose = poseOf(item, Vec2::UnitX());
            Sheet own{stock->id, pose.size() + Vec2::Constant(2.0 * options.margin), {}};
            own.placements.push_back(
                {item.part, pose.turn, Vec2::Constant(options.margin) - pose.box.min});
            oversized.push_back(std::move(own));
            layout.oversized.push_back(item.part);
        }
        if (!items.empty()) {
            Packing packing = bestPacking(items, empty, options);
            std::move(packing.sheets.begin(), packing.sheets.end(),
                      std::back_inserter(layout.sheets));
        }
        std::move(oversized.begin(), oversized.end(), std::back_inserter(layout.sheets));
    }
    return layout;
}

double usedShare(const Layout &layout, const std::vector<Part> &parts)
{
    double used = 0.0, whole = 0.0;
    for (const Sheet &sheet : layout.sheets) {
        whole += sheet.size.x() * sheet.size.y();
        for (const Placement &placement : sheet.placements)
            used += area(parts[static_cast<std::size_t>(placement.part)].outline.region);
    }
    return whole > 0.0 ? used / whole : 0.0;
}

} // namespace fff
