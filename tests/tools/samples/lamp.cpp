// A shade of ribs that two rings hold. One rib is drawn; it leans about its slit in the lower ring,
// and the upper ring follows it outwards.
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

// As it is drawn, mm: along the rib from its foot.
constexpr double kLampHeight = 176.0, kLampLower = 34.0, kLampUpper = 150.0;

/// Outwards from the middle.
Contour lampRib()
{
    return through({{{42, 0}, true},
                    {{66, 0}, true},
                    {{78, 40}},
                    {{84, 84}},
                    {{72, 132}},
                    {{50, 168}},
                    {{34, 176}, true},
                    {{30, 160}},
                    {{40, 124}},
                    {{48, 84}},
                    {{46, 40}}});
}

Figure disc(double diameter)
{
    return {.kind = "circle", .numbers = {diameter}};
}

} // namespace

void lamp(const std::string &folder)
{
    Maker maker(2.0);
    maker.show({.name = "height",
                .typed = "176 mm",
                .least = 140,
                .most = 240,
                .step = 2,
                .note = "Of a rib, along it"});
    maker.show({.name = "ribs", .kind = ValueKind::Count, .typed = "12", .least = 7, .most = 18});
    maker.show({.name = "twist",
                .kind = ValueKind::Angle,
                .typed = "12°",
                .least = 0,
                .most = 25,
                .step = 1,
                .note = "How far each rib leans"});
    maker.derive("lower", ValueKind::Length, "height*34/176", "Along a rib to the lower ring");
    maker.derive("between", ValueKind::Length, "height*116/176", "Along a rib from ring to ring");
    maker.derive("aside", ValueKind::Length, "between*sin(twist)",
                 "How far beside its place below a rib meets the upper ring");

    const SectionRef low = maker.addFigures("Lower ring", lying(kLampLower), disc(124), {disc(72)});
    const SectionRef rib = maker.addOn(low, "Rib", radial(0.0), lampRib());
    const SectionRef high = maker.addFigures("Upper ring", lying(kLampUpper), disc(94), {disc(40)});
    const OperationId ribs = maker.apply("rotational", "Ribs", {{"sections", {rib}}},
                                         {{"what", "selection"}, {"times", 12.0}});

    maker.drive(ribs, "times", "ribs");
    // A sheet that leans stands on an edge of its own thickness.
    const std::string foot = "t/2*sin(twist)";
    maker.drive(low, "y", "lower*cos(twist) + " + foot);
    maker.drive(rib, "height", "height");
    maker.drive(rib, "angle", "90° - twist");
    maker.drive(rib, "y", "height/2*cos(twist) + " + foot);
    maker.drive(rib, "z", "(height/2 - lower)*sin(twist)");
    maker.drive(high, "y", "(lower + between)*cos(twist) + " + foot);
    maker.driveFigure(high, 0, "diameter", "2*sqrt((47 mm)^2 + aside^2)");
    maker.driveFigure(high, 1, "diameter", "2*sqrt((20 mm)^2 + aside^2)");
    maker.write(folder, "lamp");
}

} // namespace fff::samples
