// Where a section is strong enough, in the view: its colours, their legend and what is known of
// the place under the cursor.
#pragma once

#include "core/analysis/bearing_map.h"
#include "core/physics/stress_field.h"
#include "ui/view/mark_pen.h"

#include <QLocale>
#include <QString>

#include <memory>

namespace fff::ui {

struct BearingMarks
{
    std::shared_ptr<const BearingMap> map; // null: not known yet, or cannot be
    StressFieldPointer field;              // its colours, which are drawn on the section
    QString said;                          // in place of the legend, where there is no map
    bool isOlder = false;                  // than the model that is shown
    bool saysRigid = false;                // all else that is shown is of sections that bend
    std::optional<Bearing> asked;          // of the place under the cursor
    Vec3 place = Vec3::Zero();             // there, world
};

/// What stressColour() takes for such a mass: 1 (red) for the least that a place of the map bears,
/// 0.2 (blue) for the most, by the logarithm between; what bears a thousand times as much as the
/// least, or more, has the last colour.
double bearingUse(const BearingMap &map, double mass);

/// Of a map, what is drawn on the section (field_painter.h): bearingUse() on both faces.
StressFieldPointer bearingField(const BearingMap &map);
/// Alpha of these colours.
double bearingAlpha(const BearingMarks &marks);

/// What they mean, or how far they have come.
void paintBearing(MarkPen &pen, const BearingMarks &marks, const QLocale &locale);
/// "Bears 1.2 kg here, then Rib 4 cracks beside its slit.", beside the place.
void paintAskedBearing(MarkPen &pen, const BearingMarks &marks);

} // namespace fff::ui
