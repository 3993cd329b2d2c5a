#include "core/geometry/bulge.h"

#include "core/geometry/arc_length.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// mm: a boundary is not cut nearer to an anchor than this.
constexpr double kLeastPiece = 1e-3;

/// Of the way, after so much of the boundary from the middle, mm, of either sign; and how fast that
/// changes.
struct Push
{
    double share = 0.0, slope = 0.0;
};

Push pushAt(double from, const Bulge &bulge)
{
    const double u = (bulge.flat + bulge.blend - std::abs(from)) / bulge.blend;
    if (u <= 0.0)
        return {};
    if (u >= 1.0)
        return {1.0, 0.0};
    return {u * u * (3.0 - 2.0 * u), (from > 0.0 ? -6.0 : 6.0) * u * (1.0 - u) / bulge.blend};
}

/// The piece of a boundary between two places, which are so far from the middle.
CubicBezier pushed(const CubicBezier &piece, double from, double to, const Bulge &bulge)
{
    const Push first = pushAt(from, bulge), last = pushAt(to, bulge);
    const Vec2 begin = first.share * bulge.way, end = last.share * bulge.way;
    const Vec2 out = piece.p1 - piece.p0, in = piece.p2 - piece.p3;
    return {piece.p0 + begin, piece.p1 + begin + first.slope * out.norm() * bulge.way,
            piece.p2 + end - last.slope * in.norm() * bulge.way, piece.p3 + end};
}

} // namespace

Result<Contour> bulged(const Contour &contour, const Bulge &bulge)
{
    const ArcLength length(contour);
    const double total = length.total(), reach = bulge.flat + bulge.blend;
    if (!(bulge.flat >= 0.0) || !(bulge.blend > 0.0) || !(2.0 * reach < total))
        return failure(ErrorCode::BadValue);
    const double middle = length.of(bulge.middle);
    // Of a place, by what is shorter.
    const auto fromMiddle = [&](double at) { return std::remainder(at - middle, total); };
    std::vector<CubicBezier> segments;
    double start = 0.0;
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier segment = contour.segment(i);
        const double end = i + 1 < contour.segmentCount() ? length.of({i + 1, 0.0}) : total;
        std::vector<double> cuts{start};                    // along the boundary
        const double half = bulge.flat + 0.5 * bulge.blend; // a cubic for each half of what bends
        for (const double cut : {-reach, -half, -bulge.flat, bulge.flat, half, reach}) {
            double at = std::fmod(middle + cut, total);
            at += at < 0.0 ? total : 0.0;
            if (at > start + kLeastPiece && at < end - kLeastPiece)
                cuts.push_back(at);
        }
        std::sort(cuts.begin(), cuts.end());
        cuts.erase(std::unique(cuts.begin(), cuts.end(),
                               [](double a, double b) { return b - a < kLeastPiece; }),
                   cuts.end());
        cuts.push_back(end);
        double t = 0.0;
        for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
            const double next = k + 2 == cuts.size() ? 1.0 : length.at(cuts[k + 1]).t;
            const CubicBezier piece = t == 0.0 && next == 1.0 ? segment : segment.piece(t, next);
            // Measured from its middle, so that none goes the long way round.
            const double at = fromMiddle(0.5 * (cuts[k] + cuts[k + 1]));
            const double side = 0.5 * (cuts[k + 1] - cuts[k]);
            segments.push_back(std::abs(at) < reach ? pushed(piece, at - side, at + side, bulge)
                                                    : piece);
            t = next;
        }
        start = end;
    }
    return Contour::fromSegments(segments);
}

} // namespace fff
