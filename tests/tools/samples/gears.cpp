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
    maker.derive("pinion_x", Length, "axis_x + along", "Of the pinion");
    // A tooth of the pinion points down, so that its two cradles stand alike. The wheel turns back
    // by as much as the pinion is turned from where one of its gaps is on the line of the axes.
    maker.derive("pinion_phase", Angle, "270°", "Where a tooth of the pinion is");
    maker.derive("turn", Angle, "90° + tilt - 180°/pinion",
                 "Of the pinion, from a gap to the wheel");
    maker.derive("rest", Angle, "turn - round(turn/(360°/pinion))*360°/pinion",
                 "The same without whole teeth");
    maker.derive("phase", Angle, "360° - tilt - 360°/teeth - rest*pinion/teeth",
                 "Where a tooth of the wheel is");
}

/// Where a cradle stands: below the gap to that side of the lowest place of a wheel.
void driveCradle(Maker &maker, const SectionRef &cradle, bool isPinion, const char *side)
{
    const std::string of = isPinion ? "pinion_" : "", teeth = isPinion ? "pinion" : "teeth",
                      axis = isPinion ? "pinion_x" : "axis_x", sector = "(360°/" + teeth + ")";
    const std::string gaps = "floor((270° - " + of + "phase)/" + sector + side + ") + 0.5";
    maker.drive(cradle, "x",
                axis + " + (" + of + "root + 0.3*module)*cos(" + of + "phase + (" + gaps + ")*" +
                    sector + ")");
    maker.drive(cradle, "height", "cradle");
    maker.drive(cradle, "y", "cradle/2");
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
                .note = "Diameter a tooth: the size of the teeth"});
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
    for (const auto &[disc, of] : {std::pair{large, std::string("axis")}, {small, "pinion"}}) {
        maker.drive(disc, "x", of + "_x");
        maker.drive(disc, "y", of + "_y");
    }
    maker.driveFigure(large, 0, "diameter", "2*radius");
    maker.driveFigure(small, 0, "diameter", "2*pinion_radius");

    int number = 0;
    for (const bool isPinion : {false, true}) {
        for (const char *side : {" - 0.5", " + 0.5"}) {
            const std::string name = "Cradle " + std::to_string(++number);
            driveCradle(maker, maker.add(name, facingRight(20.0 * number), cradle()), isPinion,
                        side);
        }
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
    const OperationId pinionTeeth = maker.apply(
        "radial", "Pinion teeth", {{"section", {small}}},
        {{"kind", "gear"}, {"outerRadius", 40.0}, {"innerRadius", 29.0}, {"tooth", "trapezium"}});
    maker.drive(pinionTeeth, "sectors", "pinion");
    maker.drive(pinionTeeth, "outerRadius", "pinion_radius");
    maker.drive(pinionTeeth, "innerRadius", "pinion_root");
    maker.drive(pinionTeeth, "phase", "pinion_phase");
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
