// The forces that hold a model up and together, as arrows over the view.
#pragma once

#include "core/analysis/strength.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

#include <optional>
#include <vector>

namespace fff::ui {

struct ForceMark
{
    Vec3 at = Vec3::Zero();    // where it acts, world, mm
    Vec3 force = Vec3::Zero(); // N
    int foot = -1;             // of which body; −1: at a joint
    bool isOpen = false;       // a joint that is pulled open
    double pull = 0.0;         // N, of such a joint

    bool operator==(const ForceMark &) const = default;
};

/// What the ground presses on each foot with. Empty where forces are not known.
std::vector<ForceMark> footForces(const Strength &strength);
/// What the other sections do to one, at its joints; without one each joint's force, once.
std::vector<ForceMark> jointForces(const Analysis &analysis, const Strength &strength,
                                   std::optional<int> section = std::nullopt);

/// More numbers over a model are read by nobody.
inline constexpr int kMostForceNumbers = 5;

/// Arrows that end where the force acts. Joints pulled open have words, those near each other once
/// for all; of feet the largest forces have their number, `most` of both in all, and none where
/// something stands over the view already. What acts on one body so near that it would not be told
/// apart is one.
void paintForces(MarkPen &pen, const std::vector<ForceMark> &forces, bool isOlder,
                 const QLocale &locale, int most = kMostForceNumbers);

} // namespace fff::ui
