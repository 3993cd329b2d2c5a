#include "core/fabrication/part_list.h"

#include <algorithm>

namespace fff {

namespace {

bool haveSamePoints(const Contour &a, const Contour &b)
{
    return std::equal(
        a.points().begin(), a.points().end(), b.points().begin(), b.points().end(),
        [](const Vec2 &p, const Vec2 &q) { return (p - q).cwiseAbs().maxCoeff() <= kClipGrid; });
}

bool areTheSame(const CurvedRegion &a, const CurvedRegion &b)
{
    return haveSamePoints(a.outer, b.outer) &&
           std::equal(a.holes.begin(), a.holes.end(), b.holes.begin(), b.holes.end(),
                      haveSamePoints);
}

/// Round the polygon and back to its first point.
double around(const Polygon &polygon)
{
    double length = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        length += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    return length;
}

} // namespace

std::vector<ListedPart> partList(const std::vector<Part> &parts, const Model &model)
{
    std::vector<ListedPart> list;
    std::vector<const Part *> firsts; // of each that is listed
    for (const Part &part : parts) {
        const auto same = std::find_if(firsts.begin(), firsts.end(), [&](const Part *first) {
            return first->stock == part.stock && areTheSame(first->outline, part.outline);
        });
        if (same != firsts.end()) {
            list[static_cast<std::size_t>(same - firsts.begin())].numbers.push_back(part.number);
            continue;
        }
        firsts.push_back(&part);
        list.push_back({{part.number},
                        model.section(static_cast<std::size_t>(part.section))->name,
                        part.stock,
                        bounds(part.outline.region.outer).size(),
                        area(part.outline.region)});
    }
    return list;
}

double cutLength(const CuttingDrawing &drawing)
{
    double length = 0.0;
    for (const CuttingSheet &sheet : drawing.sheets)
        for (const CuttingPart &part : sheet.parts) {
            const Region &region = part.outline().region;
            length += around(region.outer);
            for (const Polygon &hole : region.holes)
                length += around(hole);
        }
    return length;
}

} // namespace fff
