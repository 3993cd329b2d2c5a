// What a slit is drawn to while snapping is on: the world's upright and level, a right angle to the
// contour where it leaves, a parallel to the slit that was drawn last. For the stroke and the pen.
#pragma once

#include "core/interaction/camera.h"
#include "core/interaction/overlay.h"
#include "core/model/model.h"
#include "core/stroke/stroke.h"

#include <array>
#include <optional>
#include <vector>

namespace fff {

struct SlitGuide
{
    enum class Kind { Level, Upright, RightAngle, Parallel };
    Kind kind = Kind::Level;
    Vec2 to = Vec2::Zero(); // where the slit ends on it, section's coordinates
};

/// What is said of a slit that goes along it.
Text nameOf(SlitGuide::Kind kind);

class SlitGuides
{
public:
    /// A slit that is drawn within this of a guide's direction goes along it (5°).
    static constexpr double kReach = 0.08726646259971647;

    /// from: where it was pressed, frame coordinates of the section. orientation: of the camera,
    /// for a level section, where up is as it is seen.
    SlitGuides(const Model &model, SectionPointer section, const Vec2 &from,
               const Eigen::Quaterniond &orientation);

    /// Leads the slit of the stroke, which is one from `from`, to the nearest guide within reach:
    /// as long as it was while it is in the section; once it has left, to where the guide leaves
    /// the section, on the contour itself. Left as it was drawn where there is none, where the
    /// guide would leave elsewhere, and without `snaps`.
    std::optional<SlitGuide> lead(Stroke &stroke, bool snaps) const;

    /// The guide's line beyond the slit, and of a parallel the slit that it follows.
    void show(const SlitGuide &guide, const Camera &camera, const Vec2 &viewport,
              Signs &signs) const;

private:
    struct Direction
    {
        SlitGuide::Kind kind = SlitGuide::Kind::Level;
        Vec2 along = Vec2::UnitX(); // unit
    };
    void addRightAngles();
    void addLastSlit(const Model &model);

    SectionPointer m_section;
    Vec2 m_from;
    std::vector<Direction> m_directions;
    std::optional<std::array<Vec3, 2>> m_last; // slit; world
};

} // namespace fff
