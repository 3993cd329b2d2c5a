// Hand-made sections for the tests of joints: plates standing, lying and oblique.
#pragma once

#include "core/model/edits.h"
#include "core/operations/evaluate.h"

#include <Eigen/Geometry>

namespace fff::test {

inline ShapePointer polygonShape(const Polygon &outer, const std::vector<Polygon> &holes = {})
{
    std::vector<Contour> contours;
    for (const Polygon &hole : holes)
        contours.push_back(*Contour::fromPolygon(hole));
    return *Shape::make(*Contour::fromPolygon(outer), contours);
}

inline Polygon rectangle(double x0, double y0, double x1, double y1)
{
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

inline ShapePointer plateOf(double x0, double y0, double x1, double y1)
{
    return polygonShape(rectangle(x0, y0, x1, y1));
}

/// Standing in the plane z = `at`, seen from the front: x to the right, y up.
inline Frame front(double at = 0.0)
{
    return {{0, 0, at}, Vec3::UnitX(), Vec3::UnitY()};
}
/// Standing in the plane x = `at`: its x runs to the back (−Z), y up.
inline Frame side(double at = 0.0)
{
    return {{at, 0, 0}, -Vec3::UnitZ(), Vec3::UnitY()};
}
/// Standing, turned about the vertical by `angle` from front.
inline Frame turned(double angle)
{
    return {Vec3::Zero(), Vec3(std::cos(angle), 0, -std::sin(angle)), Vec3::UnitY()};
}

inline Document withSection(Document document, ShapePointer shape, const Frame &frame)
{
    NewSection section;
    section.shape = std::move(shape);
    section.frame = frame;
    return *addSection(std::move(document), std::move(section));
}

/// One more plate, 100 x 80 about the middle of the plane z.
inline Document withPlate(Document document, double z = 0.0)
{
    return withSection(std::move(document), plateOf(-50, -40, 50, 40), front(z));
}

/// All parts are cut from sheets of this size.
inline Document onSheets(Document document, const Vec2 &size)
{
    Stock stock = *document.stocks.front();
    stock.sheet = size;
    return *setStock(std::move(document), stock);
}

inline Model twoSections(ShapePointer a, const Frame &frameA, ShapePointer b, const Frame &frameB)
{
    return evaluate(
        withSection(withSection(newDocument(), std::move(a), frameA), std::move(b), frameB));
}

} // namespace fff::test
