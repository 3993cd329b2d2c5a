// What the overlay shows of a path that is set point by point.
#pragma once

#include "core/interaction/contour_target.h"
#include "core/interaction/snapping.h"
#include "core/stroke/pen_path.h"

#include <optional>
#include <vector>

namespace fff {

/// Points are in the canvas' coordinates, mm. Equal ones look the same.
struct PenMarks
{
    ContourTarget::Purpose purpose = ContourTarget::Purpose::NewSection;
    Frame canvas;
    std::vector<PathPoint> points;
    bool hasArea = false;               // what closes makes something
    std::optional<Vec2> next;           // where the next point would be
    std::optional<Snap> snap;           // what caught it, or the point that is moved
    std::optional<Vec2> place;          // of `snap`, counted in the canvas' grid
    std::optional<Vec2> way;            // and from the point before
    int litPoint = -1;                  // under the cursor or pressed
    std::optional<PenPath::End> litEnd; // its handle is meant
    bool isClosing = false;             // a click closes the path
    Frame grid;                         // that places are counted in
    double gridStep = 0.0;              // mm; 0: points do not go to it
    std::optional<Contour> cut;         // what is enclosed, where the ground cuts that

    bool operator==(const PenMarks &) const = default;
};

} // namespace fff
