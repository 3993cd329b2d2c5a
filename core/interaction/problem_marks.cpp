#include "core/interaction/problem_marks.h"

#include "core/interaction/label_room.h"
#include "core/interaction/view_cube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

namespace fff {

namespace {

/// From an anchor up to its number, px: beyond the arrows that a chosen one may have there, which
/// reach 20 px (ui/view/problem_marks.cpp). Further rings of places lie so far apart.
constexpr double kReach = 34.0, kRingStep = 24.0;
constexpr int kRings = 8;
/// The cursor is on a dot up to here, px; on a number up to its edge and a little more.
constexpr double kDotReach = 9.0, kNumberReach = kMarkRadius + 1.0;

bool isInView(const Vec3 &world, const Camera &camera, const Vec2 &viewport)
{
    if (camera.isPerspective() && camera.forward().dot(world - camera.eye(viewport)) <= 0.0)
        return false;
    const Vec2 p = camera.toScreen(world, viewport);
    return p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= viewport.x() && p.y() <= viewport.y();
}

bool isHidden(const ProblemMark &mark, const ViewState &view)
{
    return !mark.sections.empty() &&
           std::all_of(mark.sections.begin(), mark.sections.end(),
                       [&](const SectionRef &ref) { return view.isHidden(ref); });
}

Box2 squareAt(const Vec2 &centre, double half)
{
    return {centre - Vec2::Constant(half), centre + Vec2::Constant(half)};
}

/// Straight up if it is free, then to either side of that, then further out.
Vec2 placeOfNumber(const Vec2 &anchor, const LabelRoom &room)
{
    constexpr double kHalf = kMarkRadius + kMarkGap;
    for (int ring = 0; ring < kRings; ++ring) {
        const double reach = kReach + ring * kRingStep;
        const int ways = 8 * (ring + 1);
        for (int i = 0; i < ways; ++i) {
            const int turn = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
            const double angle = 2.0 * std::numbers::pi * turn / ways;
            const Vec2 centre = anchor + reach * Vec2(std::sin(angle), -std::cos(angle));
            if (room.isFree(squareAt(centre, kHalf)))
                return centre;
        }
    }
    // One that finds no place at all takes the one that it would have had.
    const auto free = room.placeFor(anchor, Vec2::Constant(2.0 * kHalf));
    return free ? free->center() : Vec2(anchor - Vec2(0.0, kReach));
}

/// Those that are seen, the chosen one first, then errors, in the order of their rows.
std::vector<std::size_t> seenMarks(std::span<const ProblemMark> marks, const Camera &camera,
                                   const Vec2 &viewport, const ViewState &view)
{
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < marks.size(); ++i)
        if (!isHidden(marks[i], view) && isInView(marks[i].at, camera, viewport))
            seen.push_back(i);
    std::stable_sort(seen.begin(), seen.end(), [&](std::size_t a, std::size_t b) {
        return std::tuple(!marks[a].isChosen, !marks[a].isError) <
               std::tuple(!marks[b].isChosen, !marks[b].isError);
    });
    return seen;
}

/// The nearest one that it would lie on, of the numbers first; null: none is near.
PlacedMark *nearby(const Vec2 &anchor, std::vector<PlacedMark> &placed)
{
    PlacedMark *best = nullptr;
    double nearest = kMergeReach;
    for (PlacedMark &mark : placed) {
        const double distance = (mark.anchor - anchor).norm();
        const bool isUnder = !mark.isDot && (mark.centre - anchor).norm() < kMergeReach;
        if (distance < nearest || (isUnder && !best)) {
            nearest = std::min(distance, nearest);
            best = &mark;
        }
    }
    return best;
}

} // namespace

std::vector<PlacedMark> placeMarks(std::span<const ProblemMark> marks, const Camera &camera,
                                   const Vec2 &viewport, const ViewState &view,
                                   std::span<const Box2> covered)
{
    const std::vector<std::size_t> seen = seenMarks(marks, camera, viewport, view);
    std::vector<Box2> above(covered.begin(), covered.end());
    if (const std::optional<Vec2> cube = cubeCentre(viewport))
        above.push_back(squareAt(*cube, 0.5 * kCubeRoom));
    LabelRoom room(viewport);
    for (const Box2 &box : above)
        room.take(box);
    const auto isUnderOne = [&above](const Vec2 &anchor) {
        return std::any_of(above.begin(), above.end(), [&](const Box2 &box) {
            return overlap(box, squareAt(anchor, kDotsRadius));
        });
    };

    std::vector<PlacedMark> placed;
    std::set<int> numbered; // rows
    std::vector<std::size_t> others;
    for (const std::size_t i : seen) {
        const ProblemMark &mark = marks[i];
        const Vec2 anchor = camera.toScreen(mark.at, viewport);
        if (!(mark.isChosen || mark.isError) || placed.size() >= kMostNumbers ||
            numbered.contains(mark.number) || nearby(anchor, placed)) {
            others.push_back(i);
            continue;
        }
        const Vec2 centre = placeOfNumber(anchor, room);
        room.take(squareAt(centre, kMarkRadius));
        numbered.insert(mark.number);
        placed.push_back({{i}, mark.number, anchor, centre, mark.isError, false});
    }
    for (const std::size_t i : others) {
        const Vec2 anchor = camera.toScreen(marks[i].at, viewport);
        if (PlacedMark *same = nearby(anchor, placed))
            same->marks.push_back(i);
        else if (!isUnderOne(anchor))
            placed.push_back({{i}, marks[i].number, anchor, anchor, marks[i].isError, true});
    }
    return placed;
}

const PlacedMark *markAt(const Vec2 &screen, std::span<const PlacedMark> marks)
{
    const PlacedMark *best = nullptr;
    double nearest = kDotReach;
    for (const PlacedMark &mark : marks) {
        const double distance = (mark.centre - screen).norm();
        if (!mark.isDot && distance <= kNumberReach)
            return &mark; // numbers lie over dots
        if (mark.isDot && distance <= nearest) {
            nearest = distance;
            best = &mark;
        }
    }
    return best;
}

std::size_t chosenBy(const PlacedMark &placed, std::span<const ProblemMark> marks)
{
    // The chosen one comes first in the mark, and is not where it is in the list.
    std::vector<std::size_t> all = placed.marks;
    std::sort(all.begin(), all.end());
    const auto chosen =
        std::find_if(all.begin(), all.end(), [&](std::size_t i) { return marks[i].isChosen; });
    if (chosen == all.end())
        return placed.marks.front();
    return std::next(chosen) == all.end() ? all.front() : *std::next(chosen);
}

} // namespace fff
