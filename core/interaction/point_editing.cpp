#include "core/interaction/point_editing.h"

#include "core/geometry/symmetrised.h"
#include "core/interaction/point_words.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/ground.h"
#include "core/model/origin.h"
#include "core/model/symmetric_section.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace fff {

namespace {

std::vector<Vec2> placesOf(const Shape &shape, const PointSelection &points,
                           const Vec2 &by = Vec2::Zero())
{
    std::vector<Vec2> places;
    for (const PointAddress &point : points.points())
        places.push_back(position(shape, point) + by);
    return places;
}

//: %1 is the name of a section
constexpr Text kAddPoint = FFF_TEXT("Step", "Add point to %1");
constexpr CountedText kDeletePoints{//: %1 is the name of a section
                                    FFF_TEXT("Step", "Delete point of %1"),
                                    FFF_TEXT_OF_MANY("Step", "Delete %n points of %1")};

/// The control points, one after the other as they stand on the plane.
std::vector<std::pair<double, double>> pointsOf(const Shape &shape)
{
    std::vector<std::pair<double, double>> points;
    for (int b = 0; b < boundaryCount(shape); ++b)
        for (int i = 0; i < boundary(shape, b).segmentCount(); ++i) {
            const CubicBezier &curve = boundary(shape, b).segment(i);
            for (const Vec2 &p : {curve.p0, curve.p1, curve.p2})
                points.emplace_back(p.x(), p.y());
        }
    std::sort(points.begin(), points.end());
    return points;
}

/// The shape with the side on which it was changed, and the image of that.
Result<ShapePointer> withImage(const Shape &before, const Shape &after, const Halfplane &mirror)
{
    const auto was = pointsOf(before), is = pointsOf(after);
    std::vector<std::pair<double, double>> changed;
    std::set_symmetric_difference(was.begin(), was.end(), is.begin(), is.end(),
                                  std::back_inserter(changed));
    int side = 0; // of most of what was changed
    for (const auto &[x, y] : changed)
        side += mirror.height({x, y}) >= 0.0 ? 1 : -1;
    const Halfplane half{mirror.point, side >= 0 ? mirror.inward : Vec2(-mirror.inward)};
    const auto pieces = mirroredHalf(after.contour(), after.holes(), half);
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    return Shape::make(pieces->front().outer, pieces->front().holes);
}

} // namespace

Hint whyNoShape(const Error &error, const Section &section)
{
    switch (error.code) {
    case ErrorCode::SelfCrossing:
        return Hint::refusal(hints::kWouldCrossItself);
    case ErrorCode::BoundariesMeet:
        return Hint::refusal(hints::kWouldMeetHole);
    case ErrorCode::EmptyContour:
        return Hint::refusal(hints::kWouldBeEmpty, {Named{section.name}});
    case ErrorCode::TooFewPoints:
        return Hint::refusal(hints::kTooFewPoints);
    default:
        return Hint::refusal(hints::kEditFailed);
    }
}

PointEdit withEditedShape(const Document &document, SectionId id, const Result<ShapePointer> &shape,
                          std::span<const Vec2> places, Step step, const PointRules &rules)
{
    const Section *section = document.find(id);
    if (!section)
        return refused(hints::kEditFailed);
    if (section->isLocked)
        return refused(hints::kLocked, {Named{section->name}});
    if (!shape)
        return tl::unexpected(whyNoShape(shape.error(), *section));
    EditedPoints edited;
    ShapePointer kept = *shape;
    if (rules.mirror && !(*kept == *section->shape)) {
        const Result<ShapePointer> whole = withImage(*section->shape, *kept, *rules.mirror);
        if (!whole)
            return tl::unexpected(whyNoShape(whole.error(), *section));
        kept = *whole;
    } else if (const MirrorAxis *axis = symmetryOf(*section); axis && !(*kept == *section->shape)) {
        const Result<ShapePointer> whole = symmetrised(*section->shape, kept, *axis);
        if (!whole)
            return tl::unexpected(whyNoShape(whole.error(), *section));
        kept = *whole;
    }
    if (rules.cutsAtGround) {
        const Result<std::vector<ShapePointer>> pieces = clippedAtGround(kept, section->frame);
        if (!pieces)
            return tl::unexpected(whyNoShape(pieces.error(), *section));
        if (pieces->empty())
            return refused(hints::kWouldBeBelowGround, {Named{section->name}});
        if (pieces->front() != kept)
            edited.note = Hint(pieces->size() > 1 ? hints::kLargestPiece : hints::kCutAtGround,
                               {Named{section->name}});
        kept = pieces->front();
    }
    edited.points = pointsAt(*kept, places);
    // A shape that is the same as before is the same object: no step.
    Result<Document> next =
        *kept == *section->shape ? document : setShape(document, id, std::move(kept));
    if (!next)
        return refused(hints::kEditFailed);
    edited.document = *std::move(next);
    edited.step = std::move(step);
    edited.section = id;
    return edited;
}

PointEdit movedSelection(const Document &document, const PointSelection &points, const Vec2 &by,
                         const PointRules &rules)
{
    const Section *section = document.find(points.section());
    if (!section || points.isEmpty())
        return refused(hints::kEditFailed);
    Step step = ofParts(steps::kMovePoints, section->name, points.points().size());
    step.merges = "points";
    for (const PointAddress &p : points.points())
        step.merges.append(" ")
            .append(std::to_string(p.boundary))
            .append("/")
            .append(std::to_string(p.index));
    return withEditedShape(document, section->id, movedPoints(*section->shape, points.points(), by),
                           placesOf(*section->shape, points, by), std::move(step), rules);
}

PointEdit withoutSelection(const Document &document, const PointSelection &points,
                           const PointRules &rules)
{
    const Section *section = document.find(points.section());
    if (!section || points.isEmpty())
        return refused(hints::kEditFailed);
    return withEditedShape(document, section->id, withoutPoints(*section->shape, points.points()),
                           {}, ofParts(kDeletePoints, section->name, points.points().size()),
                           rules);
}

PointEdit withSelectionOfKind(const Document &document, const PointSelection &points,
                              PointKind kind, const PointRules &rules)
{
    const Section *section = document.find(points.section());
    if (!section || points.isEmpty())
        return refused(hints::kEditFailed);
    return withEditedShape(document, section->id, withKind(*section->shape, points.points(), kind),
                           placesOf(*section->shape, points),
                           ofParts(steps::kChangePoints, section->name, points.points().size()),
                           rules);
}

PointEdit withInsertedPoint(const Document &document, SectionId id, int ring, const CurvePoint &at,
                            const PointRules &rules)
{
    const Section *section = document.find(id);
    if (!section || !isPoint(*section->shape, {ring, at.segment}))
        return refused(hints::kEditFailed);
    const Vec2 place = boundary(*section->shape, ring).segment(at.segment).at(at.t);
    PointEdit edit = withEditedShape(document, id, insertedPoint(*section->shape, ring, at), {},
                                     {kAddPoint, {Named{section->name}}}, rules);
    if (edit) {
        // On a line there and back, two are at one place: the new one is where it went in.
        const PointAddress added{ring, at.segment + 1};
        const Shape &now = *edit->document.find(id)->shape;
        if (isPoint(now, added) && (position(now, added) - place).norm() < kNoHandle)
            edit->points = {added};
    }
    return edit;
}

std::optional<std::pair<int, CurvePoint>> placeBetween(const Shape &shape,
                                                       const PointSelection &points)
{
    if (points.isEmpty() || points.points().size() > 2)
        return std::nullopt;
    const PointAddress &first = points.points().front(), &last = points.points().back();
    if (!isPoint(shape, first) || !isPoint(shape, last) || first.boundary != last.boundary)
        return std::nullopt;
    const int count = boundary(shape, first.boundary).segmentCount();
    int segment = first.index;
    if (first.index != last.index && last.index != first.index + 1) {
        if (first.index != 0 || last.index != count - 1)
            return std::nullopt; // not neighbours
        segment = last.index;
    }
    return std::pair(first.boundary, CurvePoint{segment, 0.5});
}

tl::unexpected<Hint> madeByOperation(const Model &model, const SectionRef &ref)
{
    const Operation *operation = model.document.find(ref.operation);
    return tl::unexpected(Hint::refusal(
        hints::kMadeByOperation,
        {Named{model.nameOf(ref)}, Named{operation ? operation->name : std::string()}}));
}

Vec2 arrowAxis(const Frame &frame, const Camera &camera, const Vec2 &arrow)
{
    const Vec3 wanted = arrow.x() * camera.right() + arrow.y() * camera.up();
    const std::array<Vec2, 4> axes{Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)};
    Vec2 best = axes[0];
    double most = -2.0;
    for (const Vec2 &axis : axes) {
        // As it is seen: what runs away from the eye is short on the screen and yet has a
        // direction.
        const Vec3 world = frame.directionToWorld(axis);
        const Vec2 seen(camera.right().dot(world), camera.up().dot(world));
        const double along = seen.norm() > 0.0 ? seen.dot(arrow) / seen.norm() : wanted.dot(world);
        if (along > most) {
            most = along;
            best = axis;
        }
    }
    return best;
}

Vec3 arrowAxis(const Camera &camera, const Vec2 &arrow)
{
    const Vec3 wanted = arrow.x() * camera.right() + arrow.y() * camera.up();
    Eigen::Index axis = 0;
    wanted.cwiseAbs().maxCoeff(&axis);
    Vec3 best = Vec3::Zero();
    best[axis] = wanted[axis] < 0.0 ? -1.0 : 1.0;
    return best;
}

} // namespace fff
