#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

#include <string>

namespace fff::samples {

/// Carries four glasses at a handle.
void glassHolder(const std::string &folder)
{
    Maker maker(4.0);
    constexpr double high = 150, shelf = 70, floor = 22;
    for (const double x : {-82.0, 82.0})
        maker.add(x < 0 ? "Left side" : "Right side", facingRight(x),
                  through({{{-72, 0}, true},
                           {{-44, 0}, true},
                           {{-30, 11}},
                           {{0, 14}},
                           {{30, 11}},
                           {{44, 0}, true},
                           {{72, 0}, true},
                           {{70, 44}},
                           {{56, 84}},
                           {{30, 112}},
                           {{25, high}},
                           {{0, high + 12}},
                           {{-25, high}},
                           {{-30, 112}},
                           {{-56, 84}},
                           {{-70, 44}}}));
    std::vector<Contour> holes;
    for (const double x : {-37.0, 37.0}) {
        for (const double z : {-36.0, 36.0})
            holes.push_back(ellipse({x, z}, 31, 31));
    }
    maker.add("Shelf", lying(shelf), roundedRectangle({0, 0}, 208, 168, 12), holes);
    maker.add("Floor", lying(floor), roundedRectangle({0, 0}, 208, 168, 12));
    maker.add("Handle", facingFront(0.0),
              through({{{-106, high - 14}},
                       {{-96, high - 24}},
                       {{0, high - 20}},
                       {{96, high - 24}},
                       {{106, high - 14}},
                       {{96, high + 2}},
                       {{0, high + 8}},
                       {{-96, high + 2}}}));
    maker.write(folder, "glass_holder");
}

/// An organiser for a desk: compartments of upright plates that cross.
void organiser(const std::string &folder)
{
    Maker maker(3.0);
    constexpr double high = 70, wide = 105, deep = 66;
    const auto wall = [](double half, double height, double dip) {
        return through({{{-half, 0}, true},
                        {{half, 0}, true},
                        {{half, height}, true},
                        {{half * 0.5, height}, false},
                        {{0, height - dip}},
                        {{-half * 0.5, height}, false},
                        {{-half, height}, true}});
    };
    const SectionRef back = maker.add("Back", facingFront(-deep + 12), wall(wide, high + 20, -10));
    maker.add("Middle", facingFront(0.0), wall(wide, high, 0));
    const SectionRef front = maker.add("Front", facingFront(deep - 12), wall(wide, high - 20, 10));
    // To the back at positive coordinates: it rises there.
    const Contour slope = through({{{-deep, 0}, true},
                                   {{deep, 0}, true},
                                   {{deep, high + 20}, true},
                                   {{deep - 24, high + 20}},
                                   {{0, high}},
                                   {{-deep + 24, high - 20}},
                                   {{-deep, high - 20}, true}});
    const auto row = [&](const char *name, const char *part, double x, double step,
                         const SectionRef &crossed, const std::vector<Contour> &holes) {
        const SectionRef first = maker.add(part, facingRight(x), slope, holes);
        const OperationId array = maker.apply("array", name, {{"sections", {first}}},
                                              {{"count", 2.0}, {"x", step}, {"z", 0.0}});
        // All go in from above.
        maker.open(crossed, first, {0, 1});
        maker.open(crossed, {array, "1/" + std::to_string(first.drawn.value)}, {0, 1});
    };
    row("Sides", "Side", -93.0, 186.0, front, {roundedRectangle({28, high - 16}, 34, 15, 7)});
    row("Dividers", "Divider", -31.0, 62.0, back, {});
    maker.write(folder, "organiser");
}

/// A chair for a doll.
void chair(const std::string &folder)
{
    Maker maker(3.0);
    const auto side = [] {
        // The back is at positive coordinates.
        return through({{{-58, 0}, true},
                        {{-42, 0}, true},
                        {{-38, 40}},
                        {{-22, 60}},
                        {{20, 60}},
                        {{36, 40}},
                        {{46, 0}, true},
                        {{62, 0}, true},
                        {{54, 50}},
                        {{56, 110}},
                        {{68, 190}},
                        {{58, 196}},
                        {{40, 188}},
                        {{38, 120}},
                        {{26, 94}},
                        {{-20, 88}},
                        {{-52, 90}},
                        {{-58, 80}}});
    };
    for (const double x : {-48.0, 48.0})
        maker.add(x < 0 ? "Left side" : "Right side", facingRight(x), side());
    maker.add("Seat", lying(76.0),
              through({{{-64, -72}},
                       {{0, -78}},
                       {{64, -72}},
                       {{66, -20}},
                       {{60, 22}},
                       {{56, 30}, true},
                       {{-56, 30}, true},
                       {{-60, 22}},
                       {{-66, -20}}}));
    const auto slat = [](double middle, double rise) {
        return through({{{-66, middle - 8}, false},
                        {{0, middle - 10 + rise}},
                        {{66, middle - 8}},
                        {{68, middle}},
                        {{64, middle + 9}},
                        {{0, middle + 10 + rise}},
                        {{-64, middle + 9}},
                        {{-68, middle}}});
    };
    maker.add("Upper slat", facingFront(-56.0), slat(166, 5));
    maker.add("Lower slat", facingFront(-48.0), slat(130, 4));
    maker.add("Front rail", facingFront(44.0), slat(30, 6));
    maker.write(folder, "chair");
}

} // namespace fff::samples
