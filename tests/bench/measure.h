// What is measured of one model.
#pragma once

#include "core/base/result.h"
#include "core/model/document.h"

#include "tests/bench/point_event.h"

#include <QString>

#include <chrono>
#include <cstdint>
#include <string>

namespace fff::bench {

/// Medians in milliseconds of CPU time of one thread. Every run starts with reading the file, so
/// that what is computed at first use is paid for in the column that asks for it first.
struct Timings
{
    double load = 0.0;     // file to document
    double evaluate = 0.0; // document to model
    double slits = 0.0;    // model to all joints and slits
    double parts = 0.0;    // slits to all parts: the cut sections
    double svg = 0.0;      // cut sections to the bytes of the cutting file
    double drawing = 0.0;  // of that the writing alone: marks, kerf and layout are there
    double drag = 0.0;     // a section moved, and the model of that; no slits
    double edit = 0.0;     // the same with all joints, slits, cuts and triangles that follow
    double undo = 0.0;     // back, with all of that
    double anew = 0.0;     // the same where what operations made is not kept any more
    double point = 0.0;    // the worst move of a control point, with all that follows
    double gizmo = 0.0;    // a move of the gizmo: event, snapping, edit, model
    double check = 0.0;    // all checks but planning, nothing known from before
    double plan = 0.0;  // the plan of the assembly, and what is said of it; kPlanningTime at most
    double again = 0.0; // both after an edit, with what is known from before
};

/// As the window has it.
inline constexpr std::chrono::milliseconds kPlanningTime(1000);

/// Bytes that one more undo step keeps, by counting, and what they should be: 16 a section and a
/// stock (the lists of pointers), the changed section, and the model they are in.
struct StepMemory
{
    std::int64_t counted = 0;
    std::int64_t expected = 0;
    std::int64_t held = 0; // with what operations made of it, while it is one of the last steps
};

struct Measurement
{
    std::string name;
    int sections = 0;
    int joints = 0;
    int neighbours = 0; // of the section that is edited
    Timings milliseconds;
    PointEvent point;
    StepMemory step;
    double kernel = 0.0; // ms, of the kernel in the same minutes; 0 when it was not run
};

/// edited   index of the section that is moved; −1: one in the middle by its number of joints
/// runs     of which the median is taken
Result<Measurement> measure(const std::string &name, const QString &path, int runs,
                            int edited = -1);

} // namespace fff::bench
