#include "core/templates/template_curves.h"

#include "core/base/tolerances.h"
#include "core/geometry/tangle.h"

namespace fff {

Result<TemplateCurvesPointer> makeTemplateCurves(std::vector<CurvePath> lines)
{
    Box2 box;
    for (const CurvePath &line : lines)
        for (const Vec2 &p : line.flatten(kCutChord))
            box.extend(p);
    if (box.isEmpty() || !(box.size().maxCoeff() > 0.0))
        return failure(ErrorCode::EmptyContour);
    auto made = std::make_shared<TemplateCurves>();
    made->size = box.size();
    for (const CurvePath &line : joined(std::move(lines), kDrawnGap)) {
        std::vector<Vec2> points = line.points();
        for (Vec2 &p : points)
            p -= box.center();
        if (Result<CurvePath> moved = CurvePath::fromPoints(std::move(points)))
            made->lines.push_back(*std::move(moved));
    }
    std::vector<CurvePath> closed;
    for (const CurvePath &line : made->lines) {
        const bool isSimple = line.isClosed() && largestTangle({line}) <= kMostCrossingWork;
        (isSimple ? closed : made->open).push_back(line);
    }
    Result<std::vector<Outline>> outlines = outlinesOf(closed);
    if (!outlines)
        return tl::unexpected(std::move(outlines.error()));
    made->outlines = *std::move(outlines);
    return made;
}

} // namespace fff
