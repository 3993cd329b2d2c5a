#include "core/assembly/playback.h"

#include "core/base/easing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff {

namespace {

/// Of a step's time its parts wait before and after they move, for the eye to find them.
constexpr double kWait = 0.12;
/// Between what is drawn apart and what it was brought to, of the model's diagonal.
constexpr double kApartGap = 0.04;
constexpr double kAcross = 1e-9;    // of a unit vector: too little to come clear of anything
constexpr double kSamePlace = 1e-6; // mm

Box3 shifted(Box3 box, const Vec3 &by)
{
    box.min += by;
    box.max += by;
    return box;
}

/// How far `a` has to go along `direction` (unit) to be clear of b from then on; 0 for one that its
/// way never takes through b.
double wayToClear(const Box3 &a, const Box3 &b, const Vec3 &direction)
{
    double from = 0.0, to = std::numeric_limits<double>::infinity(); // where they meet
    for (int axis = 0; axis < 3; ++axis) {
        const double before = b.min[axis] - a.max[axis], behind = b.max[axis] - a.min[axis];
        const double speed = direction[axis];
        if (std::abs(speed) < kAcross) {
            if (before >= 0.0 || behind <= 0.0)
                return 0.0;
            continue;
        }
        from = std::max(from, std::min(before / speed, behind / speed));
        to = std::min(to, std::max(before / speed, behind / speed));
    }
    return from < to && std::isfinite(to) ? to : 0.0;
}

bool contains(const std::vector<int> &ascending, int part)
{
    return std::binary_search(ascending.begin(), ascending.end(), part);
}

/// Where one is on a way after that share of its length.
Vec3 onWay(const std::vector<Vec3> &way, double share)
{
    if (share >= 1.0)
        return way.back(); // to the last bit
    double length = 0.0;
    for (std::size_t i = 1; i < way.size(); ++i)
        length += (way[i] - way[i - 1]).norm();
    double left = share * length;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double piece = (way[i] - way[i - 1]).norm();
        if (left < piece)
            return way[i - 1] + left / piece * (way[i] - way[i - 1]);
        left -= piece;
    }
    return way.back();
}

} // namespace

Playback::Playback(AssemblyPlan plan, std::vector<Box3> boxes)
    : m_plan(std::move(plan)), m_boxes(std::move(boxes)), m_first(m_boxes.size(), -1),
      m_apart(m_boxes.size(), Vec3::Zero())
{
    if (m_plan.verdict != AssemblyPlan::Verdict::Possible)
        m_plan.steps.clear();
    Box3 all;
    for (const Box3 &box : m_boxes)
        all.extend(box);
    m_diagonal = all.size().norm();
    for (std::size_t i = 0; i < m_plan.steps.size(); ++i) {
        const AssemblyStep &step = m_plan.steps[i];
        std::vector<Vec3> way{Vec3::Zero()}; // from its end
        for (auto move = step.moves.rbegin(); move != step.moves.rend(); ++move)
            way.push_back(way.back() - move->distance * move->direction);
        if (way.back().norm() < kSamePlace)
            way.resize(1); // it is where it belongs as soon as it is put down
        std::reverse(way.begin(), way.end());
        m_ways.push_back(std::move(way));
        m_ways.back().front() += asideOf(i);
        for (const int part : step.parts) {
            int &first = m_first[static_cast<std::size_t>(part)];
            first = first < 0 ? static_cast<int>(i) : first;
        }
        drawApart(i);
    }
}

/// How much further back a group's way begins, that it can be put together there.
Vec3 Playback::asideOf(std::size_t index) const
{
    const AssemblyStep &step = m_plan.steps[index];
    if (m_ways[index].size() < 2 || step.parts.size() < 2)
        return Vec3::Zero();
    // All that its parts take up while they are put together: those that come later are where their
    // own ways begin as long as they are no obstacle, which is until they come.
    Box3 taken, others;
    for (std::size_t i = 0; i < index; ++i) {
        for (const int part : m_plan.steps[i].parts) {
            const bool isInside = contains(step.parts, part);
            if (!isInside && !step.onto.contains(part))
                continue;
            Vec3 later = Vec3::Zero();
            for (std::size_t k = i + 1; k < index; ++k)
                if (contains(m_plan.steps[k].parts, part))
                    later += m_ways[k].front();
            for (const Vec3 &corner : m_ways[i]) {
                const Box3 box = shifted(m_boxes[static_cast<std::size_t>(part)],
                                         isInside ? Vec3(corner + later) : Vec3(Vec3::Zero()));
                (isInside ? taken : others).extend(box);
            }
        }
    }
    const Vec3 back = -step.moves.front().direction;
    return wayToClear(shifted(taken, m_ways[index].front()), others, back) * back;
}

/// Takes the parts of a step back along its way, and on until they are clear of the others.
void Playback::drawApart(std::size_t index)
{
    const AssemblyStep &step = m_plan.steps[index];
    if (m_ways[index].size() < 2)
        return;
    Vec3 offset = Vec3::Zero();
    for (const Move &move : step.moves)
        offset -= move.distance * move.direction;
    const Vec3 back = -step.moves.front().direction;
    double further = 0.0;
    for (const int part : step.parts) {
        const auto p = static_cast<std::size_t>(part);
        const Box3 box = shifted(m_boxes[p], m_apart[p] + offset);
        for (const int other : step.onto) {
            const auto o = static_cast<std::size_t>(other);
            further = std::max(further, wayToClear(box, shifted(m_boxes[o], m_apart[o]), back));
        }
    }
    offset += (further + kApartGap * m_diagonal) * back;
    for (const int part : step.parts)
        m_apart[static_cast<std::size_t>(part)] += offset;
}

int Playback::stepAt(double time) const
{
    if (!(time > 0.0))
        return -1;
    return std::min(static_cast<int>(std::ceil(std::min(time, double(stepCount())))), stepCount()) -
           1;
}

std::vector<PartPlace> Playback::at(double time, double drawnApart) const
{
    const int step = stepAt(time);
    if (step < 0)
        return std::vector<PartPlace>(m_boxes.size());
    const double share = std::min(time, double(stepCount())) - step;
    const double moved = std::clamp((share - kWait) / (1.0 - 2.0 * kWait), 0.0, 1.0);
    return placesDuring(step, easeInOutCubic(moved), drawnApart);
}

std::vector<PartPlace> Playback::before(int step, double drawnApart) const
{
    return placesDuring(step, 0.0, drawnApart);
}

std::vector<PartPlace> Playback::placesDuring(int step, double share, double drawnApart) const
{
    std::vector<PartPlace> places(m_boxes.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i].isThere = m_first[i] >= 0 && m_first[i] <= step;
        if (places[i].isThere && drawnApart > 0.0)
            places[i].offset = drawnApart * m_apart[i];
    }
    // What is to be brought on later as one is still where that way begins.
    for (std::size_t i = static_cast<std::size_t>(step); i < m_ways.size(); ++i) {
        const bool isNow = i == static_cast<std::size_t>(step);
        const Vec3 offset = isNow ? onWay(m_ways[i], share) : m_ways[i].front();
        for (const int part : m_plan.steps[i].parts) {
            PartPlace &place = places[static_cast<std::size_t>(part)];
            if (!place.isThere)
                continue;
            place.offset += offset;
            place.isMoving = place.isMoving || isNow;
        }
    }
    return places;
}

Vec3 Playback::middleOf(int step, double drawnApart) const
{
    Box3 box;
    const std::vector<PartPlace> places = placesDuring(step, 1.0, drawnApart);
    for (const int part : m_plan.steps[static_cast<std::size_t>(step)].parts) {
        const auto p = static_cast<std::size_t>(part);
        box.extend(shifted(m_boxes[p], places[p].offset));
    }
    return box.center();
}

std::optional<Vec3> Playback::lastDirection(int step) const
{
    const AssemblyStep &s = m_plan.steps[static_cast<std::size_t>(step)];
    if (way(step).size() < 2)
        return {};
    return s.moves.back().direction;
}

Box3 Playback::reach(double drawnApart) const
{
    Box3 reach;
    // What is to be brought on later as one is where those ways begin.
    std::vector<Vec3> later(m_boxes.size(), Vec3::Zero());
    for (std::size_t step = m_ways.size(); step-- > 0;) {
        for (const int part : m_plan.steps[step].parts) {
            const auto p = static_cast<std::size_t>(part);
            const Vec3 offset = drawnApart * m_apart[p] + m_ways[step].back() + later[p];
            for (const Vec3 &corner : m_ways[step])
                reach.extend(shifted(m_boxes[p], offset + corner));
            later[p] += m_ways[step].front();
        }
    }
    return reach;
}

} // namespace fff
