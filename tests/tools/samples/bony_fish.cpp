#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

/// Skull, backbone and tail in one, from the snout along the back and round.
Contour spine()
{
    return flowing(
        {{{-150, 128}, true}, {{-138, 146}},     {{-112, 163}},      {{-84, 167}},  {{-66, 158}},
         {{-54, 146}},        {{-36, 142}},      {{0, 140}},         {{50, 136.5}}, {{88, 134}},
         {{106, 139}},        {{124, 155}},      {{146, 178}, true}, {{140, 154}},  {{135, 128}},
         {{140, 102}},        {{146, 78}, true}, {{124, 101}},       {{106, 117}},  {{88, 121}},
         {{50, 118.5}},       {{0, 114.5}},      {{-36, 112}},       {{-54, 106}},  {{-74, 90}},
         {{-98, 79}},         {{-122, 75}},      {{-146, 80}, true}, {{-136, 88}},  {{-116, 93}},
         {{-98, 101}},        {{-88, 112}},      {{-98, 119}},       {{-122, 122}}});
}

/// A pair of ribs in one; a quarter of its height is in the spine.
Contour rib()
{
    return flowingBothSides({{{0, 127}},
                             {{13, 124}},
                             {{32, 110}},
                             {{44, 84}},
                             {{40, 50}, true},
                             {{33, 82}},
                             {{22, 99}},
                             {{0, 106}}});
}

Contour ray()
{
    return flowingBothSides({{{0, 127.5}}, {{10, 128}}, {{11, 142}}, {{5, 164}}, {{0, 192}, true}});
}

Contour teeth()
{
    return flowingBothSides(
        {{{0, 89}}, {{8, 89.5}}, {{11, 97}}, {{9.5, 114}, true}, {{5, 105}}, {{0, 102}}});
}

Contour foot()
{
    return flowingBothSides({{{0, 127}},
                             {{9, 125}},
                             {{8, 96}},
                             {{7.5, 58}},
                             {{14, 28}},
                             {{32, 12}},
                             {{46, 6}},
                             {{48, 0}, true},
                             {{28, 0}, true},
                             {{14, 6}},
                             {{0, 9}}});
}

Contour longFoot()
{
    return flowing({{{-86, 0}, true},
                    {{-56, 0}, true},
                    {{-34, 7}},
                    {{-4, 9}},
                    {{28, 7}},
                    {{50, 0}, true},
                    {{80, 0}, true},
                    {{76, 7}},
                    {{44, 17}},
                    {{0, 34}},
                    {{-48, 17}},
                    {{-82, 7}}});
}

} // namespace

/// The bones of a fish: ribs and rays as large as the spine is thick, teeth as the jaw is.
void bonyFish(const std::string &folder)
{
    Maker maker;
    const SectionRef bone = maker.add("Spine", facingFront(0.0), spine(), {circle({-104, 144}, 8)});
    // On a foot of its own, which stands in the place of one of the ribs.
    constexpr double at = -7.0, step = 11.0;
    const SectionRef stand = maker.addOn(bone, "Foot", facingRight(at), foot());
    maker.addOn(stand, "Long foot", facingFront(0.0), longFoot());

    const SectionRef first = maker.addOn(bone, "Rib", facingRight(at - 4.0 * step), rib());
    const OperationId ribs =
        maker.apply("linear", "Ribs", {{"section", {first}}, {"along", {bone}}},
                    {{"repeatBy", "spacing"},
                     {"spacing", step},
                     {"to", 0.79},
                     {"scale", "thickness"},
                     {"notBelow", 0.4}});
    maker.hide(ribs, "4");
    const SectionRef spike = maker.addOn(bone, "Ray", facingRight(at - 3.5 * step), ray());
    maker.apply("linear", "Rays", {{"section", {spike}}, {"along", {bone}}},
                {{"repeatBy", "spacing"},
                 {"spacing", step},
                 {"to", 0.79},
                 {"scale", "thickness"},
                 {"notBelow", 0.4}});
    const SectionRef tooth = maker.addOn(bone, "Tooth", facingRight(-106.0), teeth());
    maker.apply("linear", "Teeth", {{"section", {tooth}}, {"along", {bone}}},
                {{"repeatBy", "spacing"},
                 {"spacing", 8.0},
                 {"from", 0.06},
                 {"side", "back"},
                 {"scale", "thickness"},
                 {"notBelow", 0.4}});
    maker.write(folder, "bony_fish");
}

} // namespace fff::samples
