#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

constexpr double kMiddle = 12.0; // of the body, along it

/// From the side, the head to the left.
Contour back()
{
    return flowing({{{-84, 50}},
                    {{-78, 62}},
                    {{-64, 67}},
                    {{-55, 65}, true},
                    {{-47, 78}},
                    {{-32, 83}},
                    {{-20, 78}, true},
                    {{-7, 90}},
                    {{14, 94}},
                    {{36, 89}},
                    {{55, 74}},
                    {{66, 48}},
                    {{62, 34}},
                    {{36, 25}},
                    {{-4, 22}},
                    {{-44, 28}},
                    {{-70, 36}}});
}

/// One leg, outwards along x: hip in the body, knee, claw.
Contour leg()
{
    return flowing({{{14, 38}},      {{18, 32}}, {{31, 34}}, {{45, 47}}, {{59, 64}},
                    {{67, 61}},      {{77, 40}}, {{84, 16}}, {{87, 4}},  {{88, 0}, true},
                    {{99, 0}, true}, {{96, 5}},  {{91, 22}}, {{85, 46}}, {{76, 70}},
                    {{64, 79}},      {{51, 71}}, {{37, 56}}, {{20, 51}}, {{14, 46}}});
}

/// Two horns that bend towards each other; across the head, the tips to the left.
Contour horns()
{
    return flowing({{{-56, 0}},    {{-57, 11}},       {{-70, 17}},        {{-82, 25}},
                    {{-104, 32}},  {{-124, 24}},      {{-134, 9}, true},  {{-121, 15}},
                    {{-112, 18}},  {{-111, 9}, true}, {{-104, 19}},       {{-92, 14}},
                    {{-88, 0}},    {{-92, -14}},      {{-104, -19}},      {{-111, -9}, true},
                    {{-112, -18}}, {{-121, -15}},     {{-134, -9}, true}, {{-124, -24}},
                    {{-104, -32}}, {{-82, -25}},      {{-70, -17}},       {{-57, -11}}});
}

/// A slice of the wing cases.
Contour plate()
{
    return flowingBothSides(
        {{{0, 103}}, {{19, 99}}, {{32, 86}}, {{35, 66}, true}, {{27, 75}}, {{14, 80}}, {{0, 81}}});
}

} // namespace

/// A stag beetle: legs round its body, plates round its back.
void beetle(const std::string &folder)
{
    Maker maker;
    const SectionRef body = maker.add("Body", lying(42.0), ellipse({kMiddle, 0}, 62, 31));
    const SectionRef ridge = maker.addOn(body, "Back", facingFront(0.0), back());
    maker.addOn(ridge, "Horns", lying(54.0), horns());
    const SectionRef first = maker.addOn(body, "Leg", facingRight(kMiddle), leg());
    const SectionRef top = maker.addOn(ridge, "Plate", facingRight(14.0), plate());
    maker.apply("revolve", "Legs", {{"section", {first}}, {"along", {body}}},
                {{"closed", true}, {"count", 6.0}});
    maker.apply("revolve", "Plates", {{"section", {top}}, {"along", {ridge}}},
                {{"count", 7.0}, {"from", 0.845}, {"to", 0.05}, {"scale", "thickness"}});
    maker.write(folder, "beetle");
}

} // namespace fff::samples
