#include "core/templates/guide_curve.h"

#include "core/base/tolerances.h"
#include "core/geometry/fit.h"

namespace fff {

Result<Contour> guideCurve(const CutLoop &loop, const Frame &frame, double tolerance)
{
    if (loop.area < kMinArea)
        return failure(ErrorCode::EmptyContour);
    std::vector<Vec2> samples;
    samples.reserve(loop.points.size());
    for (const Vec3 &p : loop.points)
        samples.push_back(frame.toLocal(p));
    FitOptions options;
    options.tolerance = tolerance;
    const std::vector<CubicBezier> chain = fitClosedCurve(samples, options);
    if (chain.size() < 2)
        return failure(ErrorCode::EmptyContour);
    return Contour::fromSegments(chain);
}

} // namespace fff
