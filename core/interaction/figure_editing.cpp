#include "core/interaction/figure_editing.h"

#include "core/base/tolerances.h"
#include "core/interaction/contour_words.h"
#include "core/interaction/pick.h"
#include "core/interaction/point_editing.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/snapping.h"
#include "core/model/edit_words.h"
#include "core/model/figures.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A section that rises by less (sine) counts as level.
constexpr double kLevel = 0.02;
/// Sine of the lean of a plane that something can stand in (30°), and of the angle at which the
/// view looks down on an upright plane too flatly to draw in it (60°).
constexpr double kStands = 0.5, kLooksDown = 0.866;
/// Of a hole that nobody gave a place: of the section's size, and how many places are tried along
/// each of its sides.
constexpr double kShare = 1.0 / 3.0;
constexpr int kPlaces = 9;
/// Sizes that nobody gave are multiples of this, mm.
constexpr double kRound = 0.5;
/// Of what is set down on the ground, mm.
constexpr double kFineChord = 1e-3;

SectionEdit edited(tl::expected<DrawnContour, Hint> drawn)
{
    if (!drawn)
        return tl::unexpected(drawn.error());
    EditedSections result{std::move(drawn->document), std::move(drawn->step)};
    result.note = std::move(drawn->note);
    return result;
}

/// The plane that the figure is to lie in, x to the right and y up as it is seen.
Frame planeOf(const Model &model, const FigurePlace &place)
{
    const Eigen::Quaterniond &view = place.camera.orientation;
    const auto &sections = model.document.sections;
    const Section *section = place.section;
    if (!section && !sections.empty())
        section = sections.back().get();
    if (section)
        return ownGrid(section->frame, view);
    const Vec3 backward = place.camera.backward();
    if (std::abs(backward.y()) > kLooksDown)
        return ownGrid({Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}, view);
    const Vec3 normal = Vec3(backward.x(), 0.0, backward.z()).normalized();
    return {Vec3::Zero(), Vec3::UnitY().cross(normal), Vec3::UnitY()};
}

/// How far to the right the box has to go so that it is beside what lies in that plane.
double wayToTheRight(const Model &model, const Frame &plane, const Box2 &box)
{
    std::vector<Box2> there;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const Section &section = *model.section(i);
        if (section.frame.normal().cross(plane.normal()).norm() > kPracticallyParallel ||
            std::abs(plane.height(section.frame.origin)) > model.stockOf(i).thickness)
            continue;
        Box2 own;
        for (const Vec2 &p : section.shape->region().outer)
            own.extend(plane.toLocal(section.frame.toWorld(p)));
        there.push_back(own);
    }
    std::sort(there.begin(), there.end(),
              [](const Box2 &a, const Box2 &b) { return a.max.x() < b.max.x(); });
    double way = 0.0;
    for (const Box2 &own : there)
        if (own.min.y() < box.max.y() + kBeside && own.max.y() > box.min.y() - kBeside &&
            own.min.x() < box.max.x() + way + kBeside && own.max.x() > box.min.x() + way - kBeside)
            way = own.max.x() + kBeside - box.min.x();
    return way;
}

} // namespace

SectionEdit addedFigure(const Model &model, Figure figure, const FigurePlace &place,
                        const DrawingRules &rules)
{
    figure.centre = Vec2::Zero();
    const Result<Contour> contour = contourOf(figure);
    if (!contour)
        return refused(hints::kEditFailed);
    Box2 box;
    for (const Vec2 &p : contour->flatten(kFineChord).points)
        box.extend(p);
    const Frame plane = planeOf(model, place);
    Vec2 middle = pointOnPlane(place.camera, place.viewport, plane, 0.5 * place.viewport)
                      .value_or(Vec2::Zero());
    if (plane.y.y() > kLevel) { // above the ground, which would cut off a hair of what touches it
        const double lowest = (kFineChord - plane.origin.y()) / plane.y.y() - box.min.y();
        const bool stands = std::abs(plane.normal().y()) < kStands;
        middle.y() = stands ? lowest : std::max(lowest, middle.y());
    }
    middle.x() += wayToTheRight(model, plane, {middle + box.min, middle + box.max});
    const Frame frame{plane.toWorld(middle), plane.x, plane.y};
    SectionEdit edit =
        edited(drawFigure(model.document, ContourTarget::newSection(frame), figure, rules));
    if (edit)
        edit->select = {{edit->document.sections.back()->id}};
    return edit;
}

SectionEdit figureHole(const Model &model, const SectionRef &ref, const Figure &figure)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    return edited(drawFigure(model.document, ContourTarget::hole(section), figure, {}));
}

SectionEdit figureHoleInside(const Model &model, const SectionRef &ref, Figure figure)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    const Box2 box = section.shape->bounds();
    const Vec2 most = Vec2::Constant(kShare * box.size().minCoeff());
    const Vec2 size = sizeOf(figure);
    const double factor = std::min(1.0, most.x() / size.maxCoeff());
    if (factor < 1.0) // to sizes that people say
        figure = sized(figure, (size * factor / kRound).array().floor().max(1.0) * kRound);
    figure.turn = uprightTurn(section.frame);
    // From the middle outwards.
    std::vector<Vec2> places{section.shape->centroid(), box.center()};
    for (int i = 1; i < kPlaces; ++i)
        for (int j = 1; j < kPlaces; ++j)
            places.push_back(box.min + box.size().cwiseProduct(Vec2(i, j)) / kPlaces);
    std::stable_sort(places.begin() + 2, places.end(), [&box](const Vec2 &a, const Vec2 &b) {
        return (a - box.center()).squaredNorm() < (b - box.center()).squaredNorm();
    });
    for (const Vec2 &place : places) {
        figure.centre = place;
        SectionEdit edit = figureHole(model, ref, figure);
        const Section *now = edit ? edit->document.find(section.id) : nullptr;
        if (now && now->shape->holes().size() == section.shape->holes().size() + 1 &&
            boundaryOf(*now->shape, figure) > 0)
            return edit;
    }
    return refused(hints::kHoleOutside, {Named{section.name}});
}

SectionEdit figureContour(const Model &model, const SectionRef &ref, const FigureKind &kind)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    Figure figure = sized(newFigure(kind), section.shape->bounds().size());
    figure.centre = section.shape->bounds().center();
    return edited(drawFigure(model.document, ContourTarget::redraw(section), figure,
                             {.cutsAtGround = false}));
}

SectionEdit changedFigure(const Model &model, const SectionRef &ref, int boundary,
                          const Figure &figure)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    Result<Document> next = setFigure(model.document, section.id, boundary, figure);
    if (!next)
        return tl::unexpected(whyNoShape(next.error(), section));
    //: %1 is the name of a section
    Step step{FFF_TEXT("Step", "Change shape of %1"), {Named{section.name}}};
    step.merges = "figure ";
    step.merges.append(std::to_string(section.id.value))
        .append("/")
        .append(std::to_string(boundary));
    return EditedSections{*std::move(next), std::move(step)};
}

} // namespace fff
