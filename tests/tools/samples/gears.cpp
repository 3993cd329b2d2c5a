#include "core/base/units.h"
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

/// Carries a wheel in the middle and one to either side; beams run between them.
Contour cradle()
{
    return roundedBothSides({{{9, 46}, 5},
                             {{12, 26}, 3},
                             {{18, 26}, 3},
                             {{21, 46}, 5},
                             {{34, 46}, 6},
                             {{42, 18}, 12},
                             {{54, 13}, 6},
                             {{54, 0}}});
}

} // namespace

/// A clockwork that stands still: discs that one operation makes gears and another one pierces.
void gears(const std::string &folder)
{
    Maker maker;
    const SectionRef large = maker.add("Large wheel", facingFront(0.0), circle({-28, 82}, 62)),
                     small = maker.add("Front wheel", facingFront(26.0), circle({60, 63}, 42)),
                     rear = maker.add("Rear wheel", facingFront(-26.0), circle({60, 63}, 42));
    int number = 1;
    for (const double x : {-54.0, -2.0, 41.0, 79.0})
        maker.add("Cradle " + std::to_string(number++), facingRight(x), cradle());
    const SectionRef front = maker.add("Sill", facingFront(13.0), strip(-88, 104, 15, 6));
    maker.apply("radial", "Teeth", {{"section", {large}}},
                {{"kind", "gear"},
                 {"sectors", 22.0},
                 {"outerRadius", 64.0},
                 {"innerRadius", 55.0},
                 {"tooth", "trapezium"},
                 {"phase", radians(8.0)}});
    maker.apply(
        "radial", "Ring of holes", {{"section", {large}}},
        {{"kind", "holes"}, {"sectors", 8.0}, {"outerRadius", 40.0}, {"innerRadius", 22.0}});
    maker.apply("radial", "Star", {{"section", {large}}},
                {{"kind", "star"},
                 {"sectors", 8.0},
                 {"outerRadius", 16.0},
                 {"innerRadius", 10.0},
                 {"applyTo", "holes"}});
    maker.apply("radial", "Round teeth", {{"section", {small}}},
                {{"kind", "gear"},
                 {"sectors", 14.0},
                 {"outerRadius", 44.0},
                 {"innerRadius", 36.0},
                 {"tooth", "round"}});
    maker.apply("radial", "Sun", {{"section", {small}}},
                {{"kind", "star"},
                 {"sectors", 10.0},
                 {"outerRadius", 20.0},
                 {"innerRadius", 11.0},
                 {"applyTo", "holes"}});
    maker.apply("radial", "Square teeth", {{"section", {rear}}},
                {{"kind", "gear"},
                 {"sectors", 14.0},
                 {"outerRadius", 50.0},
                 {"innerRadius", 42.0},
                 {"tooth", "square"},
                 {"phase", radians(90.0 + 180.0 / 14.0)}});
    maker.apply("radial", "Larger holes", {{"section", {rear}}},
                {{"kind", "holes"},
                 {"sectors", 5.0},
                 {"outerRadius", 31.0},
                 {"innerRadius", 11.0},
                 {"phase", radians(90.0)}});
    maker.apply("mirror", "Other sill", {{"sections", {front}}},
                {{"plane", "z"}, {"what", "selection"}});
    maker.write(folder, "gears");
}

} // namespace fff::samples
