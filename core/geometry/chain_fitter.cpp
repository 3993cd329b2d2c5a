#include "core/geometry/chain_fitter.h"

#include <algorithm>
#include <array>

namespace fff {

namespace {

/// A joint is looked for until it is known to this part of its segment's length.
constexpr double kJointPrecision = 0.04;
/// Nor nearer than to this part of a tolerance.
constexpr double kLeastPrecision = 0.1;
/// The first segment of a stretch is tried over so many reaches first.
constexpr double kFirstTry = 4.0;
/// Lengths of pieces where nothing longer fits, in tolerances.
constexpr std::array kShortLengths{2.0, 1.0, 0.5};
/// A segment shorter than this part of its neighbour is a stub.
constexpr double kStub = 0.3;
/// Where between its earliest and its latest place a joint is tried.
constexpr std::array kShares{0.5, 0.3, 0.7, 0.15, 0.85};

} // namespace

ChainFitter::ChainFitter(const SampledLine &line, double tolerance, double reach,
                         double leastCorner)
    : m_line(line), m_tolerance(tolerance), m_reach(reach), m_leastCorner(leastCorner),
      m_spans(line, tolerance), m_joints(line.size())
{
}

std::vector<ChainFitter::Link> ChainFitter::takeLinks()
{
    std::erase_if(m_chain, [](const Link &link) {
        return link.curve.p0 == link.curve.p3 && link.curve.isStraight(0.0);
    });
    return std::move(m_chain);
}

std::vector<CubicBezier> ChainFitter::takeChain()
{
    std::vector<CubicBezier> chain;
    for (const Link &link : takeLinks())
        chain.push_back(link.curve);
    return chain;
}

const CurveEnd &ChainFitter::joint(std::size_t at)
{
    if (at == m_stretch.from)
        return m_stretch.start;
    if (at == m_stretch.to)
        return m_stretch.end;
    if (!m_joints[at])
        m_joints[at] = m_line.smoothJoint(at, m_stretch.lowest, m_stretch.highest);
    return *m_joints[at];
}

std::optional<CubicBezier> ChainFitter::piece(std::size_t from, std::size_t to)
{
    return m_spans.fit(from, to, joint(from), joint(to));
}

/// Where samples lie about so wildly that no fit holds: a piece as short as it takes, but not from
/// one sample of a trembling hand to the next if that can be helped.
ChainFitter::Piece ChainFitter::shortest(std::size_t from)
{
    for (const double length : kShortLengths) {
        const std::size_t to = m_line.indexAt(m_line.along(from) + length * m_tolerance);
        if (to <= from + 1 || to > m_stretch.to)
            continue;
        if (const auto curve = m_spans.shortPiece(from, to, joint(from), joint(to)))
            return {to, *curve};
    }
    return {from + 1, m_spans.shortestPiece(from, from + 1, joint(from), joint(from + 1)),
            !m_spans.shortPiece(from, from + 1, joint(from), joint(from + 1))};
}

ChainFitter::Piece ChainFitter::shortestBefore(std::size_t to)
{
    for (const double length : kShortLengths) {
        const std::size_t from = m_line.indexAt(m_line.along(to) - length * m_tolerance);
        if (from + 1 >= to || from < m_stretch.from)
            continue;
        if (const auto curve = m_spans.shortPiece(from, to, joint(from), joint(to)))
            return {from, *curve};
    }
    return {to - 1, m_spans.shortestPiece(to - 1, to, joint(to - 1), joint(to)),
            !m_spans.shortPiece(to - 1, to, joint(to - 1), joint(to))};
}

/// The longest piece that starts at a sample: tried in growing lengths from `tried` mm on, then by
/// halves.
ChainFitter::Piece ChainFitter::furthest(std::size_t from, double tried)
{
    const std::size_t last = m_stretch.to;
    std::size_t good = from, bad = last + 1;
    std::optional<CubicBezier> best;
    const auto attempt = [&](std::size_t to) {
        const auto curve = piece(from, to);
        (curve ? good : bad) = to;
        if (curve)
            best = curve;
    };
    for (double length = tried; good < last && bad > last; length *= 2.0) {
        // Of the samples where a hand halts at the end, indexAt() knows the first.
        const double end = m_line.along(from) + length;
        attempt(end >= m_line.along(last) ? last : std::clamp(m_line.indexAt(end), from + 1, last));
    }
    while (bad - good > 1 && good < last) {
        const double gap = m_line.lengthBetween(good, bad);
        const double precision = std::max(kJointPrecision * m_line.lengthBetween(from, good),
                                          kLeastPrecision * m_tolerance);
        if (good > from && gap <= precision)
            break;
        const std::size_t middle = m_line.indexAt(m_line.along(good) + 0.5 * gap);
        attempt(std::clamp(middle, good + 1, bad - 1));
    }
    return best ? Piece{good, *best} : shortest(from);
}

/// The longest piece that ends at a sample, and where it starts.
ChainFitter::Piece ChainFitter::earliest(std::size_t to, double tried)
{
    const std::size_t first = m_stretch.from;
    std::size_t good = to;
    std::optional<std::size_t> bad;
    std::optional<CubicBezier> best;
    const auto attempt = [&](std::size_t from) {
        const auto curve = piece(from, to);
        if (!curve) {
            bad = from;
            return;
        }
        good = from;
        best = curve;
    };
    for (double length = tried; good > first && !bad; length *= 2.0)
        attempt(std::clamp(m_line.indexAt(m_line.along(to) - length), first, to - 1));
    while (bad && good - *bad > 1) {
        const double gap = m_line.lengthBetween(*bad, good);
        const double precision = std::max(kJointPrecision * m_line.lengthBetween(good, to),
                                          kLeastPrecision * m_tolerance);
        if (good < to && gap <= precision)
            break;
        const std::size_t middle = m_line.indexAt(m_line.along(*bad) + 0.5 * gap);
        attempt(std::clamp(middle, *bad + 1, good - 1));
    }
    if (!best)
        return shortestBefore(to);
    return {good, *best};
}

std::vector<ChainFitter::Piece> ChainFitter::forwards()
{
    std::vector<Piece> pieces;
    double tried = kFirstTry * m_reach;
    for (std::size_t at = m_stretch.from; at < m_stretch.to; at = pieces.back().to) {
        pieces.push_back(furthest(at, tried));
        tried = std::max(m_reach, m_line.lengthBetween(at, pieces.back().to));
    }
    return pieces;
}

/// From the end back; in the order of the line.
std::vector<ChainFitter::Piece> ChainFitter::backwards()
{
    std::vector<Piece> pieces;
    double tried = kFirstTry * m_reach;
    for (std::size_t at = m_stretch.to; at > m_stretch.from;) {
        const Piece piece = earliest(at, tried);
        const std::size_t from = piece.to;
        pieces.push_back({at, piece.curve, piece.isForced});
        tried = std::max(m_reach, m_line.lengthBetween(from, at));
        at = from;
    }
    std::reverse(pieces.begin(), pieces.end());
    return pieces;
}

/// Each joint so far from its earliest towards its latest place. Nothing when one of the segments
/// does not fit then.
std::vector<ChainFitter::Piece> ChainFitter::balanced(const std::vector<Piece> &late,
                                                      const std::vector<Piece> &early, double share)
{
    std::vector<Piece> pieces;
    std::size_t from = m_stretch.from;
    for (std::size_t k = 0; k < late.size(); ++k) {
        const double along =
            share * m_line.along(late[k].to) + (1.0 - share) * m_line.along(early[k].to);
        const std::size_t to = k + 1 < late.size() ? m_line.indexAt(along) : m_stretch.to;
        const auto curve = to > from ? piece(from, to) : std::nullopt;
        if (!curve)
            return {};
        pieces.push_back({to, *curve});
        from = to;
    }
    return pieces;
}

/// Neighbours that are one after all are joined; of two of which one is a mere stub the joint is
/// moved.
void ChainFitter::mend(std::vector<Piece> &pieces)
{
    std::size_t from = m_stretch.from;
    for (std::size_t k = 0; k + 1 < pieces.size();) {
        const std::size_t middle = pieces[k].to, to = pieces[k + 1].to;
        const double first = m_line.lengthBetween(from, middle);
        const double second = m_line.lengthBetween(middle, to);
        if (std::min(first, second) >= kStub * std::max(first, second)) {
            from = pieces[k++].to;
            continue;
        }
        if (const auto whole = piece(from, to)) {
            pieces[k] = {to, *whole};
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k) + 1);
            continue;
        }
        for (const double share : kShares) {
            const std::size_t at = m_line.indexAt(m_line.along(from) + share * (first + second));
            if (at <= from || at >= to)
                continue;
            const auto one = piece(from, at);
            const auto two = one ? piece(at, to) : std::nullopt;
            if (!two)
                continue;
            pieces[k] = {at, *one};
            pieces[k + 1] = {to, *two};
            break;
        }
        from = pieces[k++].to;
    }
}

std::optional<std::size_t> ChainFitter::firstForced(const std::vector<Piece> &pieces) const
{
    std::size_t from = m_stretch.from;
    for (const Piece &piece : pieces) {
        if (piece.isForced)
            return from;
        from = piece.to;
    }
    return {};
}

void ChainFitter::smoothen(Stretch &before, Stretch &after, double leastCorner)
{
    const Vec2 &in = before.end.direction, &out = after.start.direction;
    if (turnBetween(in, out) >= leastCorner)
        return;
    before.end.direction = after.start.direction = (in + out).normalized();
    before.isEndGiven = after.isStartGiven = true;
}

void ChainFitter::fitSmooth(const Stretch &stretch)
{
    m_stretch = stretch;
    std::vector<Piece> pieces = forwards();
    const std::optional<std::size_t> forced = firstForced(pieces);
    if (forced && stretch.to - stretch.from == 1) {
        m_chain.push_back({CubicBezier::line(stretch.start.position, stretch.end.position),
                           stretch.from, stretch.to});
        return;
    }
    if (forced) {
        const std::size_t corner = *forced > stretch.from ? *forced : *forced + 1;
        Stretch before = stretch, after = stretch;
        before.to = before.highest = after.from = after.lowest = corner;
        before.end = m_line.endJoint(stretch.from, corner);
        after.start = m_line.startJoint(corner, stretch.to);
        before.isEndGiven = after.isStartGiven = false;
        smoothen(before, after, m_leastCorner);
        fit(before);
        fit(after);
        return;
    }
    if (pieces.size() > 1) {
        std::vector<Piece> early = backwards();
        std::vector<Piece> even;
        if (firstForced(early))
            early.clear();
        if (early.size() == pieces.size()) {
            for (std::size_t i = 0; i < kShares.size() && even.empty(); ++i)
                even = balanced(pieces, early, kShares[i]);
        }
        if (!even.empty())
            pieces = std::move(even);
        else if (!early.empty() && early.size() < pieces.size())
            pieces = std::move(early);
    }
    mend(pieces);
    std::size_t from = stretch.from;
    for (const Piece &p : pieces) {
        const auto best = m_spans.best(from, p.to, joint(from), joint(p.to));
        m_chain.push_back({best.value_or(p.curve), from, p.to});
        from = p.to;
    }
}

void ChainFitter::fit(const Stretch &stretch)
{
    if (!stretch.isStartGiven && !stretch.isEndGiven &&
        m_line.isStraight(stretch.from, stretch.to, m_tolerance)) {
        m_chain.push_back({CubicBezier::line(stretch.start.position, stretch.end.position),
                           stretch.from, stretch.to});
        return;
    }
    Stretch rest = stretch;
    for (StraightRun run : m_line.straightRuns(stretch.from, stretch.to)) {
        // A line that all but reaches a corner comes from it.
        if (m_line.lengthBetween(rest.from, run.from) < m_reach) {
            if (!rest.isStartGiven)
                run.start = {rest.start.position,
                             (run.end.position - rest.start.position).normalized()};
            else if (rest.from != run.from || rest.start.position != run.start.position)
                continue;
            run.from = rest.from;
            run.end.direction = run.start.direction;
        }
        if (m_line.lengthBetween(run.to, stretch.to) < m_reach) {
            if (!stretch.isEndGiven)
                run.end = {stretch.end.position,
                           (stretch.end.position - run.start.position).normalized()};
            else if (stretch.to != run.to || stretch.end.position != run.end.position)
                continue;
            run.to = stretch.to;
            if (run.from != rest.from)
                run.start.direction = run.end.direction;
            else if (rest.isStartGiven)
                continue;
        }
        if (!m_line.isStraight(run.from, run.to, m_tolerance))
            continue;
        if (run.from > rest.from) {
            Stretch before = rest;
            before.to = run.from;
            before.end = run.start;
            before.isEndGiven = true;
            fitSmooth(before);
        }
        m_chain.push_back(
            {CubicBezier::line(run.start.position, run.end.position), run.from, run.to});
        rest.from = run.to;
        rest.start = run.end;
        rest.isStartGiven = true;
    }
    if (rest.from < rest.to)
        fitSmooth(rest);
}

} // namespace fff
