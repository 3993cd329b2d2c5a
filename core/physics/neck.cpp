#include "core/physics/neck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace fff {

namespace {

/// An end this near to a vertex lies on it, mm: less than what lasers keep.
constexpr double kAtVertex = 0.02;
constexpr double kMinNeck = 0.05; // mm: shorter ones are where rings touch
/// Of 45°, the cosine, and rounding: chords of the grid between straight edges lean by just that.
constexpr double kLeastStraight = 1.0 / std::numbers::sqrt2 - 1e-6;
/// Normals that differ by less than this length (29°) face the same way.
constexpr double kSameSideNormals = 0.5;
/// A vertex that turns by less is one of a curve, for the direction in which the boundary faces
/// (20°, its sine): from there on it may be re-entrant.
constexpr double kSmoothSine = 0.3420201433256687;
/// Its turn is spread over no more than this share of the chord to both sides: a member does not
/// feel which way a short stretch of its boundary faces.
constexpr double kSmoothShare = 0.25;
/// A vertex that turns by more is a corner, not a stretch of a curve (25°, radians).
constexpr double kCurveTurn = 0.4363323129985824;
/// Both rims of a curved bar have one centre, up to this share of its width.
constexpr double kConcentricShare = 0.5;
/// Below this radius in widths the inner rim shrinks to a point.
constexpr double kLeastRadius = 0.55;
constexpr double kCurvedRadius = 2.0;
/// Beyond this radius in widths curvature adds less than 2 %.
constexpr double kStraightRadius = 20.0;
/// Only what leans no more than this from a slit runs beside it (22.5°, its cosine, and rounding:
/// rays and lines of the grid lean by just that).
constexpr double kBesideCosine = 0.9238795325112867 - 1e-6;
/// What begins at a slit's root does not pass it: nearer than this it is level with it, mm.
constexpr double kLevel = kClipSlack;
/// Of two faces that are as opposite to the other end's, up to this, the first one is taken (no
/// unit); of two shadows that leave as much the first one, mm.
constexpr double kTie = 1e-7;
/// The way from a chord to the slit's corner may touch what both of them touch, mm.
constexpr double kTouchSlack = 0.05;

/// What may be the outward normal at an end of a chord that leaves the material along `way`.
struct EndNormals
{
    std::array<Vec2, 3> normals;
    int count = 0;

    void add(const Vec2 &normal) { normals[static_cast<std::size_t>(count++)] = normal; }
};

bool isAtVertex(const Vec2 &p, const Vec2 &vertex)
{
    return (p - vertex).squaredNorm() <= kAtVertex * kAtVertex;
}

bool isSmooth(const Vec2 &before, const Vec2 &after)
{
    return before.dot(after) > 0.0 && std::abs(cross(before, after)) < kSmoothSine;
}

/// The outward normal of the curve that an edge is a chord of: the turn at a vertex is spread over
/// half of the shorter of its edges, to both sides, and over no more than `reach` mm.
Vec2 smoothNormal(const SectionOutline &outline, const OutlinePoint &point, double reach)
{
    const Vec2 &own = outline.outward(point.ring, point.edge);
    const int other = point.share < 0.5 ? point.edge - 1 : point.edge + 1;
    const Vec2 &next = outline.outward(point.ring, other);
    if (!isSmooth(own, next))
        return own;
    const Vec2 &vertex = outline.vertex(point.ring, std::max(point.edge, other));
    const double spread = std::min({0.5 * outline.length(point.ring, point.edge),
                                    0.5 * outline.length(point.ring, other), reach});
    const double away = (point.at - vertex).norm();
    if (away >= spread)
        return own;
    return (own + 0.5 * (1.0 - away / spread) * (next - own)).normalized();
}

EndNormals endNormals(const SectionOutline &outline, const OutlinePoint &point, const Vec2 &way,
                      double chord)
{
    EndNormals result;
    int vertex = point.edge;
    const bool isAtOne = isAtVertex(point.at, outline.vertex(point.ring, vertex)) ||
                         isAtVertex(point.at, outline.vertex(point.ring, ++vertex));
    const Vec2 &before = outline.outward(point.ring, vertex - 1);
    const Vec2 &after = outline.outward(point.ring, vertex);
    if (!isAtOne || isSmooth(before, after)) {
        result.add(smoothNormal(outline, point, kSmoothShare * chord));
        return result;
    }
    const double turn = cross(before, after) >= 0.0 ? 1.0 : -1.0;
    const bool isBetween = turn * cross(before, way) >= 0.0 && turn * cross(way, after) >= 0.0 &&
                           way.dot(before + after) > 0.0;
    // Beside a re-entrant corner either edge may be where a member ends; a corner that sticks out
    // is the end of none.
    const bool isReentrant = outline.isReentrant(point.ring, vertex);
    if (isBetween)
        result.add(way);
    if (isReentrant || (!isBetween && before.dot(way) > after.dot(way)))
        result.add(before);
    if (isReentrant || (!isBetween && before.dot(way) <= after.dot(way)))
        result.add(after);
    return result;
}

/// How the chord's section runs: of what the ends allow, between the two faces that are most
/// opposite to each other, if that still counts; else what leans least.
void measureLean(const EndNormals &begins, const EndNormals &ends, const Vec2 &way, Neck &neck)
{
    bool isFirst = true;
    double widest = 0.0;
    for (int i = 0; i < begins.count; ++i) {
        for (int j = 0; j < ends.count; ++j) {
            const Vec2 span = ends.normals[static_cast<std::size_t>(j)] -
                              begins.normals[static_cast<std::size_t>(i)];
            const double width = span.norm();
            const bool isSameSide = width < kSameSideNormals || span.dot(way) <= 0.0;
            const Vec2 across = isSameSide ? way : Vec2(span / width);
            const double straight = way.dot(across);
            const bool isGood = !isSameSide && straight >= kLeastStraight;
            const bool wasGood = !neck.isSameSide && neck.straight >= kLeastStraight;
            const bool isBetter = isGood != wasGood ? isGood
                                  : isGood          ? width > widest + kTie
                                                    : straight > neck.straight + kTie;
            if (!isFirst && !isBetter)
                continue;
            isFirst = false;
            widest = width;
            neck.isSameSide = isSameSide;
            neck.across = across;
            neck.straight = straight;
        }
    }
}

bool isAtCornerOf(const SectionOutline &outline, const OutlinePoint &point)
{
    for (const int index : {point.edge, point.edge + 1})
        if (outline.isReentrant(point.ring, index) &&
            isAtVertex(point.at, outline.vertex(point.ring, index)))
            return true;
    return false;
}

/// How a ring goes on from a point.
struct RingTurn
{
    double turn = 0.0; // radians
    double way = 0.0;  // mm of arc over which it does
};

/// Within `reach` mm of arc, one way; nothing at a corner. The turn at a vertex stands for the arc
/// from the middle of the edge before it to that of the one behind.
std::optional<RingTurn> turnWithin(const SectionOutline &outline, const OutlinePoint &point,
                                   double reach, int step)
{
    int vertex = step > 0 ? point.edge + 1 : point.edge;
    double way = (outline.vertex(point.ring, vertex) - point.at).norm();
    RingTurn result{0.0, reach};
    const int limit =
        static_cast<int>(outline.rings()[static_cast<std::size_t>(point.ring)].size());
    for (int count = 0; way < reach && count < limit; ++count) {
        const double here = outline.turn(point.ring, vertex);
        if (std::abs(here) > kCurveTurn)
            return std::nullopt;
        const double edge = outline.length(point.ring, step > 0 ? vertex : vertex - 1);
        result.turn += here;
        result.way = way + 0.5 * edge;
        way += edge;
        vertex += step;
    }
    return result;
}

/// Curvature of a ring around a point, 1/mm, positive where the material is convex.
std::optional<double> curvatureAt(const SectionOutline &outline, const OutlinePoint &point,
                                  double length)
{
    const auto back = turnWithin(outline, point, 0.5 * length, -1);
    const auto on = back ? turnWithin(outline, point, 0.5 * length, 1) : std::nullopt;
    if (!on)
        return std::nullopt;
    return (back->turn + on->turn) / (back->way + on->way);
}

void measureBend(const SectionOutline &outline, const Chord &chord, Neck &neck)
{
    const auto a = curvatureAt(outline, chord.begin, neck.length);
    const auto b = a && *a != 0.0 ? curvatureAt(outline, chord.end, neck.length) : std::nullopt;
    if (!b || *a * *b >= 0.0)
        return;
    const double outer = 1.0 / std::max(*a, *b), inner = -1.0 / std::min(*a, *b);
    if (std::abs(outer - inner - neck.length) > kConcentricShare * neck.length)
        return;
    const double radius = std::max(0.5 * (outer + inner) / neck.length, kLeastRadius); // in l
    neck.isCurved = radius < kCurvedRadius;
    if (radius > kStraightRadius)
        return;
    const double ri = radius - 0.5, rn = 1.0 / std::log((radius + 0.5) / ri);
    neck.bend = std::max(1.0, (rn - ri) / (6.0 * (radius - rn) * ri));
}

/// Where the shadow of a slit ends at the most: at its mouth's height, at 45° from its root.
Box2 shadowedBy(const SlitLine &slit)
{
    const Vec2 around = Vec2::Constant(std::numbers::sqrt2 * slit.depth + slit.width);
    return {slit.root - around, slit.root + around};
}

/// What the shadow of a slit leaves of the neck, if that is less than of others.
void shadow(const PieceShape &shape, int index, Neck &neck)
{
    const SlitLine &slit = shape.slits[static_cast<std::size_t>(index)];
    const Vec2 chord = neck.end - neck.begin;
    const double rise = chord.dot(slit.opening);
    const Vec2 &low = rise > 0.0 ? neck.begin : neck.end,
               &high = rise > 0.0 ? neck.end : neck.begin;
    // Along the slit from its root, and beside its middle.
    const Vec2 side = perpendicular(slit.opening);
    const double lowAlong = slit.opening.dot(low - slit.root);
    const double highAlong = slit.opening.dot(high - slit.root);
    if (lowAlong >= -kLevel || highAlong <= kLevel ||
        std::abs(chord.normalized().dot(slit.opening)) < kBesideCosine ||
        !shape.netCuts[static_cast<std::size_t>(index)])
        return;
    const Vec2 level = low + (lowAlong / (lowAlong - highAlong)) * (high - low);
    const double beside = side.dot(level - slit.root), sign = beside >= 0.0 ? 1.0 : -1.0;
    // All of the slit is on one side: else the cut ends at its wall, or crosses it.
    const Vec2 mouth = slit.root + slit.depth * slit.opening, way = high - low;
    if ((cross(way, slit.root - low) >= 0.0) != (cross(way, mouth - low) >= 0.0) ||
        sign * side.dot(high - slit.root) <= 0.5 * slit.width + kTouchSlack)
        return;
    const auto above = [&](const Vec2 &p) { // over the line at 45° from the root's corner
        return slit.opening.dot(p - slit.root) -
               (sign * side.dot(p - slit.root) - 0.5 * slit.width);
    };
    const double under = above(low), over = above(high);
    if (under >= -kLevel || over <= kLevel)
        return;
    const Vec2 limit = low + (under / (under - over)) * (high - low);
    const double limitAlong = slit.opening.dot(limit - slit.root);
    const double length = (limit - low).norm() * neck.straight;
    if (limitAlong < -kLevel || limitAlong > slit.depth + kLevel ||
        (neck.shadowSlit >= 0 && length >= neck.shadowLength - kTie))
        return;
    const Vec2 corner = slit.root + sign * 0.5 * slit.width * side;
    if (!shape.outline.isClear(corner, level, kTouchSlack))
        return;
    neck.shadowSlit = index;
    neck.shadowBegin = rise > 0.0 ? low : limit;
    neck.shadowEnd = rise > 0.0 ? limit : low;
    neck.shadowLength = length;
    neck.isNetOnPlus = (rise > 0.0 ? 1.0 : -1.0) * cross(way, slit.root - low) < 0.0;
    const LineCut &net = shape.netCuts[static_cast<std::size_t>(index)]->cut;
    neck.isOnNetPlus = net.line.across(level) < 0.0;
}

/// How far the holes that a cut crosses reach beside it.
void measureHoles(const SectionOutline &outline, const LineCut &cut, const Chord &chord, Neck &neck)
{
    int last = 0;
    for (const OutlineCrossing &c : cut.crossed) {
        const int ring = c.point.ring;
        if (ring == last)
            continue;
        last = ring;
        double minus = 0.0, plus = 0.0;
        for (const Vec2 &p : outline.rings()[static_cast<std::size_t>(ring)]) {
            const double left = cut.line.across(p);
            minus = std::max(minus, left);
            plus = std::max(plus, -left);
        }
        neck.zoneMinus = std::max(neck.zoneMinus, minus);
        neck.zonePlus = std::max(neck.zonePlus, plus);
        if (ring == chord.begin.ring || ring == chord.end.ring)
            neck.halfOpening = std::max(neck.halfOpening, 0.5 * (minus + plus));
    }
}

} // namespace

bool counts(const Neck &neck)
{
    return neck.length >= kMinNeck && neck.straight >= kLeastStraight && !neck.isSameSide;
}

PieceShape::PieceShape(const Region &region, std::vector<SlitLine> given)
    : outline(region), slits(std::move(given))
{
    for (std::size_t ring = 0; ring < outline.rings().size(); ++ring)
        for (std::size_t i = 0; i < outline.rings()[ring].size(); ++i)
            if (outline.isReentrant(static_cast<int>(ring), static_cast<int>(i)))
                corners.push_back(
                    {static_cast<int>(ring), static_cast<int>(i), outline.rings()[ring][i]});
    slitZones.fill(slits.size(), [this](std::size_t i) { return shadowedBy(slits[i]); });
    cornerBoxes.fill(corners.size(), [this](std::size_t i) {
        return Box2{corners[i].at, corners[i].at};
    });
    LineCutter cutter(outline);
    netCuts.resize(slits.size());
    for (std::size_t i = 0; i < slits.size() && !outline.isEmpty(); ++i) {
        const SlitLine &slit = slits[i];
        // Slits are half as deep as what they are in, mostly.
        const double reach = std::max(slit.depth, slit.width);
        if (auto found = cutter.from({outline.nearest(slit.root).at, -slit.opening}, reach))
            netCuts[i] = *std::move(found);
    }
    size = outline.bounds().isEmpty() ? 0.0 : outline.bounds().size().norm();
}

Neck leaningNeck(const PieceShape &shape, const CutLine &line, const Chord &chord)
{
    const Vec2 &way = line.direction;
    Neck neck;
    neck.begin = chord.begin.at;
    neck.end = chord.end.at;
    measureLean(endNormals(shape.outline, chord.begin, -way, chord.length()),
                endNormals(shape.outline, chord.end, way, chord.length()), way, neck);
    neck.length = chord.length() * neck.straight;
    return neck;
}

void measure(const PieceShape &shape, const LineCut &cut, int chordIndex, Neck &neck)
{
    const Chord &chord = cut.chords[static_cast<std::size_t>(chordIndex)];
    neck.isAtCorner =
        isAtCornerOf(shape.outline, chord.begin) || isAtCornerOf(shape.outline, chord.end);
    measureBend(shape.outline, chord, neck);
    measureHoles(shape.outline, cut, chord, neck);
    Box2 box;
    box.extend(neck.begin);
    box.extend(neck.end);
    shape.slitZones.any([&box](const Box2 &zone) { return zone.intersects(box); },
                        [&](std::size_t slit) {
                            shadow(shape, static_cast<int>(slit), neck);
                            return false;
                        });
    const Vec2 middle = neck.middle();
    neck.isNearCorner = shape.cornerBoxes.any(
        [&](const Box2 &corners) { return distanceToBox(corners, middle) < neck.length; },
        [&](std::size_t i) {
            const Vec2 &at = shape.corners[i].at;
            return (at - middle).squaredNorm() < neck.length * neck.length &&
                   !isAtVertex(at, neck.begin) && !isAtVertex(at, neck.end);
        });
    const double depth = std::min(cut.minus.area, cut.plus.area) / neck.length; // of a side
    neck.isStubby = depth < neck.length;
    neck.isCap = depth < 0.5 * neck.length;
}

Neck neckOf(const PieceShape &shape, const LineCut &cut, int chord)
{
    Neck neck = leaningNeck(shape, cut.line, cut.chords[static_cast<std::size_t>(chord)]);
    measure(shape, cut, chord, neck);
    return neck;
}

} // namespace fff
