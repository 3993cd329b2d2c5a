#include "core/interaction/label_room.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

std::optional<Box2> LabelRoom::placeFor(const Vec2 &middle, const Vec2 &size) const
{
    // The nearest free place touches something: the wanted line or column, the view's edge, or the
    // edges of boxes that are taken. So it is enough to look there.
    std::vector<double> across{middle.x(), kEdge + 0.5 * size.x(),
                               m_viewport.x() - kEdge - 0.5 * size.x()};
    std::vector<double> along{middle.y(), kEdge + 0.5 * size.y(),
                              m_viewport.y() - kEdge - 0.5 * size.y()};
    for (const Box2 &box : m_taken) {
        across.push_back(box.min.x() - kApart - 0.5 * size.x());
        across.push_back(box.max.x() + kApart + 0.5 * size.x());
        along.push_back(box.min.y() - kApart - 0.5 * size.y());
        along.push_back(box.max.y() + kApart + 0.5 * size.y());
    }
    const auto byDistance = [](std::vector<double> &places, double wanted) {
        std::sort(places.begin(), places.end(), [wanted](double a, double b) {
            return std::abs(a - wanted) < std::abs(b - wanted);
        });
        places.erase(std::unique(places.begin(), places.end()), places.end());
    };
    byDistance(across, middle.x());
    byDistance(along, middle.y());
    std::optional<Box2> best;
    double least = std::numeric_limits<double>::infinity();
    for (const double x : across) {
        const double aside = kAside * std::abs(x - middle.x());
        if (aside >= least)
            break;
        for (const double y : along) {
            const double way = std::hypot(aside, y - middle.y());
            if (way >= least)
                break;
            const Box2 box = boxAt({x, y}, size);
            if (!isFree(box))
                continue;
            best = box;
            least = way;
        }
    }
    return best;
}

} // namespace fff
