#include "core/model/symmetric_section.h"

#include "core/geometry/mirrored_boundaries.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace fff {

namespace {

/// The control points as they stand on the plane, in order.
std::vector<std::pair<double, double>> placesOf(const Shape &shape)
{
    std::vector<std::pair<double, double>> places;
    const auto add = [&](const Contour &contour) {
        for (const Vec2 &p : contour.points())
            places.emplace_back(p.x(), p.y());
    };
    add(shape.contour());
    for (const Contour &hole : shape.holes())
        add(hole);
    std::sort(places.begin(), places.end());
    return places;
}

bool isLeftChanged(const Shape &before, const Shape &after, const MirrorAxis &axis)
{
    const auto was = placesOf(before), is = placesOf(after);
    std::vector<std::pair<double, double>> changed;
    std::set_symmetric_difference(was.begin(), was.end(), is.begin(), is.end(),
                                  std::back_inserter(changed));
    int left = 0;
    for (const auto &[x, y] : changed) {
        const double height = axis.height({x, y});
        if (std::abs(height) > kSameImage)
            left += height > 0.0 ? 1 : -1;
    }
    return left >= 0;
}

} // namespace

const MirrorAxis *symmetryOf(const Section &section)
{
    return section.symmetry && isSymmetric(*section.shape, *section.symmetry) ? &*section.symmetry
                                                                              : nullptr;
}

bool isSymmetric(const Shape &shape, const MirrorAxis &axis)
{
    return isMirrored(shape.contour(), shape.holes(), axis);
}

Result<ShapePointer> symmetrised(const Shape &before, const ShapePointer &after,
                                 const MirrorAxis &axis)
{
    Result<ClippedPiece> whole =
        withImage(after->contour(), after->holes(), axis, isLeftChanged(before, *after, axis));
    if (!whole)
        return tl::unexpected(whole.error());
    Result<ShapePointer> shape = Shape::make(std::move(whole->outer), std::move(whole->holes));
    if (shape && !(*shape)->isPlain() && before.isPlain())
        return failure(ErrorCode::SelfCrossing);
    return shape;
}

Result<Document> setSymmetry(Document document, SectionId id, std::optional<MirrorAxis> axis)
{
    for (SectionPointer &pointer : document.sections) {
        if (pointer->id != id)
            continue;
        if (axis && !isSymmetric(*pointer->shape, *axis))
            return failure(ErrorCode::BadValue, "symmetry");
        if (pointer->symmetry == axis)
            return document;
        Section next = *pointer;
        next.symmetry = axis;
        pointer = std::make_shared<const Section>(std::move(next));
        return document;
    }
    return failure(ErrorCode::UnknownReference, std::to_string(id.value));
}

} // namespace fff
