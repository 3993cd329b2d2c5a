#include "core/templates/chain_closing.h"

#include <algorithm>
#include <limits>

namespace fff {

namespace {

constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();
/// Chords of a joining cubic: it is fitted again where a section follows it.
constexpr int kBridgeChords = 24;
/// Points that are this near to each other, beside the size of what is cut, need no curve between
/// them: programs that sew surfaces leave such gaps.
constexpr double kCrackShare = 1e-6;
/// How much of the end of a chain says which way it arrives, beside the gap to be bridged.
constexpr double kArrivalShare = 0.25;

/// An end of an open chain: 2 c its start, 2 c + 1 its last point.
class OpenEnds
{
public:
    explicit OpenEnds(const std::vector<CutChain> &chains) : m_chains(chains)
    {
        for (const CutChain &chain : chains) {
            m_points.push_back(chain.points.front());
            m_points.push_back(chain.points.back());
        }
    }

    /// Of each end the other one that it is joined with. Two ends that have none nearer are a pair,
    /// whichever pairs are looked for first: so it is those with the shortest way that come first.
    std::vector<std::size_t> pairs() const
    {
        const std::size_t count = m_points.size();
        std::vector<std::size_t> partners(count, kNowhere), nearest(count, kNowhere);
        std::vector<std::size_t> free(count);
        for (std::size_t i = 0; i < count; ++i)
            free[i] = i;
        while (!free.empty()) {
            for (const std::size_t i : free)
                if (nearest[i] == kNowhere || partners[nearest[i]] != kNowhere)
                    nearest[i] = nearestOf(i, free);
            for (const std::size_t i : free) {
                const std::size_t j = nearest[i];
                if (partners[i] == kNowhere && partners[j] == kNowhere && nearest[j] == i) {
                    partners[i] = j;
                    partners[j] = i;
                }
            }
            std::erase_if(free, [&](std::size_t i) { return partners[i] != kNowhere; });
        }
        return partners;
    }

    const Vec3 &point(std::size_t end) const { return m_points[end]; }

    /// The way in which the chain runs out of its end, over a length that counts beside the gap.
    Vec3 arrival(std::size_t end, double gap) const
    {
        const std::vector<Vec3> &points = m_chains[end / 2].points;
        const Vec3 &at = m_points[end];
        Vec3 from = at;
        for (std::size_t i = 1; i < points.size(); ++i) {
            from = end % 2 == 0 ? points[i] : points[points.size() - 1 - i];
            if ((at - from).norm() >= kArrivalShare * gap)
                break;
        }
        return (at - from).stableNormalized();
    }

private:
    /// By length, then by index, so that the nearest of all are always each other's.
    std::size_t nearestOf(std::size_t i, const std::vector<std::size_t> &free) const
    {
        std::size_t best = kNowhere;
        double least = std::numeric_limits<double>::infinity();
        const auto rank = [i](std::size_t j) { return std::pair(std::min(i, j), std::max(i, j)); };
        for (const std::size_t j : free) {
            if (j == i)
                continue;
            const double length = (m_points[j] - m_points[i]).squaredNorm();
            if (best == kNowhere || length < least || (length == least && rank(j) < rank(best))) {
                least = length;
                best = j;
            }
        }
        return best;
    }

    const std::vector<CutChain> &m_chains;
    std::vector<Vec3> m_points;
};

/// Points between two ends, without them.
std::vector<Vec3> bridge(const OpenEnds &ends, std::size_t from, std::size_t to, double crack,
                         const CutPlane &plane)
{
    const Vec3 a = ends.point(from), b = ends.point(to);
    const double gap = (b - a).norm();
    if (gap <= crack)
        return {};
    const double reach = gap / 3.0;
    const Vec3 out = a + reach * ends.arrival(from, gap), in = b + reach * ends.arrival(to, gap);
    std::vector<Vec3> points;
    for (int i = 1; i < kBridgeChords; ++i) {
        const double t = double(i) / kBridgeChords, s = 1.0 - t;
        const Vec3 p = s * s * s * a + 3.0 * s * s * t * out + 3.0 * s * t * t * in + t * t * t * b;
        points.push_back(p - plane.height(p) / plane.normal.squaredNorm() * plane.normal);
    }
    return points;
}

} // namespace

std::vector<CutLoop> closedChains(std::vector<CutChain> chains, const CutPlane &plane)
{
    std::vector<CutLoop> loops;
    std::vector<CutChain> open;
    Box3 box;
    for (CutChain &chain : chains) {
        for (const Vec3 &p : chain.points)
            box.extend(p);
        if (!chain.isClosed) {
            open.push_back(std::move(chain));
            continue;
        }
        CutLoop loop;
        loop.points = std::move(chain.points);
        loop.isOriented = chain.isOriented;
        loops.push_back(std::move(loop));
    }
    if (open.empty())
        return loops;
    const double crack = kCrackShare * box.size().maxCoeff();
    const OpenEnds ends(open);
    const std::vector<std::size_t> partners = ends.pairs();
    std::vector<std::uint8_t> isDone(open.size(), 0);
    for (std::size_t first = 0; first < open.size(); ++first) {
        if (isDone[first])
            continue;
        CutLoop loop;
        std::int64_t forwards = 0, backwards = 0;
        bool isOriented = true;
        std::size_t end = 2 * first; // where the walk enters a chain
        do {
            const std::vector<Vec3> &points = open[end / 2].points;
            isDone[end / 2] = 1;
            isOriented = isOriented && open[end / 2].isOriented;
            const auto count = static_cast<std::int64_t>(points.size());
            if (end % 2 == 0) {
                loop.points.insert(loop.points.end(), points.begin(), points.end());
                forwards += count;
            } else {
                loop.points.insert(loop.points.end(), points.rbegin(), points.rend());
                backwards += count;
            }
            const std::size_t out = end ^ std::size_t(1), next = partners[out];
            const std::vector<Vec3> between = bridge(ends, out, next, crack, plane);
            loop.bridges.push_back({loop.points.size() - 1, between.size() + 1});
            loop.points.insert(loop.points.end(), between.begin(), between.end());
            end = next;
        } while (end != 2 * first);
        loop.isOriented = isOriented && (forwards == 0 || backwards == 0);
        if (backwards > forwards)
            loop.reverse();
        if (loop.points.size() >= 3)
            loops.push_back(std::move(loop));
    }
    return loops;
}

} // namespace fff
