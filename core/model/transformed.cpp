#include "core/model/transformed.h"

#include "core/geometry/mapped_contour.h"

#include <cmath>

namespace fff {

namespace {

Result<Contour> mapped(const Contour &contour, const PlaneMap &map)
{
    return map.band ? fff::mapped(contour, *map.band) : fff::mapped(contour, map.matrix, map.about);
}

/// What a band stretches is no figure of its kind any more.
std::optional<Figure> mapped(const Figure &figure, const PlaneMap &map)
{
    if (!map.band)
        return fff::mapped(figure, map.matrix, map.about);
    const Result<Contour> contour = contourOf(figure);
    const std::optional<Vec2> shift = contour ? map.band->shiftOf(contour->bounds()) : std::nullopt;
    if (!shift)
        return std::nullopt;
    Figure next = figure;
    next.centre += *shift;
    return next;
}

/// Words are moved as they are; other lines are stretched with what is under them.
Result<MarkPointer> mapped(const MarkPointer &mark, const PlaneMap &map)
{
    if (!map.band)
        return fff::mapped(mark, map.matrix, map.about);
    Mark next = *mark;
    std::optional<Vec2> shift;
    if (next.lettering) {
        shift = map(next.lettering->at) - next.lettering->at;
        next.lettering->at += *shift;
    }
    for (CurvePath &path : next.paths) {
        std::vector<Vec2> points = path.points();
        for (Vec2 &p : points)
            p = shift ? Vec2(p + *shift) : map(p);
        Result<CurvePath> moved = CurvePath::fromPoints(std::move(points));
        if (!moved)
            return tl::unexpected(moved.error());
        path = *std::move(moved);
    }
    return std::make_shared<const Mark>(std::move(next));
}

} // namespace

Result<ShapePointer> mappedShape(const ShapePointer &shape, const PlaneMap &map)
{
    if (map.isIdentity())
        return shape;
    Result<Contour> contour = mapped(shape->contour(), map);
    if (!contour)
        return tl::unexpected(contour.error());
    std::vector<Contour> holes;
    for (const Contour &hole : shape->holes()) {
        Result<Contour> next = mapped(hole, map);
        if (!next)
            return tl::unexpected(next.error());
        holes.push_back(*std::move(next));
    }
    return Shape::make(*std::move(contour), std::move(holes));
}

Result<Section> stretched(Section section, const PlaneMap &map, const ShapeMap &shapeOf)
{
    if (map.isIdentity())
        return section;
    Result<ShapePointer> shape = shapeOf(section.shape, map);
    if (!shape)
        return failure(shape.error().code, section.name);
    section.shape = *std::move(shape);
    std::vector<Figure> figures;
    for (const Figure &figure : section.figures)
        if (std::optional<Figure> next = mapped(figure, map))
            figures.push_back(*std::move(next));
    section.figures = std::move(figures);
    std::vector<MarkPointer> marks;
    for (const MarkPointer &mark : section.marks)
        if (Result<MarkPointer> next = mapped(mark, map))
            marks.push_back(*std::move(next));
    section.marks = std::move(marks);
    if (section.symmetry)
        section.symmetry = MirrorAxis{map(section.symmetry->point),
                                      (map.matrix * section.symmetry->direction).normalized()};
    if (section.copyOf) {
        section.copyOf->matrix = map.matrix * section.copyOf->matrix;
        section.copyOf->shift = map(section.copyOf->shift);
    }
    return section;
}

Result<Section> transformed(Section section, const Similarity &placement, const ShapeMap &shapeOf)
{
    section.frame = placed(section.frame, placement);
    if (section.copyOf && placement.turn.determinant() < 0.0)
        section.copyOf->isMirrored = !section.copyOf->isMirrored;
    return stretched(std::move(section), PlaneMap::scaled(placement.scale), shapeOf);
}

Section asCopy(Section section)
{
    std::shared_ptr<const CopyOf> before;
    if (section.copyOf)
        before = std::make_shared<const CopyOf>(*std::move(section.copyOf));
    section.copyOf = CopyOf{section.ref(), std::move(before)};
    return section;
}

Parent transformed(Parent parent, const Similarity &placement)
{
    parent.slitFrom *= placement.scale;
    parent.slitTo *= placement.scale;
    return parent;
}

namespace {

/// As large as the map makes areas; what lies aslant in a plane that is stretched stays as it lies.
void mapTemplates(Document &document, const std::function<bool(const SectionRef &)> &isMapped,
                  const PlaneMap &map)
{
    const double scale = std::sqrt(std::abs(map.matrix.determinant()));
    for (TemplatePointer &pointer : document.templates) {
        if (pointer->on == SectionRef() || !isMapped(pointer->on) || map.isIdentity())
            continue;
        Template next = *pointer;
        next.frame.origin.head<2>() = map(next.frame.origin.head<2>());
        next.scale *= scale;
        pointer = std::make_shared<const Template>(std::move(next));
    }
}

} // namespace

void mapPlaces(Document &document, const std::function<bool(const SectionRef &)> &isMapped,
               const PlaneMap &map)
{
    mapTemplates(document, isMapped, map);
    for (Load &load : document.loads)
        if (isMapped(load.section))
            load.position = map(load.position);
    for (Dimension &dimension : document.dimensions)
        for (Anchor *anchor : {&dimension.from, &dimension.to})
            if (anchor->section != SectionRef() && isMapped(anchor->section))
                anchor->at.head<2>() = map(anchor->at.head<2>());
    for (JointOverridePointer &pointer : document.jointOverrides) {
        if (pointer->shares.empty() || !isMapped(pointer->a))
            continue;
        JointOverride next = *pointer;
        for (JointOverride::Share &share : next.shares)
            share.at = map(share.at);
        pointer = std::make_shared<const JointOverride>(std::move(next));
    }
}

} // namespace fff
