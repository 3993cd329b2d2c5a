// Where the replicas of a row stand, along a line or a contour. Internal to operations.
#pragma once

#include <vector>

namespace fff {

/// More than this nobody wants of one row; a spacing that asks for more stops there.
inline constexpr int kMostReplicas = 500;

/// Places are mm along the row; the source stands at 0.
struct RowRequest
{
    double from = 0.0, to = 0.0; // the range, from < to; it may lie beside the source
    bool goesForward = true, goesBack = false;
    bool isByCount = true;
    int count = 2;        // of the row, the source among them
    double spacing = 1.0; // mm, > 0
    bool isRing = false;  // the range is once round and its ends are one place
};

struct RowPlace
{
    int number = 0; // counted from the source: forward 1, 2 …, back −1, −2 …
    double at = 0.0;
};

struct Row
{
    std::vector<RowPlace> places; // by their numbers
    bool isStopped = false;       // at kMostReplicas
};

/// By spacing: all places in the range that are a multiple of it from the source, or from the
/// range's nearer end where that lies beyond the source; an end counts as in it.
///
/// By count: each section has its part of the range to itself and stands in the middle of it, but
/// the source, which stands where it does; so the last one is half a step from the end, where a
/// root would have come to nothing. To both sides there are as many as the room on each is for, and
/// in a ring all steps are equal.
///
/// Numbers are counted from the source, so that another count or range keeps those that stay.
Row placesOf(const RowRequest &request);

} // namespace fff
