// A name for a desk or a door: the plate is as long as the name that is typed.
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

Contour nameShield()
{
    return flowingBothSides({{{0, 6.5}},
                             {{58, 5}},
                             {{90, 6}, true},
                             {{92, 13}},
                             {{99, 18}, true},
                             {{104, 31}},
                             {{99, 44}, true},
                             {{92, 48}},
                             {{90, 55}, true},
                             {{58, 53}},
                             {{26, 56}},
                             {{0, 61}}});
}

Contour nameFoot()
{
    return flowingBothSides(
        {{{29, 0}, true}, {{29, 4}}, {{21, 8}}, {{12, 12}}, {{9, 20}}, {{0, 23}}});
}

} // namespace

void namePlate(const std::string &folder)
{
    Maker maker(3.0);
    maker.show({.name = "name", .kind = ValueKind::Text, .typed = "Ada Lovelace"});
    maker.show({.name = "letters",
                .typed = "18 mm",
                .least = 12,
                .most = 30,
                .step = 1,
                .note = "Height of the capitals; a long name has to be smaller"});
    maker.derive("widths", ValueKind::Ratio, "0.76*len(name) + 2.4",
                 "How wide the plate is, in heights of a capital");
    maker.derive("capital", ValueKind::Length, "min(letters; 560 mm/widths)",
                 "What the sheet has room for");
    maker.derive("plate", ValueKind::Length, "max(80 mm; widths*capital)", "Its width");

    const SectionRef shield = maker.add("Name plate", facingFront(0.0), nameShield());
    maker.write(shield, {.text = "Ada Lovelace", .height = 18.0, .at = {0.0, 34.0}});
    const SectionRef foot = maker.add("Foot", facingRight(-74.0), nameFoot());
    maker.apply("mirror", "Other foot", {{"sections", {foot}}},
                {{"plane", "x"}, {"what", "selection"}});

    maker.driveWords(shield, 0, "text", "{name}");
    maker.driveWords(shield, 0, "height", "capital");
    maker.drive(shield, "width", "plate");
    maker.drive(shield, "height", "20 mm + 1.9*capital");
    maker.drive(shield, "y", "15 mm + 0.95*capital");
    maker.drive(foot, "x", "-0.36*plate");
    maker.drive(foot, "width", "40 mm + capital");
    maker.write(folder, "name_plate");
}

} // namespace fff::samples
