#include "core/operations/radial.h"

#include "core/base/text.h"
#include "core/geometry/radial_contour.h"
#include "core/geometry/symmetrised.h"
#include "core/model/mended_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

using Unit = ParameterSpec::Unit;

/// The largest piece of what the sectors together are.
Result<ShapePointer> sectorAllRound(const Shape &shape, const Vec2 &centre, int count, double phase)
{
    const auto pieces = repeatedSector(shape.contour(), shape.holes(), centre, count, phase);
    if (!pieces)
        return tl::unexpected(pieces.error());
    if (pieces->empty())
        return failure(ErrorCode::EmptyContour);
    return Shape::make(pieces->front().outer, pieces->front().holes);
}

ToothShape toothOf(const std::string &key)
{
    return key == "round"    ? ToothShape::Round
           : key == "square" ? ToothShape::Square
                             : ToothShape::Trapezium;
}

/// The contours that were asked for: one, or the holes of a ring.
std::vector<Contour> askedContours(const OperationContext &context, const Vec2 &centre)
{
    const std::string kind = context.choice("kind");
    const double outer = context.number("outerRadius"), inner = context.number("innerRadius");
    const double phase = context.number("phase");
    const int count = context.count("sectors");
    if (kind == "holes")
        return ringOfCircles(centre, outer, inner, count, phase);
    if (kind == "circle" || count < 2)
        return {circleContour(centre, outer)};
    if (kind == "star")
        return {starContour(centre, outer, inner, count, phase)};
    return {gearContour(centre, outer, inner, count, phase, toothOf(context.choice("tooth")))};
}

/// In place of the contour, or as holes.
Result<ShapePointer> withContours(const Shape &shape, std::vector<Contour> contours, bool asHoles)
{
    std::vector<PlacedContour> holes;
    for (const Contour &hole : shape.holes())
        holes.push_back({hole, {}});
    PlacedContour outer{shape.contour(), {}};
    if (asHoles)
        for (Contour &contour : contours)
            holes.push_back({std::move(contour), {}});
    else
        outer.contour = std::move(contours.front());
    std::vector<Warning> mended; // what no longer fits is left out
    return makeMendedShape(outer, holes, {}, mended);
}

void make(OperationContext &context)
{
    const SectionPointer section = context.input("section");
    if (!section)
        return;
    const Shape &shape = *section->shape;
    const Vec2 centre = shape.centroid();
    const std::string kind = context.choice("kind");
    const bool asHoles = kind == "holes" || context.choice("applyTo") == "holes";
    Result<ShapePointer> next;
    if (kind == "sector") {
        next = sectorAllRound(shape, centre, context.count("sectors"), context.number("phase"));
        if (next && context.choice("applyTo") == "holes")
            next = withContours(shape, {(*next)->contour()}, true);
    } else {
        next = withContours(shape, askedContours(context, centre), asHoles);
    }
    if (!context.made(next)) {
        context.notice({OperationNotice::Kind::NothingFits});
        return;
    }
    Section changed = *section;
    changed.shape = *std::move(next);
    context.change(section->ref(), std::make_shared<const Section>(std::move(changed)));
}

ParameterSpec radius(const char *key, const char *label, double standard,
                     std::vector<const char *> kinds)
{
    return {.key = key,
            .label = label,
            .unit = Unit::Length,
            .standard = standard,
            .least = 1.0,
            .most = 2000.0,
            .step = 0.5,
            .sliderLeast = 1.0,
            .sliderMost = 150.0,
            .countsIf = "kind",
            .countsFor = std::move(kinds)};
}

std::vector<ParameterSpec> parameters()
{
    return {{.key = "kind",
             .label = QT_TRANSLATE_NOOP("Operation", "Kind"),
             .unit = Unit::Choice,
             .standard = 2,
             .choices = {{"circle", QT_TRANSLATE_NOOP("Operation", "Circle")},
                         {"star", QT_TRANSLATE_NOOP("Operation", "Star")},
                         {"gear", QT_TRANSLATE_NOOP("Operation", "Gear")},
                         {"holes", QT_TRANSLATE_NOOP("Operation", "Holes")},
                         {"sector", QT_TRANSLATE_NOOP("Operation", "Drawn sector")}},
             .heading = QT_TRANSLATE_NOOP("Operation", "Shape")},
            {.key = "sectors",
             .label = QT_TRANSLATE_NOOP("Operation", "Sectors"),
             .unit = Unit::Count,
             .standard = 10,
             .least = 1,
             .most = 200,
             .sliderLeast = 1,
             .sliderMost = 40,
             .countsIf = "kind",
             .countsFor = {"star", "gear", "holes", "sector"}},
            radius("outerRadius", QT_TRANSLATE_NOOP("Operation", "Outer radius"), 40.0,
                   {"circle", "star", "gear", "holes"}),
            radius("innerRadius", QT_TRANSLATE_NOOP("Operation", "Inner radius"), 28.0,
                   {"star", "gear", "holes"}),
            {.key = "tooth",
             .label = QT_TRANSLATE_NOOP("Operation", "Tooth"),
             .unit = Unit::Choice,
             .choices = {{"round", QT_TRANSLATE_NOOP("Operation", "Round")},
                         {"square", QT_TRANSLATE_NOOP("Operation", "Square")},
                         {"trapezium", QT_TRANSLATE_NOOP("Operation", "Trapezium")}},
             .countsIf = "kind",
             .countsFor = {"gear"}},
            {.key = "phase",
             .label = QT_TRANSLATE_NOOP("Operation", "Phase"),
             .unit = Unit::Angle,
             .standard = 0.0,
             .least = 0.0,
             .most = 2.0 * std::numbers::pi,
             .step = std::numbers::pi / 180.0,
             .sliderLeast = 0.0,
             .sliderMost = 2.0 * std::numbers::pi,
             .countsIf = "kind",
             .countsFor = {"star", "gear", "holes", "sector"}},
            {.key = "applyTo",
             .label = QT_TRANSLATE_NOOP("Operation", "Apply to"),
             .unit = Unit::Choice,
             .choices = {{"contour", QT_TRANSLATE_NOOP("Operation", "Contour")},
                         {"holes", QT_TRANSLATE_NOOP("Operation", "Holes")}},
             .countsIf = "kind",
             .countsFor = {"circle", "star", "gear", "sector"}}};
}

/// "Hind legs gear", which is what one is if nothing else is said.
const char *radialName(const Operation &operation)
{
    const auto kind = operation.parameters.find("kind");
    const auto is = [&](const char *key) {
        return kind != operation.parameters.end() &&
               kind->second == ParameterValue(std::string(key));
    };
    if (is("circle"))
        return QT_TRANSLATE_NOOP("Operation", "%1 circle");
    if (is("star"))
        return QT_TRANSLATE_NOOP("Operation", "%1 star");
    if (is("holes"))
        return QT_TRANSLATE_NOOP("Operation", "%1 holes");
    if (is("sector"))
        return QT_TRANSLATE_NOOP("Operation", "%1 rosette");
    return QT_TRANSLATE_NOOP("Operation", "%1 gear");
}

} // namespace

const OperationKind kRadial{
    .key = "radial",
    .version = 1,
    .name = QT_TRANSLATE_NOOP("Operation", "Radial"),
    .summary = QT_TRANSLATE_NOOP(
        "Operation",
        "Turns a section into a circle, a star or a gear, or cuts such holes into it."),
    .calls = radialName,
    .inputs = {{.role = "section",
                .label = QT_TRANSLATE_NOOP("Operation", "Section"),
                .prompt = QT_TRANSLATE_NOOP("Operation", "Click the section to shape.")}},
    .parameters = parameters(),
    .make = make};

} // namespace fff
