// Small models in which all that takes booleans happens: contours to be mended when they are read,
// slits that are cut the general way, tabs, forms, marks, and operations that cut.
#pragma once

#include "core/model/joint_override.h"
#include "core/model/marks.h"
#include "tests/core/operations/operation_models.h"

#include <string>
#include <vector>

namespace fff::test {

struct NamedDocument
{
    std::string name;
    Document document;
};

inline MarkPointer lineMark(const Polygon &line, Mark::Kind kind)
{
    return std::make_shared<const Mark>(Mark{kind, {*CurvePath::fromLine(line)}});
}

/// Drawn across itself, with holes over each other and over the edge.
inline Document toBeMended()
{
    Document document = newDocument();
    add(document, "Knot", shapeOf(polygonContour({{0, 0}, {60, 0}, {60, 40}, {20, -15}, {0, 40}})),
        frontFrame());
    add(document, "Sieve",
        shapeOf(circle({0, 30}, 30),
                {circle({-5, 30}, 6), circle({4, 30}, 6), circle({28, 30}, 6)}),
        sideFrame({15, 0, 0}));
    return document;
}

/// Slits into a hole and in forms, tabs, and lines that leave their section.
inline Document joined()
{
    Document document = newDocument();
    Stock milled = *document.stocks.front();
    milled.slitEnd = SlitEnd::Dogbone;
    milled.toolDiameter = 2.0;
    document = setStock(std::move(document), milled).value();
    const SectionId body =
        add(document, "Body", shapeOf(circle({0, 40}, 40), {circle({0, 40}, 9)}), frontFrame());
    add(document, "Wing", shapeOf(circle({0, 40}, 30)), sideFrame({3, 0, 0}));
    add(document, "Fin", shapeOf(circle({0, 40}, 12)), sideFrame({-37, 0, 0}));
    const SectionId shelf =
        add(document, "Shelf", shapeOf(polygonContour(rectangleAt(0, 10, 60, 40))),
            sideFrame({70, 0, 0}));
    const SectionId wall =
        add(document, "Wall", shapeOf(polygonContour(rectangleAt(71.5, 0, 40, 60))),
            frontFrame({0, 0, 30}));
    JointOverride wanted;
    wanted.a = SectionRef(shelf);
    wanted.b = SectionRef(wall);
    wanted.kind = JointKind::Tabs;
    document = setJointOverride(std::move(document), wanted).value();
    document =
        addMark(std::move(document), body, lineMark({{-60, 60}, {60, 60}}, Mark::Kind::Engraved))
            .value();
    return addMark(std::move(document), body, lineMark({{-30, 20}, {-60, 0}}, Mark::Kind::Scored))
        .value();
}

inline Document divided(const char *edge, double clearance)
{
    Document document = newDocument();
    std::mt19937 random(5);
    const SectionId panel = add(document, "Panel", shapeOf(blob(random, 9, 70)), frontFrame());
    Operation grid = operation("grid", {{"section", {panel}}},
                               {{"fitSheet", false},
                                {"cellWidth", 50.0},
                                {"cellHeight", 50.0},
                                {"edge", std::string(edge)},
                                {"connectorSize", 8.0},
                                {"clearance", clearance}});
    grid.name = "Tiles";
    add(document, std::move(grid));
    return document;
}

/// A section across a mirror, one that is turned round, a gear, and a row of scaled copies.
inline Document repeated()
{
    FishBones bones;
    Operation row = operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                              {{"scale", std::string("thickness")}, {"count", 4.0}});
    row.name = "Ribs";
    add(bones.document, std::move(row));
    const SectionId wheel =
        add(bones.document, "Wheel", shapeOf(circle({0, 30}, 25)), frontFrame({100, 20, 40}));
    Operation gear = operation("radial", {{"section", {wheel}}}, {{"kind", std::string("sector")}});
    gear.name = "Gear";
    add(bones.document, std::move(gear));
    std::mt19937 random(3);
    const SectionId face =
        add(bones.document, "Face", shapeOf(blob(random, 9, 40)), frontFrame({5, 60, 80}));
    Operation mirror = operation("mirror", {{"sections", {face}}},
                                 {{"what", std::string("selection")}, {"plane", std::string("x")}});
    mirror.name = "Twin";
    add(bones.document, std::move(mirror));
    return bones.document;
}

inline std::vector<NamedDocument> faultModels()
{
    return {{"to be mended", toBeMended()},
            {"joined", joined()},
            {"divided straight", divided("straight", 0.2)},
            {"divided as a jigsaw", divided("jigsaw", 0.2)},
            {"repeated", repeated()}};
}

} // namespace fff::test
