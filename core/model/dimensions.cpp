#include "core/model/dimensions.h"

#include <algorithm>

namespace fff {

namespace {

/// An anchor this near to a control point is at it, mm.
constexpr double kAtPoint = 1e-6;

/// Where the point of `before` at this place is in `after`.
std::optional<Vec2> follow(const Contour &before, const Contour &after, const Vec2 &at)
{
    const std::vector<Vec2> &old = before.points(), &now = after.points();
    if (old.size() != now.size())
        return std::nullopt;
    for (std::size_t i = 0; i < old.size(); i += 3)
        if ((old[i] - at).norm() <= kAtPoint)
            return now[i];
    return std::nullopt;
}

std::optional<Vec2> follow(const Shape &before, const Shape &after, const Vec2 &at)
{
    std::optional<Vec2> now = follow(before.contour(), after.contour(), at);
    const bool hasSameHoles = before.holes().size() == after.holes().size();
    for (std::size_t i = 0; !now && hasSameHoles && i < before.holes().size(); ++i)
        now = follow(before.holes()[i], after.holes()[i], at);
    return now;
}

} // namespace

Result<Document> addDimension(Document document, const Anchor &from, const Anchor &to)
{
    for (const Anchor *anchor : {&from, &to})
        if (const SectionId id = anchor->section.drawn; id.isValid() && !document.find(id))
            return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                           {std::to_string(id.value)});
    if (from == to)
        return failure(ErrorCode::BadValue, "to", {"0 mm", "another place"});
    const DimensionId id{document.nextId++};
    document.dimensions.push_back({id, from, to});
    return document;
}

Result<Document> removeDimension(Document document, DimensionId id)
{
    if (std::erase_if(document.dimensions, [id](const Dimension &d) { return d.id == id; }) == 0)
        return failure(ErrorCode::UnknownReference, std::to_string(id.value),
                       {std::to_string(id.value)});
    return document;
}

std::optional<Vec3> placeOf(const Model &model, const Anchor &anchor)
{
    if (anchor.section == SectionRef())
        return anchor.at;
    const Section *section = model.find(anchor.section);
    if (!section)
        return std::nullopt;
    return section->frame.toWorld(anchor.at.head<2>()) + anchor.at.z() * section->frame.normal();
}

Anchor anchorOn(const Section *section, const Vec3 &place)
{
    if (!section)
        return {{}, place};
    const Vec2 at = section->frame.toLocal(place);
    return {section->ref(), {at.x(), at.y(), section->frame.height(place)}};
}

void followPoints(Document &document, SectionId id, const Shape &before, const Shape &after)
{
    for (Dimension &dimension : document.dimensions)
        for (Anchor *anchor : {&dimension.from, &dimension.to})
            if (anchor->section == SectionRef(id))
                if (const auto now = follow(before, after, anchor->at.head<2>()))
                    anchor->at.head<2>() = *now;
}

} // namespace fff
