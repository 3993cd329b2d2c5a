#include "core/interaction/label_room.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// A way aside counts as so much longer than one up or down: words are wide, and the eye finds
/// those above and below what they name.
constexpr double kAside = 1.6;
/// Boxes along a line that is taken are so long at most, px.
constexpr double kLinePiece = 24.0;

Box2 boxAt(const Vec2 &middle, const Vec2 &size)
{
    return {middle - 0.5 * size, middle + 0.5 * size};
}

/// The nearest middles down and up from `start` at which a box of that half size stands free in the
/// column at x. boxes: by their upper edges.
std::array<double, 2> gapsIn(double x, double start, const Vec2 &half,
                             const std::vector<Box2> &boxes)
{
    const auto isBeside = [&](const Box2 &box) {
        return box.max.x() <= x - half.x() || box.min.x() >= x + half.x();
    };
    const auto isIn = [&](const Box2 &box, double y) {
        return box.min.y() - half.y() < y && y < box.max.y() + half.y();
    };
    double down = start;
    for (const Box2 &box : boxes)
        if (!isBeside(box) && isIn(box, down))
            down = box.max.y() + half.y() + LabelRoom::kApart;
    double up = start;
    for (bool isMoved = true; isMoved;) { // one that begins higher may reach lower
        isMoved = false;
        for (auto box = boxes.rbegin(); box != boxes.rend(); ++box)
            if (!isBeside(*box) && isIn(*box, up)) {
                up = box->min.y() - half.y() - LabelRoom::kApart;
                isMoved = true;
            }
    }
    return {down, up};
}

} // namespace

bool overlap(const Box2 &a, const Box2 &b)
{
    return (a.min.array() < b.max.array()).all() && (b.min.array() < a.max.array()).all();
}

void LabelRoom::takeLine(const Vec2 &from, const Vec2 &to, double halfWidth)
{
    // An oblique line's box would take up the whole view.
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / kLinePiece)));
    for (int i = 0; i < pieces; ++i) {
        Box2 box;
        box.extend(Vec2(from + (to - from) * (static_cast<double>(i) / pieces)));
        box.extend(Vec2(from + (to - from) * (static_cast<double>(i + 1) / pieces)));
        box.min.array() -= halfWidth;
        box.max.array() += halfWidth;
        take(box);
    }
}

bool LabelRoom::isInView(const Box2 &box) const
{
    return (box.min.array() >= kEdge).all() &&
           (box.max.array() <= m_viewport.array() - kEdge).all();
}

bool LabelRoom::isFree(const Box2 &box) const
{
    return isInView(box) && std::none_of(m_taken.begin(), m_taken.end(),
                                         [&](const Box2 &other) { return overlap(box, other); });
}

std::optional<Box2> LabelRoom::placeFor(const Vec2 &middle, const Vec2 &size, double farthest) const
{
    const Vec2 half = 0.5 * size;
    const Vec2 least = half.array() + kEdge, most = m_viewport.array() - kEdge - half.array();
    if ((least.array() > most.array()).any() || !middle.allFinite())
        return std::nullopt;
    const Vec2 start = middle.cwiseMax(least).cwiseMin(most);
    double shortest = farthest + kAside * (start - middle).norm();
    // Boxes that are too far away for a place beside them to count are not in the way either.
    std::vector<Box2> near;
    for (const Box2 &box : m_taken)
        if (((box.min - half - start).array() <= shortest).all() &&
            ((start - box.max - half).array() <= shortest).all())
            near.push_back(box);
    std::sort(near.begin(), near.end(),
              [](const Box2 &a, const Box2 &b) { return a.min.y() < b.min.y(); });
    // The nearest free place stands in the wanted column, or beside a box that is taken: so it is
    // enough to look there, in each column for the nearest gap.
    std::vector<double> columns{start.x()};
    for (const Box2 &box : near)
        for (const double x : {box.min.x() - kApart - half.x(), box.max.x() + kApart + half.x()})
            if (x >= least.x() && x <= most.x())
                columns.push_back(x);
    std::sort(columns.begin(), columns.end(), [&middle](double a, double b) {
        return std::abs(a - middle.x()) < std::abs(b - middle.x());
    });
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    std::optional<Box2> best;
    for (const double x : columns) {
        const double aside = kAside * std::abs(x - middle.x());
        if (aside > shortest)
            break;
        for (const double y : gapsIn(x, start.y(), half, near)) {
            const double way = std::hypot(aside, y - middle.y());
            if (y < least.y() || y > most.y() || way > shortest || (best && way >= shortest))
                continue;
            best = boxAt({x, y}, size);
            shortest = way;
        }
    }
    return best;
}

} // namespace fff
