#include "core/operations/row.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A place this share of a step beyond the end is at the end: sums of steps are rounded.
constexpr double kEndShare = 1e-9;

/// The room on one side of the source, as distances from it.
struct Room
{
    double begin = 0.0, end = 0.0;
    bool holdsSource = false; // begins at the source, which takes its first place

    bool isEmpty() const { return !(end > begin); }
};

Room roomOf(double from, double to)
{
    return {std::max(from, 0.0), to, from <= 0.0};
}

void place(const Room &room, int count, double step, int sign, Row &row)
{
    // Beyond the source the first one stands half a step inside the range, as the last one does.
    const double first = room.holdsSource ? step : room.begin + 0.5 * step;
    for (int i = 0; i < count; ++i)
        row.places.push_back({sign * (i + 1), sign * (first + i * step)});
}

void placeBySpacing(const Room &room, double spacing, int sign, Row &row)
{
    if (room.isEmpty())
        return;
    const double first = room.holdsSource ? spacing : room.begin;
    const double fitting = std::floor((room.end - first) / spacing + kEndShare) + 1.0;
    const int count = static_cast<int>(std::clamp(fitting, 0.0, kMostReplicas + 1.0));
    row.isStopped = row.isStopped || count > kMostReplicas;
    for (int i = 0; i < std::min(count, kMostReplicas); ++i)
        row.places.push_back({sign * (i + 1), sign * (first + i * spacing)});
}

/// count: of replicas.
void placeByCount(const Room &room, int count, int sign, Row &row)
{
    if (room.isEmpty() || count < 1)
        return;
    const double parts = room.holdsSource ? count + 0.5 : count;
    place(room, count, (room.end - room.begin) / parts, sign, row);
}

void placeByCount(const Room &ahead, const Room &behind, int count, Row &row)
{
    if (behind.isEmpty() || ahead.isEmpty()) {
        placeByCount(ahead, count, 1, row);
        placeByCount(behind, count, -1, row);
        return;
    }
    // Both begin at the source.
    const double step = (ahead.end + behind.end) / (count + 1);
    const int before = std::clamp(static_cast<int>(std::lround(behind.end / step - 0.5)), 0, count);
    place(ahead, count - before, step, 1, row);
    place(behind, before, step, -1, row);
}

} // namespace

Row placesOf(const RowRequest &request)
{
    Row row;
    const Room none;
    const Room ahead = request.goesForward ? roomOf(request.from, request.to) : none;
    const Room behind = request.goesBack ? roomOf(-request.to, -request.from) : none;
    if (request.isRing && request.isByCount)
        place({0.0, 0.0, true}, request.count - 1, (request.to - request.from) / request.count, 1,
              row);
    else if (request.isByCount)
        placeByCount(ahead, behind, request.count - 1, row);
    if (!request.isByCount) {
        placeBySpacing(ahead, request.spacing, 1, row);
        placeBySpacing(behind, request.spacing, -1, row);
        // Once round, what comes to the source's place again is left out.
        if (request.isRing)
            std::erase_if(row.places, [&](const RowPlace &p) {
                return p.at > request.to - 0.5 * request.spacing;
            });
    }
    std::sort(row.places.begin(), row.places.end(),
              [](const RowPlace &a, const RowPlace &b) { return a.number < b.number; });
    return row;
}

} // namespace fff
