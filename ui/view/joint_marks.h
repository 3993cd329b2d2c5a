// Marks of joints: where slits meet, and the slits of a joint that is pointed at or selected.
#pragma once

#include "core/interaction/sign.h"
#include "ui/view/mark_pen.h"

#include <QLocale>

namespace fff::ui {

void paintJoints(MarkPen &pen, const sign::Joints &joints, const QLocale &locale);

} // namespace fff::ui
