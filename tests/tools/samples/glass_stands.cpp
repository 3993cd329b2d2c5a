#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

constexpr double kFullGlass = 0.625; // 350 ml of water in a glass of 275 g, kg

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

void glass(const std::string &folder, const std::string &name, double legs, double shelf,
           double ring, Contour leg, std::vector<Contour> holes)
{
    Maker maker;
    const SectionRef disc = maker.add("Shelf", lying(shelf), circle({0, 0}, 47));
    maker.addOn(disc, "Leg", facingFront(0.0), std::move(leg), std::move(holes));
    maker.add("Ring", lying(ring), circle({0, 0}, 60), {circle({0, 0}, 38)});
    maker.hang(disc, {0, 0}, kFullGlass);
    maker.apply("rotational", "Legs", {}, {{"times", legs}});
    maker.write(folder, name);
}

} // namespace

/// Holds a glass of water; one leg is drawn.
void glassOnThreeLegs(const std::string &folder)
{
    glass(folder, "glass_three_legs", 3.0, 40.0, 98.0, slenderLeg(), {});
}

void glassOnFourLegs(const std::string &folder)
{
    glass(folder, "glass_four_legs", 4.0, 31.0, 90.0, strongLeg(), {drop({68, 34})});
}

} // namespace fff::samples
