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

TraceOptions optionsOf(const GreyPicture &grey, const PictureTrace &trace)
{
    TraceOptions options;
    options.threshold = thresholdOf(grey, trace);
    options.isInverted = trace.isInverted;
    options.smoothing = trace.smoothing;
    options.smallest = trace.smallest;
    return options;
}

/// What of a template has a place and something in it.
Result<Drawing> placedDrawing(const Model &model, const Template &one)
{
    Drawing drawing;
    drawing.name = one.name;
    drawing.place = worldPlacement(one, model);
    drawing.step = steps::kTraceTemplate;
    if (!drawing.place || !(one.picture || one.curves))
        return failure(ErrorCode::BadValue, "template",
                       {one.name, "a picture or a drawing that is there"});
    if (one.curves)
        drawing.lines = one.curves->lines;
    return drawing;
}

} // namespace

double thresholdOf(const TemplatePicture &picture, const PictureTrace &trace)
{
    return thresholdOf(greyOf(picture, trace.by), trace);
}

Result<TracedPicturePointer> PictureTracer::traced(TemplatePicturePointer picture,
                                                   const PictureTrace &trace, const LongWork &work)
{
    if (!picture)
        return failure(ErrorCode::BadValue, "picture");
    if (picture != m_picture || trace.by != m_by) {
        m_grey = greyOf(*picture, trace.by);
        m_picture = picture;
        m_by = trace.by;
    }
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    const Result<std::vector<TracedRegion>> regions =
        fff::traced(m_grey, optionsOf(m_grey, trace), work);
    if (!regions)
        return tl::unexpected(regions.error());
    auto made = std::make_shared<TracedPicture>();
    made->picture = std::move(picture);
    made->trace = trace;
    made->regions = regions->size();
    for (const TracedRegion &region : *regions) {
        made->lines.push_back(CurvePath::around(region.outer));
        for (const Contour &hole : region.holes)
            made->lines.push_back(CurvePath::around(hole));
    }
    return made;
}

Result<Drawing> drawingOf(const Model &model, const Template &one, const WantedTrace &wanted,
                          const LongWork &work)
{
    Result<Drawing> drawing = placedDrawing(model, one);
    if (!drawing || one.curves)
        return drawing;
    TracedPicturePointer known = wanted.known;
    if (!known || !known->isOf(one, wanted.trace)) {
        Result<TracedPicturePointer> traced =
            PictureTracer().traced(one.picture, wanted.trace, work);
        if (!traced)
            return tl::unexpected(std::move(traced.error()));
        known = *std::move(traced);
    }
    drawing->lines = known->lines;
    drawing->outlines = known->regions;
    return drawing;
}

Result<Drawing> drawingOf(const Model &model, const Template &one, const PictureTrace &trace,
                          const LongWork &work)
{
    return drawingOf(model, one, WantedTrace{one.id, {}, trace, {}}, work);
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
