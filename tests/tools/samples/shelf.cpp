// A shelf for spices, or for the books of a doll: two sides, boards between them, and a crest that
// keeps them at a right angle.
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

// As it is drawn, mm.
constexpr double kShelfWidth = 240.0, kShelfHeight = 300.0, kShelfDepth = 90.0;
/// From the end of a board to the side.
constexpr double kShelfBeyond = 22.0;

/// Its back is at positive coordinates. In front it breathes a little, above it curls back.
Contour shelfSide()
{
    return flowing({{{-45, 0}, true},
                    {{-26, 0}, true},
                    {{-17, 8}},
                    {{0, 13}},
                    {{17, 8}},
                    {{26, 0}, true},
                    {{45, 0}, true},
                    {{45, 300}, true},
                    {{30, 299}},
                    {{12, 293}},
                    {{-8, 285}},
                    {{-28, 275}},
                    {{-41, 254}},
                    {{-44, 216}},
                    {{-41, 168}},
                    {{-39, 122}},
                    {{-43, 76}},
                    {{-45, 34}}});
}

/// Bowed in front.
Contour shelfBoard()
{
    return flowingBothSides({{{0, -45}},
                             {{70, -43.5}},
                             {{105, -38}},
                             {{117, -28}},
                             {{120, -12}, true},
                             {{120, 45}, true}});
}

Contour shelfCrest()
{
    return flowingBothSides({{{0, 282}},
                             {{50, 279}},
                             {{92, 273}},
                             {{107, 275}},
                             {{113, 286}},
                             {{108, 299}},
                             {{94, 304}},
                             {{70, 304}},
                             {{44, 311}},
                             {{22, 321}},
                             {{0, 325}}});
}

/// Of spices.
Load jars()
{
    Load load;
    load.name = "Jars";
    load.mass = 0.25;
    load.height = 35.0;
    load.spread = Spread::Patch;
    load.width = 60.0;
    return load;
}

} // namespace

void shelf(const std::string &folder)
{
    Maker maker(4.0);
    maker.show({.name = "width",
                .typed = "240 mm",
                .least = 160,
                .most = 360,
                .step = 5,
                .note = "Of the boards, from end to end"});
    maker.show({.name = "height",
                .typed = "300 mm",
                .least = 220,
                .most = 350,
                .step = 5,
                .note = "Of the sides; the crest stands higher"});
    maker.show({.name = "depth",
                .typed = "90 mm",
                .least = 80,
                .most = 130,
                .step = 5,
                .note = "Of the sides"});
    maker.show({.name = "boards", .kind = ValueKind::Count, .typed = "3", .least = 2, .most = 5});
    maker.preset("Three shelves", {});
    maker.preset("Four shelves", {{"height", "350 mm"}, {"boards", "4"}});
    maker.preset("Wide", {{"width", "340 mm"}, {"depth", "110 mm"}});

    const double x = -(kShelfWidth / 2.0 - kShelfBeyond);
    const SectionRef side = maker.add("Side", facingRight(x), shelfSide());
    const SectionRef board = maker.add("Board", lying(0.11 * kShelfHeight), shelfBoard());
    const SectionRef crest =
        maker.add("Crest", facingFront(-kShelfDepth / 2.0 + 15.0), shelfCrest());
    maker.put(board, {0, 9}, jars());
    maker.apply("mirror", "Other side", {{"sections", {side}}},
                {{"plane", "x"}, {"what", "selection"}});
    const OperationId boards =
        maker.apply("array", "Boards", {{"sections", {board}}},
                    {{"count", 3.0}, {"x", 0.0}, {"y", 0.69 * kShelfHeight / 2.0}, {"z", 0.0}});

    // No jar is higher than what is above it.
    maker.driveLoad("height", "min(35 mm; 0.28*height/(boards - 1))");
    maker.drive(side, "width", "depth");
    maker.drive(side, "height", "height");
    maker.drive(side, "x", "22 mm - width/2");
    maker.drive(side, "y", "height/2");
    maker.drive(side, "z", "0 mm");
    maker.drive(board, "width", "width");
    maker.drive(board, "height", "depth");
    maker.drive(board, "y", "0.11*height");
    maker.drive(board, "z", "depth/10");
    maker.drive(boards, "count", "boards");
    maker.drive(boards, "y", "0.69*height/(boards - 1)");
    const double above = maker.middleOf(crest).y() - kShelfHeight;
    maker.drive(crest, "width", "width - 16 mm");
    maker.drive(crest, "y", "height + " + millimetres(above));
    maker.drive(crest, "z", "15 mm - depth/2");
    maker.write(folder, "shelf");
}

} // namespace fff::samples
