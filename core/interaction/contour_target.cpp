#include "core/interaction/contour_target.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/snapping.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/ground.h"
#include "core/model/mended_shape.h"
#include "core/model/symmetric_section.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

//: %1 is the name of a section
constexpr Text kRedrawSection = FFF_TEXT("Step", "Redraw %1");
//: %1 is the name of a section
constexpr Text kAddHole = FFF_TEXT("Step", "Draw a hole in %1");

/// The document after a step that changed one section; nothing when that could not be done.
tl::expected<DrawnContour, Hint> changed(Result<Document> next, Text step, const Section &section)
{
    if (!next)
        return refused(hints::kFailed);
    DrawnContour drawn;
    drawn.document = *std::move(next);
    drawn.step = {step, {Named{section.name}}};
    drawn.name = section.name;
    drawn.section = section.id;
    return drawn;
}

/// The section's shape with these holes, mended; its hint says what had to be.
tl::expected<DrawnContour, Hint> withShape(const Document &document, const Section &section,
                                           const Contour &contour,
                                           const std::vector<Contour> &holes, Text step)
{
    std::vector<PlacedContour> placed;
    for (const Contour &hole : holes)
        placed.push_back({hole, {}});
    std::vector<Warning> warnings;
    Result<ShapePointer> shape = makeMendedShape({contour, {}}, placed, section.name, warnings);
    if (!shape)
        return refused(hints::kFailed);
    const auto has = [&](WarningCode code) {
        return std::any_of(warnings.begin(), warnings.end(),
                           [code](const Warning &w) { return w.code == code; });
    };
    if (step == kAddHole && has(WarningCode::HoleOutside))
        return refused(hints::kHoleOutside, {Named{section.name}});
    tl::expected<DrawnContour, Hint> drawn =
        changed(setShape(document, section.id, *std::move(shape)), step, section);
    if (!drawn)
        return drawn;
    if (has(WarningCode::NotchedContour))
        drawn->note = Hint(hints::kHoleIsNotch, {Named{section.name}});
    else if (step == kAddHole && has(WarningCode::MergedHoles))
        drawn->note = Hint(hints::kHolesMerged, {Named{section.name}});
    else if (has(WarningCode::HoleOutside))
        drawn->note = Hint(hints::kHolesLeftOut, {Named{section.name}});
    return drawn;
}

/// The axis, where what was kept of the contour is symmetric to it.
std::optional<MirrorAxis> symmetricTo(const Shape &shape, const MirrorAxis &axis)
{
    return isSymmetric(shape, axis) ? std::optional(axis) : std::nullopt;
}

/// From the coordinates of one frame to those of another one in the same plane.
MirrorAxis inFrame(const MirrorAxis &axis, const Frame &from, const Frame &to)
{
    return {to.toLocal(from.toWorld(axis.point)),
            to.directionToLocal(from.directionToWorld(axis.direction)).normalized()};
}
Result<Contour> inFrame(const Contour &contour, const Frame &from, const Frame &to)
{
    if (from == to)
        return contour;
    std::vector<Vec2> points;
    for (const Vec2 &p : contour.points())
        points.push_back(to.toLocal(from.toWorld(p)));
    return Contour::fromPoints(std::move(points));
}

tl::expected<DrawnContour, Hint> newSection(const Document &document, const ContourTarget &target,
                                            const Contour &contour, const DrawingRules &rules)
{
    NewSection section;
    section.frame = seenFrame(target);
    const Result<Contour> placed = inFrame(contour, target.canvas, section.frame);
    const Result<ShapePointer> shape =
        placed ? Shape::make(*placed) : Result<ShapePointer>(tl::unexpected(placed.error()));
    if (!shape)
        return refused(hints::kFailed);
    section.name = freeSectionName(document, rules.naming);
    section.shape = *shape;
    section.parent = target.parent;
    if (rules.axis)
        section.symmetry =
            symmetricTo(*section.shape, inFrame(*rules.axis, target.canvas, section.frame));
    Result<Document> next = addSection(document, std::move(section));
    if (!next)
        return refused(hints::kFailed);
    DrawnContour drawn;
    drawn.document = *std::move(next);
    const Section &added = *drawn.document.sections.back();
    drawn.step = {steps::kDrawSection, {Named{added.name}}};
    drawn.name = added.name;
    drawn.section = added.id;
    return drawn;
}

tl::expected<DrawnContour, Hint> redrawn(const Document &document, SectionId id,
                                         const Contour &contour,
                                         const std::optional<MirrorAxis> &axis)
{
    const Section *section = document.find(id);
    if (!section)
        return refused(hints::kFailed);
    tl::expected<DrawnContour, Hint> drawn =
        withShape(document, *section, contour, section->shape->holes(), kRedrawSection);
    if (!drawn)
        return drawn;
    const Shape &shape = *drawn->document.find(id)->shape;
    Result<Document> next = setSymmetry(std::move(drawn->document), id,
                                        axis ? symmetricTo(shape, *axis) : std::nullopt);
    if (!next)
        return refused(hints::kFailed);
    drawn->document = *std::move(next);
    return drawn;
}

/// In the contour and away from all other holes: nothing has to be mended.
bool isWellInside(const Contour &hole, const Shape &shape)
{
    const Box2 box = hole.bounds();
    const auto isApart = [&](const Contour &other) { return !box.intersects(other.bounds()); };
    return std::abs(hole.signedArea()) > kMinArea &&
           std::all_of(shape.holes().begin(), shape.holes().end(), isApart) &&
           nesting(hole, shape.contour(), kCutChord) == Nesting::FirstInside;
}

tl::expected<DrawnContour, Hint> withHole(const Document &document, SectionId id,
                                          const Contour &hole)
{
    const Section *section = document.find(id);
    if (!section)
        return refused(hints::kFailed);
    const Shape &shape = *section->shape;
    std::vector<Contour> holes = shape.holes();
    holes.push_back(hole);
    if (isWellInside(hole, shape)) {
        Result<ShapePointer> whole = Shape::make(shape.contour(), std::move(holes));
        if (!whole)
            return refused(hints::kFailed);
        return changed(setShape(document, id, *std::move(whole)), kAddHole, *section);
    }
    tl::expected<DrawnContour, Hint> drawn =
        withShape(document, *section, shape.contour(), holes, kAddHole);
    if (drawn && std::abs(drawn->document.find(id)->shape->area() - shape.area()) < kMinArea)
        return refused(hints::kHoleOutside, {Named{section->name}}); // there is a hole already
    return drawn;
}

} // namespace

ContourTarget ContourTarget::newSection(const Frame &canvas, std::optional<Parent> parent)
{
    ContourTarget target;
    target.canvas = canvas;
    target.parent = std::move(parent);
    return target;
}

ContourTarget ContourTarget::redraw(const Section &section)
{
    ContourTarget target;
    target.purpose = Purpose::Redraw;
    target.canvas = section.frame;
    target.section = section.id;
    return target;
}

ContourTarget ContourTarget::hole(const Section &section)
{
    ContourTarget target = redraw(section);
    target.purpose = Purpose::Hole;
    return target;
}

Frame seenFrame(const ContourTarget &target)
{
    const Frame &canvas = target.canvas;
    const auto eye = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), canvas.normal());
    Frame frame = ownGrid(canvas, eye);
    Vec3 x = frame.x;
    for (const Vec3 &other : {frame.y, Vec3(-frame.x), Vec3(-frame.y)})
        if (other.dot(target.right) > x.dot(target.right) + kSameDirection)
            x = other;
    // The very axes where they differ by rounding alone.
    if ((x - canvas.x).norm() < kSameDirection)
        return canvas;
    return {canvas.origin, x, frame.x.cross(frame.y).cross(x).normalized()};
}

std::optional<MirrorAxis> slitAxis(const ContourTarget &target, const Document &document)
{
    std::optional<Parent> parent = target.parent;
    if (target.purpose == ContourTarget::Purpose::Redraw) {
        if (const Section *section = document.find(target.section))
            parent = section->parent;
    }
    const Section *ground = parent ? document.find(parent->section.drawn) : nullptr;
    if (!ground)
        return {};
    const auto onCanvas = [&](const Vec2 &p) {
        return target.canvas.toLocal(ground->frame.toWorld(p));
    };
    const Vec2 from = onCanvas(parent->slitFrom), way = onCanvas(parent->slitTo) - from;
    if (way.norm() < kMinOverlap)
        return {};
    return MirrorAxis{from, way.normalized()};
}

void moveToDistance(CanvasChoice &canvas, double distance)
{
    Frame &frame = canvas.target.canvas;
    frame.origin += (distance - *canvas.distance) * frame.normal();
    canvas.distance = distance;
}

tl::expected<DrawnContour, Hint> drawContour(const Document &document, const ContourTarget &target,
                                             const Contour &contour, const DrawingRules &rules)
{
    if (const Section *section = document.find(target.section); section && section->isLocked)
        return tl::unexpected(Hint::refusal(hints::kLocked, {Named{section->name}}));
    if (target.purpose == ContourTarget::Purpose::Hole)
        return withHole(document, target.section, contour);
    Result<std::vector<ClippedPiece>> pieces;
    if (rules.cutsAtGround)
        pieces = clippedAtGround(contour, target.canvas);
    else
        pieces->push_back({contour, {}});
    if (!pieces)
        return refused(hints::kEditFailed);
    if (pieces->empty())
        return refused(hints::kBelowGround);
    const Contour &kept = pieces->front().outer;
    tl::expected<DrawnContour, Hint> drawn =
        target.purpose == ContourTarget::Purpose::Redraw
            ? redrawn(document, target.section, kept, rules.axis)
            : newSection(document, target, kept, rules);
    if (!drawn)
        return drawn;
    drawn->isCutAtGround = !(kept == contour);
    if (pieces->size() > 1)
        drawn->note = Hint(hints::kLargestPiece, {Named{drawn->name}});
    else if (drawn->isCutAtGround && !drawn->note)
        drawn->note = Hint(hints::kCutAtGround, {Named{drawn->name}});
    return drawn;
}

tl::expected<DrawnContour, Hint> drawFigure(const Document &document, const ContourTarget &target,
                                            const Figure &figure, const DrawingRules &rules)
{
    const Result<Contour> contour = contourOf(figure);
    if (!contour)
        return refused(hints::kEditFailed);
    tl::expected<DrawnContour, Hint> drawn = drawContour(document, target, *contour, rules);
    if (!drawn)
        return drawn;
    Figure placed = figure;
    const Frame &frame = drawn->document.find(drawn->section.drawn)->frame;
    if (!(frame == target.canvas)) {
        placed.centre = frame.toLocal(target.canvas.toWorld(figure.centre));
        const Vec2 right = frame.directionToLocal(target.canvas.x);
        placed.turn += std::atan2(right.y(), right.x());
    }
    Result<Document> with = addFigure(drawn->document, drawn->section.drawn, placed);
    if (with)
        drawn->document = *std::move(with);
    return drawn;
}

} // namespace fff
