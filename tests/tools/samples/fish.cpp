#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

/// A trout on two feet: one body, ribs across it.
void fish(const std::string &folder)
{
    Maker maker(3.0);
    maker.add(
        "Body", facingFront(0.0),
        through({{{-128, 66}},     {{-112, 84}},      {{-84, 98}}, {{-46, 108}}, {{-34, 128}, true},
                 {{-4, 126}},      {{22, 106}},       {{58, 92}},  {{92, 80}},   {{136, 112}, true},
                 {{128, 76}},      {{136, 40}, true}, {{92, 66}},  {{62, 50}},   {{36, 42}},
                 {{20, 26}, true}, {{4, 38}},         {{-40, 36}}, {{-84, 42}},  {{-114, 54}}}),
        {ellipse({-102, 76}, 5, 5)});
    // Where, how wide to each side, from and to which height.
    const double ribs[][4] = {{-86, 22, 50, 91}, {-66, 29, 44, 97}, {-20, 33, 44, 98},
                              {4, 31, 47, 95},   {50, 18, 57, 86},  {70, 12, 62, 80}};
    int number = 1;
    for (const auto &[x, wide, low, high] : ribs)
        maker.add("Rib " + std::to_string(number++), facingRight(x),
                  ellipse({0, (low + high) / 2}, wide, (high - low) / 2));
    for (const double x : {-43.0, 27.0}) {
        const bool isFront = x < 0;
        const double wide = isFront ? 33 : 26, middle = isFront ? 72 : 70, up = isFront ? 28 : 22;
        maker.add(isFront ? "Front foot" : "Hind foot", facingRight(x),
                  through({{{0, middle + up}},
                           {{-wide * 0.8, middle + up * 0.6}},
                           {{-wide, middle}},
                           {{-wide * 0.62, middle - up * 0.85}},
                           {{-16, 24}},
                           {{-38, 7}},
                           {{-40, 0}, true},
                           {{-18, 0}, true},
                           {{0, 11}},
                           {{18, 0}, true},
                           {{40, 0}, true},
                           {{38, 7}},
                           {{16, 24}},
                           {{wide * 0.62, middle - up * 0.85}},
                           {{wide, middle}},
                           {{wide * 0.8, middle + up * 0.6}}}));
    }
    maker.write(folder, "fish");
}

} // namespace fff::samples
