// Boundaries that are given by numbers: circles, rectangles and the like. A figure is what was
// asked for; the contour is made of it, and lives on its own once a person edits that by hand.
#pragma once

#include "core/geometry/contour.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff {

/// One of the numbers of a kind of figure.
struct FigureNumber
{
    enum class Unit { Length, Count }; // mm
    const char *key;
    const char *label; // English, marked for translation in the context "Figure"
    Unit unit = Unit::Length;
    double standard = 0.0, least = 0.0, most = 0.0;
};

/// A kind of figure. All lie round their centre, as high and wide as their numbers say before they
/// are turned; polygons and stars stand on a tip upwards.
struct FigureKind
{
    const char *key;
    const char *name;
    std::vector<FigureNumber> numbers;
    /// Counter-clockwise, round 0. numbers: in their order, in their ranges.
    Contour (*make)(std::span<const double> numbers);
};

/// circle: diameter. ellipse: width, height. rectangle: width, height, corner (a radius, at most
/// half of the smaller side). polygon: diameter (of the circle through its corners), sides. star:
/// diameter, inner (the same of its inner corners), tips. slot: length, width, with round ends.
std::span<const FigureKind> figureKinds();
/// Null for one that this version does not know.
const FigureKind *figureKind(std::string_view key);

struct Figure
{
    std::string kind;
    std::vector<double> numbers; // as the kind has them
    Vec2 centre = Vec2::Zero();  // in the coordinates of what it is drawn in, mm
    double turn = 0.0;           // radians, counter-clockwise

    bool operator==(const Figure &) const = default;
};

/// One of the kind with its standard numbers.
Figure newFigure(const FigureKind &kind);
/// The figure as large as a box round its centre of this size, mm: the numbers that say how large
/// it is follow, others stay.
Figure sized(Figure figure, const Vec2 &size);
/// Before it is turned, width and height, mm.
Vec2 sizeOf(const Figure &figure);

/// Its boundary. Errors  BadValue, place = the number's key, where one is out of its range or
/// missing; place "kind" for an unknown one.
Result<Contour> contourOf(const Figure &figure);
/// Whether the contour is that of the figure, either way round, to kSameFigure.
bool isOf(const Contour &contour, const Figure &figure);

/// The figure with each point p at about + matrix (p − about). Nothing where it would be no figure
/// of its kind: it leans, or is mirrored, or round corners would be ellipses. A circle becomes an
/// ellipse.
std::optional<Figure> mapped(const Figure &figure, const Eigen::Matrix2d &matrix,
                             const Vec2 &about);

/// Control points that differ by less are the same, mm: what rounding leaves of a few moves.
inline constexpr double kSameFigure = 1e-6;

} // namespace fff
