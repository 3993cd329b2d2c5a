// Two wheels that mesh: discs that one operation makes gears and others pierce. Cradles reach into
// the gaps between teeth, so that no tooth is cut in two.
#include "core/base/units.h"
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

/// Carries a wheel in the middle; a beam runs to either side of it.
Contour cradle()
{
    return flowingBothSides(
        {{{46, 0}, true}, {{45, 7}}, {{34, 15}}, {{23, 22}}, {{13, 31}}, {{9, 45}}, {{0, 48}}});
}

Contour sill()
{
    return flowingBothSides(
        {{{100, 0}, true}, {{100, 8}, true}, {{96, 14}}, {{84, 15}}, {{0, 15}}});
}

/// A disc of this radius round there; teeth come later.
Figure wheel(double radius)
{
    return {.kind = "circle", .numbers = {2.0 * radius}};
}

void deriveTrain(Maker &maker)
{
    using enum ValueKind;
    maker.derive("radius", Length, "module*(teeth/2 + 1)",
                 "Of the wheel, to the tips of its teeth");
    maker.derive("pinion_radius", Length, "module*(pinion/2 + 1)", "Of the pinion, likewise");
    maker.derive("root", Length, "module*(teeth/2 - 1.2)",
                 "Of the wheel, to the ground of its gaps");
    maker.derive("pinion_root", Length, "module*(pinion/2 - 1.2)", "Of the pinion, likewise");
    maker.derive("distance", Length, "module*((teeth + pinion)/2 + 0.5)",
                 "From axis to axis, with some play");
    maker.derive("cradle", Length, "16 mm + 0.4*radius", "Height of the cradles");
    maker.derive("axis_y", Length, "cradle + 0.65*root", "Height of the wheel's axis");
    maker.derive("pinion_y", Length, "cradle + pinion_root/2", "Height of the pinion's axis");
    maker.derive("tilt", Angle, "asin((axis_y - pinion_y)/distance)",
                 "How much lower the pinion is, seen from the wheel");
    maker.derive("along", Length, "distance*cos(tilt)", "From axis to axis, level");
    maker.derive("axis_x", Length, "-(along + pinion_radius - radius)/2", "Of the wheel");
    // A tooth of the pinion points down, so that its two cradles stand alike. The wheel turns back
    // by as much as the pinion is turned from where one of its gaps is on the line of the axes.
    maker.derive("turn", Angle, "90° + tilt - 180°/pinion",
                 "Of the pinion, from a gap to the wheel");
    maker.derive("rest", Angle, "turn - round(turn/(360°/pinion))*360°/pinion",
                 "The same without whole teeth");
    maker.derive("phase", Angle, "360° - tilt - 360°/teeth - rest*pinion/teeth",
                 "Where a tooth of the wheel is");
}

/// Below the gap to that side (−1, 1) of the lowest place of the wheel.
std::string belowWheel(int side)
{
    const std::string gaps = "(floor((270° - phase)*teeth/360°" +
                             std::string(side < 0 ? " - 0.5" : " + 0.5") + ") + 0.5)";
    return "axis_x + (root + 0.3*module)*cos(phase + " + gaps + "*360°/teeth)";
}

/// Likewise of the pinion, whose lowest tooth points down.
std::string belowPinion(int side)
{
    return std::string("axis_x + along ") + (side < 0 ? "-" : "+") +
           " (pinion_root + 0.3*module)*sin(180°/pinion)";
}

} // namespace

void gears(const std::string &folder)
{
    Maker maker;
    maker.show({.name = "module",
                .typed = "5 mm",
                .least = 3.5,
                .most = 5.5,
                .step = 0.1,
                .note = "Size of the teeth: the diameter over their number"});
    maker.show({.name = "teeth",
                .kind = ValueKind::Count,
                .typed = "22",
                .least = 18,
                .most = 26,
                .note = "Of the wheel"});
    maker.show({.name = "pinion",
                .kind = ValueKind::Count,
                .typed = "14",
                .least = 12,
                .most = 16,
                .note = "Teeth of the pinion"});
    deriveTrain(maker);

    const SectionRef large = maker.addFigures("Wheel", facingFront(0.0), wheel(60.0)),
                     small = maker.addFigures("Pinion", facingFront(0.0), wheel(40.0));
    maker.drive(large, "x", "axis_x");
    maker.drive(large, "y", "axis_y");
    maker.drive(small, "x", "axis_x + along");
    maker.drive(small, "y", "pinion_y");
    maker.driveFigure(large, 0, "diameter", "2*radius");
    maker.driveFigure(small, 0, "diameter", "2*pinion_radius");

    int number = 0;
    for (const std::string &x : {belowWheel(-1), belowWheel(1), belowPinion(-1), belowPinion(1)}) {
        ++number;
        const SectionRef one =
            maker.add("Cradle " + std::to_string(number), facingRight(20.0 * number), cradle());
        maker.drive(one, "x", x);
        maker.drive(one, "height", "cradle");
        maker.drive(one, "y", "cradle/2");
    }
    const SectionRef front = maker.add("Sill", facingFront(17.0), sill());
    maker.drive(front, "width", "along + radius + pinion_radius");

    const OperationId teeth = maker.apply(
        "radial", "Teeth", {{"section", {large}}},
        {{"kind", "gear"}, {"outerRadius", 60.0}, {"innerRadius", 49.0}, {"tooth", "trapezium"}});
    maker.drive(teeth, "sectors", "teeth");
    maker.drive(teeth, "outerRadius", "radius");
    maker.drive(teeth, "innerRadius", "root");
    maker.drive(teeth, "phase", "phase");
    const OperationId holes = maker.apply(
        "radial", "Ring of holes", {{"section", {large}}},
        {{"kind", "holes"}, {"sectors", 8.0}, {"outerRadius", 31.0}, {"innerRadius", 17.0}});
    maker.drive(holes, "outerRadius", "0.52*radius");
    maker.drive(holes, "innerRadius", "0.28*radius");
    const OperationId star = maker.apply("radial", "Star", {{"section", {large}}},
                                         {{"kind", "star"},
                                          {"sectors", 8.0},
                                          {"outerRadius", 15.0},
                                          {"innerRadius", 9.0},
                                          {"applyTo", "holes"}});
    maker.drive(star, "outerRadius", "0.22*radius");
    maker.drive(star, "innerRadius", "0.13*radius");
    const OperationId pinionTeeth = maker.apply("radial", "Pinion teeth", {{"section", {small}}},
                                                {{"kind", "gear"},
                                                 {"outerRadius", 40.0},
                                                 {"innerRadius", 29.0},
                                                 {"tooth", "trapezium"},
                                                 {"phase", radians(270.0)}});
    maker.drive(pinionTeeth, "sectors", "pinion");
    maker.drive(pinionTeeth, "outerRadius", "pinion_radius");
    maker.drive(pinionTeeth, "innerRadius", "pinion_root");
    const OperationId sun = maker.apply("radial", "Sun", {{"section", {small}}},
                                        {{"kind", "star"},
                                         {"sectors", 10.0},
                                         {"outerRadius", 16.0},
                                         {"innerRadius", 9.0},
                                         {"applyTo", "holes"}});
    maker.drive(sun, "outerRadius", "0.32*pinion_radius");
    maker.drive(sun, "innerRadius", "0.18*pinion_radius");
    maker.apply("mirror", "Other sill", {{"sections", {front}}},
                {{"plane", "z"}, {"what", "selection"}});
    maker.write(folder, "gears");
}

} // namespace fff::samples
