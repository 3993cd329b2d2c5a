#include "core/stroke/stroke_contour.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/fit.h"
#include "core/geometry/sampled_line.h"
#include "core/stroke/closed_fit.h"
#include "core/stroke/filled_line.h"
#include "core/stroke/line_ends.h"
#include "core/stroke/settled_half.h"
#include "core/stroke/small_round.h"
#include "core/stroke/twitch.h"

#include <algorithm>
#include <utility>

namespace fff {

namespace {

using Refusal = StrokeContour::Refusal;

/// What is smaller than this many tolerances is a slip of the hand, not a shape.
constexpr double kSmallestExtent = 3.0;
/// A loop that is drawn smaller than so many tolerances is one, too.
constexpr double kSmallestDrawn = 4.0;
/// What is smaller than this many tolerances is fitted as if it were that large; to this part of
/// the tolerance at least, which is what a pixel is good for.
constexpr double kSmallCorner = 0.85; // radians
constexpr double kFittedExtent = 16.0, kFinestFit = 0.4;

/// What it takes to close a segment, and to take one apart where the contour crosses itself, in
/// samples.
constexpr std::size_t kSegmentWork = 150, kCrossingWork = 2000;
/// To find where on a guide a point is, in the same.
constexpr std::size_t kGuidedWork = 4;
/// Segments of a contour that is looked at closely where it crosses itself.
constexpr int kCloselyResolved = 50;

double extentOf(const std::vector<CubicBezier> &chain)
{
    Box2 box;
    for (const CubicBezier &s : chain)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
            box.extend(s.at(t));
    return box.size().maxCoeff();
}

/// A long scribble is taken apart on the chords that it will be cut on: looking closer, as is done
/// for what has a few crossings, would take longer than the hand from one place to the next.
Result<ResolvedContour> withoutCrossings(const Contour &contour)
{
    if (contour.segmentCount() <= kCloselyResolved)
        return resolveCrossings(contour);
    if (isPlain(contour, {}, kCutChord))
        return ResolvedContour{contour, false, {}, false};
    Result<std::vector<CurvedRegion>> regions =
        windingRegions({contour}, WindingRule::NonZero, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    if (regions->empty())
        return failure(ErrorCode::EmptyContour);
    return ResolvedContour{std::move(regions->front().outer), true, {}, false};
}

/// The largest region of the closed chain, if it is one to speak of.
void close(std::vector<CubicBezier> chain, double tolerance, StrokeContour &stroke)
{
    const double chainExtent = extentOf(chain);
    stroke.refusal =
        chainExtent < kSmallestExtent * tolerance ? Refusal::TooShort : Refusal::NoArea;
    // A contour has two segments at least: a loop of a single one is cut in its middle.
    if (chain.size() == 1)
        chain = {chain.front().piece(0.0, 0.5), chain.front().piece(0.5, 1.0)};
    const Result<Contour> closed = Contour::fromSegments(chain);
    if (!closed)
        return;
    stroke.work += kSegmentWork * chain.size();
    Result<ResolvedContour> resolved = withoutCrossings(*closed);
    if (!resolved)
        return;
    if (resolved->wasCrossing)
        stroke.work += kCrossingWork * chain.size();
    const double extent = bounds(resolved->contour.flatten(tolerance).points).size().maxCoeff();
    const double area = std::abs(resolved->contour.signedArea());
    if (extent < kSmallestExtent * tolerance || area < std::max(kMinArea, tolerance * extent)) {
        if (resolved->wasCrossing && stroke.refusal == Refusal::NoArea)
            stroke.refusal = Refusal::CrossesWithoutLoop;
        return;
    }
    stroke.contour = std::move(resolved->contour);
    stroke.wasCrossing = stroke.wasCrossing || resolved->wasCrossing;
    stroke.refusal = Refusal::None;
}

/// Those along what the ends leave, as pieces of that line.
std::vector<FittedPiece> within(const MeantEnds &ends, const std::vector<FittedPiece> &settled)
{
    std::vector<FittedPiece> pieces;
    for (FittedPiece piece : settled) {
        if (piece.from < ends.from || piece.to > ends.to)
            continue;
        piece.from = piece.from - ends.from + ends.place;
        piece.to = piece.to - ends.from + ends.place;
        pieces.push_back(piece);
    }
    return pieces;
}

/// The line that is closed: as it is meant, or with what guides made of it.
struct LineToClose
{
    const std::vector<Vec2> &points;
    const std::vector<FittedPiece> &known; // of its fit
    double cornerAngle = 0.0;
    bool isGuided = false;
};

/// A line that begins and ends on a guide, and goes on there from its end to its beginning.
void closeLoop(const LineToClose &line, const FitOptions &options, StrokeContour &stroke)
{
    // The first piece again, so that the line knows how it arrives there.
    std::vector<Vec2> points = line.points;
    std::vector<FittedPiece> known = line.known;
    FittedPiece again = known.front();
    again.from = points.size() - 1;
    again.to = points.size();
    points.push_back(again.curve.p3);
    known.push_back(again);
    stroke.fitted = fitAround(points, known, options);
    stroke.fitted.pop_back();
    stroke.fitted.back().p3 = stroke.fitted.front().p0;
}

void closePlain(const std::vector<Vec2> &samples, const LineToClose &line, double tolerance,
                double smallest, StrokeContour &stroke)
{
    const FitOptions options{
        .tolerance = tolerance, .cornerAngle = line.cornerAngle, .work = &stroke.work};
    if (line.isGuided && stroke.guided->isLoop) {
        closeLoop(line, options, stroke);
        close(stroke.fitted, smallest, stroke);
        return;
    }
    const std::optional<std::vector<Vec2>> hasty =
        line.isGuided ? std::nullopt : filledRound(samples, tolerance);
    const MeantEnds ends = meantEnds(hasty ? *hasty : line.points, tolerance);
    stroke.wasCrossing = ends.isLoop;
    if (auto loop = line.isGuided ? std::nullopt : smallRound(ends.line, smallest)) {
        stroke.fitted = *std::move(loop);
        close(stroke.fitted, smallest, stroke);
        return;
    }
    const std::vector<FittedPiece> settled = within(ends, line.known);
    // Nothing leads on over a corner, so there is nothing to share out.
    auto loop = ends.isCorner ? std::nullopt : closedFit(ends.line, settled, options);
    if (loop) {
        stroke.fitted = *std::move(loop);
        close(stroke.fitted, smallest, stroke);
        return;
    }
    stroke.fitted = fitAround(ends.line, settled, options);
    if (stroke.fitted.empty())
        return;
    CubicBezier &last = stroke.fitted.back();
    const Vec2 &start = stroke.fitted.front().p0;
    if ((last.p3 - start).norm() <= kClipGrid)
        last.p3 = start;
    else
        stroke.closing = closingSegment(stroke.fitted);
    std::vector<CubicBezier> chain = stroke.fitted;
    if (stroke.closing)
        chain.push_back(*stroke.closing);
    close(std::move(chain), smallest, stroke);
}

/// False when the halves would not meet; then nothing is changed.
bool closeMirrored(const LineToClose &line, double tolerance, double smallest,
                   StrokeContour &stroke)
{
    std::optional<MirroredHalf> half = mirroredHalf(line.points, *stroke.axis, *stroke.symmetry,
                                                    tolerance, line.known, &stroke.work);
    if (!half)
        return false;
    std::vector<CubicBezier> chain = std::move(half->outline);
    chain.insert(chain.end(), half->mirrored.begin(), half->mirrored.end());
    stroke.fitted = std::move(half->fitted);
    stroke.opening = half->opening;
    stroke.closing = half->closing;
    stroke.mirrored = std::move(half->mirrored);
    stroke.wasCrossing = half->wasCrossing;
    stroke.wasCutAtAxis = half->wasCut;
    close(std::move(chain), smallest, stroke);
    return true;
}

/// Of the line that is meant, the points by which no guide catches it.
std::vector<FreeSamples> freePoints(const MeantLine &meant, const std::vector<FreeSamples> &samples)
{
    std::vector<FreeSamples> points;
    for (const FreeSamples &free : samples)
        points.push_back({meant.placeOf(free.from), meant.placeOf(free.to)});
    return points;
}

/// tolerance: that it is fitted to
void closeFitted(const std::vector<Vec2> &samples, const MeantLine &meant, double tolerance,
                 const StrokeContourOptions &options, StrokeContour &stroke)
{
    if (options.axis)
        stroke.symmetry = judgeSymmetry(samples, *options.axis, options.mirrorRatio, tolerance);
    if (options.guides) {
        stroke.guided = guided(meant.points(), freePoints(meant, options.free), *options.guides);
        stroke.work += kGuidedWork * meant.points().size();
    }
    if (stroke.guided && stroke.guided->whole) {
        const PathLocator &guide = options.guides->lines[*stroke.guided->whole];
        stroke.fitted = guide.piece(0.0, guide.length());
        close(stroke.fitted, options.tolerance, stroke);
        return;
    }
    const bool isGuided = stroke.guided && !stroke.guided->pieces.empty();
    const LineToClose line{isGuided ? stroke.guided->points : meant.points(),
                           isGuided ? stroke.guided->pieces : meant.settled().pieces(),
                           meant.cornerAngle(), isGuided};
    stroke.isMirrored = stroke.symmetry && stroke.symmetry->isOneSided && options.isSymmetryOn;
    if (stroke.isMirrored && closeMirrored(line, tolerance, options.tolerance, stroke))
        return;
    stroke.doHalvesMeet = !stroke.isMirrored;
    stroke.isMirrored = false;
    closePlain(samples, line, tolerance, options.tolerance, stroke);
}

void reach(const SlitToReach &slit, StrokeContour &stroke)
{
    SlitReach found = reached(*stroke.contour, slit);
    stroke.isApart = found.isApart;
    if (!found.withNeck)
        return;
    stroke.work += kCrossingWork * stroke.contour->segmentCount();
    stroke.beside = std::exchange(stroke.contour, std::move(found.withNeck));
}

} // namespace

FitOptions fitOptions(const StrokeContourOptions &options)
{
    return {.tolerance = options.tolerance};
}

StrokeContour strokeContour(const std::vector<Vec2> &samples, const StrokeContourOptions &options)
{
    const std::vector<Vec2> usable = SampledLine::usable(samples);
    MeantLine meant(fitOptions(options));
    meant.follow(usable);
    return strokeContour(usable, meant, options);
}

StrokeContour strokeContour(const std::vector<Vec2> &samples, const MeantLine &meant,
                            const StrokeContourOptions &options)
{
    StrokeContour stroke;
    stroke.refusal = Refusal::TooShort;
    stroke.axis = options.axis;
    const Box2 drawn = bounds(samples);
    const double extent = drawn.isEmpty() ? 0.0 : drawn.size().maxCoeff();
    // Joins to the axis would make something even of a slip of the hand.
    const bool isDot = extent < kSmallestDrawn * options.tolerance;
    if (isDot || isTwitch(samples)) {
        if (!isDot)
            stroke.refusal = Refusal::Twitch;
        const FitOptions plain{.tolerance = options.tolerance, .work = &stroke.work};
        stroke.fitted = fitAround(meant.points(), meant.settled().pieces(), plain);
        return stroke;
    }
    const double tolerance =
        std::clamp(extent / kFittedExtent, kFinestFit * options.tolerance, options.tolerance);
    if (tolerance < options.tolerance && meant.settled().pieces().empty()) {
        MeantLine small({.tolerance = tolerance, .cornerAngle = kSmallCorner});
        small.follow(samples);
        closeFitted(samples, small, tolerance, options, stroke);
    } else {
        closeFitted(samples, meant, options.tolerance, options, stroke);
    }
    if (stroke.contour && options.slit)
        reach(*options.slit, stroke);
    return stroke;
}

} // namespace fff
