#include "core/stroke/stroke_contour.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/fit.h"

#include <algorithm>

namespace fff {

namespace {

/// What is smaller than this many tolerances is a slip of the hand, not a shape.
constexpr double kSmallestExtent = 5.0;

/// All segments of the closed chain.
std::vector<CubicBezier> closedChain(const StrokeContour &stroke)
{
    std::vector<CubicBezier> chain = stroke.fitted;
    if (stroke.closing)
        chain.push_back(*stroke.closing);
    // A contour has two segments at least: a loop of a single one is cut in its middle.
    if (chain.size() == 1)
        chain = {chain.front().piece(0.0, 0.5), chain.front().piece(0.5, 1.0)};
    return chain;
}

} // namespace

StrokeContour strokeContour(const std::vector<Vec2> &samples, double tolerance)
{
    StrokeContour stroke;
    stroke.fitted = fitCurve(samples, {.tolerance = tolerance});
    if (stroke.fitted.empty())
        return stroke;
    CubicBezier &last = stroke.fitted.back();
    const Vec2 &start = stroke.fitted.front().p0;
    if ((last.p3 - start).norm() <= kClipGrid)
        last.p3 = start;
    else
        stroke.closing = closingSegment(stroke.fitted);

    const Result<Contour> closed = Contour::fromSegments(closedChain(stroke));
    if (!closed)
        return stroke;
    Result<ResolvedContour> resolved = resolveCrossings(*closed);
    if (!resolved)
        return stroke;
    const double extent = bounds(resolved->contour.flatten(tolerance).points).size().maxCoeff();
    const double area = std::abs(resolved->contour.signedArea());
    if (extent < kSmallestExtent * tolerance || area < std::max(kMinArea, tolerance * extent))
        return stroke;
    stroke.contour = std::move(resolved->contour);
    stroke.wasCrossing = resolved->wasCrossing;
    return stroke;
}

} // namespace fff
