#include "core/interaction/problem_marks.h"

#include "core/interaction/view_cube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// From an anchor up to its mark, px; further rings of places lie this far apart.
constexpr double kReach = 26.0, kRingStep = 24.0;
constexpr int kRings = 8;

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

class Room
{
public:
    explicit Room(const Vec2 &viewport) : m_viewport(viewport), m_cube(cubeCentre(viewport)) {}

    bool isFree(const Vec2 &centre) const
    {
        constexpr double kMargin = kMarkRadius + kMarkGap;
        if ((centre.array() < kMargin).any() ||
            (centre.array() > m_viewport.array() - kMargin).any())
            return false;
        if (m_cube && (centre - *m_cube).norm() < 0.5 * kCubeRoom + kMarkRadius)
            return false;
        return std::all_of(m_taken.begin(), m_taken.end(), [&](const Vec2 &taken) {
            return (taken - centre).norm() >= 2.0 * kMarkRadius + kMarkGap;
        });
    }
    void take(const Vec2 &centre) { m_taken.push_back(centre); }

private:
    Vec2 m_viewport;
    std::optional<Vec2> m_cube;
    std::vector<Vec2> m_taken;
};

/// Straight up if it is free, then to either side of that, then further out.
Vec2 placeFor(const Vec2 &anchor, const Room &room)
{
    for (int ring = 0; ring < kRings; ++ring) {
        const double reach = kReach + ring * kRingStep;
        const int ways = 8 * (ring + 1);
        for (int i = 0; i < ways; ++i) {
            const int turn = i % 2 == 0 ? i / 2 : -(i + 1) / 2;
            const double angle = 2.0 * std::numbers::pi * turn / ways;
            const Vec2 centre = anchor + reach * Vec2(std::sin(angle), -std::cos(angle));
            if (room.isFree(centre))
                return centre;
        }
    }
    return anchor - Vec2(0.0, kReach);
}

} // namespace

std::vector<PlacedMark> placeMarks(std::span<const ProblemMark> marks, const Camera &camera,
                                   const Vec2 &viewport, const ViewState &view)
{
    std::vector<PlacedMark> placed;
    Room room(viewport);
    for (const ProblemMark &mark : marks) {
        if (isHidden(mark, view) || !isInView(mark.at, camera, viewport))
            continue;
        const Vec2 anchor = camera.toScreen(mark.at, viewport);
        const Vec2 centre = placeFor(anchor, room);
        room.take(centre);
        placed.push_back({mark.number, anchor, centre, mark.isError});
    }
    return placed;
}

int markAt(const Vec2 &screen, std::span<const PlacedMark> marks)
{
    // What was placed last is painted on top.
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
        if ((mark->centre - screen).norm() <= kMarkRadius + 1.0)
            return mark->number;
    }
    return 0;
}

} // namespace fff
