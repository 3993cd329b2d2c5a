#include "core/physics/stress_places.h"

#include <algorithm>
#include <numeric>

namespace fff {

namespace {
/// Ends of necks this near are at one corner, mm.
constexpr double kOneCorner = 0.05;
} // namespace

std::vector<int> weakestPlaces(const SectionStress &stress, const PlaceOptions &options)
{
    const auto of = [&stress](int i) -> const NeckStress & {
        return stress.necks[static_cast<std::size_t>(i)];
    };
    std::vector<int> order(stress.necks.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&of](int a, int b) { return of(a).cornerUse > of(b).cornerUse; });
    std::vector<int> kept;
    for (const int i : order) {
        const NeckStress &neck = of(i);
        if (neck.cornerUse < options.least)
            break;
        if (!neck.counts())
            continue;
        const bool isCorner = neck.stress.notch > 1.0;
        const Vec2 middle = 0.5 * (neck.begin + neck.end);
        int atOneCorner = 0;
        bool isCovered = false;
        for (const int k : kept) {
            const NeckStress &other = of(k);
            const auto meets = [&other](const Vec2 &p) {
                return (other.begin - p).norm() < kOneCorner || (other.end - p).norm() < kOneCorner;
            };
            const bool isOneCorner =
                isCorner && other.stress.notch > 1.0 && (meets(neck.begin) || meets(neck.end));
            if (isOneCorner)
                ++atOneCorner;
            else if ((0.5 * (other.begin + other.end) - middle).norm() < options.along)
                isCovered = true;
        }
        if (!isCovered && atOneCorner < options.atCorner)
            kept.push_back(i);
    }
    return kept;
}

} // namespace fff
