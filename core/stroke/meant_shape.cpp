#include "core/stroke/meant_shape.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/convex_hull.h"
#include "core/geometry/mirrored_boundaries.h"
#include "core/geometry/round_fit.h"
#include "core/stroke/straightened.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Off a circle and an ellipse, as a part of the radius: on the mean, and at most.
constexpr double kCircleMean = 0.042, kCircleMost = 0.11, kEllipseMean = 0.032, kEllipseMost = 0.09;
/// Axes whose ratio is above this are a circle's; below that a needle's.
constexpr double kRound = 0.85, kNeedle = 0.2;
/// Of the hull's area, what a line without bays encloses.
constexpr double kConvex = 0.975;
/// Turn at a joint that is a corner, and none of a round thing, radians.
constexpr double kRoundCorner = 0.7;
/// Chords of a contour that is looked at, as a part of its extent.
constexpr double kChord = 2e-3;
constexpr double kTenth = 0.1; // mm

bool hasCorner(const Contour &contour)
{
    const std::vector<double> turns = turnsAtJoints(contour);
    return std::any_of(turns.begin(), turns.end(), [](double t) { return t > kRoundCorner; });
}

bool hasBay(const Polygon &polygon)
{
    return std::abs(signedArea(polygon)) < kConvex * std::abs(signedArea(convexHull(polygon)));
}

/// About as far apart as they are long, so that a place counts for the line it stands for.
Polygon evenly(const Contour &contour)
{
    return contour.polygon(kChord * contour.bounds().size().maxCoeff());
}

std::optional<MeantShape> made(MeantShape::Kind kind, Figure figure)
{
    for (double &number : figure.numbers)
        number = std::max(1.0, std::round(number / kTenth)) * kTenth;
    Result<Contour> contour = contourOf(figure);
    if (!contour)
        return {};
    return MeantShape{kind, std::move(figure), *std::move(contour)};
}

/// As near as it can be to what it was, with its middle on the axis, and one of its own along it.
Figure centredOn(const std::optional<MirrorAxis> &axis, Figure figure)
{
    if (!axis)
        return figure;
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const Vec2 &along = axis->direction;
    figure.centre -= axis->height(figure.centre) * perpendicular(along);
    const double way = std::atan2(along.y(), along.x());
    figure.turn = way + kQuarter * std::round((figure.turn - way) / kQuarter);
    return figure;
}

std::optional<MeantShape> meantRound(const Contour &drawn, const std::optional<MirrorAxis> &axis)
{
    const Polygon line = evenly(drawn);
    if (hasCorner(drawn) || hasBay(line))
        return {};
    const std::optional<RoundFit> circle = fitCircle(line), ellipse = fitEllipse(line);
    if (!circle || !ellipse || ellipse->mean > kCircleMean * ellipse->size())
        return {};
    if (ellipse->minor >= kRound * ellipse->major && circle->mean <= kCircleMean * circle->major &&
        circle->most <= kCircleMost * circle->major)
        return made(MeantShape::Kind::Circle,
                    centredOn(axis, {"circle", {2.0 * circle->major}, circle->centre, 0.0}));
    if (ellipse->minor < kNeedle * ellipse->major ||
        ellipse->mean > kEllipseMean * ellipse->size() ||
        ellipse->most > kEllipseMost * ellipse->size())
        return {};
    return made(MeantShape::Kind::Ellipse,
                centredOn(axis, {"ellipse",
                                 {2.0 * ellipse->major, 2.0 * ellipse->minor},
                                 ellipse->centre,
                                 ellipse->turn}));
}

} // namespace

std::optional<MeantShape> meantShape(const Contour &drawn, double tolerance,
                                     const std::optional<MirrorAxis> &axis)
{
    if (std::optional<MeantShape> round = meantRound(drawn, axis))
        return round;
    std::optional<Straightened> straight = straightened(drawn, tolerance);
    if (straight && axis) {
        Result<ClippedPiece> whole = withImage(straight->contour, {}, *axis, true);
        if (!whole)
            return {};
        straight->contour = std::move(whole->outer);
    }
    if (!straight || !isPlain(straight->contour, {}, kCutChord))
        return {};
    return MeantShape{straight->hasRightAngles ? MeantShape::Kind::RightAngles
                                               : MeantShape::Kind::StraightLines,
                      {},
                      std::move(straight->contour)};
}

} // namespace fff
