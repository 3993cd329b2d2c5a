#include "core/geometry/sampled_line.h"

#include "core/base/tolerances.h"
#include "core/geometry/bezier.h"
#include "core/geometry/simplified_line.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fff {

namespace {

/// A determinant below this part of its diagonal's product is rounding (no unit): the samples are
/// too few, or lie too near to each other, to tell a parabola from a line.
constexpr double kSingular = 1e-9;
/// Reaches between samples that are left without further ones.
constexpr double kLongestGap = 2.0;
/// Of a tolerance, that the line on which distances are measured may be off the samples.
constexpr double kMeasuringError = 1.0;
/// Tolerances of the line that a sample stands for in any case, also where the hand halts.
constexpr double kLeastWeight = 1e-3;
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
/// Of an edge of the simplified line, the middle part that says whether it stands for a straight
/// run: its ends reach into the bends beside it.
constexpr double kCore = 0.7;
/// Tolerances that a straight run may bend over that part. An arc whose chord is an edge of the
/// simplified line bends twice as much.
constexpr double kLargestBend = 0.2;
/// Tolerances that the line may leave a straight run's, on the mean over half a reach.
constexpr double kLeaving = 0.3;
/// Part that a run keeps at least when it is let go on to twice that.
constexpr double kAbruptness = 0.85;
/// Samples that tell a straight run from a quick hand's leaps.
constexpr std::size_t kStraightSamples = 8;
/// Of a tolerance, that samples may be off the parabola that says where the line passes.
constexpr double kParabolaError = 0.7;
/// Tolerances that a joint may be off its sample.
constexpr double kJointOffset = 0.9;
/// Reaches over which the parabola is laid, from the least to the most.
constexpr std::array kParabolaReaches{1.0, 2.0, 3.0};
/// Samples that a parabola is laid through at most.
constexpr std::size_t kParabolaSamples = 48;

Vec2 unit(const Vec2 &way)
{
    const double length = way.norm();
    return length > 0.0 ? Vec2(way / length) : Vec2::Zero();
}

} // namespace

std::vector<Vec2> SampledLine::usable(const std::vector<Vec2> &samples)
{
    std::vector<Vec2> points;
    points.reserve(samples.size());
    for (const Vec2 &p : samples) {
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > kMaxCoordinate)
            continue;
        if (points.empty() || (p - points.back()).norm() > kClipGrid)
            points.push_back(p);
    }
    return points;
}

SampledLine::SampledLine(const std::vector<Vec2> &samples, double tolerance, double reach)
    : m_tolerance(tolerance), m_reach(reach)
{
    fillGaps(usable(samples));
    if (m_points.size() < 2)
        return;
    measure();
    sum();
}

void SampledLine::fillGaps(const std::vector<Vec2> &drawn)
{
    m_points.reserve(drawn.size());
    m_drawn.reserve(drawn.size());
    for (const Vec2 &p : drawn) {
        if (!m_points.empty()) {
            const Vec2 from = m_points.back();
            const double pieces = std::min(std::ceil((p - from).norm() / (kLongestGap * m_reach)),
                                           double(CubicBezier::kMaxChords));
            for (double i = 1.0; i < pieces; ++i)
                m_points.push_back(from + (p - from) * (i / pieces));
        }
        m_drawn.push_back(m_points.size());
        m_points.push_back(p);
    }
}

std::size_t SampledLine::drawnBefore(std::size_t i) const
{
    const auto after = std::upper_bound(m_drawn.begin(), m_drawn.end(), i);
    return static_cast<std::size_t>(after - m_drawn.begin()) - 1;
}

void SampledLine::measure()
{
    m_vertices = simplified(m_points, kMeasuringError * m_tolerance);
    m_along.assign(m_points.size(), 0.0);
    for (std::size_t k = 0; k + 1 < m_vertices.size(); ++k) {
        const std::size_t from = m_vertices[k], to = m_vertices[k + 1];
        const Vec2 chord = m_points[to] - m_points[from];
        const double length = chord.norm();
        m_along[to] = m_along[from] + length;
        for (std::size_t i = from + 1; i < to; ++i) {
            // A hand that comes back to the very point has not got anywhere.
            const double foot =
                length > 0.0 ? chord.dot(m_points[i] - m_points[from]) / length : 0.0;
            m_along[i] = std::clamp(m_along[from] + foot, m_along[i - 1], m_along[to]);
        }
    }
    m_weight.resize(m_points.size());
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_weight[i] =
            kLeastWeight * m_tolerance +
            0.5 * (m_along[std::min(i + 1, m_points.size() - 1)] - m_along[i > 0 ? i - 1 : 0]);
}

void SampledLine::sum()
{
    m_sums.resize(m_points.size() + 1);
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        const double w = m_weight[i], s = m_along[i];
        const Vec2 p = m_points[i] - m_points.front();
        Sums &next = m_sums[i + 1];
        next = m_sums[i];
        next.w += w;
        next.s += w * s;
        next.ss += w * s * s;
        next.p += w * p;
        next.sp += w * s * p;
    }
}

std::size_t SampledLine::indexAt(double along) const
{
    const auto at = std::lower_bound(m_along.begin(), m_along.end(), along);
    return std::min(static_cast<std::size_t>(at - m_along.begin()), size() - 1);
}

/// Of the straight line through the samples [from, to] by least squares.
Vec2 SampledLine::directionBetween(std::size_t from, std::size_t to) const
{
    const Sums &a = m_sums[from], &b = m_sums[to + 1];
    const double w = b.w - a.w, s = b.s - a.s;
    const double spread = (b.ss - a.ss) - s * s / w;
    const Vec2 slope = (b.sp - a.sp) - (s / w) * (b.p - a.p);
    if (to - from >= 2 && spread > 0.0 && slope.norm() > 0.0)
        return unit(slope);
    return unit(m_points[to] - m_points[from]);
}

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

/// Least squares over the samples [from, to], each counting for the line it stands for.
SampledLine::Parabola SampledLine::parabola(std::size_t at, std::size_t from, std::size_t to,
                                            bool isThroughPoint) const
{
    const std::size_t step = (to - from) / kParabolaSamples + 1;
    std::array<double, 5> m{}; // moments of s
    std::array<Vec2, 3> r{Vec2::Zero(), Vec2::Zero(), Vec2::Zero()};
    const Vec2 &base = m_points[at];
    const double scale = 1.0 / m_reach;
    for (std::size_t i = from; i <= to; i += step) {
        const double s = (m_along[i] - m_along[at]) * scale;
        const double w = m_weight[i];
        const Vec2 p = m_points[i] - base;
        double power = w;
        for (std::size_t k = 0; k < 5; ++k, power *= s) {
            m[k] += power;
            if (k < 3)
                r[k] += power * p;
        }
    }
    Parabola result;
    Vec2 bend = Vec2::Zero(), slope = Vec2::Zero(), offset = Vec2::Zero();
    // Two or three unknowns; a matrix without a parabola in it gives a straight line.
    const auto straight = [&] { slope = m[2] > 0.0 ? Vec2(r[1] / m[2]) : Vec2::Zero(); };
    if (isThroughPoint) {
        const double determinant = m[2] * m[4] - m[3] * m[3];
        if (determinant > kSingular * m[2] * m[4]) {
            slope = (m[4] * r[1] - m[3] * r[2]) / determinant;
            bend = (m[2] * r[2] - m[3] * r[1]) / determinant;
        } else {
            straight();
        }
    } else {
        Eigen::Matrix3d matrix;
        matrix << m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4];
        const double determinant = matrix.determinant();
        if (determinant > kSingular * m[0] * m[2] * m[4]) {
            Eigen::Matrix<double, 3, 2> right;
            right << r[0].transpose(), r[1].transpose(), r[2].transpose();
            const Eigen::Matrix<double, 3, 2> x = matrix.inverse() * right;
            offset = x.row(0).transpose();
            slope = x.row(1).transpose();
            bend = x.row(2).transpose();
        } else {
            straight();
        }
    }
    result.position = base + offset;
    result.slope = slope;
    result.bend = bend;
    for (std::size_t i = from; i <= to; i += step) {
        const double s = (m_along[i] - m_along[at]) * scale;
        const Vec2 off = offset + s * slope + s * s * bend - (m_points[i] - base);
        result.largestError = std::max(result.largestError, off.squaredNorm());
    }
    result.largestError = std::sqrt(result.largestError);
    return result;
}

CurveEnd SampledLine::joint(std::size_t at, std::size_t from, std::size_t to, bool isEnd) const
{
    CurveEnd result{m_points[at], unit(m_points[to] - m_points[from])};
    for (std::size_t k = 0; k < kParabolaReaches.size(); ++k) {
        const double reach = kParabolaReaches[k] * m_reach;
        const std::size_t first = std::max(indexAt(m_along[at] - reach), from);
        std::size_t last = std::min(indexAt(m_along[at] + reach), to);
        if (last > at && m_along[last] > m_along[at] + reach)
            --last;
        last = std::max(last, std::min(at + 1, to));
        const Parabola fit = parabola(at, std::min(first, at > from ? at - 1 : from), last, isEnd);
        const Vec2 direction = unit(fit.slope);
        if (k > 0 && fit.largestError > kParabolaError * m_tolerance)
            break;
        if (direction.isZero())
            continue;
        result.direction = direction;
        const Vec2 off = fit.position - m_points[at];
        const double limit = kJointOffset * m_tolerance;
        if (!isEnd)
            result.position =
                m_points[at] + off * std::min(1.0, limit / std::max(off.norm(), limit));
    }
    if (result.direction.isZero())
        result.direction = Vec2::UnitX();
    return result;
}

CurveEnd SampledLine::smoothJoint(std::size_t at, std::size_t from, std::size_t to) const
{
    return joint(at, from, to, false);
}

CurveEnd SampledLine::startJoint(std::size_t from, std::size_t to) const
{
    return joint(from, from, to, true);
}

CurveEnd SampledLine::endJoint(std::size_t from, std::size_t to) const
{
    return joint(to, from, to, true);
}

bool SampledLine::isStraight(std::size_t from, std::size_t to, double tolerance) const
{
    const Vec2 chord = m_points[to] - m_points[from];
    const double length = chord.norm();
    if (length <= kClipGrid)
        return false;
    const Vec2 way = chord / length;
    double furthest = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
        const Vec2 off = m_points[i] - m_points[from];
        const double along = way.dot(off);
        furthest = std::max(furthest, along);
        const Vec2 foot = std::clamp(along, 0.0, length) * way;
        if ((off - foot).norm() > tolerance || along < furthest - tolerance)
            return false;
    }
    return true;
}

Vec2 SampledLine::meanBetween(std::size_t from, std::size_t to) const
{
    const Sums &a = m_sums[from], &b = m_sums[to + 1];
    return m_points.front() + (b.p - a.p) / (b.w - a.w);
}

/// Both ends as far out as the line stays within `leaving` mm of the run's.
StraightRun SampledLine::extended(StraightRun run, const Vec2 &base, double leaving,
                                  std::size_t lowest, std::size_t highest) const
{
    const Vec2 &way = run.start.direction;
    const auto off = [&](const Vec2 &p) { return std::abs(cross(way, p - base)); };
    const auto isOnLine = [&](std::size_t next, std::size_t a, std::size_t b) {
        return off(m_points[next]) <= m_tolerance && off(meanBetween(a, b)) <= leaving;
    };
    const double ahead = 0.5 * m_reach;
    while (run.to < highest) {
        const std::size_t next = run.to + 1;
        if (!isOnLine(next, next, std::max(indexAt(m_along[run.to] + ahead), next)))
            break;
        run.to = next;
    }
    while (run.from > lowest) {
        const std::size_t next = run.from - 1;
        if (!isOnLine(next, std::min(indexAt(m_along[run.from] - ahead), next), next))
            break;
        run.from = next;
    }
    return run;
}

/// The one that an edge of the simplified line stands for, if it does, within [lowest, highest].
std::optional<StraightRun> SampledLine::straightRun(std::size_t from, std::size_t to,
                                                    std::size_t lowest, std::size_t highest) const
{
    const double cut = 0.5 * (1.0 - kCore) * lengthBetween(from, to);
    const std::size_t first = indexAt(m_along[from] + cut), last = indexAt(m_along[to] - cut);
    const std::size_t middle = indexAt(0.5 * (m_along[first] + m_along[last]));
    if (last < first + 2 || middle <= first || middle >= last)
        return {};
    const Vec2 way = directionBetween(first, last), base = meanBetween(first, last);
    const Parabola fit = parabola(middle, first, last, false);
    const double half = 0.5 * lengthBetween(first, last) / m_reach;
    if (std::abs(cross(way, fit.bend)) * half * half > kLargestBend * m_tolerance)
        return {};
    const auto off = [&](const Vec2 &p) { return std::abs(cross(way, p - base)); };
    for (std::size_t i = first; i <= last; ++i) {
        if (off(m_points[i]) > m_tolerance)
            return {};
    }
    const StraightRun core{first, last, {base, way}, {base, way}};
    StraightRun run = extended(core, base, kLeaving * m_tolerance, lowest, highest);
    const StraightRun more = extended(run, base, 2.0 * kLeaving * m_tolerance, lowest, highest);
    if (lengthBetween(run.from, run.to) < kAbruptness * lengthBetween(more.from, more.to) ||
        drawnBefore(run.to) < drawnBefore(run.from) + kStraightSamples)
        return {};
    const auto joint = [&](std::size_t i) {
        return CurveEnd{base + way.dot(m_points[i] - base) * way, way};
    };
    run.start = joint(run.from);
    run.end = joint(run.to);
    if ((run.end.position - run.start.position).dot(way) < kLeastStraight * m_reach)
        return {};
    return run;
}

std::vector<StraightRun> SampledLine::straightRuns(std::size_t from, std::size_t to) const
{
    std::vector<StraightRun> runs;
    const auto firstVertex = std::upper_bound(m_vertices.begin(), m_vertices.end(), from);
    auto k = static_cast<std::size_t>(firstVertex - m_vertices.begin());
    k = k > 0 ? k - 1 : 0;
    for (; k + 1 < m_vertices.size() && m_vertices[k] < to; ++k) {
        const std::size_t lowest = runs.empty() ? from : runs.back().to;
        const std::size_t a = std::max(m_vertices[k], lowest), b = std::min(m_vertices[k + 1], to);
        if (b <= a || lengthBetween(a, b) < kLeastStraight * m_reach)
            continue;
        if (const auto run = straightRun(a, b, lowest, to))
            runs.push_back(*run);
    }
    return runs;
}

} // namespace fff
