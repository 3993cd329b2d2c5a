#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

/// 350 ml of water in a glass of 275 g.
Load fullGlass()
{
    Load glass;
    glass.name = "Glass of water";
    glass.preset = "glass";
    glass.mass = 0.625;
    glass.filled = 0.35;
    glass.height = 60.0;
    glass.spread = Spread::Patch;
    glass.width = 60.0;
    return glass;
}

/// Outwards from the glass, with a slit for each of the two discs.
Contour slenderLeg()
{
    return flowing({{{72, 0}, true}, {{92, 0}, true}, {{90, 6}},   {{78, 24}},   {{70, 46}},
                    {{67, 68}},      {{69, 88}},      {{75, 104}}, {{76, 114}},  {{70, 121}},
                    {{61, 119}},     {{54, 110}},     {{46, 103}}, {{44.5, 96}}, {{48, 90}},
                    {{54, 78}},      {{54, 62}},      {{49, 52}},  {{40, 48}},   {{27, 47}},
                    {{22, 40}},      {{27, 33}},      {{42, 31}},  {{57, 22}}});
}

Contour strongLeg()
{
    return flowing({{{54, 0}, true}, {{92, 0}, true}, {{90, 9}},   {{83, 24}},  {{83, 44}},
                    {{87, 66}},      {{84, 88}},      {{74, 104}}, {{60, 110}}, {{48, 104}},
                    {{44, 92}},      {{47, 80}},      {{53, 68}},  {{51, 54}},  {{41, 44}},
                    {{27, 40}},      {{21, 31}},      {{27, 22}},  {{42, 18}},  {{51, 9}}});
}

/// A drop that stands on its tip.
Contour drop(const Vec2 &at)
{
    return flowing({{at, true},
                    {at + Vec2(8, 17)},
                    {at + Vec2(4, 28)},
                    {at + Vec2(-4, 27)},
                    {at + Vec2(-7, 16)}});
}

Figure round(double diameter)
{
    return {.kind = "circle", .numbers = {diameter}};
}

/// An arched leg of the stands that the paper tries in acrylic (figure 17): its shank is so wide,
/// mm, where it bears most, and the hub round its slit for the shelf reaches so far above and below
/// that.
Contour archedLeg(double shank, double hub)
{
    const double h = 0.5 * shank, level = 62.0;
    return flowing({{{144, 0}, true},    {{154, 0}, true}, {{152, 10}},
                    {{138, 36}},         {{112, 60 + h}},  {{80, 70 + h}},
                    {{62, 74 + h}},      {{58, 86}},       {{63, 104}},
                    {{64, 114}},         {{56, 119}},      {{49, 110}},
                    {{44, 98}},          {{46, 86}},       {{42, level + hub + 3}},
                    {{28, level + hub}}, {{21, level}},    {{28, level - hub}},
                    {{44, level - hub}}, {{62, 66 - h}},   {{80, 70 - h}},
                    {{108, 60 - h}},     {{131, 36}},      {{143, 10}}});
}

/// The acrylic of figure 17.
Stock paperAcrylic()
{
    Stock stock = flatfabAcrylic();
    stock.kerf = 0.15;
    return stock;
}

void acrylicGlass(const std::string &folder, const std::string &name, double legs, Contour leg)
{
    Maker maker(paperAcrylic());
    const SectionRef disc = maker.add("Shelf", lying(62.0), circle({0, 0}, 46));
    maker.addOn(disc, "Leg", facingFront(0.0), std::move(leg));
    maker.add("Ring", lying(104.0), circle({0, 0}, 57), {circle({0, 0}, 38)});
    maker.put(disc, {0, 0}, fullGlass());
    maker.apply("rotational", "Legs", {}, {{"times", legs}});
    maker.write(folder, name);
}

} // namespace

void acrylicThinThree(const std::string &folder)
{
    acrylicGlass(folder, "acrylic_thin_three", 3.0, archedLeg(2.3, 9.0));
}
void acrylicThinFour(const std::string &folder)
{
    acrylicGlass(folder, "acrylic_thin_four", 4.0, archedLeg(2.3, 9.0));
}
void acrylicThickThree(const std::string &folder)
{
    acrylicGlass(folder, "acrylic_thick_three", 3.0, archedLeg(7.0, 7.0));
}
void acrylicThickFour(const std::string &folder)
{
    acrylicGlass(folder, "acrylic_thick_four", 4.0, archedLeg(12.0, 16.0));
}

/// Holds a glass of water; one leg is drawn.
void glassOnThreeLegs(const std::string &folder)
{
    Maker maker;
    const SectionRef disc = maker.add("Shelf", lying(40.0), circle({0, 0}, 47));
    maker.addOn(disc, "Leg", facingFront(0.0), slenderLeg());
    maker.add("Ring", lying(98.0), circle({0, 0}, 60), {circle({0, 0}, 38)});
    maker.put(disc, {0, 0}, fullGlass());
    maker.apply("rotational", "Legs", {}, {{"times", 3.0}});
    maker.write(folder, "glass_three_legs");
}

/// As wide as the glass, on as many legs as one likes.
void glassOnFourLegs(const std::string &folder)
{
    Maker maker;
    maker.show({.name = "diameter",
                .typed = "76 mm",
                .least = 64,
                .most = 92,
                .step = 1,
                .note = "Of the glass"});
    maker.show({.name = "legs", .kind = ValueKind::Count, .typed = "4", .least = 3, .most = 6});
    maker.preset("Tumbler", {});
    maker.preset("Small glass", {{"diameter", "66 mm"}, {"legs", "3"}});
    maker.preset("Mug", {{"diameter", "86 mm"}, {"legs", "5"}});
    const SectionRef disc = maker.addFigures("Shelf", lying(31.0), round(94.0));
    const SectionRef leg =
        maker.addOn(disc, "Leg", facingFront(0.0), strongLeg(), {drop({68, 34})});
    const SectionRef ring = maker.addFigures("Ring", lying(90.0), round(120.0), {round(76.0)});
    maker.put(disc, {0, 0}, fullGlass());
    const OperationId legs = maker.apply("rotational", "Legs", {}, {{"times", 4.0}});
    maker.drive(legs, "times", "legs");
    maker.driveFigure(disc, 0, "diameter", "diameter + 18 mm");
    maker.driveFigure(ring, 0, "diameter", "diameter + 44 mm");
    maker.driveFigure(ring, 1, "diameter", "diameter");
    maker.drive(leg, "x", "diameter/2 + " + millimetres(maker.middleOf(leg).x() - 38.0));
    maker.driveLoad("width", "diameter - 16 mm");
    maker.write(folder, "glass_four_legs");
}

} // namespace fff::samples
