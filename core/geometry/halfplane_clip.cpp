#include "core/geometry/halfplane_clip.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/curve_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

namespace fff {

namespace {

/// What is kept of a boundary in one run: from where it comes up through the line (entry) to where
/// it goes down again (exit).
struct Run
{
    std::vector<CubicBezier> segments;
    double entry = 0.0, exit = 0.0; // mm along the line
};

/// A stretch of one segment that lies on one side.
struct Stretch
{
    int segment = 0;
    double from = 0.0, to = 1.0;
    bool isKept = false;
};

/// Height of a curve over the line as a cubic polynomial in Bernstein form.
std::array<double, 4> heights(const CubicBezier &curve, const Halfplane &halfplane)
{
    return {halfplane.height(curve.p0), halfplane.height(curve.p1), halfplane.height(curve.p2),
            halfplane.height(curve.p3)};
}

/// Appends what of the segment lies on which side, joined with the stretch before where both are
/// on one side.
void addStretches(int index, const CubicBezier &curve, const Halfplane &halfplane,
                  std::vector<Stretch> &stretches)
{
    const auto add = [&](double from, double to, bool isKept) {
        if (!stretches.empty() && stretches.back().segment == index &&
            stretches.back().isKept == isKept)
            stretches.back().to = to;
        else
            stretches.push_back({index, from, to, isKept});
    };
    const std::array<double, 4> h = heights(curve, halfplane);
    if (*std::min_element(h.begin(), h.end()) > kOnLine)
        return add(0.0, 1.0, true);
    if (*std::max_element(h.begin(), h.end()) < -kOnLine)
        return add(0.0, 1.0, false);

    std::vector<double> nodes{0.0};
    for (const double t : levelParameters(curve, halfplane.inward))
        nodes.push_back(t);
    nodes.push_back(1.0);
    const auto sideAt = [&](double t) {
        const double height = halfplane.height(curve.at(t));
        return height > kOnLine ? 1 : height < -kOnLine ? -1 : 0;
    };
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double from = nodes[i], to = nodes[i + 1];
        const int sideOfFrom = sideAt(from), sideOfTo = sideAt(to);
        if (sideOfFrom * sideOfTo < 0) {
            const double t =
                crossLine({curve, from, to}, halfplane.point, halfplane.inward, 0.0).value_or(from);
            add(from, t, sideOfFrom > 0);
            add(t, to, sideOfTo > 0);
        } else if (sideOfFrom == 0 && sideOfTo == 0) {
            // In the line: the inside is to the left of every boundary.
            const Vec2 way = curve.at(to) - curve.at(from);
            add(from, to, way.dot(halfplane.along()) >= 0.0);
        } else {
            add(from, to, sideOfFrom + sideOfTo > 0);
        }
    }
}

Vec2 ontoLine(const Vec2 &p, const Halfplane &halfplane)
{
    return p - halfplane.height(p) * halfplane.inward;
}

/// Cuts one boundary. False when nothing of it lies beyond the line.
bool cutBoundary(const Contour &contour, const Halfplane &halfplane, std::vector<Run> &runs)
{
    std::vector<Stretch> stretches;
    for (int i = 0; i < contour.segmentCount(); ++i)
        addStretches(i, contour.segment(i), halfplane, stretches);
    const auto isDropped = [](const Stretch &s) { return !s.isKept; };
    const auto first = std::find_if(stretches.begin(), stretches.end(), isDropped);
    if (first == stretches.end())
        return false;
    std::rotate(stretches.begin(), first, stretches.end());

    bool isRunning = false;
    for (const Stretch &stretch : stretches) {
        if (stretch.isKept && !isRunning)
            runs.emplace_back();
        isRunning = stretch.isKept;
        if (!stretch.isKept)
            continue;
        const CubicBezier curve = contour.segment(stretch.segment);
        runs.back().segments.push_back(curve.piece(stretch.from, stretch.to));
    }
    return true;
}

/// Puts the ends of a run on the line.
void placeEnds(Run &run, const Halfplane &halfplane)
{
    Vec2 &start = run.segments.front().p0, &end = run.segments.back().p3;
    start = ontoLine(start, halfplane);
    end = ontoLine(end, halfplane);
    run.entry = halfplane.along().dot(start - halfplane.point);
    run.exit = halfplane.along().dot(end - halfplane.point);
}

/// Joins the runs along the line to closed boundaries. Just inside the line, along it, every run
/// that comes down opens the inside and the next one that goes up closes it. Nothing where they do
/// not alternate: boundaries touch each other there.
std::optional<std::vector<Contour>> joinRuns(const std::vector<Run> &runs)
{
    std::vector<std::size_t> exits(runs.size()), entries;
    std::iota(exits.begin(), exits.end(), 0);
    entries = exits;
    std::sort(exits.begin(), exits.end(),
              [&](std::size_t a, std::size_t b) { return runs[a].exit < runs[b].exit; });
    std::sort(entries.begin(), entries.end(),
              [&](std::size_t a, std::size_t b) { return runs[a].entry < runs[b].entry; });
    std::vector<std::size_t> next(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs[exits[i]].exit > runs[entries[i]].entry + kOnLine ||
            (i + 1 < runs.size() && runs[entries[i]].entry >= runs[exits[i + 1]].exit))
            return std::nullopt;
        next[exits[i]] = entries[i];
    }
    std::vector<Contour> contours;
    std::vector<bool> isUsed(runs.size(), false);
    for (std::size_t start = 0; start < runs.size(); ++start) {
        std::vector<CubicBezier> segments;
        for (std::size_t i = start; !isUsed[i]; i = next[i]) {
            isUsed[i] = true;
            segments.insert(segments.end(), runs[i].segments.begin(), runs[i].segments.end());
            const Vec2 &from = segments.back().p3, &to = runs[next[i]].segments.front().p0;
            if (runs[next[i]].entry - runs[i].exit > kOnLine)
                segments.push_back(CubicBezier::line(from, to));
        }
        if (segments.size() == 1) // a loop: a contour has two segments at least
            segments = {segments.front().piece(0.0, 0.5), segments.front().piece(0.5, 1.0)};
        if (!segments.empty())
            contours.push_back(Contour::ofSegments(segments));
    }
    return contours;
}

Contour wound(const Contour &contour, bool isCounterClockwise)
{
    return (contour.signedArea() > 0.0) == isCounterClockwise ? contour : contour.reversed();
}

double area(const ClippedPiece &piece)
{
    double sum = std::abs(piece.outer.signedArea());
    for (const Contour &hole : piece.holes)
        sum -= std::abs(hole.signedArea());
    return sum;
}

/// Gives each hole to the piece that it lies in.
std::vector<ClippedPiece> withHoles(std::vector<Contour> contours, std::vector<Contour> holes)
{
    std::vector<ClippedPiece> pieces;
    std::vector<Polygon> polygons;
    for (Contour &contour : contours) {
        if (!holes.empty())
            polygons.push_back(contour.polygon(kCutChord));
        pieces.push_back({std::move(contour), {}});
    }
    for (Contour &hole : holes) {
        // A vertex in the boundary does not tell; not all of them lie there.
        const Polygon ring = hole.polygon(kCutChord);
        std::size_t owner = 0;
        for (std::size_t i = 0; i < pieces.size() && pieces.size() > 1; ++i) {
            const auto isInPiece = [&](const Vec2 &p) {
                return locate(p, polygons[i]) == Side::Inside;
            };
            if (std::any_of(ring.begin(), ring.end(), isInPiece))
                owner = i;
        }
        pieces[owner].holes.push_back(std::move(hole));
    }
    return pieces;
}

void sortBySize(std::vector<ClippedPiece> &pieces)
{
    std::erase_if(pieces, [](const ClippedPiece &piece) { return area(piece) < kMinArea; });
    std::stable_sort(
        pieces.begin(), pieces.end(),
        [](const ClippedPiece &a, const ClippedPiece &b) { return area(a) > area(b); });
}

/// The same by the general boolean, for boundaries that touch where the line cuts them.
Result<std::vector<ClippedPiece>>
clipByBoolean(const Contour &contour, const std::vector<Contour> &holes, const Halfplane &halfplane)
{
    const Box2 box = contour.bounds();
    const Vec2 along = halfplane.along();
    const Vec2 foot = ontoLine(box.center(), halfplane);
    const double reach = box.size().norm() + std::abs(halfplane.height(box.center()));
    const Polygon beyond{foot + reach * along, foot - reach * along,
                         foot - reach * along - reach * halfplane.inward,
                         foot + reach * along - reach * halfplane.inward};
    std::vector<ClippedPiece> pieces;
    Result<std::vector<CurvedRegion>> regions = subtract(contour, holes, {beyond}, kCutChord);
    if (!regions)
        return tl::unexpected(regions.error());
    for (CurvedRegion &region : *regions) {
        // Its grid is coarser than what is asked for here.
        std::vector<Vec2> points = region.outer.points();
        for (std::size_t i = 0; i < points.size(); i += 3) {
            if (std::abs(halfplane.height(points[i])) <= kClipSlack)
                points[i] = ontoLine(points[i], halfplane);
        }
        pieces.push_back({Contour::ofPoints(std::move(points)), std::move(region.holes)});
    }
    return pieces;
}

} // namespace

bool isInside(const Contour &contour, const Halfplane &halfplane)
{
    const auto isKept = [&](const Vec2 &p) { return halfplane.height(p) >= -kOnLine; };
    // The curve lies in the hull of its control points.
    if (std::all_of(contour.points().begin(), contour.points().end(), isKept))
        return true;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        if (!isKept(curve.p0))
            return false;
        for (const double t : levelParameters(curve, halfplane.inward)) {
            if (!isKept(curve.at(t)))
                return false;
        }
    }
    return true;
}

Result<std::vector<ClippedPiece>> clip(const Contour &contour, const std::vector<Contour> &holes,
                                       const Halfplane &halfplane)
{
    // Holes lie in the contour.
    if (isInside(contour, halfplane)) {
        std::vector<ClippedPiece> whole{{contour, holes}};
        std::erase_if(whole, [](const ClippedPiece &piece) { return area(piece) < kMinArea; });
        return whole;
    }
    std::vector<Run> runs;
    cutBoundary(wound(contour, true), halfplane, runs);
    std::vector<Contour> whole;
    for (const Contour &hole : holes) {
        const Contour turned = wound(hole, false);
        if (!cutBoundary(turned, halfplane, runs))
            whole.push_back(turned);
    }
    for (Run &run : runs)
        placeEnds(run, halfplane);
    std::vector<ClippedPiece> pieces;
    if (std::optional<std::vector<Contour>> contours = joinRuns(runs)) {
        if (!contours->empty())
            pieces = withHoles(std::move(*contours), std::move(whole));
    } else {
        Result<std::vector<ClippedPiece>> cut = clipByBoolean(contour, holes, halfplane);
        if (!cut)
            return cut;
        pieces = *std::move(cut);
    }
    sortBySize(pieces);
    return pieces;
}

} // namespace fff
