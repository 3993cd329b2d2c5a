#include "core/geometry/contour_blend.h"

#include "core/geometry/arc_length.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

double fraction(double share)
{
    const double rest = share - std::floor(share);
    return rest < 1.0 ? rest : 0.0;
}

/// A place that both contours are cut at: the share of p's length, and where it is on each.
struct Node
{
    double share = 0.0;
    CurvePoint onP, onQ;
    bool isOfP = false, isOfQ = false; // an anchor of it
};

/// The piece of a contour from one of its places on to the next one, in one segment, forwards.
CubicBezier pieceAhead(const Contour &contour, CurvePoint from, const CurvePoint &to)
{
    if (from.t >= 1.0)
        from = {(from.segment + 1) % contour.segmentCount(), 0.0};
    const bool endsHere = to.segment == from.segment && to.t > from.t;
    const bool isNowhere = to == from;
    return contour.segment(from.segment).piece(from.t, isNowhere ? from.t : endsHere ? to.t : 1.0);
}

/// The same backwards.
CubicBezier pieceBack(const Contour &contour, CurvePoint from, const CurvePoint &to)
{
    const bool isNowhere = to == from;
    const int count = contour.segmentCount();
    if (from.t <= 0.0 && !isNowhere)
        from = {(from.segment + count - 1) % count, 1.0};
    const bool endsHere = to.segment == from.segment && to.t < from.t;
    return contour.segment(from.segment).piece(from.t, isNowhere ? from.t : endsHere ? to.t : 0.0);
}

class NodeFinder
{
public:
    NodeFinder(const ArcLength &p, const ArcLength &q, const Correspondence &correspondence)
        : m_p(p), m_q(q), m_correspondence(correspondence)
    {
    }

    /// By their share, from p's start on.
    std::vector<Node> find() const
    {
        std::vector<Node> nodes;
        for (int i = 0; i < m_p.contour().segmentCount(); ++i) {
            Node node;
            node.onP = {i, 0.0};
            node.share = m_p.of(node.onP) / m_p.total();
            node.isOfP = true;
            nodes.push_back(node);
        }
        for (int i = 0; i < m_q.contour().segmentCount(); ++i) {
            Node node;
            node.onQ = {i, 0.0};
            node.share = onP(m_q.of(node.onQ) / m_q.total());
            node.isOfQ = true;
            nodes.push_back(node);
        }
        std::stable_sort(nodes.begin(), nodes.end(),
                         [](const Node &a, const Node &b) { return a.share < b.share; });
        nodes = joined(std::move(nodes));
        for (Node &node : nodes) {
            if (!node.isOfP)
                node.onP = m_p.at(node.share * m_p.total());
            if (!node.isOfQ)
                node.onQ = m_q.at(onQ(node.share) * m_q.total());
        }
        return nodes;
    }

private:
    double onP(double shareOfQ) const
    {
        return fraction(m_correspondence.isReversed ? m_correspondence.offset - shareOfQ
                                                    : shareOfQ - m_correspondence.offset);
    }
    double onQ(double shareOfP) const
    {
        return fraction(m_correspondence.isReversed ? m_correspondence.offset - shareOfP
                                                    : m_correspondence.offset + shareOfP);
    }

    /// Neighbours of which one is p's and the other q's become one, each once.
    std::vector<Node> joined(std::vector<Node> nodes) const
    {
        const auto join = [](Node &kept, const Node &other) {
            if (other.isOfP) {
                kept.onP = other.onP;
                kept.share = other.share;
            } else {
                kept.onQ = other.onQ;
            }
            kept.isOfP = kept.isOfQ = true;
        };
        const auto belongs = [](const Node &a, const Node &b, double gap) {
            return gap <= kJoinedAnchors && a.isOfP != b.isOfP && a.isOfQ != b.isOfQ;
        };
        std::vector<Node> result;
        for (const Node &node : nodes) {
            if (!result.empty() && belongs(result.back(), node, node.share - result.back().share))
                join(result.back(), node);
            else
                result.push_back(node);
        }
        // Across p's start.
        if (result.size() > 2 && belongs(result.front(), result.back(),
                                         result.front().share + 1.0 - result.back().share)) {
            join(result.front(), result.back());
            result.pop_back();
        }
        return result;
    }

    const ArcLength &m_p, &m_q;
    Correspondence m_correspondence;
};

} // namespace

std::vector<Vec2> uniformSamples(const Contour &contour, int count)
{
    const ArcLength length(contour);
    std::vector<Vec2> samples;
    samples.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        samples.push_back(positionAt(contour, length.at(length.total() * i / count)));
    return samples;
}

Correspondence bestCorrespondence(const Contour &p, const Contour &q)
{
    const std::vector<Vec2> ps = uniformSamples(p, kBlendSamples),
                            qs = uniformSamples(q, kBlendSamples);
    constexpr int n = kBlendSamples;
    double least = std::numeric_limits<double>::infinity();
    int best = 0;
    bool isReversed = false;
    for (const int way : {1, -1}) {
        for (int k = 0; k < n; ++k) {
            double sum = 0.0;
            for (int i = 0; i < n && sum < least; ++i) {
                const auto at = static_cast<std::size_t>((k + way * i + n) % n);
                sum += (ps[at] - qs[static_cast<std::size_t>(i)]).norm();
            }
            if (sum < least) {
                least = sum;
                best = k;
                isReversed = way < 0;
            }
        }
    }
    // p[k] is q[0], so p[0] is q[−k], and reversed q[k].
    const double share = static_cast<double>(best) / n;
    return {isReversed ? share : fraction(-share), isReversed};
}

ContourBlend::ContourBlend(const Contour &p, const Contour &q, const Correspondence &correspondence)
{
    const ArcLength lengthP(p), lengthQ(q);
    const std::vector<Node> nodes = NodeFinder(lengthP, lengthQ, correspondence).find();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Node &from = nodes[i], &to = nodes[(i + 1) % nodes.size()];
        m_p.push_back(pieceAhead(p, from.onP, to.onP));
        m_q.push_back(correspondence.isReversed ? pieceBack(q, from.onQ, to.onQ)
                                                : pieceAhead(q, from.onQ, to.onQ));
    }
}

Contour ContourBlend::at(double share) const
{
    const auto mix = [share](const Vec2 &a, const Vec2 &b) {
        return Vec2((1.0 - share) * a + share * b);
    };
    std::vector<Vec2> points;
    points.reserve(3 * m_p.size());
    for (std::size_t i = 0; i < m_p.size(); ++i)
        for (const auto point : {&CubicBezier::p0, &CubicBezier::p1, &CubicBezier::p2})
            points.push_back(mix(m_p[i].*point, m_q[i].*point));
    return Contour::ofPoints(std::move(points));
}

} // namespace fff
