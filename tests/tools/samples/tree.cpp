#include "tests/tools/samples/contours.h"
#include "tests/tools/samples/maker.h"
#include "tests/tools/samples/samples.h"

namespace fff::samples {

/// A fir of two silhouettes with small ones across.
void tree(const std::string &folder)
{
    Maker maker(3.0);
    const auto silhouette = [](double wide) {
        const std::vector<Vec2> right = {{27, 0},
                                         {9, 14},
                                         {wide, 34},
                                         {wide * 0.5, 70},
                                         {wide * 0.76, 72},
                                         {wide * 0.36, 108},
                                         {wide * 0.54, 110},
                                         {wide * 0.2, 144},
                                         {wide * 0.32, 146}};
        std::vector<Corner> corners;
        for (std::size_t i = 0; i < right.size(); ++i)
            corners.push_back({right[i], i < 2 || i % 2 == 0});
        corners.push_back({{0, 184}, true});
        for (std::size_t i = right.size(); i-- > 0;)
            corners.push_back({{-right[i].x(), right[i].y()}, i < 2 || i % 2 == 0});
        return through(corners);
    };
    maker.add("Fir", facingFront(0.0), silhouette(72));
    maker.add("Fir across", facingRight(0.0), silhouette(72));
    const auto twig = [](double low, double high, double wide) {
        return through({{{0, high}, true},
                        {{-wide * 0.45, low + (high - low) * 0.42}},
                        {{-wide, low}, true},
                        {{0, low + 5}},
                        {{wide, low}, true},
                        {{wide * 0.45, low + (high - low) * 0.42}}});
    };
    int number = 1;
    for (const double at : {-40.0, 40.0}) {
        maker.add("Twig " + std::to_string(number++), facingRight(at), twig(38, 92, 30));
        maker.add("Twig " + std::to_string(number++), facingFront(at), twig(38, 92, 30));
    }
    for (const double at : {-22.0, 22.0}) {
        maker.add("Twig " + std::to_string(number++), facingRight(at), twig(78, 140, 18));
        maker.add("Twig " + std::to_string(number++), facingFront(at), twig(78, 140, 18));
    }
    maker.write(folder, "tree");
}

} // namespace fff::samples
