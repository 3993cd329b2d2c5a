#include "core/interaction/template_drawing.h"

#include "core/templates/template_curves.h"

namespace fff {

namespace {

/// What is at least half opaque counts.
constexpr double kHalfOpaqueThreshold = 0.5;

double thresholdOf(const GreyPicture &grey, const PictureTrace &trace)
{
    const bool isByOpacity = trace.by == TraceBy::Opacity;
    return trace.threshold.value_or(isByOpacity ? kHalfOpaqueThreshold : suggestedThreshold(grey));
}

Result<std::vector<CurvePath>> tracedLines(const TemplatePicture &picture,
                                           const PictureTrace &trace, const LongWork &work)
{
    const GreyPicture grey = greyOf(picture, trace.by);
    TraceOptions options;
    options.threshold = thresholdOf(grey, trace);
    options.isInverted = trace.isInverted;
    options.smoothing = trace.smoothing;
    options.smallest = trace.smallest;
    const Result<std::vector<TracedRegion>> regions = traced(grey, options, work);
    if (!regions)
        return tl::unexpected(regions.error());
    std::vector<CurvePath> lines;
    for (const TracedRegion &region : *regions) {
        lines.push_back(CurvePath::around(region.outer));
        for (const Contour &hole : region.holes)
            lines.push_back(CurvePath::around(hole));
    }
    return lines;
}

} // namespace

double thresholdOf(const TemplatePicture &picture, const PictureTrace &trace)
{
    return thresholdOf(greyOf(picture, trace.by), trace);
}

Result<Drawing> drawingOf(const Model &model, const Template &one, const PictureTrace &trace,
                          const LongWork &work)
{
    Drawing drawing;
    drawing.name = one.name;
    drawing.place = worldPlacement(one, model);
    drawing.step = steps::kTraceTemplate;
    if (!drawing.place || !(one.picture || one.curves))
        return failure(ErrorCode::BadValue, "template",
                       {one.name, "a picture or a drawing that is there"});
    if (one.curves) {
        drawing.lines = one.curves->lines;
        return drawing;
    }
    Result<std::vector<CurvePath>> lines = tracedLines(*one.picture, trace, work);
    if (!lines)
        return tl::unexpected(std::move(lines.error()));
    drawing.lines = *std::move(lines);
    return drawing;
}

SectionEdit madeOfDrawing(const Model &model, const Drawing &drawing, DrawingAs as,
                          const SectionRef &section, const DrawingRules &rules)
{
    if (drawing.lines.empty())
        return refused(hints::kNothingTraced, {Named{drawing.name}});
    switch (as) {
    case DrawingAs::Sections:
        break;
    case DrawingAs::Contour:
        return drawingContour(model, section, drawing);
    case DrawingAs::Holes:
        return drawingHoles(model, section, drawing);
    case DrawingAs::Engraved:
        return drawingMark(model, section, drawing, Mark::Kind::Engraved);
    case DrawingAs::Scored:
        return drawingMark(model, section, drawing, Mark::Kind::Scored);
    }
    return placedSections(model, drawing, rules);
}

} // namespace fff
