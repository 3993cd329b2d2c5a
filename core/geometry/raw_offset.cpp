#include "core/geometry/raw_offset.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace fff {

namespace {

// Halvings of one segment before what is left of it is taken for its chords; it is a cusp then.
constexpr int kMaxHalvings = 12;
// A boundary that turns by more is a cusp. Whether to the left or to the right may be rounding, or
// a loop too small to see; the half disc round its tip is swept either way.
constexpr double kCuspTurn = 5.0 / 6.0 * std::numbers::pi;
// An offset that is shorter than its curve by more than this share is left to chords.
constexpr double kLeastStretch = 0.02;
// Ends of offset curves that are this near, in mm, are led to one point.
constexpr double kSameEnd = 1e-4;
constexpr double kMaxArc = std::numbers::pi / 3.0; // of one cubic

/// Right of the direction: away from the material.
Vec2 rightOf(const Vec2 &direction)
{
    return -perpendicular(direction);
}

/// Unit tangent, also where the handle lies on the end point: there the next derivative that does
/// not vanish has it. Nothing for a segment that is a point.
std::optional<Vec2> tangent(const CubicBezier &curve, double t)
{
    const double size = std::max(
        {(curve.p1 - curve.p0).norm(), (curve.p2 - curve.p0).norm(), (curve.p3 - curve.p0).norm()});
    if (const Vec2 d = curve.derivative(t); d.norm() > kParallelSine * size)
        return d.normalized();
    // Towards the inside of the parameter range, and always forwards.
    const double side = t < 0.5 ? 1.0 : -1.0;
    if (const Vec2 d = side * curve.secondDerivative(t); d.norm() > kParallelSine * size)
        return d.normalized();
    const Vec2 chord = curve.p3 - curve.p0;
    if (chord.isZero())
        return std::nullopt;
    return chord.normalized();
}

/// A piece of the boundary with its offset, and the directions in which it begins and ends.
struct Piece
{
    Vec2 from, to; // of the boundary
    Vec2 first, last;
    CubicBezier offset;
    bool isStraight = false;
    int segment = 0;
};

class PieceMaker
{
public:
    PieceMaker(double distance, double error, std::vector<Piece> &pieces)
        : m_distance(distance), m_error(error), m_pieces(pieces)
    {
    }

    /// chord: 0 for curves
    void add(const CubicBezier &curve, int segment, double chord)
    {
        m_segment = segment;
        if (curve.isStraight(kClipGrid))
            addLine(curve.p0, curve.p3);
        else if (chord > 0.0)
            addChords(curve, chord, 0);
        else
            addCurve(curve, 0.0, 1.0, 0);
    }

private:
    void addLine(const Vec2 &from, const Vec2 &to)
    {
        const Vec2 way = to - from;
        if (way.norm() <= kClipGrid)
            return;
        const Vec2 direction = way.normalized(), shift = m_distance * rightOf(direction);
        m_pieces.push_back({from, to, direction, direction,
                            CubicBezier::line(from + shift, to + shift), true, m_segment});
    }

    /// Chords near the curve, whose offsets are as near to the curve's.
    void addChords(const CubicBezier &curve, double chord, int halvings)
    {
        const double bend =
            m_distance * (1.0 - std::cos(0.5 * turnOf(curve))); // beyond a chord's offset
        if (halvings == kMaxHalvings || (curve.isStraight(chord) && bend <= chord)) {
            addLine(curve.p0, curve.p3);
            return;
        }
        addChords(curve.piece(0.0, 0.5), chord, halvings + 1);
        addChords(curve.piece(0.5, 1.0), chord, halvings + 1);
    }

    /// How far the legs of its control polygon turn; π where one turns back.
    static double turnOf(const CubicBezier &curve)
    {
        double sum = 0.0;
        std::optional<Vec2> before;
        for (const Vec2 &leg :
             std::array<Vec2, 3>{curve.p1 - curve.p0, curve.p2 - curve.p1, curve.p3 - curve.p2}) {
            if (leg.norm() <= kParallelSine)
                continue;
            if (before)
                sum += std::abs(std::atan2(cross(*before, leg), before->dot(leg)));
            before = leg;
        }
        return std::min(sum, std::numbers::pi);
    }

    /// Cubics for the offset between two parameters: Hermite pieces with the exact ends and
    /// derivatives o' = c' (1 + distance · curvature). The curve itself is reproduced, so the error
    /// is only that of the normal, times the distance.
    void addCurve(const CubicBezier &curve, double from, double to, int halvings)
    {
        const auto direction = [&](double t) { return tangent(curve, t).value_or(Vec2::UnitX()); };
        const auto point = [&](double t) -> Vec2 {
            return curve.at(t) + m_distance * rightOf(direction(t));
        };
        const auto stretch = [&](double t) {
            const Vec2 d = curve.derivative(t);
            const double speed = d.norm();
            return 1.0 + m_distance * cross(d, curve.secondDerivative(t)) / (speed * speed * speed);
        };
        constexpr int kSamples = 8;
        int regular = 0; // not nan, too
        for (int i = 0; i <= kSamples; ++i)
            regular += stretch(from + (to - from) * i / kSamples) >= kLeastStretch ? 1 : 0;
        const bool isLast = halvings == kMaxHalvings;
        if (regular == 0 || (isLast && regular <= kSamples)) {
            addChords(curve.piece(from, to), 0.25 * m_error, 0);
            return;
        }
        const double step = (to - from) / 3.0;
        const Vec2 start = point(from), end = point(to);
        const CubicBezier piece{start,
                                start + step * (curve.derivative(from) * finite(stretch(from))),
                                end - step * (curve.derivative(to) * finite(stretch(to))), end};
        bool isNear = regular > kSamples;
        for (double u : {0.2, 0.4, 0.6, 0.8})
            isNear = isNear && (piece.at(u) - point(from + u * (to - from))).norm() <= m_error;
        if (isNear) {
            m_pieces.push_back({curve.at(from), curve.at(to), direction(from), direction(to), piece,
                                false, m_segment});
        } else if (isLast) {
            addChords(curve.piece(from, to), 0.25 * m_error, 0);
        } else {
            const double middle = 0.5 * (from + to);
            addCurve(curve, from, middle, halvings + 1);
            addCurve(curve, middle, to, halvings + 1);
        }
    }

    static double finite(double stretch) { return std::isfinite(stretch) ? stretch : 1.0; }

    double m_distance, m_error;
    std::vector<Piece> &m_pieces;
    int m_segment = 0;
};

/// The way from the end of one piece's offset to the start of the next one's.
class Joiner
{
public:
    Joiner(double distance, const OffsetStyle &style, RawOffset &result)
        : m_distance(distance), m_style(style), m_result(result)
    {
    }

    std::vector<CubicBezier> join(Piece &a, Piece &b)
    {
        const Vec2 end = a.offset.p3, start = b.offset.p0;
        const double gap = (start - end).norm();
        const double sine = cross(a.last, b.first), cosine = a.last.dot(b.first);
        if (gap <= kClipGrid)
            return {};
        if (gap <= kSameEnd && cosine > 0.0 && !(a.isStraight && b.isStraight)) {
            meetAt(a, b, b.isStraight ? start : end);
            return {};
        }
        double turn = std::atan2(sine, cosine);
        if (turn < 0.0 && turn > -kCuspTurn)
            return aroundRight(a, b, -turn);
        if (turn < 0.0)
            turn += 2.0 * std::numbers::pi;
        if (std::cos(0.5 * turn) * kMitreLimit < 1.0 || isRound(a, b))
            return arc(a, b, turn);
        return mitre(a, b, turn);
    }

private:
    /// Of two curves that all but meet.
    static void meetAt(Piece &a, Piece &b, const Vec2 &point)
    {
        if (!a.isStraight) {
            a.offset.p2 += point - a.offset.p3;
            a.offset.p3 = point;
        }
        if (!b.isStraight) {
            b.offset.p1 += point - b.offset.p0;
            b.offset.p0 = point;
        }
    }

    bool isRound(const Piece &a, const Piece &b) const
    {
        const auto segment = static_cast<std::size_t>(b.segment);
        // Between chords of one curve there are no corners to speak of.
        return a.segment != b.segment && segment < m_style.isRound.size() &&
               m_style.isRound[segment];
    }

    std::vector<CubicBezier> mitre(Piece &a, Piece &b, double turn)
    {
        const Vec2 end = a.offset.p3, start = b.offset.p0;
        const Vec2 tip = end + m_distance * std::tan(0.5 * turn) * a.last;
        if (a.segment != b.segment)
            m_result.mitres.push_back({b.from, b.segment});
        return through(a, b, end, tip, start);
    }

    /// A straight neighbour goes on to the point instead.
    static std::vector<CubicBezier> through(Piece &a, Piece &b, const Vec2 &end, const Vec2 &point,
                                            const Vec2 &start)
    {
        std::vector<CubicBezier> way;
        if (a.isStraight)
            a.offset = CubicBezier::line(a.offset.p0, point);
        else
            way.push_back(CubicBezier::line(end, point));
        if (b.isStraight)
            b.offset = CubicBezier::line(point, b.offset.p3);
        else
            way.push_back(CubicBezier::line(point, start));
        return way;
    }

    std::vector<CubicBezier> arc(const Piece &a, const Piece &b, double turn) const
    {
        const bool isFine = m_style.arcChord > 0.0;
        const double most =
            isFine ? std::min(kMaxArc, std::sqrt(8.0 * m_style.arcChord / m_distance)) : kMaxArc;
        const int count = std::max(1, static_cast<int>(std::ceil(turn / most)));
        const double step = turn / count;
        const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * m_distance;
        const Eigen::Rotation2Dd rotation(step);
        std::vector<CubicBezier> way;
        Vec2 direction = a.last, from = a.offset.p3;
        for (int i = 0; i < count; ++i) {
            const Vec2 next = rotation * direction;
            const Vec2 to = i + 1 < count ? Vec2(b.from + m_distance * rightOf(next)) : b.offset.p0;
            way.push_back(
                isFine ? CubicBezier::line(from, to)
                       : CubicBezier{from, from + handle * direction, to - handle * next, to});
            direction = next;
            from = to;
        }
        return way;
    }

    std::vector<CubicBezier> aroundRight(Piece &a, Piece &b, double turn) const
    {
        const Vec2 end = a.offset.p3, start = b.offset.p0;
        const double trim = m_distance * std::tan(0.5 * turn);
        const double room = 0.5 * std::min((a.to - a.from).norm(), (b.to - b.from).norm());
        if (a.isStraight && b.isStraight && trim <= room) {
            const Vec2 crossing = end - trim * a.last;
            return through(a, b, end, crossing, start);
        }
        return {CubicBezier::line(end, b.from), CubicBezier::line(b.from, start)};
    }

    double m_distance;
    const OffsetStyle &m_style;
    RawOffset &m_result;
};

} // namespace

Result<RawOffset> rawOffset(const Contour &contour, double distance, double error,
                            const OffsetStyle &style)
{
    std::vector<Piece> pieces;
    PieceMaker maker(distance, error, pieces);
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        maker.add(contour.segment(i), i, index < style.chords.size() ? style.chords[index] : 0.0);
    }
    RawOffset result;
    Joiner joiner(distance, style, result);
    std::vector<std::vector<CubicBezier>> joins;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        joins.push_back(joiner.join(pieces[i], pieces[(i + 1) % pieces.size()]));
    std::vector<CubicBezier> chain;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        chain.push_back(pieces[i].offset);
        chain.insert(chain.end(), joins[i].begin(), joins[i].end());
    }
    Result<Contour> moved = Contour::fromSegments(chain);
    if (!moved)
        return tl::unexpected(moved.error());
    result.contour = std::move(*moved);
    return result;
}

} // namespace fff
