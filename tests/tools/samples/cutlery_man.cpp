#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

namespace {

// Hands, from above the wrist round their tips to below it; along and across the arm.
using Hand = std::vector<Corner>;

Hand fork()
{
    Hand hand = {{{0, 6}}, {{9, 4.5}}, {{17, 12}}};
    // Three tines and what is between them.
    for (const double tine : {10.5, 0.0, -10.5}) {
        hand.insert(hand.end(), {{{40, tine + 2.2}, true}, {{40, tine - 2.2}, true}});
        if (tine > -10.0)
            hand.insert(hand.end(),
                        {{{22, tine - 2.8}}, {{19.5, tine - 5.25}}, {{22, tine - 7.7}}});
    }
    hand.insert(hand.end(), {{{17, -12}}, {{9, -4.5}}, {{0, -6}}});
    return hand;
}

Hand spoon(double length, double wide)
{
    return {{{0, 6}},
            {{0.22 * length, 4.2}},
            {{0.62 * length, wide}},
            {{0.9 * length, 0.68 * wide}},
            {{length, 0}},
            {{0.9 * length, -0.68 * wide}},
            {{0.62 * length, -wide}},
            {{0.22 * length, -4.2}},
            {{0, -6}}};
}

Hand knife()
{
    return {{{0, 6}},   {{6, 4.8}}, {{11, 8.5}, true}, {{26, 10}},  {{40, 6}},
            {{46, -3}}, {{43, -8}}, {{28, -8}},        {{8, -5.5}}, {{0, -6}}};
}

/// A man from the front, who is symmetric but for his hands, with six hooks on each arm.
Contour man(const Hand &right, const Hand &left)
{
    constexpr double wrist = 105.0, arm = 199.0;
    const auto half = [&](const Hand &hand) {
        std::vector<Corner> corners = {{{0, 277}},  {{11, 274}}, {{16, 262}},
                                       {{15, 250}}, {{10, 240}}, {{8.5, 232}},
                                       {{12, 224}}, {{26, 218}}, {{37, 213}}};
        for (int hook = 0; hook < 6; ++hook) {
            const double x = 41.0 + 10.5 * hook;
            corners.insert(corners.end(), {{{x, arm + 6}},
                                           {{x + 3.5, arm + 5.6}},
                                           {{x + 5.2, arm + 11}},
                                           {{x + 8.2, arm + 10.5}}});
        }
        for (const Corner &corner : hand)
            corners.push_back({corner.at + Vec2(wrist, arm), corner.isSharp});
        corners.insert(corners.end(), {{{78, arm - 9}},
                                       {{50, arm - 12}},
                                       {{33, 178}},
                                       {{25, 158}},
                                       {{24, 140}},
                                       {{33, 118}},
                                       {{48, 86}},
                                       {{56, 64}},
                                       {{69, 42}},
                                       {{78, 17}},
                                       {{96, 8}},
                                       {{103, 0}, true},
                                       {{68, 0}, true},
                                       {{63, 16}},
                                       {{50, 40}},
                                       {{38, 64}},
                                       {{20, 97}},
                                       {{0, 114}}});
        return corners;
    };
    std::vector<Corner> all = half(right);
    const std::vector<Corner> other = half(left);
    for (std::size_t i = other.size() - 1; i-- > 1;)
        all.push_back({{-other[i].at.x(), other[i].at.y()}, other[i].isSharp});
    return flowing(all);
}

} // namespace

/// Leonardo's man as a stand for cutlery, loaded as in the paper.
void cutleryMan(const std::string &folder)
{
    Maker maker;
    const SectionRef wide =
        maker.add("Forks and teaspoons", facingFront(0.0), man(fork(), spoon(36, 9)));
    const SectionRef deep =
        maker.addOn(wide, "Spoons and knives", facingRight(0.0), man(spoon(44, 13), knife()));
    maker.hang(wide, {70, 204}, 0.376);
    maker.hang(wide, {-70, 204}, 0.185);
    maker.hang(deep, {70, 204}, 0.476);
    maker.hang(deep, {-70, 204}, 0.405);
    maker.write(folder, "cutlery_man");
}

} // namespace fff::samples
