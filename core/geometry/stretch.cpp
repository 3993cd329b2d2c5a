#include "core/geometry/stretch.h"

#include "core/base/tolerances.h"
#include "core/geometry/curve_crossing.h"

#include <algorithm>

namespace fff {

Result<Contour> stretchedOutside(const Contour &contour, const Halfplane &kept, double factor)
{
    const auto isBelow = [&](const Vec2 &p) { return kept.height(p) < 0.0; };
    std::vector<CubicBezier> pieces;
    const auto add = [&](CubicBezier piece) {
        if (isBelow(piece.at(0.5)))
            for (Vec2 *p : {&piece.p0, &piece.p1, &piece.p2, &piece.p3})
                *p += (factor - 1.0) * kept.height(*p) * kept.inward;
        if (!pieces.empty())
            piece.p0 = pieces.back().p3;
        pieces.push_back(piece);
    };
    for (int i = 0; i < contour.segmentCount(); ++i) {
        const CubicBezier curve = contour.segment(i);
        std::vector<double> nodes = levelParameters(curve, kept.inward);
        nodes.push_back(1.0);
        double from = 0.0, piece = 0.0;
        for (const double to : nodes) {
            const double here = kept.height(curve.at(from)), there = kept.height(curve.at(to));
            if (std::min(here, there) < -kOnLine && std::max(here, there) > kOnLine) {
                if (const auto t = crossLine({curve, from, to}, kept.point, kept.inward, 0.0)) {
                    add(curve.piece(piece, *t));
                    piece = *t;
                }
            }
            from = to;
        }
        add(curve.piece(piece, 1.0));
    }
    pieces.back().p3 = pieces.front().p0;
    return Contour::fromSegments(pieces);
}

} // namespace fff
