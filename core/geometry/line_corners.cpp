// Where a drawn line turns all at once.
#include "core/geometry/sampled_line.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Reaches over which a corner is judged.
constexpr double kCornerReach = 1.5;
/// Of a corner's turn, what has to be seen over half the reach as well: of a bend it is half.
constexpr double kConcentration = 0.45;
/// Of the angle that makes a corner, what the curves that meet there have to turn by themselves.
constexpr double kSharpness = 0.7;
/// Reaches to each side of a corner that say whether it stands out, how far off a cubic its sides
/// lie on the mean, as a part of their length and the sine of half the turn, and the part of that
/// from which on it does.
constexpr double kCornerSide = 2.5, kCornerOff = 0.072, kStandsOut = 0.55;
/// And so many times as far, squared, as from two parabolas that meet there.
constexpr double kTimesApart = 1.8;
/// A step aside by a shaky hand: its width and the way over it in reaches, and by how much the line
/// may turn over it, radians.
constexpr double kStepWidth = 0.45, kStepWay = 1.5, kStepTurn = 0.35;
/// With fewer samples a cubic follows any corner.
constexpr std::size_t kToTell = 9;

} // namespace

double SampledLine::turnAt(std::size_t at, double reach) const
{
    const std::size_t from = std::min(indexAt(m_along[at] - reach), at > 0 ? at - 1 : 0);
    const std::size_t to = std::max(indexAt(m_along[at] + reach), std::min(at + 1, size() - 1));
    return turnBetween(directionBetween(from, at), directionBetween(at, to));
}

/// The sample near `at` that is furthest out: in the direction in which a corner points whose sides
/// go as the line does before and after.
std::size_t SampledLine::sharpest(std::size_t at, double reach) const
{
    const auto around = [&](double from) { return indexAt(m_along[at] + from * reach); };
    const std::size_t from = around(-1.5), before = std::max(around(-0.25), from + 1);
    const std::size_t to = around(1.5), after = std::min(around(0.25), std::max(to, at + 1) - 1);
    if (before > at || after < at)
        return at;
    const Vec2 outwards = directionBetween(from, before) - directionBetween(after, to);
    std::size_t best = at;
    for (std::size_t i = std::max<std::size_t>(around(-0.75), 1);
         i <= std::min(around(0.75), size() - 2); ++i) {
        if (outwards.dot(m_points[i] - m_points[best]) > 0.0)
            best = i;
    }
    return best;
}

std::vector<std::size_t> SampledLine::corners(double angle) const
{
    std::vector<std::size_t> result;
    const double reach = kCornerReach * m_reach;
    // So near to an end there is too little line to tell a corner from a shaky hand.
    const double least = 0.5 * m_reach;
    std::size_t best = 0; // of a reach; 0 for none
    double bestTurn = 0.0;
    const auto settle = [&] {
        if (best == 0)
            return;
        const std::size_t corner = sharpest(best, m_reach);
        if ((result.empty() || m_along[corner] > m_along[result.back()]) &&
            turnAt(corner, 0.5 * reach) >= kConcentration * bestTurn)
            result.push_back(corner);
        best = 0;
    };
    for (std::size_t i = 1; i + 1 < size(); ++i) {
        if (best > 0 && lengthBetween(best, i) > m_reach)
            settle();
        if (m_along[i] < least || length() - m_along[i] < least)
            continue;
        const double here = turnAt(i, reach);
        if (here > angle && (best == 0 || here > bestTurn)) {
            best = i;
            bestTurn = here;
        }
    }
    settle();
    // Bends look like corners from afar: what two parabolas that end there say is nearer.
    const std::vector<std::size_t> found = withoutSteps(result);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t from = kept > 0 ? result[kept - 1] : 0;
        const std::size_t to = k + 1 < found.size() ? found[k + 1] : size() - 1;
        const CurveEnd before = endJoint(from, found[k]), after = startJoint(found[k], to);
        const double turn = turnBetween(before.direction, after.direction);
        if (turn >= kSharpness * angle && standsOut(found[k], from, to, turn))
            result[kept++] = found[k];
    }
    result.resize(kept);
    return result;
}

/// Without pairs of them between which the line only goes over to another track beside its own.
std::vector<std::size_t> SampledLine::withoutSteps(const std::vector<std::size_t> &corners) const
{
    std::vector<std::size_t> result;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        result.push_back(corners[k]);
        if (k + 1 == corners.size() ||
            lengthBetween(corners[k], corners[k + 1]) > kStepWay * m_reach)
            continue;
        const std::size_t a = corners[k], b = corners[k + 1];
        const double side = kCornerSide * m_reach;
        if (m_along[a] < side || length() - m_along[b] < side)
            continue;
        const Vec2 before = directionBetween(indexAt(m_along[a] - side), a),
                   after = directionBetween(b, indexAt(m_along[b] + side));
        const Vec2 over = m_points[b] - m_points[a], way = unit(before + after);
        if (turnBetween(before, after) > kStepTurn || way.dot(over) <= 0.0 ||
            std::abs(cross(way, over)) > kStepWidth * m_reach)
            continue;
        result.pop_back();
        ++k;
    }
    return result;
}

/// Of the samples [from, to] from the polynomial of so many coefficients that is nearest to them, a
/// function of the way along, mm²; one that passes the sample `at`, where it has to.
template <int Count>
double SampledLine::meanSquareOff(std::size_t at, std::size_t from, std::size_t to,
                                  bool isThroughPoint) const
{
    using Matrix = Eigen::Matrix<double, Count, Count>;
    Matrix matrix = Matrix::Zero();
    Eigen::Matrix<double, Count, 2> right = Eigen::Matrix<double, Count, 2>::Zero();
    const auto powers = [&](std::size_t i) {
        Eigen::Matrix<double, Count, 1> v;
        const double s = (m_along[i] - m_along[at]) / m_reach;
        v[0] = isThroughPoint ? 0.0 : 1.0;
        double power = 1.0;
        for (int k = 1; k < Count; ++k)
            v[k] = power *= s;
        return v;
    };
    double weight = 0.0;
    for (std::size_t i = from; i <= to; ++i) {
        const auto v = powers(i);
        matrix += m_weight[i] * v * v.transpose();
        right += m_weight[i] * v * (m_points[i] - m_points[at]).transpose();
        weight += m_weight[i];
    }
    for (int k = 0; k < Count; ++k)
        matrix(k, k) += kSingular * weight;
    const Eigen::Matrix<double, Count, 2> x = matrix.ldlt().solve(right);
    double sum = 0.0;
    for (std::size_t i = from; i <= to; ++i)
        sum +=
            m_weight[i] * (x.transpose() * powers(i) - (m_points[i] - m_points[at])).squaredNorm();
    return sum / weight;
}

/// Whether the samples around lie about a cubic as they do about a corner that turns so much, and
/// not as those of a bend or of a shaky hand do.
bool SampledLine::standsOut(std::size_t at, std::size_t from, std::size_t to, double turn) const
{
    const double side =
        std::min({kCornerSide * m_reach, lengthBetween(from, at), lengthBetween(at, to)});
    const std::size_t first = std::max(indexAt(m_along[at] - side), from);
    const std::size_t last = std::min(indexAt(m_along[at] + side), to);
    if (!(side > 0.0) || last < first + kToTell)
        return true;
    const double smooth = meanSquareOff<4>(at, first, last, false);
    const double apart =
        0.5 * (meanSquareOff<3>(at, first, at, true) + meanSquareOff<3>(at, at, last, true));
    const double expected = kCornerOff * side * std::sin(0.5 * turn);
    return smooth - apart >= kStandsOut * kStandsOut * expected * expected &&
           smooth >= kTimesApart * apart;
}

} // namespace fff
