// How the section that is repeated stands in the one that it is repeated along. Internal to
// operations.
#pragma once

#include "core/assembly/intervals.h"
#include "core/operations/operation_context.h"

namespace fff {

struct SourceCrossing
{
    /// By what a copy keeps its place in the root, along the axis.
    enum class Hold {
        Low,   // the root's edge at the lower end of the overlap, where the section leaves it
        High,  // that at its upper end
        Middle // the middle of the root: the section goes through it or is enclosed by it
    };
    Axis axis;              // direction = normal(root) × normal(section)
    PlaneLine line;         // the axis in the root's coordinates
    bool isMeeting = false; // else there is no overlap, and only `axis` and `line` count
    Overlap overlap;        // a: the root's interval, b: the section's
    Hold hold = Hold::Middle;

    double depth() const { return overlap.to - overlap.from; }
    double girth() const { return overlap.a.length(); } // of the root
};

/// Nothing when their planes are nearly parallel. Of several overlaps it is that in which the
/// section was drawn on the root, else the longest.
std::optional<SourceCrossing> sourceCrossing(const Section &root, const Section &section);

/// Of the intervals on another line that which goes on from `before` on its own: the one that
/// overlaps it most, else the nearest. Nothing when there is none.
std::optional<Interval> continued(const std::vector<Interval> &intervals, const Interval &before);

/// By how much a section is scaled where the root's girth is so many times that at the source:
/// parameters "strength" and "notBelow".
double scaleFor(const OperationContext &context, double ratio);

} // namespace fff
