// What colours over the model mean: a bar with numbers beside it, under the view cube.
#pragma once

#include "ui/view/mark_pen.h"

#include <functional>

namespace fff::ui {

/// px: the right end and the top of what stands under the cube.
QPointF underCube(const Vec2 &viewport);

/// px: where a legend stands, with all that it may have.
QRectF legendRoom(const Vec2 &viewport);

struct Legend
{
    QString title;
    QStringList heads = {}; // over the columns of numbers
    QString note = {};      // below, muted
    double bottom = 0.0;    // what the lowest colour stands for, of a stress (stress_colours.h);
    double top = 1.0;       // the highest
    struct Tick
    {
        double at = 0.0; // 0 at the bar's bottom, 1 at its top
        QStringList columns;
    };
    std::vector<Tick> ticks = {};
};

/// Paints it, and says where its lower end is, px.
double paintLegend(MarkPen &pen, const Legend &legend);

} // namespace fff::ui
