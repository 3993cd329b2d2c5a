#include "core/fabrication/marked_lines.h"

#include "core/base/tolerances.h"
#include "core/geometry/line_clip.h"

namespace fff {

namespace {

double lengthOf(const Polygon &line)
{
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

Result<void> addOnPart(const CurvePath &path, const Region &region, std::vector<CurvePath> &lines)
{
    const Polygon line = path.flatten(kDrawChord);
    const Result<std::vector<Polygon>> pieces = clippedLine(line, region);
    if (!pieces) {
        lines.push_back(path);
        return tl::unexpected(pieces.error());
    }
    double left = 0.0;
    for (const Polygon &piece : *pieces)
        left += lengthOf(piece);
    // Snapping to the grid of booleans moves every vertex by half a step.
    const double rounding = static_cast<double>(line.size()) * kClipGrid;
    if (left >= lengthOf(line) - rounding) {
        lines.push_back(path);
        return {};
    }
    for (const Polygon &piece : *pieces) {
        Result<CurvePath> cut = CurvePath::fromLine(piece);
        if (!cut)
            return tl::unexpected(cut.error());
        lines.push_back(*std::move(cut));
    }
    return {};
}

} // namespace

MarkedLines linesOn(const Part &part, const std::vector<MarkPointer> &marks)
{
    MarkedLines lines;
    if (marks.empty())
        return lines;
    Region region;
    region.outer = part.outline.outer.polygon(kDrawChord);
    for (const Contour &hole : part.outline.holes)
        region.holes.push_back(hole.polygon(kDrawChord));
    for (const MarkPointer &mark : marks)
        for (const CurvePath &path : mark->paths) {
            std::vector<CurvePath> &kind =
                mark->kind == Mark::Kind::Scored ? lines.scored : lines.engraved;
            if (const Result<void> added = addOnPart(path, region, kind); !added)
                lines.error = added.error();
        }
    return lines;
}

} // namespace fff
