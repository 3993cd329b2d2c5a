#include "core/base/units.h"
#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

#include <cmath>

namespace fff::samples {

namespace {

constexpr double kHalf = 150.0; // of the bridge's length

/// The deck's height.
double deckAt(double x)
{
    return 80.0 - 26.0 * (x / kHalf) * (x / kHalf);
}

Contour arch()
{
    std::vector<Corner> corners;
    for (double x = -kHalf; x <= kHalf; x += 50.0)
        corners.push_back({{x, deckAt(x)}, std::abs(x) == kHalf});
    corners.push_back({{kHalf, 0}, true});
    corners.push_back({{112, 0}, true});
    for (const double degrees : {18.0, 38.0, 62.0, 90.0, 118.0, 142.0, 162.0}) {
        const double angle = radians(degrees);
        corners.push_back({{112.0 * std::cos(angle), 55.0 * std::sin(angle)}});
    }
    corners.push_back({{-112, 0}, true});
    corners.push_back({{-kHalf, 0}, true});
    return flowing(corners);
}

/// A band over the deck, round at its ends.
Contour rail()
{
    constexpr double half = 7.5, end = 142.0;
    const auto at = [](double x, double along, double over) {
        const Vec2 way = Vec2(1.0, (deckAt(x + 0.5) - deckAt(x - 0.5))).normalized();
        return Corner{Vec2(x, deckAt(x) + 26.0) + along * way + over * Vec2(-way.y(), way.x())};
    };
    std::vector<Corner> corners;
    for (const double side : {1.0, -1.0}) {
        for (const double share : {-1.0, -0.96, -0.6, -0.2, 0.2, 0.6, 0.96, 1.0})
            corners.push_back(at(side * share * end, 0.0, side * half));
        for (const double degrees : {45.0, 0.0, -45.0})
            corners.push_back(at(side * end, side * half * std::cos(radians(degrees)),
                                 side * half * std::sin(radians(degrees))));
    }
    return flowing(corners);
}

/// Across the deck, with a post to each side; over its height at x.
Contour beam(double x)
{
    const double y = deckAt(x);
    return flowingBothSides({{{0, y + 6}},
                             {{24, y + 5}},
                             {{33, y + 9}},
                             {{36, y + 22}},
                             {{37, y + 26}, true},
                             {{49, y + 26}, true},
                             {{50, y + 16}},
                             {{47, y + 2}},
                             {{36, y - 6}},
                             {{0, y - 10}}});
}

/// Like a timber of a boat, under the arch.
Contour timber(double low, double high)
{
    const double half = 0.5 * (high - low);
    return flowingBothSides({{{0, low + half}},
                             {{20, low + half - 1}},
                             {{46, low + half + 7}},
                             {{50, low + half + 1}, true},
                             {{36, low - 3}},
                             {{18, low - 10}},
                             {{0, low - 12}}});
}

Contour pier(double x)
{
    const double y = deckAt(x);
    return flowingBothSides({{{0, y + 8}},
                             {{22, y + 8}},
                             {{31, y + 12}},
                             {{35, y + 26}, true},
                             {{51, y + 26}, true},
                             {{51, y + 6}},
                             {{47, y - 14}},
                             {{50, 14}},
                             {{56, 0}, true},
                             {{36, 0}, true},
                             {{26, 14}},
                             {{0, 20}}});
}

} // namespace

/// A footbridge: beams follow its deck, timbers grow with the arch that they are under.
void bridge(const std::string &folder)
{
    Maker maker;
    constexpr double step = 19.0;
    const SectionRef wall = maker.add("Arch", facingFront(0.0), arch());
    const SectionRef pillar = maker.addOn(wall, "Pier", facingRight(-131.0), pier(-131.0));
    const SectionRef first = maker.addOn(wall, "Beam", facingRight(0.0), beam(0.0));
    const SectionRef side = maker.add("Rail", facingFront(43.0), rail());
    const double end = -4.5 * step;
    const SectionRef low =
        maker.addOn(wall, "Timber", facingRight(end),
                    timber(55.0 * std::sqrt(1.0 - end * end / (112.0 * 112.0)), deckAt(end)));
    maker.apply(
        "linear", "Beams", {{"section", {first}}, {"along", {wall}}},
        {{"repeatBy", "spacing"}, {"spacing", step}, {"from", 0.1}, {"to", 0.9}, {"side", "both"}});
    maker.apply("linear", "Timbers", {{"section", {low}}, {"along", {wall}}},
                {{"repeatBy", "spacing"}, {"spacing", step}, {"to", 0.79}, {"scale", "thickness"}});
    maker.apply("mirror", "Other pier", {{"sections", {pillar}}},
                {{"plane", "x"}, {"what", "selection"}});
    maker.apply("mirror", "Other rail", {{"sections", {side}}},
                {{"plane", "z"}, {"what", "selection"}});
    maker.write(folder, "bridge");
}

} // namespace fff::samples
