#include "core/operations/stretched_by_numbers.h"

#include "core/model/edits.h"
#include "core/model/figures.h"
#include "core/model/lettering.h"
#include "core/model/marks.h"
#include "core/model/moving.h"
#include "core/model/point_edits.h"

#include <cmath>

namespace fff {

namespace {

/// Holes that are figures keep their numbers where the section is stretched: round ones stay round.
/// Their centres go along; one that has no room so is stretched.
Document withFiguresKept(Document document, const Section &before, const PlaneMap &map)
{
    for (int i = 1; i < boundaryCount(*before.shape); ++i) {
        const Figure *known = figureOf(before, i);
        const Section *now = document.find(before.id);
        if (!known || !now || i >= boundaryCount(*now->shape))
            continue;
        Figure figure = *known;
        figure.centre = map(figure.centre);
        if (const Figure *same = figureOf(*now, i); same && *same == figure)
            continue;
        Result<Contour> contour = contourOf(figure);
        const Result<ShapePointer> shape =
            contour ? withBoundary(*now->shape, i, *std::move(contour))
                    : Result<ShapePointer>(tl::unexpected(contour.error()));
        Result<Document> next = shape ? setShape(document, before.id, *shape)
                                      : Result<Document>(tl::unexpected(shape.error()));
        if (next)
            next = addFigure(*std::move(next), before.id, figure);
        if (next)
            document = *std::move(next);
    }
    return document;
}

/// Words keep the height of their letters where the section is stretched, and stay words.
Document withLetteringKept(Document document, const Section &before, const PlaneMap &map)
{
    const Section *now = document.find(before.id);
    if (!now || now->marks.size() != before.marks.size())
        return document;
    for (std::size_t i = 0; i < before.marks.size(); ++i) {
        const Mark &mark = *before.marks[i];
        if (!mark.lettering)
            continue;
        Lettering words = *mark.lettering;
        words.at = map(words.at);
        Result<MarkPointer> written = letteredMark(words, mark.kind);
        Result<Document> next = written ? setMark(document, before.id, i, *std::move(written))
                                        : Result<Document>(tl::unexpected(written.error()));
        if (next)
            document = *std::move(next);
    }
    return document;
}

} // namespace

Result<Document> stretchedByNumbers(Document document, const Section &section, const PlaneMap &map)
{
    Result<Document> next = stretchedSection(std::move(document), section.id, map);
    if (!next)
        return next;
    return withLetteringKept(withFiguresKept(*std::move(next), section, map), section, map);
}

std::optional<Vec2> slitHolding(const Document &document, const Section &section, const Vec2 &along)
{
    const Section *holder = section.parent ? document.find(section.parent->section.drawn) : nullptr;
    if (!holder)
        return std::nullopt;
    const Vec3 way = section.frame.directionToWorld(along).normalized();
    const Vec3 slit =
        holder->frame.directionToWorld(section.parent->slitTo - section.parent->slitFrom);
    const bool isAlong = std::abs(slit.dot(way)) >= kUpright * slit.norm();
    if (isAlong && std::abs(way.y()) >= kUpright)
        return std::nullopt;
    return section.frame.toLocal(
        holder->frame.toWorld(0.5 * (section.parent->slitFrom + section.parent->slitTo)));
}

} // namespace fff
