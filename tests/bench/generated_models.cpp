#include "tests/bench/generated_models.h"

#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/model/operation_edits.h"
#include "core/operations/operation_kind.h"

#include <charconv>
#include <cmath>

namespace fff::bench {

namespace {

constexpr double kHeight = 40.0;     // mm, of every strip
constexpr double kRibPitch = 10.0;   // mm
constexpr double kStripPitch = 20.0; // mm

ShapePointer strip(double length)
{
    return *Shape::make(
        *Contour::fromPolygon({{0, 0}, {length, 0}, {length, kHeight}, {0, kHeight}}));
}

/// A closed curve through the points.
Contour smooth(const std::vector<Vec2> &points)
{
    const std::size_t n = points.size();
    const auto at = [&](std::size_t i) { return points[(i + n) % n]; };
    std::vector<Vec2> controls;
    for (std::size_t i = 0; i < n; ++i) {
        controls.push_back(at(i));
        controls.push_back(at(i) + (at(i + 1) - at(i + n - 1)) / 6.0);
        controls.push_back(at(i + 1) - (at(i + 2) - at(i)) / 6.0);
    }
    return *Contour::fromPoints(std::move(controls));
}

/// Along +X at this corner.
Frame alongX(double x, double z)
{
    return {{x, 0, z}, Vec3::UnitX(), Vec3::UnitY()};
}

/// Along −Z at this corner.
Frame alongZ(double x, double z)
{
    return {{x, 0, z}, -Vec3::UnitZ(), Vec3::UnitY()};
}

void add(Document &document, const ShapePointer &shape, const Frame &frame)
{
    NewSection section;
    section.name = "Section " + std::to_string(document.sections.size() + 1);
    section.shape = shape;
    section.frame = frame;
    document = *addSection(std::move(document), std::move(section));
}

void print(std::string &out, std::initializer_list<double> numbers)
{
    char buffer[32];
    for (const double number : numbers) {
        const auto end = std::to_chars(buffer, buffer + sizeof buffer, number + 0.0,
                                       std::chars_format::general, 6);
        out.append(" ").append(buffer, end.ptr);
    }
    out += '\n';
}

} // namespace

Document repeated(const char *kind, bool scaled, bool branches)
{
    constexpr int kReplicas = 50;
    constexpr double kLength = 600.0; // mm
    Document document = newDocument();
    std::vector<Vec2> outline;
    for (int i = 0; i <= 12; ++i)
        outline.push_back({kLength * i / 12.0, 60.0 + 12.0 * std::sin(0.9 * i)});
    for (int i = 12; i >= 0; --i)
        outline.push_back({kLength * i / 12.0, 120.0 + 10.0 * std::cos(0.7 * i)});
    add(document, *Shape::make(smooth(outline)), alongX(0.0, 0.0));
    const Contour rib = *Contour::fromPoints({{-30, 20},
                                              {-34, 60},
                                              {-18, 92},
                                              {0, 95},
                                              {18, 92},
                                              {34, 60},
                                              {30, 20},
                                              {12, 50},
                                              {-12, 50}});
    const Frame across{{200, 0, 0}, Vec3::UnitZ(), Vec3::UnitY()};
    add(document, *Shape::make(rib), across);
    for (const double z : {-24.0, 24.0}) {
        if (!branches)
            continue;
        add(document, *Shape::make(*Contour::fromPolygon({{-12, 0}, {-12, 24}, {12, 24}, {12, 0}})),
            {{200, 30, z}, Vec3::UnitX(), Vec3::UnitY()});
    }
    Operation operation = newOperation(*operationKind(kind));
    operation.name = kind;
    operation.inputs["section"] = {{SectionRef(document.sections[1]->id), "Rib"}};
    operation.inputs["along"] = {{SectionRef(document.sections[0]->id), "Spine"}};
    operation.parameters["count"] = kReplicas + 1.0;
    operation.parameters["wholeBranch"] = branches;
    if (operation.kind == "linear")
        operation.parameters["side"] = std::string("both");
    if (scaled)
        operation.parameters["scale"] = std::string("thickness");
    return addOperation(std::move(document), std::move(operation));
}

Document comb(int sections)
{
    Document document = newDocument();
    add(document, strip(kRibPitch * sections), alongX(0, 0));
    const ShapePointer rib = strip(60.0);
    for (int i = 1; i < sections; ++i)
        add(document, rib, alongZ(kRibPitch * i, 30.0));
    return document;
}

Document jointedComb(int sections)
{
    Document document = newDocument();
    // Every tenth rib has a corner above and below it, which stand out by turns.
    constexpr int kRibsAnEdge = 10;
    const int edges = (sections + kRibsAnEdge - 1) / kRibsAnEdge;
    Polygon outline;
    for (int i = 0; i <= edges; ++i)
        outline.push_back({kRibPitch * kRibsAnEdge * i, i % 2 == 0 ? 0.0 : -1.0});
    for (int i = edges; i >= 0; --i)
        outline.push_back({kRibPitch * kRibsAnEdge * i, kHeight + (i % 2 == 0 ? 0.0 : 1.0)});
    add(document, *Shape::make(*Contour::fromPolygon(outline)), alongX(0, 0));
    const ShapePointer rib = *Shape::make(
        *Contour::fromPolygon({{0, 0.5 * kHeight}, {60, 0.5 * kHeight}, {60, 60}, {0, 60}}));
    for (int i = 1; i < sections; ++i)
        add(document, rib, alongZ(kRibPitch * i, 30.0));
    return document;
}

Document lattice(int n)
{
    Document document = newDocument();
    const ShapePointer shape = strip(kStripPitch * (n + 1));
    for (int i = 1; i <= n; ++i)
        add(document, shape, alongX(0, -kStripPitch * i));
    for (int i = 1; i <= n; ++i)
        add(document, shape, alongZ(kStripPitch * i, 0));
    return document;
}

Document crates(int n, int reach)
{
    Document document = newDocument();
    const ShapePointer shape = strip(kStripPitch * (reach + 1));
    const double pitch = kStripPitch * (reach + 2);
    // As many crates of reach × reach as make n² joints.
    for (int column = 0; column < n / reach; ++column) {
        for (int row = 0; row < n / reach; ++row) {
            for (int i = 1; i <= reach; ++i)
                add(document, shape, alongX(pitch * column, -pitch * row - kStripPitch * i));
            for (int i = 1; i <= reach; ++i)
                add(document, shape, alongZ(pitch * column + kStripPitch * i, -pitch * row));
        }
    }
    return document;
}

Document latticeWithShort(int n)
{
    Document document = lattice(n);
    // Between two strips that run along Z, across the first two that run along X.
    add(document, strip(1.9 * kStripPitch), alongZ(1.5 * kStripPitch, -0.55 * kStripPitch));
    return document;
}

std::string flatfabText(const Document &document)
{
    std::string out =
        "HeaderParameters 1\nFlatFab " + std::to_string(document.sections.size()) + "\n";
    const double unit = 1.0 / kPaperUnit;
    const auto vector = [&](const char *name, const Vec3 &v, double scale) {
        out += name;
        print(out, {scale * v.x(), scale * v.y(), scale * v.z()});
    };
    for (const SectionPointer &section : document.sections) {
        const Frame &frame = section->frame;
        vector("P", frame.origin, unit);
        vector("T", frame.x, 1.0);
        vector("N", frame.normal(), 1.0);
        vector("B", frame.y, 1.0);
        std::vector<Vec2> points = section->shape->contour().points();
        points.push_back(points.front());
        out += "BoundaryCurves 1\nSketchPoints 0\nBezierPoints " + std::to_string(points.size()) +
               "\n";
        for (const Vec2 &p : points)
            print(out, {unit * p.x(), unit * p.y()});
    }
    return out;
}

} // namespace fff::bench
