// Compartments for a drawer, on a grid: all walls of one direction are one wall, again and again.
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

// As it is drawn, mm. Walls reach so far beyond the last one that they cross.
constexpr double kDrawerWidth = 240.0, kDrawerDepth = 180.0, kDrawerBeyond = 8.0;

/// Higher than the walls across all along, so that each goes down over those.
Contour drawerSide()
{
    return flowingBothSides(
        {{{90, 0}, true}, {{90, 42}, true}, {{88.5, 50}}, {{84, 54}}, {{58, 56.2}}, {{0, 58}}});
}

/// Dips, for a hand that reaches in.
Contour drawerWall()
{
    return flowingBothSides({{{120, 0}, true},
                             {{120, 36}, true},
                             {{118, 46}},
                             {{111, 50}},
                             {{95, 47.5}},
                             {{62, 40}},
                             {{0, 36}}});
}

} // namespace

void drawerOrganiser(const std::string &folder)
{
    Maker maker(3.0);
    maker.show({.name = "width",
                .typed = "240 mm",
                .least = 150,
                .most = 360,
                .step = 1,
                .note = "Of the drawer, inside"});
    maker.show({.name = "depth",
                .typed = "180 mm",
                .least = 120,
                .most = 300,
                .step = 1,
                .note = "Of the drawer, inside"});
    maker.show({.name = "height",
                .typed = "58 mm",
                .least = 30,
                .most = 90,
                .step = 1,
                .note = "Of the highest wall"});
    maker.show({.name = "columns", .kind = ValueKind::Count, .typed = "4", .least = 1, .most = 6});
    maker.show({.name = "rows", .kind = ValueKind::Count, .typed = "2", .least = 1, .most = 5});
    maker.preset("Cutlery", {});
    maker.preset("Pens", {{"width", "160 mm"},
                          {"depth", "240 mm"},
                          {"height", "40 mm"},
                          {"columns", "3"},
                          {"rows", "1"}});
    maker.preset("Screws", {{"width", "300 mm"},
                            {"depth", "240 mm"},
                            {"height", "45 mm"},
                            {"columns", "6"},
                            {"rows", "5"}});
    maker.derive("column", ValueKind::Length, "(width - 16 mm)/columns", "From wall to wall");
    maker.derive("row", ValueKind::Length, "(depth - 16 mm)/rows", "From wall to wall");

    const SectionRef side =
        maker.add("Side", facingRight(kDrawerBeyond - kDrawerWidth / 2.0), drawerSide());
    const SectionRef wall =
        maker.add("Wall", facingFront(kDrawerDepth / 2.0 - kDrawerBeyond), drawerWall());
    const OperationId sides =
        maker.apply("array", "Columns", {{"sections", {side}}},
                    {{"count", 5.0}, {"x", (kDrawerWidth - 16.0) / 4.0}, {"z", 0.0}});
    const OperationId walls = maker.apply("array", "Rows", {{"sections", {wall}}},
                                          {{"count", 3.0}, {"z", -(kDrawerDepth - 16.0) / 2.0}});

    maker.drive(side, "width", "depth");
    maker.drive(side, "height", "height");
    maker.drive(side, "x", "8 mm - width/2");
    maker.drive(side, "y", "height/2");
    maker.drive(sides, "count", "columns + 1");
    maker.drive(sides, "x", "column");
    maker.drive(wall, "width", "width");
    maker.drive(wall, "height", "height*50/58");
    maker.drive(wall, "y", "height*25/58");
    maker.drive(wall, "z", "depth/2 - 8 mm");
    maker.drive(walls, "count", "rows + 1");
    maker.drive(walls, "z", "-row");
    maker.write(folder, "drawer_organiser");
}

} // namespace fff::samples
