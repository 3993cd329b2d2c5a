#include "core/interaction/drawing_editing.h"

#include "core/geometry/mapped_contour.h"
#include "core/geometry/outlines.h"
#include "core/interaction/drawing_words.h"
#include "core/interaction/section_editing.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"
#include "core/model/marks.h"
#include "core/model/mended_shape.h"
#include "core/model/naming.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace fff {

namespace {

//: %1 is the name of a file
constexpr Text kImportDrawing = FFF_TEXT("Step", "Import %1");
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

/// From the drawing to a plane: upright there, its middle at `to`.
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

Placing placedOn(const Section &section, const Drawing &drawing)
{
    return {Eigen::Rotation2Dd(uprightTurn(section.frame)).toRotationMatrix(),
            boundsOf(drawing.lines).center(), section.shape->bounds().center()};
}

Hint leftOut(const Drawing &drawing, int outlines)
{
    return Message{hints::kDrawingLeft, {Named{drawing.name}}, outlines};
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
    EditedSections edit{*std::move(next), {kImportDrawing, {Named{drawing.name}}}};
    const auto left = std::count_if(warnings.begin(), warnings.end(), [](const Warning &w) {
        return w.code == WarningCode::HoleOutside || w.code == WarningCode::DegenerateHole;
    });
    if (left > 0)
        edit.note = leftOut(drawing, static_cast<int>(left));
    return edit;
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
    EditedSections edit{*std::move(next), {kImportDrawing, {Named{drawing.name}}}};
    edit.select.emplace();
    for (std::size_t i = model.document.sections.size(); i < edit.document.sections.size(); ++i)
        edit.select->push_back(edit.document.sections[i]->id);
    if (left > 0)
        edit.note = leftOut(drawing, left);
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
                         const auto outlines = outlinesIn(drawing);
                         if (!outlines)
                             return tl::unexpected(outlines.error());
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
            return EditedSections{*std::move(next), {kImportDrawing, {Named{drawing.name}}}};
        });
}

} // namespace fff
