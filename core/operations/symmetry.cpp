#include "core/operations/symmetry.h"

#include "core/base/text.h"
#include "core/base/tolerances.h"
#include "core/geometry/contour_points.h"
#include "core/geometry/symmetrised.h"
#include "core/operations/copying.h"
#include "core/operations/images.h"
#include "core/operations/source_crossing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

/// Two shapes in space are one image when they differ by no more, mm: frames and files round.
constexpr double kSameImage = 1e-4;
/// A section that is no farther from an image than this, mm, was drawn for it: by hand, in another
/// program with a few digits, or as a copy that was moved there.
constexpr double kDrawnForIt = 0.1;
/// That one symmetry can be about, of a selection.
constexpr int kMostSections = 500;

/// Over a section of this size, mm, round a point of the second plane.
bool isSamePlane(const Frame &a, const Frame &b, const Vec3 &point, double size, double within)
{
    return size * a.normal().cross(b.normal()).norm() <= within &&
           std::abs(a.height(point)) <= within;
}

/// Whether the placement maps the section's plane to itself.
bool keepsPlane(const Section &section, const Similarity &placement)
{
    const Frame &frame = section.frame;
    const double size = section.shape->bounds().size().norm();
    const Frame image = placed(frame, placement);
    return isSamePlane(frame, image, image.origin, size, kSameImage);
}

/// The same region in space: planes, areas, middles and boundaries agree, mm.
bool isSameImage(const Section &a, const Section &b, double within = kSameImage)
{
    const double size = a.shape->bounds().size().norm();
    if (!isSamePlane(a.frame, b.frame, b.frame.toWorld(b.shape->centroid()), size, within))
        return false;
    if (std::abs(a.shape->area() - b.shape->area()) > within * (1.0 + size) ||
        (a.frame.toWorld(a.shape->centroid()) - b.frame.toWorld(b.shape->centroid())).norm() >
            within)
        return false;
    // Of the boundary: every anchor of one lies on the other's.
    const auto isNear = [&](const Vec2 &p) {
        const Vec2 q = b.frame.toLocal(a.frame.toWorld(p));
        return nearestPlace(b.shape->contour(), q).distance <= within;
    };
    for (int i = 0; i < a.shape->contour().segmentCount(); ++i)
        if (!isNear(a.shape->contour().segment(i).p0))
            return false;
    return true;
}

/// Where a line in the world runs in a section's plane; the section has to contain it.
PlaneLine lineIn(const Frame &frame, const Vec3 &point, const Vec3 &direction)
{
    return {frame.toLocal(point), frame.directionToLocal(direction).normalized()};
}

bool reachesAcross(const Shape &shape, const PlaneLine &line)
{
    double least = 0.0, most = 0.0;
    for (const Vec2 &p : shape.region().outer) {
        least = std::min(least, line.across(p));
        most = std::max(most, line.across(p));
    }
    return least < -kSameImage && most > kSameImage && !intervalsOn(line, shape.region()).empty();
}

/// The larger half and its image.
Result<ShapePointer> mirrored(const ShapePointer &of, const PlaneLine &line)
{
    const Shape &shape = *of;
    const Vec2 left = perpendicular(line.direction);
    double areas[2] = {};
    for (const int side : {0, 1}) {
        const Result<std::vector<ClippedPiece>> pieces =
            clip(shape.contour(), shape.holes(), {line.point, side == 0 ? left : Vec2(-left)});
        if (!pieces)
            return tl::unexpected(pieces.error());
        for (const ClippedPiece &piece : *pieces) {
            areas[side] += std::abs(piece.outer.signedArea());
            for (const Contour &hole : piece.holes)
                areas[side] -= std::abs(hole.signedArea());
        }
    }
    // A shape that is symmetric stays bit for bit what it is.
    if (std::abs(areas[0] - areas[1]) <= kSameImage) {
        const Eigen::Matrix2d mirror =
            2.0 * line.direction * line.direction.transpose() - Eigen::Matrix2d::Identity();
        Section own, image;
        const Result<ShapePointer> other = mappedShape(of, {mirror, line.point});
        const Result<ShapePointer> same = Shape::make(shape.contour(), shape.holes());
        if (!other || !same)
            return other ? same : other;
        own.shape = *same;
        image.shape = *other;
        if (isSameImage(own, image))
            return own.shape;
    }
    const Halfplane half{line.point, areas[0] >= areas[1] ? left : Vec2(-left)};
    const auto pieces = mirroredHalf(shape.contour(), shape.holes(), half);
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    return Shape::make(pieces->front().outer, pieces->front().holes);
}

class SymmetryMaker : public ImageMaker
{
public:
    using ImageMaker::ImageMaker;

    /// It is of this shape from now on, as are its copies; of its own where that is none.
    void reshape(const SectionPointer &section, const Result<ShapePointer> &shape)
    {
        const std::optional<ShapePointer> made = context().made(shape);
        if (!made || **made == *section->shape)
            return;
        Section next = *section;
        next.shape = *made;
        change(section, std::make_shared<const Section>(std::move(next)));
    }
    /// Its larger half across the line, and the image of that.
    void mirror(const SectionPointer &section, const PlaneLine &line)
    {
        context().setMirror(section->ref(), {line.point, perpendicular(line.direction)});
        reshape(section, mirrored(section->shape, line));
    }
    /// Sections that are there at the image's place already.
    bool hasImage(const SectionPointer &section, const Similarity &placement) const
    {
        const Section image = imageOf(*section, placement);
        return std::any_of(scope().begin(), scope().end(), [&](const SectionPointer &other) {
            return isSameImage(image, *other, kDrawnForIt);
        });
    }
};

/// The sections that a symmetry is about; nothing when it misses one.
std::optional<std::vector<SectionPointer>> scopeOf(OperationContext &context)
{
    if (context.choice("what") == "whole")
        return context.all();
    std::vector<SectionPointer> sections = context.inputs("sections");
    if (sections.empty()) {
        context.notice({.kind = OperationNotice::Kind::InputMissing, .role = "sections"});
        return std::nullopt;
    }
    return sections;
}

struct Mirror
{
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitX();

    Similarity placement() const
    {
        return Similarity::turned(Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose(),
                                  point);
    }
};

std::optional<Mirror> mirrorOf(OperationContext &context)
{
    const std::string plane = context.choice("plane");
    if (plane == "x")
        return Mirror{};
    if (plane == "y")
        return Mirror{Vec3::Zero(), Vec3::UnitY()};
    if (plane == "z")
        return Mirror{Vec3::Zero(), Vec3::UnitZ()};
    const SectionPointer section = context.input("across");
    if (!section)
        return std::nullopt;
    return Mirror{section->frame.origin, section->frame.normal()};
}

void makeMirror(OperationContext &context)
{
    const std::optional<Mirror> mirror = mirrorOf(context);
    std::optional<std::vector<SectionPointer>> scope = scopeOf(context);
    if (!mirror || !scope)
        return;
    const Similarity placement = mirror->placement();
    SymmetryMaker maker(context, *std::move(scope));
    const std::vector<SectionPointer> all = maker.scope(); // which changes
    for (const SectionPointer &section : all) {
        const Frame &frame = section->frame;
        if (keepsPlane(*section, placement)) {
            const Vec3 along = frame.normal().cross(mirror->normal);
            if (along.norm() < 0.5) { // it lies in the mirror
                maker.leave(section);
                continue;
            }
            const Vec3 foot =
                frame.origin - mirror->normal.dot(frame.origin - mirror->point) * mirror->normal;
            const PlaneLine line = lineIn(frame, foot, along);
            if (context.isOn("join") && reachesAcross(*section->shape, line)) {
                maker.leave(section);
                maker.mirror(section, line);
                continue;
            }
        }
        if (maker.hasImage(section, placement))
            maker.leave(section);
    }
    maker.addCopies(placement, {}, "\u2032");
}

/// A line in space.
struct TurnAxis
{
    Vec3 point = Vec3::Zero(), direction = Vec3::UnitY();

    Similarity turn(double angle) const
    {
        return Similarity::turned(Eigen::AngleAxisd(angle, direction).toRotationMatrix(), point);
    }
};

std::optional<TurnAxis> turnAxisOf(OperationContext &context)
{
    if (context.choice("axis") == "vertical")
        return TurnAxis{};
    const std::vector<SectionPointer> sections = context.inputs("around");
    if (sections.size() < 2)
        return std::nullopt;
    const std::optional<SourceCrossing> crossing = sourceCrossing(*sections[0], *sections[1]);
    if (!crossing) {
        context.notice({OperationNotice::Kind::InputsApart});
        return std::nullopt;
    }
    return TurnAxis{crossing->axis.point, crossing->axis.direction};
}

/// One that the axis goes through square: the sector round its frame's x, all round.
bool keepTurned(SymmetryMaker &maker, const SectionPointer &section, const TurnAxis &axis,
                int times)
{
    const Frame &frame = section->frame;
    if (frame.normal().cross(axis.direction).norm() > kPracticallyParallel)
        return false;
    const double along = axis.direction.dot(frame.normal());
    const Vec3 through =
        axis.point + frame.normal().dot(frame.origin - axis.point) / along * axis.direction;
    const Vec2 centre = frame.toLocal(through);
    if (locate(centre, section->shape->region().outer) == Side::Outside)
        return false;
    const auto pieces =
        repeatedSector(section->shape->contour(), section->shape->holes(), centre, times, 0.0);
    maker.leave(section);
    if (!pieces)
        maker.reshape(section, tl::unexpected(pieces.error()));
    else if (!pieces->empty())
        maker.reshape(section, Shape::make(pieces->front().outer, pieces->front().holes));
    return true;
}

void makeRotational(OperationContext &context)
{
    const std::optional<TurnAxis> axis = turnAxisOf(context);
    std::optional<std::vector<SectionPointer>> scope = scopeOf(context);
    if (!axis || !scope)
        return;
    const int times = context.count("times");
    const double step = 2.0 * std::numbers::pi / times;
    SymmetryMaker maker(context, *std::move(scope));
    std::vector<SectionPointer> halves; // upright ones that half a turn maps to themselves
    const std::vector<SectionPointer> all = maker.scope(); // which changes
    for (const SectionPointer &section : all) {
        if (keepTurned(maker, section, *axis, times))
            continue;
        const bool isHalf = times % 2 == 0 && keepsPlane(*section, axis->turn(0.5 * times * step));
        if (isHalf) {
            const PlaneLine line = lineIn(section->frame, axis->point, axis->direction);
            if (reachesAcross(*section->shape, line)) {
                halves.push_back(section);
                maker.mirror(section, line);
                continue;
            }
        }
        bool hasAll = true;
        for (int i = 1; i < times && hasAll; ++i)
            hasAll = maker.hasImage(section, axis->turn(i * step));
        if (hasAll)
            maker.leave(section);
    }
    for (int i = 1; i < times; ++i) {
        if (2 * i == times)
            for (const SectionPointer &section : halves)
                maker.leave(section);
        std::string mark = " ";
        maker.addCopies(axis->turn(i * step), std::to_string(i),
                        mark.append(std::to_string(i + 1)));
    }
}

std::vector<InputSpec> symmetryInputs(const InputSpec &first)
{
    return {first,
            {.role = "sections",
             .label = QT_TRANSLATE_NOOP("Operation", "Sections"),
             .prompt = QT_TRANSLATE_NOOP("Operation", "Click the sections that it applies to."),
             .least = 0,
             .most = kMostSections,
             .countsIf = "what",
             .countsFor = {"selection"}}};
}

bool isOfAll(const Operation &operation)
{
    const auto what = operation.parameters.find("what");
    return what == operation.parameters.end() ||
           what->second == ParameterValue(std::string("whole"));
}

bool narrow(Operation &operation, std::vector<OperationInput> sections)
{
    if (std::ssize(sections) > kMostSections)
        return false;
    operation.parameters.insert_or_assign("what", std::string("selection"));
    operation.inputs.insert_or_assign("sections", std::move(sections));
    return true;
}

ParameterSpec whatParameter()
{
    return {.key = "what",
            .label = QT_TRANSLATE_NOOP("Operation", "Applies to"),
            .unit = Unit::Choice,
            .choices = {{"whole", QT_TRANSLATE_NOOP("Operation", "Whole model")},
                        {"selection", QT_TRANSLATE_NOOP("Operation", "Selection")}}};
}

} // namespace

const OperationKind kMirror{
    .key = "mirror",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Mirror"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Repeats everything drawn on one side on the other."),
    .inputs = symmetryInputs(
        {.role = "across",
         .label = QT_TRANSLATE_NOOP("Operation", "Mirror"),
         .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section to mirror across."),
         .least = 0,
         .countsIf = "plane",
         .countsFor = {"section"}}),
    .parameters = {{.key = "plane",
                    .label = QT_TRANSLATE_NOOP("Operation", "Plane"),
                    .unit = Unit::Choice,
                    .choices = {{"x", "X"},
                                {"y", "Y"},
                                {"z", "Z"},
                                {"section", QT_TRANSLATE_NOOP("Operation", "A section's plane")}},
                    .heading = QT_TRANSLATE_NOOP("Operation", "Symmetry")},
                   whatParameter(),
                   {.key = "join",
                    .label = QT_TRANSLATE_NOOP("Operation", "Join at the plane"),
                    .unit = Unit::Switch,
                    .standard = 1.0}},
    .make = makeMirror,
    .isOfAll = isOfAll,
    .narrow = narrow};

const OperationKind kRotational{
    .key = "rotational",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Rotational"),
    .summary = QT_TRANSLATE_NOOP("Operation", "Repeats everything drawn once all round an axis."),
    .inputs = symmetryInputs(
        {.role = "around",
         .label = QT_TRANSLATE_NOOP("Operation", "Axis"),
         .prompt = QT_TRANSLATE_NOOP("Operation", "Click the two sections whose slit is the axis."),
         .least = 0,
         .most = 2,
         .countsIf = "axis",
         .countsFor = {"slit"}}),
    .parameters = {{.key = "axis",
                    .label = QT_TRANSLATE_NOOP("Operation", "Axis"),
                    .unit = Unit::Choice,
                    .choices = {{"vertical", QT_TRANSLATE_NOOP("Operation", "Vertical")},
                                {"slit", QT_TRANSLATE_NOOP("Operation", "Slit")}},
                    .heading = QT_TRANSLATE_NOOP("Operation", "Symmetry")},
                   {.key = "times",
                    .label = QT_TRANSLATE_NOOP("Operation", "Count"),
                    .unit = Unit::Count,
                    .standard = 6,
                    .least = 2,
                    .most = 60,
                    .sliderLeast = 2,
                    .sliderMost = 24},
                   whatParameter()},
    .make = makeRotational,
    .isOfAll = isOfAll,
    .narrow = narrow};

} // namespace fff
