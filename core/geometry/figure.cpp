#include "core/geometry/figure.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// Of a circle: off it by 4 µm a metre.
constexpr double kArc = kTurn / 8.0;
/// Sizes that a figure may have, mm.
constexpr double kLeast = 0.5, kMost = 5000.0;
constexpr double kSides = 100.0;
/// No unit: how far a map may be from one that keeps a kind of figure.
constexpr double kNoLean = 1e-9;

Vec2 onCircle(double radius, double angle)
{
    return radius * Vec2(std::cos(angle), std::sin(angle));
}

/// A chain of control points, as Contour::fromPoints() wants them.
class Chain
{
public:
    void line(const Vec2 &from, const Vec2 &to)
    {
        if (from == to)
            return;
        add(from, from + (to - from) / 3.0, from + (to - from) * (2.0 / 3.0));
    }
    /// Counter-clockwise, in pieces of kArc at most.
    void arc(const Vec2 &centre, double radius, double from, double to)
    {
        if (radius <= 0.0)
            return;
        const int pieces = static_cast<int>(std::lround((to - from) / kArc));
        const double step = (to - from) / pieces;
        const double handle = 4.0 / 3.0 * std::tan(0.25 * step);
        for (int i = 0; i < pieces; ++i) {
            const Vec2 p = onCircle(radius, from + i * step);
            const Vec2 q = onCircle(radius, from + (i + 1) * step);
            add(centre + p, centre + p + handle * Vec2(-p.y(), p.x()),
                centre + q - handle * Vec2(-q.y(), q.x()));
        }
    }
    Contour closed() { return Contour::ofPoints(std::move(m_points)); }

private:
    void add(const Vec2 &p0, const Vec2 &p1, const Vec2 &p2)
    {
        m_points.insert(m_points.end(), {p0, p1, p2});
    }
    std::vector<Vec2> m_points;
};

Contour ellipse(double width, double height)
{
    Chain chain;
    chain.arc(Vec2::Zero(), 1.0, 0.0, kTurn);
    std::vector<Vec2> points = chain.closed().points();
    for (Vec2 &p : points)
        p = Vec2(0.5 * width * p.x(), 0.5 * height * p.y());
    return Contour::ofPoints(std::move(points));
}

Contour makeCircle(std::span<const double> n)
{
    return ellipse(n[0], n[0]);
}

Contour makeEllipse(std::span<const double> n)
{
    return ellipse(n[0], n[1]);
}

/// From the lower right corner on.
Contour makeRectangle(std::span<const double> n)
{
    const Vec2 half(0.5 * n[0], 0.5 * n[1]);
    const double radius = std::min(n[2], half.minCoeff());
    const Vec2 inner = half - Vec2::Constant(radius);
    const Vec2 signs[] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
    Chain chain;
    for (int i = 0; i < 4; ++i) {
        const Vec2 centre = signs[i].cwiseProduct(inner);
        const Vec2 next = signs[(i + 1) % 4].cwiseProduct(inner);
        const double from = (i - 1) * 0.25 * kTurn, to = i * 0.25 * kTurn;
        chain.arc(centre, radius, from, to);
        chain.line(centre + onCircle(radius, to), next + onCircle(radius, to));
    }
    return chain.closed();
}

Contour tips(double outer, double inner, int count)
{
    Polygon corners;
    const double half = 0.5 * kTurn / count;
    for (int i = 0; i < count; ++i) {
        corners.push_back(onCircle(0.5 * outer, 0.25 * kTurn + 2 * i * half));
        if (inner > 0.0)
            corners.push_back(onCircle(0.5 * inner, 0.25 * kTurn + (2 * i + 1) * half));
    }
    return Contour::ofPolygon(corners);
}

Contour makePolygon(std::span<const double> n)
{
    return tips(n[0], 0.0, static_cast<int>(n[1]));
}

Contour makeStar(std::span<const double> n)
{
    return tips(n[0], std::min(n[1], n[0]), static_cast<int>(n[2]));
}

/// As a rectangle whose corners meet; one that is shorter than wide is a circle.
Contour makeSlot(std::span<const double> n)
{
    const double width = n[1], length = std::max(n[0], width);
    const double radius = 0.5 * width, way = 0.5 * length - radius;
    Chain chain;
    chain.arc({way, 0.0}, radius, -0.25 * kTurn, 0.25 * kTurn);
    chain.line({way, radius}, {-way, radius});
    chain.arc({-way, 0.0}, radius, 0.25 * kTurn, 0.75 * kTurn);
    chain.line({-way, -radius}, {way, -radius});
    return chain.closed();
}

FigureNumber length(const char *key, const char *label, double standard, double least = kLeast)
{
    return {key, label, FigureNumber::Unit::Length, standard, least, kMost};
}

FigureNumber count(const char *key, const char *label, double standard)
{
    return {key, label, FigureNumber::Unit::Count, standard, 3.0, kSides};
}

/// Which of its numbers is a width, a height; −1: none is by itself.
struct SizeNumbers
{
    int width = 0, height = 0;
};

SizeNumbers sizeNumbers(const Figure &figure)
{
    const bool isRound =
        figure.kind == "circle" || figure.kind == "polygon" || figure.kind == "star";
    return {0, isRound ? 0 : 1};
}

} // namespace

std::span<const FigureKind> figureKinds()
{
    static const FigureKind kKinds[] = {
        {"circle",
         QT_TRANSLATE_NOOP("Figure", "Circle"),
         {length("diameter", QT_TRANSLATE_NOOP("Figure", "Diameter"), 40.0)},
         makeCircle},
        {"ellipse",
         QT_TRANSLATE_NOOP("Figure", "Ellipse"),
         {length("width", QT_TRANSLATE_NOOP("Figure", "Width"), 60.0),
          length("height", QT_TRANSLATE_NOOP("Figure", "Height"), 40.0)},
         makeEllipse},
        {"rectangle",
         QT_TRANSLATE_NOOP("Figure", "Rectangle"),
         {length("width", QT_TRANSLATE_NOOP("Figure", "Width"), 60.0),
          length("height", QT_TRANSLATE_NOOP("Figure", "Height"), 40.0),
          length("corner", QT_TRANSLATE_NOOP("Figure", "Corner radius"), 0.0, 0.0)},
         makeRectangle},
        {"polygon",
         QT_TRANSLATE_NOOP("Figure", "Polygon"),
         {length("diameter", QT_TRANSLATE_NOOP("Figure", "Diameter"), 50.0),
          count("sides", QT_TRANSLATE_NOOP("Figure", "Sides"), 6.0)},
         makePolygon},
        {"star",
         QT_TRANSLATE_NOOP("Figure", "Star"),
         {length("diameter", QT_TRANSLATE_NOOP("Figure", "Diameter"), 60.0),
          length("inner", QT_TRANSLATE_NOOP("Figure", "Inner diameter"), 30.0),
          count("tips", QT_TRANSLATE_NOOP("Figure", "Tips"), 5.0)},
         makeStar},
        {"slot",
         QT_TRANSLATE_NOOP("Figure", "Slot"),
         {length("length", QT_TRANSLATE_NOOP("Figure", "Length"), 40.0),
          length("width", QT_TRANSLATE_NOOP("Figure", "Width"), 10.0)},
         makeSlot},
    };
    return kKinds;
}

const FigureKind *figureKind(std::string_view key)
{
    for (const FigureKind &kind : figureKinds())
        if (key == kind.key)
            return &kind;
    return nullptr;
}

Figure newFigure(const FigureKind &kind)
{
    Figure figure{kind.key, {}};
    for (const FigureNumber &number : kind.numbers)
        figure.numbers.push_back(number.standard);
    return figure;
}

Vec2 sizeOf(const Figure &figure)
{
    const SizeNumbers of = sizeNumbers(figure);
    return {figure.numbers[static_cast<std::size_t>(of.width)],
            figure.numbers[static_cast<std::size_t>(of.height)]};
}

Figure sized(Figure figure, const Vec2 &size)
{
    const FigureKind *kind = figureKind(figure.kind);
    const SizeNumbers of = sizeNumbers(figure);
    if (!kind || figure.numbers.size() != kind->numbers.size())
        return figure;
    const Vec2 was = sizeOf(figure);
    const auto set = [&](int index, double value) {
        const FigureNumber &number = kind->numbers[static_cast<std::size_t>(index)];
        figure.numbers[static_cast<std::size_t>(index)] =
            std::clamp(value, number.least, number.most);
    };
    if (of.width == of.height) {
        set(of.width, size.maxCoeff());
        // Inner corners keep their ratio.
        if (figure.kind == "star" && was.x() > 0.0)
            set(1, figure.numbers[1] * figure.numbers[0] / was.x());
        return figure;
    }
    set(of.width, size.x());
    set(of.height, size.y());
    return figure;
}

namespace {

/// As Contour::fromPoints() wants them. Errors  those of contourOf() but its own.
Result<std::vector<Vec2>> figurePoints(const Figure &figure)
{
    const FigureKind *kind = figureKind(figure.kind);
    if (!kind)
        return failure(ErrorCode::BadValue, "kind", {figure.kind, "a kind of figure"});
    for (std::size_t i = 0; i < kind->numbers.size(); ++i) {
        const FigureNumber &number = kind->numbers[i];
        const double value = i < figure.numbers.size() ? figure.numbers[i] : std::nan("");
        const bool isWhole = number.unit != FigureNumber::Unit::Count || value == std::round(value);
        if (!(value >= number.least && value <= number.most) || !isWhole)
            return failure(ErrorCode::BadValue, number.key, {std::to_string(value), ""});
    }
    const Contour made = kind->make(figure.numbers);
    const Eigen::Rotation2Dd turn(figure.turn);
    std::vector<Vec2> points = made.points();
    for (Vec2 &p : points)
        p = figure.centre + (figure.turn == 0.0 ? p : Vec2(turn * p));
    return points;
}

} // namespace

Result<Contour> contourOf(const Figure &figure)
{
    Result<std::vector<Vec2>> points = figurePoints(figure);
    return points ? Contour::fromPoints(*std::move(points)) : tl::unexpected(points.error());
}

bool isOf(const Contour &contour, const Figure &figure)
{
    // Points are compared, and no contour is made, which may fail: what is a figure stays one.
    const Result<std::vector<Vec2>> points = figurePoints(figure);
    if (!points || points->size() != contour.points().size())
        return false;
    const auto isSame = [&points](const Contour &other) {
        for (std::size_t i = 0; i < points->size(); ++i)
            if (!((other.points()[i] - (*points)[i]).norm() <= kSameFigure))
                return false;
        return true;
    };
    return isSame(contour) || isSame(contour.reversed());
}

std::optional<Figure> mapped(const Figure &figure, const Eigen::Matrix2d &matrix, const Vec2 &about)
{
    // Along the figure's own axes.
    const Eigen::Matrix2d axes = Eigen::Rotation2Dd(figure.turn).toRotationMatrix();
    const Eigen::Matrix2d own = matrix * axes;
    const Vec2 x = own.col(0), y = own.col(1);
    const double scaleX = x.norm(), scaleY = y.norm();
    if (!(scaleX > 0.0) || !(cross(x, y) > 0.0) || std::abs(x.dot(y)) > kNoLean * scaleX * scaleY)
        return std::nullopt;
    Figure next = figure;
    next.centre = about + matrix * (figure.centre - about);
    next.turn = std::atan2(x.y(), x.x());
    if (std::abs(scaleX - scaleY) <= kNoLean * scaleX) {
        const FigureKind *kind = figureKind(figure.kind);
        for (std::size_t i = 0; kind && i < next.numbers.size(); ++i)
            if (kind->numbers[i].unit == FigureNumber::Unit::Length)
                next.numbers[i] *= scaleX;
        return next;
    }
    if (figure.kind == "circle") {
        next.kind = "ellipse";
        next.numbers = {scaleX * figure.numbers[0], scaleY * figure.numbers[0]};
        return next;
    }
    const bool isBoxed =
        figure.kind == "ellipse" || (figure.kind == "rectangle" && figure.numbers[2] == 0.0);
    if (!isBoxed)
        return std::nullopt;
    next.numbers[0] *= scaleX;
    next.numbers[1] *= scaleY;
    return next;
}

} // namespace fff
