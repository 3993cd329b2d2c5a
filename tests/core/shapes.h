// One suite of shapes for all tests, plain and nasty. Contours in mm.
#pragma once

#include "core/geometry/contour.h"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace fff::test {

struct NamedContour
{
    const char *name;
    Contour contour;
};

inline Contour polygonContour(const Polygon &polygon)
{
    return Contour::fromPolygon(polygon).value();
}

inline Polygon rectangleAt(double x, double y, double width, double height)
{
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// Turned by `angle` about its middle.
inline Polygon turnedRectangle(const Vec2 &middle, double width, double height, double angle)
{
    const Vec2 u(std::cos(angle), std::sin(angle));
    const Vec2 a = 0.5 * width * u, b = 0.5 * height * perpendicular(u);
    return {middle - a - b, middle + a - b, middle + a + b, middle - a + b};
}

/// Four arcs, off a true circle by 0.03 % of the radius.
inline Contour circle(const Vec2 &middle, double radius)
{
    const double h = 0.5522847498 * radius;
    const auto p = [&](double x, double y) { return Vec2(middle + Vec2(x, y)); };
    return Contour::fromPoints({p(radius, 0), p(radius, h), p(h, radius), p(0, radius),
                                p(-h, radius), p(-radius, h), p(-radius, 0), p(-radius, -h),
                                p(-h, -radius), p(0, -radius), p(h, -radius), p(radius, -h)})
        .value();
}

/// Smooth and closed through `count` points at random distances from the origin.
inline Contour blob(std::mt19937 &random, int count, double radius)
{
    std::uniform_real_distribution<double> reach(0.6 * radius, radius);
    std::vector<Vec2> through;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        through.push_back(reach(random) * Vec2(std::cos(angle), std::sin(angle)));
    }
    const auto at = [&](int i) { return through[static_cast<std::size_t>((i + count) % count)]; };
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        points.push_back(at(i));
        points.push_back(at(i) + (at(i + 1) - at(i - 1)) / 6.0);
        points.push_back(at(i + 1) - (at(i + 2) - at(i)) / 6.0);
    }
    return Contour::fromPoints(std::move(points)).value();
}

inline Contour comb(int teeth)
{
    Polygon polygon{{0.0, -10.0}, {4.0 * teeth, -10.0}};
    for (int i = teeth; i-- > 0;) {
        const double x = 4.0 * i;
        polygon.insert(polygon.end(), {{x + 4.0, 30.0}, {x + 2.0, 30.0}, {x + 2.0, 0.0}, {x, 0.0}});
    }
    return polygonContour(polygon);
}

/// Two turns of a band 4 mm wide, all curves.
inline Contour spiral()
{
    constexpr int kSteps = 16;
    const auto at = [](double turn, double inwards) {
        const double angle = 2.0 * std::numbers::pi * turn;
        return Vec2((8.0 + 10.0 * turn - inwards) * Vec2(std::cos(angle), std::sin(angle)));
    };
    const auto slope = [&](double turn, double inwards) {
        const double h = 1e-4;
        return Vec2((at(turn + h, inwards) - at(turn - h, inwards)) / (2.0 * h));
    };
    std::vector<CubicBezier> segments;
    const auto run = [&](double from, double to, double inwards) {
        const double third = (to - from) / 3.0;
        segments.push_back({at(from, inwards), at(from, inwards) + third * slope(from, inwards),
                            at(to, inwards) - third * slope(to, inwards), at(to, inwards)});
    };
    for (int i = 0; i < kSteps; ++i)
        run(2.0 * i / kSteps, 2.0 * (i + 1) / kSteps, 0.0);
    segments.push_back(CubicBezier::line(at(2.0, 0.0), at(2.0, 4.0)));
    for (int i = kSteps; i-- > 0;)
        run(2.0 * (i + 1) / kSteps, 2.0 * i / kSteps, 4.0);
    segments.push_back(CubicBezier::line(at(0.0, 4.0), at(0.0, 0.0)));
    return Contour::fromSegments(segments).value();
}

inline Contour figureEight()
{
    return Contour::fromPoints({{0, 0},
                                {20, 20},
                                {40, 10},
                                {40, 0},
                                {40, -10},
                                {20, -20},
                                {0, 0},
                                {-15, 15},
                                {-30, 10},
                                {-30, 0},
                                {-30, -10},
                                {-15, -15}})
        .value();
}

/// None of these crosses itself.
inline std::vector<NamedContour> simpleContours()
{
    std::mt19937 random(20140505);
    return {
        {"a square", polygonContour(rectangleAt(0, 0, 40, 40))},
        {"a clockwise square", polygonContour(rectangleAt(0, 0, 40, 40)).reversed()},
        {"a square with collinear points",
         polygonContour(
             {{0, 0}, {10, 0}, {20, 0}, {20.5, 0}, {40, 0}, {40, 13}, {40, 40}, {0, 40}, {0, 20}})},
        {"a square with a tiny edge",
         polygonContour({{0, 0}, {40, 0}, {40, 20}, {40.00002, 20.00001}, {40, 40}, {0, 40}})},
        {"a square with an edge below the grid",
         polygonContour({{0, 0}, {40, 0}, {40, 40}, {40.0000001, 40.0000001}, {0, 40}})},
        {"a triangle like a needle", polygonContour({{0, 0}, {200, 0.3}, {200, -0.3}})},
        {"a letter U",
         polygonContour(
             {{0, 0}, {40, 0}, {40, 40}, {30, 40}, {30, 10}, {10, 10}, {10, 40}, {0, 40}})},
        {"a comb", comb(12)},
        {"a circle", circle({5, -3}, 25)},
        {"a circle a kilometre away", circle({900000, -900000}, 25)},
        {"a blob", blob(random, 9, 40)},
        {"a blob of many segments", blob(random, 60, 40)},
        {"a spiral", spiral()},
        {"two triangles that touch at a corner",
         polygonContour({{0, 0}, {20, -10}, {20, 10}, {0, 0}, {-20, 10}, {-20, -10}})},
        {"a ring cut open along a line that is there twice", polygonContour({{0, 0},
                                                                             {40, 0},
                                                                             {40, 40},
                                                                             {0, 40},
                                                                             {0, 0},
                                                                             {10, 10},
                                                                             {10, 30},
                                                                             {30, 30},
                                                                             {30, 10},
                                                                             {10, 10}})},
        {"a heart with a handle on its tip", Contour::fromPoints({{0, -30},
                                                                  {0, -30},
                                                                  {30, -5},
                                                                  {30, 15},
                                                                  {30, 30},
                                                                  {5, 35},
                                                                  {0, 10},
                                                                  {-5, 35},
                                                                  {-30, 30},
                                                                  {-30, 15},
                                                                  {-30, -5},
                                                                  {0, -30}})
                                                 .value()},
        {"a clockwise tear with a cusp", Contour::fromPoints({{0, 30},
                                                              {0, 10},
                                                              {20, 10},
                                                              {20, -10},
                                                              {20, -30},
                                                              {-20, -30},
                                                              {-20, -10},
                                                              {-20, 10},
                                                              {0, 10}})
                                             .value()},
    };
}

inline std::vector<NamedContour> crossingContours()
{
    return {
        {"a figure eight", figureEight()},
        {"a bow tie", polygonContour({{0, 0}, {40, 30}, {40, 0}, {0, 20}})},
        {"a figure eight that crosses at a corner",
         polygonContour({{0, 0}, {20, -10}, {20, 10}, {0, 0}, {-20, -10}, {-20, 10}})},
        {"a curve with a loop", Contour::fromPoints({{0, 0},
                                                     {20, 0},
                                                     {40, 0},
                                                     {60, 0},
                                                     {55, 15},
                                                     {45, 25},
                                                     {40, 40},
                                                     {-40, 100},
                                                     {100, 100},
                                                     {20, 40},
                                                     {15, 25},
                                                     {5, 15}})
                                    .value()},
        {"a circle run round twice",
         polygonContour({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {1, 1}, {39, 1}, {39, 39}, {1, 39}})},
    };
}

} // namespace fff::test
