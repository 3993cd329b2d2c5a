#include "core/stroke/calmed_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace fff {

namespace {

/// Samples to each side whose differences say how large the noise is, and fewer do not.
constexpr std::size_t kNoiseWindow = 16, kFewestDifferences = 12;
/// Mean squares of the differences of noise, in those of a coordinate's noise.
constexpr double kThirdDifferences = 20.0;
/// The median of what is a square of two equal normal numbers, in their variance.
constexpr double kMedianOfSquares = 1.386;
/// Third differences to second ones (squares): 3.3 of noise alone, far below 1 of a smooth way.
constexpr double kNoiseRatio = 1.1;
/// Noise in tolerances: less is left alone, so much is taken off, and more is meant.
constexpr double kLeastNoise = 0.25, kWholeNoise = 0.4, kMostNoise = 1.6;
/// Standard deviations that residuals may be above what the noise makes them.
constexpr double kResiduals = 3.0;

/// Samples before and after that a parabola is laid through; to both sides first, then to one, as
/// beside a corner, and few of them where the way bends too much for more.
struct Window
{
    std::size_t before = 0, after = 0;
};
constexpr std::array kWindows{Window{20, 20}, Window{12, 12}, Window{8, 8},  Window{14, 4},
                              Window{4, 14},  Window{14, 1},  Window{1, 14}, Window{14, 0},
                              Window{0, 14},  Window{5, 5},   Window{3, 3}};

double medianOf(std::array<double, 2 * kNoiseWindow + 1> &values, std::size_t count)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

/// Of a coordinate, around a sample: its standard deviation, mm. 0: it is none.
double noiseAt(const std::vector<Vec2> &p, std::size_t i)
{
    const std::size_t from = i > kNoiseWindow ? i - kNoiseWindow : 0;
    const std::size_t to = std::min(i + kNoiseWindow, p.size() - 1);
    std::array<double, 2 * kNoiseWindow + 1> second{}, third{};
    std::size_t count = 0;
    for (std::size_t k = from; k + 3 <= to; ++k, ++count) {
        const Vec2 one = p[k] - 2.0 * p[k + 1] + p[k + 2],
                   two = p[k + 1] - 2.0 * p[k + 2] + p[k + 3];
        second[count] = one.squaredNorm();
        third[count] = (two - one).squaredNorm();
    }
    if (count < kFewestDifferences)
        return 0.0;
    const double ofThird = medianOf(third, count);
    if (ofThird < kNoiseRatio * medianOf(second, count))
        return 0.0;
    return std::sqrt(ofThird / (kThirdDifferences * kMedianOfSquares));
}

/// Where the parabola through the window passes the sample; none where it cannot follow.
std::optional<Vec2> passing(const std::vector<Vec2> &p, std::size_t i, const Window &window,
                            double noise)
{
    if (i < window.before || i + window.after >= p.size())
        return {};
    const std::size_t from = i - window.before, to = i + window.after;
    // Moments about the window's middle: those of odd powers vanish.
    const double middle = 0.5 * static_cast<double>(from + to), count = double(to - from + 1);
    double m2 = 0.0, m4 = 0.0;
    Vec2 sum = Vec2::Zero(), first = Vec2::Zero(), second = Vec2::Zero();
    for (std::size_t k = from; k <= to; ++k) {
        const double t = static_cast<double>(k) - middle;
        const Vec2 off = p[k] - p[i];
        m2 += t * t;
        m4 += t * t * t * t;
        sum += off;
        first += t * off;
        second += t * t * off;
    }
    const double determinant = count * m4 - m2 * m2;
    const Vec2 base = (m4 * sum - m2 * second) / determinant;
    const Vec2 slope = first / m2;
    const Vec2 bend = (count * second - m2 * sum) / determinant;
    double residuals = 0.0;
    for (std::size_t k = from; k <= to; ++k) {
        const double t = static_cast<double>(k) - middle;
        residuals += (p[k] - p[i] - base - t * slope - t * t * bend).squaredNorm();
    }
    const double freedom = 2.0 * (count - 3.0);
    const double most = freedom * (1.0 + kResiduals * std::sqrt(2.0 / freedom));
    if (residuals > most * noise * noise)
        return {};
    const double t = static_cast<double>(i) - middle;
    return Vec2(p[i] + base + t * slope + t * t * bend);
}

Vec2 calmedAt(const std::vector<Vec2> &p, std::size_t i, double tolerance)
{
    const double noise = noiseAt(p, i);
    if (noise < kLeastNoise * tolerance || noise > kMostNoise * tolerance)
        return p[i];
    const double share =
        std::clamp((noise / tolerance - kLeastNoise) / (kWholeNoise - kLeastNoise), 0.0, 1.0);
    for (const Window &window : kWindows)
        if (const std::optional<Vec2> meant = passing(p, i, window, noise))
            return p[i] + share * (*meant - p[i]);
    return p[i];
}

} // namespace

void calm(const std::vector<Vec2> &samples, double tolerance, std::size_t from,
          std::vector<Vec2> &result)
{
    result.resize(samples.size());
    for (std::size_t i = from; i < samples.size(); ++i)
        result[i] = calmedAt(samples, i, tolerance);
}

} // namespace fff
