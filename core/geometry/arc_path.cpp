#include "core/geometry/arc_path.h"

#include <cmath>
#include <numbers>

namespace fff {

Vec2 Arc::at(double share) const
{
    const double angle = from + share * sweep;
    return center + radius * Vec2(std::cos(angle), std::sin(angle));
}

Arc arcOf(const Vec2 &start, const ArcStep &step)
{
    // The middle of the chord lies (1 − b²) / 4b chords from the centre.
    const Vec2 chord = step.end - start;
    const double away = 0.25 * (1.0 / step.bulge - step.bulge);
    Arc arc;
    arc.center = 0.5 * (start + step.end) + away * perpendicular(chord);
    arc.radius = 0.25 * chord.norm() * (1.0 / std::abs(step.bulge) + std::abs(step.bulge));
    const Vec2 out = start - arc.center;
    arc.from = std::atan2(out.y(), out.x());
    arc.sweep = 4.0 * std::atan(step.bulge);
    return arc;
}

double lengthOf(const Vec2 &start, const ArcStep &step)
{
    const double chord = (step.end - start).norm();
    // By the chord: of a flat arc neither radius nor angle is known well.
    const double quarter = std::atan(std::abs(step.bulge));
    return quarter == 0.0 ? chord : chord * 2.0 * quarter / std::sin(2.0 * quarter);
}

double ArcPath::length() const
{
    double length = 0.0;
    Vec2 at = start;
    for (const ArcStep &step : steps) {
        length += lengthOf(at, step);
        at = step.end;
    }
    return length;
}

Box2 ArcPath::bounds() const
{
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    Box2 box;
    box.extend(start);
    Vec2 at = start;
    for (const ArcStep &step : steps) {
        box.extend(step.end);
        if (step.bulge != 0.0) {
            const Arc arc = arcOf(at, step);
            const double low = std::min(arc.from, arc.from + arc.sweep),
                         high = std::max(arc.from, arc.from + arc.sweep);
            for (double quarter = std::ceil(low / kQuarter); quarter * kQuarter < high; ++quarter)
                box.extend(arc.center + arc.radius * Vec2(std::cos(quarter * kQuarter),
                                                          std::sin(quarter * kQuarter)));
        }
        at = step.end;
    }
    return box;
}

ArcPath ArcPath::reversed() const
{
    ArcPath back{end(), {}, isClosed};
    back.steps.reserve(steps.size());
    for (std::size_t i = steps.size(); i-- > 0;)
        back.steps.push_back({i > 0 ? steps[i - 1].end : start, -steps[i].bulge});
    return back;
}

} // namespace fff
