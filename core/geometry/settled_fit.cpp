#include "core/geometry/settled_fit.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <iterator>

namespace fff {

namespace {

/// Samples by which the line goes on before it is looked at again.
constexpr std::size_t kStep = SettledFit::kWindow / 4;
/// Where a segment that is as long as the largest window is cut (parameter).
constexpr double kCut = 0.5;

/// A joint of pieces that are known already, and where what follows or precedes is to be fitted.
struct GivenEnd
{
    Vec2 position = Vec2::Zero();
    std::optional<Vec2> direction; // none at a corner
};

GivenEnd endOf(const FittedPiece &piece)
{
    GivenEnd end{piece.curve.p3, {}};
    if (piece.isEndSmooth)
        end.direction = endDirection(piece.curve);
    return end;
}

GivenEnd startOf(const FittedPiece &piece)
{
    GivenEnd start{piece.curve.p0, {}};
    if (piece.isStartSmooth)
        start.direction = startDirection(piece.curve);
    return start;
}

/// Samples of a stretch between two joints, and what each of them is in the whole line.
class Stretch
{
public:
    /// The samples [first, last] of the line, and a joint before and after them if there is one.
    Stretch(const std::vector<Vec2> &line, std::size_t first, std::size_t last,
            const std::optional<GivenEnd> &start, const std::optional<GivenEnd> &end)
    {
        m_points.reserve(last + 3 - std::min(first, last));
        if (start)
            add(start->position, first > 0 ? first - 1 : 0);
        for (std::size_t i = first; i <= last && i < line.size(); ++i)
            add(line[i], i);
        if (!end)
            return;
        // The joint itself, in place of a sample that is as good as there.
        while (m_points.size() > 1 && (m_points.back() - end->position).norm() <= kClipGrid) {
            m_points.pop_back();
            m_indices.pop_back();
        }
        add(end->position, last + 1);
    }

    const std::vector<Vec2> &points() const { return m_points; }
    std::size_t indexOf(std::size_t k) const { return m_indices[k]; }

private:
    void add(const Vec2 &p, std::size_t index)
    {
        if (!m_points.empty() && (p - m_points.back()).norm() <= kClipGrid)
            return;
        m_points.push_back(p);
        m_indices.push_back(index);
    }

    std::vector<Vec2> m_points;
    std::vector<std::size_t> m_indices;
};

/// Of the samples between two of them, the one next to a point.
std::size_t nearestSample(const std::vector<Vec2> &samples, std::size_t from, std::size_t to,
                          const Vec2 &p)
{
    std::size_t best = from;
    for (std::size_t i = from; i <= to; ++i) {
        if ((samples[i] - p).squaredNorm() < (samples[best] - p).squaredNorm())
            best = i;
    }
    return best;
}

} // namespace

double lengthOf(const FittedPiece &piece)
{
    return (piece.curve.p3 - piece.curve.p0).norm();
}

void SettledFit::follow(const std::vector<Vec2> &samples, std::size_t count)
{
    while (count > m_next)
        settle(samples, m_next);
}

/// Looks at the samples before `end` only.
void SettledFit::settle(const std::vector<Vec2> &samples, std::size_t end)
{
    const std::size_t begin = m_pieces.empty() ? 0 : m_pieces.back().to;
    std::optional<GivenEnd> start;
    if (!m_pieces.empty())
        start = endOf(m_pieces.back());
    const Stretch stretch(samples, start ? begin + 1 : begin, end - 1, start, {});
    FitOptions options = m_options;
    options.work = &m_work;
    options.startDirection = start ? start->direction : m_options.startDirection;
    options.endDirection.reset();
    std::vector<FittedPiece> pieces = fitPieces(stretch.points(), options);

    const std::size_t last = begin + (end - begin) / 2; // of the samples that may be settled
    std::size_t count = 0;
    for (FittedPiece &piece : pieces) {
        piece.from = stretch.indexOf(piece.from);
        piece.to = stretch.indexOf(piece.to);
        count += piece.to <= last && piece.to > begin ? 1 : 0;
    }
    if (count == 0 && end - begin >= kLargestWindow && !pieces.empty()) {
        // One segment is as long as all of this: it stays what it is as far as its middle.
        FittedPiece &piece = pieces.front();
        const CubicBezier half = piece.curve.piece(0.0, kCut);
        piece.to = nearestSample(samples, begin + 1, std::max(piece.to, begin + 2) - 1, half.p3);
        piece.curve = half;
        piece.isEndSmooth = true;
        count = 1;
    }
    if (!pieces.empty() && start)
        pieces.front().isStartSmooth = start->direction.has_value();
    m_pieces.insert(m_pieces.end(), pieces.begin(),
                    pieces.begin() + static_cast<std::ptrdiff_t>(count));
    const std::size_t settled = m_pieces.empty() ? 0 : m_pieces.back().to;
    m_next = std::max(end + kStep, settled + kWindow);
}

std::vector<CubicBezier> fitAround(const std::vector<Vec2> &line,
                                   const std::vector<FittedPiece> &known, const FitOptions &options)
{
    std::vector<CubicBezier> chain;
    std::size_t next = 0; // sample that is not covered yet
    std::optional<GivenEnd> start;
    const auto fill = [&](std::size_t last, const std::optional<GivenEnd> &end) {
        const Stretch stretch(line, next, last, start, end);
        FitOptions between = options;
        if (start)
            between.startDirection = start->direction;
        if (end)
            between.endDirection = end->direction;
        const std::vector<CubicBezier> fitted = fitCurve(stretch.points(), between);
        chain.insert(chain.end(), fitted.begin(), fitted.end());
    };
    for (std::size_t k = 0; k < known.size(); ++k) {
        const bool goesOn =
            k > 0 && known[k - 1].to == known[k].from && known[k - 1].curve.p3 == known[k].curve.p0;
        const std::size_t from = known[k].from;
        if (!goesOn && (from > 0 || known[k].isStartBetween)) {
            const std::size_t covered = from + (known[k].isStartBetween ? 1 : 0);
            fill(covered > 0 ? covered - 1 : 0, startOf(known[k]));
        }
        chain.push_back(known[k].curve);
        next = known[k].to + 1;
        start = endOf(known[k]);
    }
    if (next < line.size())
        fill(line.size() - 1, {});
    return chain;
}

} // namespace fff
