#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

Contour whale()
{
    return flowing(
        {{{-206, 112}},      {{-196, 152}}, {{-166, 182}},      {{-118, 197}},      {{-56, 198}},
         {{4, 184}},         {{60, 158}},   {{104, 136}},       {{138, 138}},       {{156, 160}},
         {{158, 188}},       {{142, 210}},  {{114, 228}, true}, {{142, 236}},       {{168, 226}},
         {{178, 214}, true}, {{188, 228}},  {{206, 238}},       {{226, 234}, true}, {{208, 212}},
         {{196, 184}},       {{194, 150}},  {{180, 112}},       {{146, 80}},        {{92, 54}},
         {{20, 36}},         {{-60, 28}},   {{-136, 32}},       {{-186, 54}},       {{-204, 82}}});
}

/// A smile, from the cheek to the front.
Contour mouth()
{
    return flowing({{{-104, 104}},
                    {{-124, 93}},
                    {{-152, 90}},
                    {{-180, 99}},
                    {{-180, 104}},
                    {{-152, 96}},
                    {{-124, 99}},
                    {{-106, 109}}});
}

/// A drop, the round end to the left.
Contour groove(const Vec2 &at, double length)
{
    return flowing({{at + Vec2(0, 0)},
                    {at + Vec2(4, -4)},
                    {at + Vec2(0.6 * length, 2)},
                    {at + Vec2(length, 10), true},
                    {at + Vec2(0.5 * length, 8)},
                    {at + Vec2(4, 4)}});
}

/// A wave, with a lower one that breaks to each side.
Contour wave(double top)
{
    return flowingBothSides({{{0, top}},
                             {{12, top - 5}},
                             {{24, 0.6 * top}},
                             {{37, 0.36 * top}},
                             {{50, 0.42 * top}},
                             {{60, 0.56 * top}},
                             {{72, 0.6 * top}},
                             {{82, 0.48 * top}, true},
                             {{73, 0.46 * top}},
                             {{70, 0.34 * top}},
                             {{78, 0.18 * top}},
                             {{90, 0}, true}});
}

} // namespace

/// A whale too long for the machine: cells and connectors in its place, on two waves.
void whale(const std::string &folder)
{
    Maker maker;
    const SectionRef panel = maker.add("Whale", facingFront(0.0), whale(),
                                       {circle({-146, 126}, 7), mouth(), groove({-30, 60}, 60),
                                        groove({-32, 80}, 76), groove({-30, 100}, 60)});
    maker.addOn(panel, "Front wave", facingRight(-112.0), wave(62));
    maker.addOn(panel, "Hind wave", facingRight(46.0), wave(70));
    maker.apply("grid", "Cells", {{"section", {panel}}},
                {{"fitSheet", false},
                 {"cellWidth", 145.0},
                 {"cellHeight", 112.0},
                 {"connectorSize", 24.0},
                 {"connectors", 2.0}});
    maker.write(folder, "whale");
}

} // namespace fff::samples
