#include "core/operations/grid_cells.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/contour_points.h"
#include "core/geometry/halfplane_clip.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>

namespace fff {

namespace {

struct Piece
{
    int column = 0, row = 0, part = 0;
    ClippedPiece outline;
    double area = 0.0;
};

double areaOf(const ClippedPiece &piece)
{
    double area = std::abs(piece.outer.signedArea());
    for (const Contour &hole : piece.holes)
        area -= std::abs(hole.signedArea());
    return area;
}

/// The pieces between two lines of one axis.
Result<std::vector<ClippedPiece>> between(const std::vector<ClippedPiece> &pieces, int axis,
                                          double from, double to)
{
    Vec2 inward = Vec2::Zero(), at = Vec2::Zero();
    inward[axis] = 1.0;
    std::vector<ClippedPiece> result = pieces;
    for (const auto &[line, side] : {std::pair(from, 1.0), std::pair(to, -1.0)}) {
        at[axis] = line;
        std::vector<ClippedPiece> next;
        for (const ClippedPiece &piece : result) {
            Result<std::vector<ClippedPiece>> parts =
                clip(piece.outer, piece.holes, {at, side * inward});
            if (!parts)
                return parts;
            std::move(parts->begin(), parts->end(), std::back_inserter(next));
        }
        result = std::move(next);
    }
    return result;
}

Result<std::vector<Piece>> piecesOf(const Shape &shape, const CellGrid &grid)
{
    std::vector<Piece> pieces;
    const std::vector<ClippedPiece> all{{shape.contour(), shape.holes()}};
    for (int column = 0; column < grid.columns; ++column) {
        const auto strip = between(all, 0, grid.line(0, column), grid.line(0, column + 1));
        if (!strip)
            return tl::unexpected(strip.error());
        for (int row = 0; row < grid.rows; ++row) {
            auto cell = between(*strip, 1, grid.line(1, row), grid.line(1, row + 1));
            if (!cell)
                return tl::unexpected(cell.error());
            int part = 0;
            for (ClippedPiece &piece : *cell) {
                const double area = areaOf(piece);
                pieces.push_back({column, row, part++, std::move(piece), area});
            }
        }
    }
    return pieces;
}

/// Stretches of a piece's boundary that lie on a line of the grid.
std::vector<std::pair<double, double>> stretchesOn(const ClippedPiece &piece, int axis, double at)
{
    std::vector<std::pair<double, double>> stretches;
    const auto take = [&](const Contour &contour) {
        for (int i = 0; i < contour.segmentCount(); ++i) {
            const CubicBezier curve = contour.segment(i);
            const auto isOn = [&](const Vec2 &p) {
                return std::abs(p[axis] - at) <= kCrossingError + kOnLine;
            };
            if (isOn(curve.p0) && isOn(curve.p1) && isOn(curve.p2) && isOn(curve.p3))
                stretches.push_back(std::minmax({curve.p0[1 - axis], curve.p3[1 - axis]}));
        }
    };
    take(piece.outer);
    for (const Contour &hole : piece.holes)
        take(hole);
    std::sort(stretches.begin(), stretches.end());
    return stretches;
}

/// All stretches at which pieces of neighbouring cells touch; sides are indices of pieces.
std::vector<Seam> seamsOf(const std::vector<Piece> &pieces, const CellGrid &grid)
{
    std::map<std::pair<int, int>, std::vector<int>> byCell;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i)
        byCell[{pieces[static_cast<std::size_t>(i)].column,
                pieces[static_cast<std::size_t>(i)].row}]
            .push_back(i);
    std::vector<Seam> seams;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        const Piece &piece = pieces[static_cast<std::size_t>(i)];
        for (const int axis : {0, 1}) {
            const auto next = byCell.find({piece.column + (axis == 0), piece.row + (axis == 1)});
            if (next == byCell.end())
                continue;
            const int index = (axis == 0 ? piece.column : piece.row) + 1;
            const auto here = stretchesOn(piece.outline, axis, grid.line(axis, index));
            for (const int other : next->second) {
                const auto there = stretchesOn(pieces[static_cast<std::size_t>(other)].outline,
                                               axis, grid.line(axis, index));
                for (const auto &a : here)
                    for (const auto &b : there) {
                        const double from = std::max(a.first, b.first);
                        const double to = std::min(a.second, b.second);
                        if (to - from > kMinOverlap)
                            seams.push_back({axis, index, axis == 0 ? piece.row : piece.column, i,
                                             other, from, to});
                    }
            }
        }
    }
    std::sort(seams.begin(), seams.end(), [](const Seam &a, const Seam &b) {
        return std::tie(a.axis, a.index, a.row, a.from) < std::tie(b.axis, b.index, b.row, b.from);
    });
    return seams;
}

/// Which piece each one goes to: itself, or by and by a large enough neighbour.
std::vector<int> mergedInto(const std::vector<Piece> &pieces, const std::vector<Seam> &seams,
                            double leastArea)
{
    std::vector<int> into(pieces.size());
    std::iota(into.begin(), into.end(), 0);
    std::vector<double> areas;
    for (const Piece &piece : pieces)
        areas.push_back(piece.area);
    const auto root = [&into](int i) {
        while (into[static_cast<std::size_t>(i)] != i)
            i = into[static_cast<std::size_t>(i)];
        return i;
    };
    for (;;) {
        // The smallest that is too small and has a neighbour.
        int smallest = -1, target = -1;
        for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (into[index] != i || areas[index] >= leastArea ||
                (smallest >= 0 && areas[index] >= areas[static_cast<std::size_t>(smallest)]))
                continue;
            std::map<int, double> shared;
            for (const Seam &seam : seams) {
                const int a = root(seam.below), b = root(seam.above);
                if (a != b && (a == i || b == i))
                    shared[a == i ? b : a] += seam.length();
            }
            const auto most =
                std::max_element(shared.begin(), shared.end(),
                                 [](const auto &x, const auto &y) { return x.second < y.second; });
            if (most != shared.end()) {
                smallest = i;
                target = most->first;
            }
        }
        if (smallest < 0)
            break;
        into[static_cast<std::size_t>(smallest)] = target;
        areas[static_cast<std::size_t>(target)] += areas[static_cast<std::size_t>(smallest)];
    }
    for (int i = 0; i < static_cast<int>(into.size()); ++i)
        into[static_cast<std::size_t>(i)] = root(i);
    return into;
}

/// Without the anchors that seams left in straight edges.
Contour withoutSeams(const Contour &contour)
{
    std::vector<CubicBezier> segments;
    const auto goesOn = [](const CubicBezier &a, const CubicBezier &b) {
        if (!isLine(a) || !isLine(b))
            return false;
        const Vec2 u = a.p3 - a.p0, v = b.p3 - b.p0;
        return u.dot(v) > 0.0 && std::abs(cross(u, v)) <= kOnLine * (u.norm() + v.norm());
    };
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier segment = contour.segment(i);
        if (!segments.empty() && goesOn(segments.back(), segment))
            segments.back() = CubicBezier::line(segments.back().p0, segment.p3);
        else
            segments.push_back(segment);
    }
    if (segments.size() > 3 && goesOn(segments.back(), segments.front())) {
        segments.front() = CubicBezier::line(segments.back().p0, segments.front().p3);
        segments.pop_back();
    }
    // What is nothing but one line there and back.
    return segments.size() < 2 ? contour : Contour::ofSegments(segments);
}

/// The outlines of several pieces of which each touches another: one, or several where they do at
/// a corner only; the largest first.
Result<std::vector<ClippedPiece>> together(const std::vector<const Piece *> &pieces)
{
    if (pieces.size() == 1)
        return std::vector<ClippedPiece>{pieces.front()->outline};
    std::vector<Contour> contours;
    for (const Piece *piece : pieces) {
        contours.push_back(piece->outline.outer);
        contours.insert(contours.end(), piece->outline.holes.begin(), piece->outline.holes.end());
    }
    std::vector<ClippedPiece> outlines;
    const auto regions = windingRegions(contours, WindingRule::Positive, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    for (const CurvedRegion &region : *regions) {
        outlines.push_back({withoutSeams(region.outer), {}});
        for (const Contour &hole : region.holes)
            outlines.back().holes.push_back(withoutSeams(hole));
    }
    return outlines;
}

/// Winding as clip() promises only where something was cut.
ClippedPiece wound(ClippedPiece piece)
{
    if (piece.outer.signedArea() < 0.0)
        piece.outer = piece.outer.reversed();
    for (Contour &hole : piece.holes)
        if (hole.signedArea() > 0.0)
            hole = hole.reversed();
    return piece;
}

} // namespace

Result<GridCells> cutIntoCells(const Shape &shape, const CellGrid &grid, double sliver)
{
    Result<std::vector<Piece>> found = piecesOf(shape, grid);
    if (!found)
        return tl::unexpected(found.error());
    std::vector<Piece> &pieces = *found;
    for (Piece &piece : pieces)
        piece.outline = wound(std::move(piece.outline));
    const std::vector<Seam> seams = seamsOf(pieces, grid);
    const std::vector<int> into = mergedInto(pieces, seams, sliver * grid.size.prod());
    GridCells result;
    std::vector<int> cellOf(pieces.size(), -1);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (into[i] != static_cast<int>(i))
            continue;
        std::vector<const Piece *> members;
        for (std::size_t j = 0; j < pieces.size(); ++j) {
            if (into[j] == static_cast<int>(i)) {
                members.push_back(&pieces[j]);
                cellOf[j] = static_cast<int>(result.cells.size());
            }
        }
        auto outlines = together(members);
        if (!outlines)
            return tl::unexpected(outlines.error());
        int part = pieces[i].part;
        for (ClippedPiece &outline : *outlines) {
            result.cells.push_back({pieces[i].column, pieces[i].row, part, std::move(outline.outer),
                                    std::move(outline.holes)});
            part += static_cast<int>(pieces.size()); // a number that no other part has
        }
    }
    for (Seam seam : seams) {
        seam.below = cellOf[static_cast<std::size_t>(seam.below)];
        seam.above = cellOf[static_cast<std::size_t>(seam.above)];
        if (seam.below != seam.above)
            result.seams.push_back(seam);
    }
    return result;
}

} // namespace fff
