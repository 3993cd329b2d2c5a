#include "core/io/svg_shapes.h"

#include "core/geometry/bezier.h"
#include "core/io/loaded_document.h"

#include <QtCore/QCoreApplication>
#include <algorithm>
#include <cmath>

namespace fff::io {

namespace {

constexpr double kQuarter = 1.5707963267948966; // radians

/// A straight edge, unless it would have no length.
void lineTo(std::vector<Vec2> &points, const Vec2 &to)
{
    if (points.empty()) {
        points.push_back(to);
    } else if (points.back() != to) {
        const CubicBezier curve = CubicBezier::line(points.back(), to);
        points.insert(points.end(), {curve.p1, curve.p2, to});
    }
}

std::vector<SvgSubpath> rectangle(SvgSource &source, const pugi::xml_node &node, const Vec2 &all)
{
    const Vec2 at(source.length(node, "x", all.x()), source.length(node, "y", all.y()));
    const Vec2 size(source.length(node, "width", all.x()), source.length(node, "height", all.y()));
    if (!(size.minCoeff() > 0.0))
        return {};
    double rx = source.length(node, "rx", all.x(), -1.0),
           ry = source.length(node, "ry", all.y(), -1.0);
    if (rx < 0.0)
        rx = std::max(ry, 0.0);
    if (ry < 0.0)
        ry = rx;
    const Vec2 radii(std::min(rx, 0.5 * size.x()), std::min(ry, 0.5 * size.y()));
    SvgSubpath path;
    path.isClosed = true;
    const Vec2 right(size.x(), 0.0), down(0.0, size.y());
    const auto line = [&path](const Vec2 &to) { lineTo(path.points, to); };
    const bool isRound = radii.minCoeff() > 0.0;
    const Vec2 inset = isRound ? radii : Vec2(Vec2::Zero());
    const Vec2 corners[] = {at + right, at + right + down, at + down, at};
    const Vec2 inwards[] = {{-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}};
    line(at + Vec2(inset.x(), 0.0));
    for (int i = 0; i < 4; ++i) {
        const Vec2 centre = corners[i] + inwards[i].cwiseProduct(inset);
        const double from = (i - 1) * kQuarter;
        const Vec2 begin = centre + inset.cwiseProduct(Vec2(std::cos(from), std::sin(from)));
        line(isRound ? begin : corners[i]);
        if (isRound)
            appendArc(centre, radii, 0.0, from, kQuarter, path.points);
    }
    path.points.back() = path.points.front();
    return {path};
}

std::vector<SvgSubpath> ellipse(SvgSource &source, const pugi::xml_node &node, const Vec2 &all)
{
    const double diagonal = all.norm() / std::sqrt(2.0);
    const Vec2 centre(source.length(node, "cx", all.x()), source.length(node, "cy", all.y()));
    Vec2 radii = Vec2::Constant(source.length(node, "r", diagonal));
    if (localName(node) == "ellipse") {
        const double rx = source.length(node, "rx", all.x(), -1.0),
                     ry = source.length(node, "ry", all.y(), -1.0);
        radii = {rx < 0.0 ? ry : rx, ry < 0.0 ? rx : ry};
    }
    if (!(radii.minCoeff() > 0.0))
        return {};
    SvgSubpath path{{centre + Vec2(radii.x(), 0.0)}, true};
    appendArc(centre, radii, 0.0, 0.0, 4.0 * kQuarter, path.points);
    path.points.back() = path.points.front();
    return {path};
}

std::vector<SvgSubpath> corners(SvgSource &source, const pugi::xml_node &node, bool isClosed)
{
    SvgNumbers numbers(node.attribute("points").value());
    SvgSubpath path;
    path.isClosed = isClosed;
    while (!numbers.isAtEnd()) {
        const std::optional<double> x = numbers.number();
        const std::optional<double> y = x ? numbers.number() : std::nullopt;
        if (!y) {
            source.fail(ErrorCode::BadValue, node,
                        {quoted(numbers.rest()), QT_TRANSLATE_NOOP("Error", "pairs of numbers")});
            return {};
        }
        lineTo(path.points, {*x, *y});
    }
    if (isClosed && !path.points.empty())
        lineTo(path.points, Vec2(path.points.front()));
    return path.points.size() < 4 ? std::vector<SvgSubpath>() : std::vector<SvgSubpath>{path};
}

} // namespace

std::vector<SvgSubpath> svgShape(SvgSource &source, const pugi::xml_node &node, const Vec2 &all)
{
    const std::string name = localName(node);
    if (name == "rect")
        return rectangle(source, node, all);
    if (name == "circle" || name == "ellipse")
        return ellipse(source, node, all);
    if (name == "polyline" || name == "polygon")
        return corners(source, node, name == "polygon");
    if (name == "line") {
        const Vec2 from(source.length(node, "x1", all.x()), source.length(node, "y1", all.y()));
        const Vec2 to(source.length(node, "x2", all.x()), source.length(node, "y2", all.y()));
        const CubicBezier curve = CubicBezier::line(from, to);
        return from == to ? std::vector<SvgSubpath>()
                          : std::vector<SvgSubpath>{{{from, curve.p1, curve.p2, to}, false}};
    }
    const std::string data = source.property(node, "d");
    if (data.empty() || data == "none")
        return {};
    SvgPathData path = svgPath(data);
    if (!path.isWhole)
        source.fail(ErrorCode::BadValue, node,
                    {quoted(path.rest), QT_TRANSLATE_NOOP("Error", "path data")});
    return std::move(path.subpaths);
}

} // namespace fff::io
