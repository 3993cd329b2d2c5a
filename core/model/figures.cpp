#include "core/model/figures.h"

#include "core/model/edits.h"
#include "core/model/point_edits.h"

#include <algorithm>

namespace fff {

namespace {

tl::unexpected<Error> unknown(SectionId id)
{
    return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                   {std::to_string(id.value)});
}

} // namespace

int boundaryOf(const Shape &shape, const Figure &figure)
{
    for (int i = 0; i < boundaryCount(shape); ++i)
        if (isOf(boundary(shape, i), figure))
            return i;
    return -1;
}

const Figure *figureOf(const Section &section, int index)
{
    if (index < 0 || index >= boundaryCount(*section.shape))
        return nullptr;
    const Contour &of = boundary(*section.shape, index);
    const auto found = std::find_if(section.figures.begin(), section.figures.end(),
                                    [&of](const Figure &figure) { return isOf(of, figure); });
    return found == section.figures.end() ? nullptr : &*found;
}

Result<Document> addFigure(Document document, SectionId id, Figure figure)
{
    const int index = document.indexOf(id);
    if (index < 0)
        return unknown(id);
    SectionPointer &place = document.sections[static_cast<std::size_t>(index)];
    if (boundaryOf(*place->shape, figure) < 0)
        return document;
    Section next = *place;
    next.figures.push_back(std::move(figure));
    place = std::make_shared<const Section>(std::move(next));
    return document;
}

Result<Document> setFigure(Document document, SectionId id, int index, const Figure &figure)
{
    const Section *section = document.find(id);
    if (!section)
        return unknown(id);
    const Figure *before = figureOf(*section, index);
    if (!before)
        return failure(ErrorCode::BadValue, "boundary", {std::to_string(index), "a figure"});
    if (*before == figure)
        return document;
    Result<Contour> contour = contourOf(figure);
    if (!contour)
        return tl::unexpected(contour.error());
    Result<ShapePointer> shape = withBoundary(*section->shape, index, *std::move(contour));
    if (!shape)
        return tl::unexpected(shape.error());
    Result<Document> next = setShape(std::move(document), id, *std::move(shape));
    return next ? addFigure(*std::move(next), id, figure) : next;
}

} // namespace fff
