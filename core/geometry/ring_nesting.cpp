#include "core/geometry/ring_nesting.h"

#include "core/base/tolerances.h"
#include "core/geometry/grid_predicates.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace fff {

namespace {

bool liesIn(const Box2 &inner, const Box2 &outer)
{
    return (inner.min.array() >= outer.min.array()).all() &&
           (inner.max.array() <= outer.max.array()).all();
}

/// Boxes by their four sides: the last one before a place in the list that lies around another box
/// is found without looking at most of the others, beside each other and within each other.
class BoxTree
{
public:
    explicit BoxTree(const std::vector<Box2> &boxes) : m_boxes(boxes), m_order(boxes.size())
    {
        std::iota(m_order.begin(), m_order.end(), 0);
        if (!boxes.empty())
            m_root = make(0, boxes.size());
    }

    /// The last index below `before` whose box has all of `box` and that `isWanted` wants; -1:
    /// none.
    template <class IsWanted>
    int lastAround(const Box2 &box, int before, IsWanted isWanted) const
    {
        int best = -1;
        if (m_root)
            look(*m_root, box, before, best, isWanted);
        return best;
    }

private:
    static constexpr std::size_t kLeaf = 8;

    struct Node
    {
        Box2 all;
        int first = 0, last = 0; // indices of boxes in it
        std::size_t begin = 0, end = 0;
        std::unique_ptr<Node> low, high;
    };

    static double side(const Box2 &box, int which)
    {
        return which < 2 ? box.min[which] : box.max[which - 2];
    }

    /// Halves by the side that differs most.
    std::unique_ptr<Node> make(std::size_t begin, std::size_t end)
    {
        auto node = std::make_unique<Node>();
        node->begin = begin;
        node->end = end;
        const auto from = m_order.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto to = m_order.begin() + static_cast<std::ptrdiff_t>(end);
        const auto [first, last] = std::minmax_element(from, to);
        node->first = *first;
        node->last = *last;
        std::array<Box2, 2> sides; // of all the lower left corners, and of the upper right ones
        for (auto it = from; it != to; ++it) {
            sides[0].extend(boxAt(*it).min);
            sides[1].extend(boxAt(*it).max);
        }
        node->all.extend(sides[0]);
        node->all.extend(sides[1]);
        if (end - begin <= kLeaf) {
            std::sort(from, to, std::greater<>());
            return node;
        }
        const std::array<double, 4> spreads{sides[0].size().x(), sides[0].size().y(),
                                            sides[1].size().x(), sides[1].size().y()};
        const auto widest =
            static_cast<int>(std::max_element(spreads.begin(), spreads.end()) - spreads.begin());
        const std::size_t middle = begin + (end - begin) / 2;
        std::nth_element(
            from, m_order.begin() + static_cast<std::ptrdiff_t>(middle), to, [&](int a, int b) {
                const double ofA = side(boxAt(a), widest), ofB = side(boxAt(b), widest);
                return ofA != ofB ? ofA < ofB : a < b;
            });
        node->low = make(begin, middle);
        node->high = make(middle, end);
        return node;
    }

    const Box2 &boxAt(int index) const { return m_boxes[static_cast<std::size_t>(index)]; }

    template <class IsWanted>
    void look(const Node &node, const Box2 &box, int before, int &best, IsWanted &isWanted) const
    {
        if (node.first >= before || node.last <= best || !liesIn(box, node.all))
            return;
        if (node.low) {
            const bool isLowLater = node.low->last > node.high->last;
            look(isLowLater ? *node.low : *node.high, box, before, best, isWanted);
            look(isLowLater ? *node.high : *node.low, box, before, best, isWanted);
            return;
        }
        for (std::size_t i = node.begin; i < node.end && m_order[i] > best; ++i)
            if (m_order[i] < before && liesIn(box, boxAt(m_order[i])) && isWanted(m_order[i]))
                best = m_order[i];
    }

    const std::vector<Box2> &m_boxes;
    std::vector<int> m_order;
    std::unique_ptr<Node> m_root;
};

bool edgesMeet(const GridPoint &a, const GridPoint &b, const GridPoint &c, const GridPoint &d)
{
    const auto areApart = [](std::int64_t from, std::int64_t to, std::int64_t otherFrom,
                             std::int64_t otherTo) {
        return std::max(from, to) < std::min(otherFrom, otherTo) ||
               std::max(otherFrom, otherTo) < std::min(from, to);
    };
    if (areApart(a.x, b.x, c.x, d.x) || areApart(a.y, b.y, c.y, d.y))
        return false;
    return sideOf(a, b, c) * sideOf(a, b, d) <= 0 && sideOf(c, d, a) * sideOf(c, d, b) <= 0;
}

} // namespace

RingInterior::RingInterior(const Contour &contour)
    : m_corners(std::make_unique<Polygon>(contour.polygon(kCutChord))), m_box(bounds(*m_corners)),
      m_tree(*m_corners)
{
}

bool RingInterior::isInside(const Vec2 &point) const
{
    return m_tree.locate(point) != Side::Outside;
}

bool RingInterior::meets(const RingInterior &other) const
{
    const ClipGrid grid(m_box);
    // Snapping moves an edge by up to a step.
    const auto visitNear = [this](Box2 box, auto visit) {
        box.min.array() -= kClipGrid;
        box.max.array() += kClipGrid;
        m_tree.visitNear(box, visit);
    };
    bool isAnyNear = false;
    visitNear(other.m_box, [&isAnyNear](const Vec2 &, const Vec2 &) { isAnyNear = true; });
    const Polygon &corners = *other.m_corners;
    bool areMeeting = false;
    for (std::size_t i = 0, j = corners.size() - 1; isAnyNear && !areMeeting && i < corners.size();
         j = i++) {
        Box2 box;
        box.extend(corners[j]);
        box.extend(corners[i]);
        const GridPoint from = grid.snap(corners[j]), to = grid.snap(corners[i]);
        visitNear(box, [&](const Vec2 &a, const Vec2 &b) {
            areMeeting = areMeeting || edgesMeet(from, to, grid.snap(a), grid.snap(b));
        });
    }
    return areMeeting;
}

bool RingInterior::hasAll(const RingInterior &other) const
{
    return !m_corners->empty() && !other.m_corners->empty() && liesIn(other.m_box, m_box) &&
           !meets(other) && isInside(other.m_corners->front());
}

bool RingInterior::hasMost(const RingInterior &other) const
{
    const Polygon &corners = *other.m_corners;
    if (m_corners->empty() || corners.empty())
        return false;
    if (!meets(other))
        return isInside(corners.front());
    // Where they touch, the most of it says where it lies.
    return 2 * std::count_if(corners.begin(), corners.end(),
                             [this](const Vec2 &p) { return isInside(p); }) >
           std::ssize(corners);
}

std::vector<int> ringsAround(const std::vector<Contour> &rings)
{
    std::vector<Box2> boxes;
    boxes.reserve(rings.size());
    for (const Contour &ring : rings)
        boxes.push_back(ring.bounds());
    const BoxTree tree(boxes);
    std::vector<RingInterior> interiors;
    interiors.reserve(rings.size());
    for (const Contour &ring : rings)
        interiors.emplace_back(ring);
    std::vector<int> around;
    around.reserve(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const int index = static_cast<int>(i);
        around.push_back(tree.lastAround(boxes[i], index, [&](int candidate) {
            return interiors[static_cast<std::size_t>(candidate)].hasMost(interiors[i]);
        }));
    }
    return around;
}

} // namespace fff
