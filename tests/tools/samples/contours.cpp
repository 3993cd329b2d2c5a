#include "tests/tools/samples/contours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fff::samples {

namespace {

constexpr double kQuarter = 0.5522847498; // of a circle by one cubic

Contour contourOf(std::vector<Vec2> points)
{
    auto contour = Contour::fromPoints(std::move(points));
    if (!contour) {
        std::fprintf(stderr, "a contour could not be made\n");
        std::exit(1);
    }
    return *std::move(contour);
}

} // namespace

Contour through(const std::vector<Corner> &corners)
{
    const std::size_t n = corners.size();
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < n; ++i) {
        const Corner &before = corners[(i + n - 1) % n], &a = corners[i], &b = corners[(i + 1) % n],
                     &after = corners[(i + 2) % n];
        const Vec2 atA = a.isSharp ? Vec2(b.at - a.at) : Vec2((b.at - before.at) / 2.0);
        const Vec2 atB = b.isSharp ? Vec2(b.at - a.at) : Vec2((after.at - a.at) / 2.0);
        points.push_back(a.at);
        points.push_back(a.at + atA / 3.0);
        points.push_back(b.at - atB / 3.0);
    }
    return contourOf(std::move(points));
}

Contour flowing(const std::vector<Corner> &corners)
{
    const std::size_t n = corners.size();
    // The direction in which it goes through a smooth point.
    const auto wayAt = [&](std::size_t i) {
        const Vec2 in = corners[i].at - corners[(i + n - 1) % n].at,
                   out = corners[(i + 1) % n].at - corners[i].at;
        return Vec2(in / in.squaredNorm() + out / out.squaredNorm()).normalized();
    };
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Corner &a = corners[i], &b = corners[next];
        const Vec2 chord = b.at - a.at;
        const double third = chord.norm() / 3.0;
        const Vec2 straight = chord.normalized();
        points.push_back(a.at);
        points.push_back(a.at + third * (a.isSharp ? straight : wayAt(i)));
        points.push_back(b.at - third * (b.isSharp ? straight : wayAt(next)));
    }
    return contourOf(std::move(points));
}

Contour flowingBothSides(const std::vector<Corner> &right)
{
    std::vector<Corner> all = right;
    for (std::size_t i = right.size(); i-- > 0;)
        if (right[i].at.x() != 0.0)
            all.push_back({{-right[i].at.x(), right[i].at.y()}, right[i].isSharp});
    return flowing(all);
}

Contour rounded(const std::vector<RoundCorner> &corners)
{
    const std::size_t n = corners.size();
    std::vector<Vec2> ends, handles; // of each corner's arc: where it begins and ends
    for (std::size_t i = 0; i < n; ++i) {
        const RoundCorner &corner = corners[i];
        const Vec2 in = (corner.at - corners[(i + n - 1) % n].at).normalized(),
                   out = (corners[(i + 1) % n].at - corner.at).normalized();
        const double turn = std::acos(std::clamp(in.dot(out), -1.0, 1.0));
        const double cut = corner.radius * std::tan(turn / 2.0),
                     handle = corner.radius * 4.0 / 3.0 * std::tan(turn / 4.0);
        const Vec2 from = corner.at - cut * in, to = corner.at + cut * out;
        ends.insert(ends.end(), {from, to});
        handles.insert(handles.end(), {from + handle * in, to - handle * out});
    }
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 to = ends[2 * i + 1], next = ends[(2 * i + 2) % (2 * n)];
        if (corners[i].radius > 0.0)
            points.insert(points.end(), {ends[2 * i], handles[2 * i], handles[2 * i + 1]});
        points.insert(points.end(), {to, to + (next - to) / 3.0, next + (to - next) / 3.0});
    }
    return contourOf(std::move(points));
}

Contour roundedBothSides(std::vector<RoundCorner> right)
{
    for (std::size_t i = right.size(); i-- > 0;)
        if (right[i].at.x() != 0.0)
            right.push_back({{-right[i].at.x(), right[i].at.y()}, right[i].radius});
    return rounded(right);
}

Contour strip(double from, double to, double height, double radius)
{
    return rounded({{{from, 0}}, {{to, 0}}, {{to, height}, radius}, {{from, height}, radius}});
}

Contour ellipse(const Vec2 &middle, double rx, double ry)
{
    constexpr double k = kQuarter;
    const auto at = [&](double x, double y) { return Vec2(middle + Vec2(rx * x, ry * y)); };
    return contourOf({at(1, 0), at(1, k), at(k, 1), at(0, 1), at(-k, 1), at(-1, k), at(-1, 0),
                      at(-1, -k), at(-k, -1), at(0, -1), at(k, -1), at(1, -k)});
}

Contour circle(const Vec2 &middle, double radius)
{
    return ellipse(middle, radius, radius);
}

Contour roundedRectangle(const Vec2 &middle, double width, double height, double radius)
{
    constexpr double k = kQuarter;
    const double a = width / 2.0 - radius, b = height / 2.0 - radius;
    std::vector<Vec2> points;
    const Vec2 corners[] = {{a, -b}, {a, b}, {-a, b}, {-a, -b}};
    Vec2 out(0.0, -radius); // from the corner's middle to where its arc begins
    for (int i = 0; i < 4; ++i) {
        const Vec2 along(-out.y(), out.x()), from = middle + corners[i] + out,
                                             to = middle + corners[i] + along,
                                             next = middle + corners[(i + 1) % 4] + along;
        points.insert(points.end(), {from, from + k * along, to + k * out, to,
                                     to + (next - to) / 3.0, next + (to - next) / 3.0});
        out = along;
    }
    return contourOf(std::move(points));
}

} // namespace fff::samples
