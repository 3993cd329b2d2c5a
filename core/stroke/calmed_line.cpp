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
/// Samples before and after that a parabola is laid through.
struct Window
{
    std::size_t before = 0, after = 0;
};
/// Few of them to both sides, more as long as they say the same, and those beside a corner.
constexpr Window kFew{5, 5}, kFewest{3, 3};
constexpr std::array kMore{Window{8, 8}, Window{12, 12}, Window{20, 20}};
constexpr std::array kOneSided{Window{14, 1}, Window{1, 14}, Window{14, 0},
                               Window{0, 14}, Window{9, 0},  Window{0, 9}};
/// Standard deviations that residuals may be above what the noise makes them: of few samples, and
/// of more. Of the noise, by how much few and more may differ.
/// Samples beside one that have a say.
constexpr std::size_t kNeighbours = 2;
constexpr double kOfFew = 2.5, kOfMore = 1.5, kDiffer = 0.55;
/// The same where nothing follows, not from one side either: it is no corner, but more noise than
/// elsewhere.
constexpr double kOfWild = 16.0;

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

/// A parabola in time, laid through the samples around one of them.
struct Parabola
{
    std::size_t from = 0, to = 0;
    double middle = 0.0;
    Vec2 base = Vec2::Zero(), slope = Vec2::Zero(), bend = Vec2::Zero();

    Vec2 at(std::size_t i) const
    {
        const double t = static_cast<double>(i) - middle;
        return base + t * slope + t * t * bend;
    }
};

/// None where it cannot follow the samples within the noise.
std::optional<Parabola> laid(const std::vector<Vec2> &p, std::size_t i, const Window &window,
                             double noise, double deviations)
{
    if (i < window.before || i + window.after >= p.size())
        return {};
    Parabola result{i - window.before, i + window.after};
    // Moments about the window's middle: those of odd powers vanish.
    result.middle = 0.5 * static_cast<double>(result.from + result.to);
    const auto count = static_cast<double>(result.to - result.from + 1);
    double m2 = 0.0, m4 = 0.0;
    Vec2 sum = Vec2::Zero(), first = Vec2::Zero(), second = Vec2::Zero();
    for (std::size_t k = result.from; k <= result.to; ++k) {
        const double t = static_cast<double>(k) - result.middle;
        const Vec2 off = p[k] - p[i];
        m2 += t * t;
        m4 += t * t * t * t;
        sum += off;
        first += t * off;
        second += t * t * off;
    }
    const double determinant = count * m4 - m2 * m2;
    result.base = p[i] + (m4 * sum - m2 * second) / determinant;
    result.slope = first / m2;
    result.bend = (count * second - m2 * sum) / determinant;
    double residuals = 0.0;
    for (std::size_t k = result.from; k <= result.to; ++k)
        residuals += (p[k] - result.at(k)).squaredNorm();
    const double freedom = 2.0 * (count - 3.0);
    const double most = freedom * (1.0 + deviations * std::sqrt(2.0 / freedom));
    if (residuals > most * noise * noise)
        return {};
    return result;
}

/// The longest that follows the samples around one, which are noise.
std::optional<Parabola> longest(const std::vector<Vec2> &p, std::size_t i, double noise)
{
    if (std::optional<Parabola> best = laid(p, i, kFew, noise, kOfFew)) {
        const Vec2 few = best->at(i);
        for (const Window &window : kMore) {
            const std::optional<Parabola> more = laid(p, i, window, noise, kOfMore);
            if (!more || (more->at(i) - few).norm() > kDiffer * noise)
                break;
            best = more;
        }
        return best;
    }
    for (const Window &window : kOneSided)
        if (const std::optional<Parabola> meant = laid(p, i, window, noise, kOfMore))
            return meant;
    if (const std::optional<Parabola> meant = laid(p, i, kFewest, noise, kOfFew))
        return meant;
    return laid(p, i, kFew, noise, kOfWild);
}

/// What is known around a sample.
struct Local
{
    double share = 0.0; // of the noise that is taken off; 0: it is none
    std::optional<Parabola> meant;
};

Local localAt(const std::vector<Vec2> &p, std::size_t i, double tolerance)
{
    const double noise = noiseAt(p, i);
    if (noise < kLeastNoise * tolerance || noise > kMostNoise * tolerance)
        return {};
    return {std::min((noise / tolerance - kLeastNoise) / (kWholeNoise - kLeastNoise), 1.0),
            longest(p, i, noise)};
}

} // namespace

void calm(const std::vector<Vec2> &samples, double tolerance, std::size_t from,
          std::vector<Vec2> &result)
{
    result.resize(samples.size());
    const std::size_t first = from > kNeighbours ? from - kNeighbours : 0;
    std::vector<Local> locals;
    for (std::size_t i = first; i < samples.size(); ++i)
        locals.push_back(localAt(samples, i, tolerance));
    for (std::size_t i = from; i < samples.size(); ++i) {
        result[i] = samples[i];
        const Local &here = locals[i - first];
        if (here.share <= 0.0)
            continue;
        // The mean of what those beside it say, so that the line does not jump between them; also
        // where the sample is off by so much that none of its own can follow it.
        Vec2 sum = Vec2::Zero();
        double count = 0.0;
        for (std::size_t k = i > first + kNeighbours ? i - kNeighbours : first;
             k <= std::min(i + kNeighbours, samples.size() - 1); ++k) {
            const std::optional<Parabola> &meant = locals[k - first].meant;
            if (!meant || i < meant->from || i > meant->to)
                continue;
            sum += meant->at(i);
            count += 1.0;
        }
        if (count > 0.0)
            result[i] += here.share * (sum / count - samples[i]);
    }
}

} // namespace fff
