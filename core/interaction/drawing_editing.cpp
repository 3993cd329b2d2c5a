#include "core/interaction/drawing_editing.h"

#include "core/base/tolerances.h"
#include "core/geometry/mapped_contour.h"
#include "core/geometry/outlines.h"
#include "core/interaction/drawing_words.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/template_guides.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/marks.h"
#include "core/model/mended_shape.h"
#include "core/model/naming.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace fff {

namespace {

/// Of what is set down on the ground, mm.
constexpr double kFineChord = 1e-3;

Box2 boundsOf(const std::vector<CurvePath> &lines)
{
    Box2 box;
    for (const CurvePath &line : lines)
        for (const Vec2 &p : line.flatten(kFineChord))
            box.extend(p);
    return box;
}

/// From the drawing to a plane.
struct Placing
{
    Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
    Vec2 from = Vec2::Zero(), to = Vec2::Zero();

    Result<Contour> operator()(const Contour &contour) const
    {
        std::vector<Vec2> points = contour.points();
        for (Vec2 &p : points)
            p = to + turn * (p - from);
        return Contour::fromPoints(std::move(points));
    }
    Result<CurvePath> operator()(const CurvePath &path) const
    {
        std::vector<Vec2> points = path.points();
        for (Vec2 &p : points)
            p = to + turn * (p - from);
        if (path.isClosed())
            points.back() = points.front();
        return CurvePath::fromPoints(std::move(points));
    }
};

bool isAslant(const Section &section, const Similarity &place)
{
    const Vec3 normal = place.turn.col(0).cross(place.turn.col(1));
    return normal.cross(section.frame.normal()).norm() > kPracticallyParallel;
}

/// Where it lies; else upright, its middle at that of the section.
Placing placedOn(const Section &section, const Drawing &drawing)
{
    if (drawing.place) {
        Placing placing;
        for (int i = 0; i < 2; ++i)
            placing.turn.col(i) =
                section.frame.directionToLocal(drawing.place->scale * drawing.place->turn.col(i));
        placing.to = section.frame.toLocal(drawing.place->shift);
        return placing;
    }
    return {Eigen::Rotation2Dd(uprightTurn(section.frame)).toRotationMatrix(),
            boundsOf(drawing.lines).center(), section.shape->bounds().center()};
}

Hint leftOut(const Drawing &drawing, int outlines)
{
    return Message{hints::kDrawingLeft, {Named{drawing.name}}, outlines};
}

tl::unexpected<Hint> tooMany(const Drawing &drawing, std::size_t outlines)
{
    Hint hint = Hint::refusal(hints::kTooManyOutlines, {Named{drawing.name}});
    hint.words.count = static_cast<int>(outlines);
    return tl::unexpected(std::move(hint));
}

/// At least one.
tl::expected<std::vector<Outline>, Hint> outlinesIn(const Drawing &drawing)
{
    Result<std::vector<Outline>> outlines = outlinesOf(joined(drawing.lines, kDrawnGap));
    if (!outlines)
        return refused(hints::kEditFailed);
    if (outlines->empty())
        return refused(hints::kDrawingOpen, {Named{drawing.name}});
    return *std::move(outlines);
}

/// The drawn section that it is about, and what comes to it.
template <class Change>
SectionEdit onSection(const Model &model, const SectionRef &ref, const Drawing &drawing,
                      Change change)
{
    const auto drawn = drawnSection(model, ref);
    if (!drawn)
        return tl::unexpected(drawn.error());
    const Section &section = **drawn;
    if (drawing.place && isAslant(section, *drawing.place))
        return refused(hints::kDrawingAslant, {Named{section.name}, Named{drawing.name}});
    return change(section, placedOn(section, drawing));
}

SectionEdit withShape(const Model &model, const Section &section, const Contour &contour,
                      const std::vector<Contour> &holes, const Drawing &drawing)
{
    std::vector<PlacedContour> placed;
    for (const Contour &hole : holes)
        placed.push_back({hole, {}});
    std::vector<Warning> warnings;
    const Result<ShapePointer> shape =
        makeMendedShape({contour, {}}, placed, section.name, warnings);
    if (!shape)
        return refused(hints::kWouldBeEmpty, {Named{section.name}});
    Result<Document> next = setShape(model.document, section.id, *shape);
    if (!next)
        return refused(hints::kEditFailed);
    EditedSections edit{*std::move(next), {drawing.step, {Named{drawing.name}}}};
    const auto left = std::count_if(warnings.begin(), warnings.end(), [](const Warning &w) {
        return w.code == WarningCode::HoleOutside || w.code == WarningCode::DegenerateHole;
    });
    if (left > 0)
        edit.note = leftOut(drawing, static_cast<int>(left));
    return edit;
}

/// The selected sections, which are of it.
void nameAfter(const Drawing &drawing, EditedSections &edit)
{
    const std::vector<std::string> names =
        namesAfter(edit.document, drawing.name, edit.select->size());
    for (std::size_t i = 0; i < names.size(); ++i)
        if (auto named = renameSection(edit.document, (*edit.select)[i].drawn, names[i]))
            edit.document = *std::move(named);
}

} // namespace

SectionEdit drawingSections(const Model &model, const Drawing &drawing, const Naming &naming)
{
    const auto outlines = outlinesIn(drawing);
    if (!outlines)
        return tl::unexpected(outlines.error());
    const Box2 box = boundsOf(drawing.lines);
    const Box3 there = model.bounds();
    Frame frame;
    frame.origin = {(there.isEmpty() ? -0.5 * box.size().x() : there.max.x() + kBeside) -
                        box.min.x(),
                    -box.min.y(), 0.0};
    SectionNames names(model.document, naming);
    std::vector<NewSection> sections;
    int left = 0;
    for (const Outline &outline : *outlines) {
        const Result<ShapePointer> shape = Shape::make(outline.outer, outline.holes);
        if (!shape) {
            ++left;
            continue;
        }
        NewSection section;
        section.name = names.next();
        section.shape = *shape;
        section.frame = frame;
        sections.push_back(std::move(section));
    }
    Result<Document> next = addSections(model.document, std::move(sections));
    if (!next)
        return refused(hints::kEditFailed);
    EditedSections edit{*std::move(next), {drawing.step, {Named{drawing.name}}}};
    edit.select.emplace();
    for (std::size_t i = model.document.sections.size(); i < edit.document.sections.size(); ++i)
        edit.select->push_back(edit.document.sections[i]->id);
    if (left > 0)
        edit.note = leftOut(drawing, left);
    return edit;
}

SectionEdit placedSections(const Model &model, const Drawing &drawing, const DrawingRules &rules)
{
    if (drawing.outlines > kMostPlacedSections)
        return tooMany(drawing, drawing.outlines);
    const auto outlines = outlinesIn(drawing);
    if (!outlines)
        return tl::unexpected(outlines.error());
    if (outlines->size() > kMostPlacedSections)
        return tooMany(drawing, outlines->size());
    // The plane as it is looked at from the front, even if the lines are flipped in it.
    const Similarity &place = *drawing.place;
    Frame canvas{place.shift, place.turn.col(0), place.turn.col(1)};
    if (place.turn.determinant() < 0.0)
        canvas.x = -canvas.x;
    Placing placing;
    for (int i = 0; i < 2; ++i)
        placing.turn.col(i) = canvas.directionToLocal(place.scale * place.turn.col(i));
    const ContourTarget target = ContourTarget::newSection(canvas);
    EditedSections edit{model.document, {drawing.step, {Named{drawing.name}}}};
    edit.select.emplace();
    int left = 0;
    std::optional<Hint> why;
    for (const Outline &outline : *outlines) {
        const Result<Contour> outer = placing(outline.outer);
        TemplateGuides::Whole whole;
        for (const Contour &hole : outline.holes)
            if (Result<Contour> placed = placing(hole))
                whole.holes.push_back(*std::move(placed));
        if (!outer)
            return refused(hints::kEditFailed);
        whole.contour = outer->signedArea() < 0.0 ? outer->reversed() : *outer;
        auto drawn = drawWhole(edit.document, target, whole, rules);
        if (!drawn) {
            why = drawn.error();
            ++left;
            continue;
        }
        edit.document = std::move(drawn->document);
        edit.select->push_back(drawn->section);
        if (drawn->note)
            edit.note = std::move(drawn->note);
    }
    if (edit.select->empty())
        return tl::unexpected(*why);
    if (left > 0)
        edit.note = leftOut(drawing, left);
    nameAfter(drawing, edit);
    return edit;
}

SectionEdit drawingContour(const Model &model, const SectionRef &ref, const Drawing &drawing)
{
    return onSection(model, ref, drawing,
                     [&](const Section &section, Placing placing) -> SectionEdit {
                         const auto outlines = outlinesIn(drawing);
                         if (!outlines)
                             return tl::unexpected(outlines.error());
                         const Outline &outline = outlines->front();
                         if (!drawing.place)
                             placing.from = boundsOf({CurvePath::around(outline.outer)}).center();
                         const Result<Contour> contour = placing(outline.outer);
                         std::vector<Contour> holes;
                         for (const Contour &hole : outline.holes)
                             if (Result<Contour> placed = placing(hole))
                                 holes.push_back(*std::move(placed));
                         if (!contour)
                             return refused(hints::kEditFailed);
                         SectionEdit edit = withShape(model, section, *contour, holes, drawing);
                         const int left = static_cast<int>(outlines->size()) - 1;
                         if (edit && left > 0)
                             edit->note = leftOut(drawing, left);
                         return edit;
                     });
}

SectionEdit drawingHoles(const Model &model, const SectionRef &ref, const Drawing &drawing)
{
    return onSection(model, ref, drawing,
                     [&](const Section &section, const Placing &placing) -> SectionEdit {
                         if (drawing.outlines > kMostPlacedHoles)
                             return tooMany(drawing, drawing.outlines);
                         const auto outlines = outlinesIn(drawing);
                         if (!outlines)
                             return tl::unexpected(outlines.error());
                         if (outlines->size() > kMostPlacedHoles)
                             return tooMany(drawing, outlines->size());
                         std::vector<Contour> holes = section.shape->holes();
                         // What lies in a hole is gone with it.
                         for (const Outline &outline : *outlines) {
                             if (outline.isInHole)
                                 continue;
                             Result<Contour> placed = placing(outline.outer);
                             if (!placed)
                                 return refused(hints::kEditFailed);
                             holes.push_back(*std::move(placed));
                         }
                         return withShape(model, section, section.shape->contour(), holes, drawing);
                     });
}

SectionEdit drawingMark(const Model &model, const SectionRef &ref, const Drawing &drawing,
                        Mark::Kind kind)
{
    return onSection(
        model, ref, drawing, [&](const Section &section, const Placing &placing) -> SectionEdit {
            Mark mark;
            mark.kind = kind;
            for (const CurvePath &line : drawing.lines)
                if (Result<CurvePath> placed = placing(line))
                    mark.paths.push_back(*std::move(placed));
            Result<Document> next =
                addMark(model.document, section.id, std::make_shared<const Mark>(std::move(mark)));
            if (!next)
                return refused(hints::kEditFailed);
            return EditedSections{*std::move(next), {drawing.step, {Named{drawing.name}}}};
        });
}

} // namespace fff
