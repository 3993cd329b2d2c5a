#include "core/interaction/operation_handles.h"

#include "core/operations/operation_kind.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// Ends of a track that are one place, mm.
constexpr double kSamePlace = 1e-3;

} // namespace

bool OperationMarks::isRing() const
{
    return track.size() > 2 && (track.front().first - track.back().first).norm() <= kSamePlace;
}

OperationMarks operationMarks(const Model &model, OperationId id)
{
    OperationMarks marks;
    const OperationResult *result = model.resultOf(id);
    const Operation *operation = model.document.find(id);
    const OperationKind *kind = operation ? operationKind(operation->kind) : nullptr;
    if (!result || !kind || result->track.size() < 2)
        return marks;
    marks.track = result->track;
    for (const char *key : kind->handles) {
        const ParameterSpec *spec = kind->parameter(key);
        const std::optional<ParameterValue> value = valueOf(*spec, *operation);
        if (!value || !counts(*spec, *operation))
            continue;
        const double number = std::get<double>(*value);
        marks.handles.push_back({id, key, number, placeOnTrack(marks.track, number)});
    }
    return marks;
}

Vec3 placeOnTrack(const std::vector<std::pair<Vec3, double>> &track, double value)
{
    const auto after =
        std::upper_bound(track.begin() + 1, track.end() - 1, value,
                         [](double v, const auto &point) { return v < point.second; });
    const auto &[to, end] = *after;
    const auto &[from, begin] = *(after - 1);
    const double t = end > begin ? std::clamp((value - begin) / (end - begin), 0.0, 1.0) : 0.0;
    return from + t * (to - from);
}

double valueOnTrack(const std::vector<std::pair<Vec3, double>> &track, const Camera &camera,
                    const Vec2 &viewport, const Vec2 &position)
{
    double best = track.front().second, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < track.size(); ++i) {
        const Vec2 from = camera.toScreen(track[i].first, viewport);
        const Vec2 way = camera.toScreen(track[i + 1].first, viewport) - from;
        const double length2 = way.squaredNorm();
        const double t =
            length2 > 0.0 ? std::clamp((position - from).dot(way) / length2, 0.0, 1.0) : 0.0;
        const double distance = (from + t * way - position).norm();
        if (distance < nearest) {
            nearest = distance;
            best = track[i].second + t * (track[i + 1].second - track[i].second);
        }
    }
    return best;
}

int handleAt(const OperationMarks &marks, const Camera &camera, const Vec2 &viewport,
             const Vec2 &position, double reach)
{
    int best = -1;
    double nearest = reach;
    for (std::size_t i = 0; i < marks.handles.size(); ++i) {
        const OperationHandle &handle = marks.handles[i];
        const double distance = (camera.toScreen(handle.at, viewport) - position).norm();
        const bool isSamePlace =
            best >= 0 && marks.handles[static_cast<std::size_t>(best)].at == handle.at;
        const bool isAtEnd = handle.value >= marks.track.back().second;
        if (isSamePlace ? !isAtEnd : distance <= nearest) {
            best = static_cast<int>(i);
            nearest = distance;
        }
    }
    return best;
}

} // namespace fff
