#include "core/stroke/closed_fit.h"

#include "core/base/tolerances.h"
#include "core/geometry/closed_line.h"

namespace fff {

namespace {

/// The line without what lies in between, and how long that is.
struct Ends
{
    std::vector<Vec2> line;
    std::size_t headCount = 0; // samples of it before the gap
    double between = 0.0;      // mm
};

Ends endsOf(const std::vector<Vec2> &samples, const std::vector<FittedPiece> &settled,
            const PieceRange &kept)
{
    const std::size_t first = settled[kept.begin].from, last = settled[kept.end - 1].to;
    Ends ends;
    const auto at = [&](std::size_t i) { return samples.begin() + static_cast<std::ptrdiff_t>(i); };
    ends.line.assign(samples.begin(), at(first + 1));
    ends.headCount = ends.line.size();
    ends.line.insert(ends.line.end(), at(last + 1), samples.end());
    for (std::size_t k = kept.begin; k < kept.end; ++k) {
        ends.between += lengthOf(settled[k]);
        for (std::size_t i = settled[k].to; k + 1 < kept.end && i < settled[k + 1].from; ++i)
            ends.between += (samples[i + 1] - samples[i]).norm();
    }
    ends.between -= (samples[last] - samples[first]).norm();
    return ends;
}

/// The kept pieces, and what lies between them where they do not follow on each other.
std::vector<CubicBezier> fitBetween(const std::vector<Vec2> &samples,
                                    const std::vector<FittedPiece> &settled, const PieceRange &kept,
                                    const FitOptions &options)
{
    const std::size_t first = settled[kept.begin].from, last = settled[kept.end - 1].to;
    std::vector<FittedPiece> pieces(settled.begin() + static_cast<std::ptrdiff_t>(kept.begin),
                                    settled.begin() + static_cast<std::ptrdiff_t>(kept.end));
    for (FittedPiece &piece : pieces) {
        piece.from -= first;
        piece.to -= first;
    }
    return fitAround({samples.begin() + static_cast<std::ptrdiff_t>(first),
                      samples.begin() + static_cast<std::ptrdiff_t>(last) + 1},
                     pieces, options);
}

/// From the last kept piece over the closing to the first one.
std::vector<CubicBezier> fitAcross(const std::vector<Vec2> &led, std::size_t headCount,
                                   const FittedPiece &first, const FittedPiece &last,
                                   FitOptions options)
{
    const auto head = led.begin() + static_cast<std::ptrdiff_t>(headCount);
    std::vector<Vec2> line{last.curve.p3};
    const auto add = [&line](const Vec2 &p) {
        if ((p - line.back()).norm() > kClipGrid)
            line.push_back(p);
    };
    std::for_each(head, led.end(), add);
    std::for_each(led.begin(), head - 1, add); // but the one that the first piece starts at
    while (line.size() > 1 && (line.back() - first.curve.p0).norm() <= kClipGrid)
        line.pop_back();
    line.push_back(first.curve.p0);
    options.startDirection.reset();
    options.endDirection.reset();
    if (last.isEndSmooth)
        options.startDirection = endDirection(last.curve);
    if (first.isStartSmooth)
        options.endDirection = startDirection(first.curve);
    return fitCurve(line, options);
}

} // namespace

PieceRange awayFromEnds(const std::vector<FittedPiece> &pieces, double length)
{
    PieceRange range{0, pieces.size()};
    double before = 0.0, after = 0.0;
    while (!range.isEmpty() && (before < length || pieces[range.begin].isStartBetween))
        before += lengthOf(pieces[range.begin++]);
    while (!range.isEmpty() && after < length)
        after += lengthOf(pieces[--range.end]);
    return range;
}

std::optional<std::vector<CubicBezier>> closedFit(const std::vector<Vec2> &samples,
                                                  const std::vector<FittedPiece> &settled,
                                                  const FitOptions &options)
{
    const double reach = options.reach * options.tolerance;
    const PieceRange kept = awayFromEnds(settled, kEndReaches * reach);
    if (kept.isEmpty()) {
        const auto loop = closedLine(samples, options.tolerance, reach);
        if (!loop)
            return {};
        return fitClosedCurve(*loop, options);
    }
    const Ends ends = endsOf(samples, settled, kept);
    const auto led = closedLine(ends.line, options.tolerance, reach, ends.between);
    if (!led || led->size() <= ends.headCount)
        return {};
    std::vector<CubicBezier> chain = fitBetween(samples, settled, kept, options);
    const std::vector<CubicBezier> across =
        fitAcross(*led, ends.headCount, settled[kept.begin], settled[kept.end - 1], options);
    chain.insert(chain.end(), across.begin(), across.end());
    return chain;
}

} // namespace fff
