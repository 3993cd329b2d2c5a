#include "core/operations/spine_planes.h"

#include "core/base/tolerances.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// Of a spacing, by which a part may be too short for one more: sums of steps are rounded.
constexpr double kSpacingShare = 1e-9;
/// Chords that stand for a part of a spine where what is near to it is looked for.
constexpr int kSpineChords = 720;
/// mm: of a loop that is this much nearer elsewhere it is not certain that it is.
constexpr double kElsewhere = 0.5;

/// The point of a segment that is nearest to p.
template <class Vec>
Vec nearestOn(const Vec &a, const Vec &b, const Vec &p)
{
    const Vec way = b - a;
    const double length = way.squaredNorm();
    return length > 0.0 ? Vec(a + std::clamp(way.dot(p - a) / length, 0.0, 1.0) * way) : a;
}

/// The point of the loop's boundary that is nearest to the origin.
Vec2 nearestToOrigin(const Polygon &loop)
{
    Vec2 best = loop.front();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 p = nearestOn<Vec2>(loop[i], loop[(i + 1) % loop.size()], Vec2::Zero());
        if (p.squaredNorm() < best.squaredNorm())
            best = p;
    }
    return best;
}

SpineRequest ascending(SpineRequest request)
{
    if (request.from >= request.to)
        request.from -= 1.0;
    return request;
}

} // namespace

SpinePlanes::SpinePlanes(const Section &spine, const SpineRequest &request)
    : m_spine(spine), m_request(ascending(request)), m_length(spine.shape->contour())
{
    const double size = m_request.to - m_request.from;
    for (int i = 0; i <= kSpineChords; ++i) {
        const double share = m_request.from + size * i / kSpineChords;
        const CurvePoint at = m_length.at(share * m_length.total());
        m_chords.push_back(spine.frame.toWorld(positionAt(m_length.contour(), at)));
    }
}

std::vector<SpinePlane> SpinePlanes::planes() const
{
    const double begin = m_request.from * m_length.total();
    const double size = (m_request.to - m_request.from) * m_length.total();
    const double fitting = std::floor(size / m_request.spacing + kSpacingShare);
    const int count = m_request.isByCount
                          ? m_request.count
                          : static_cast<int>(std::clamp(fitting, 1.0, double(m_request.most)));
    const double step = m_request.isByCount ? size / count : m_request.spacing;
    std::vector<SpinePlane> planes;
    for (int i = 0; i < count; ++i) {
        const double along = 0.5 * size + (i - 0.5 * (count - 1) + m_request.shift) * step;
        if (!isRing() && (along < 0.0 || along > size))
            continue;
        const CurvePoint at = m_length.at(begin + along);
        const Vec3 way =
            m_spine.frame.directionToWorld(directionAt(m_length.contour(), at)).normalized();
        const Vec3 up = m_spine.frame.normal();
        planes.push_back({i,
                          {m_spine.frame.toWorld(positionAt(m_length.contour(), at)),
                           up.cross(way).normalized(), up}});
    }
    return planes;
}

double SpinePlanes::distanceTo(const Vec3 &point) const
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < m_chords.size(); ++i)
        nearest = std::min(nearest,
                           (nearestOn<Vec3>(m_chords[i], m_chords[i + 1], point) - point).norm());
    return nearest;
}

std::optional<std::size_t> SpinePlanes::loopAt(const SpinePlane &plane,
                                               const std::vector<TemplateLoop> &loops) const
{
    std::optional<std::size_t> inside, nearest;
    Vec2 point = Vec2::Zero();
    for (std::size_t k = 0; k < loops.size(); ++k) { // the largest first
        if (loops[k].isHole)
            continue;
        if (locate(Vec2::Zero(), loops[k].points) != Side::Outside) {
            inside = k;
            continue;
        }
        const Vec2 p = nearestToOrigin(loops[k].points);
        if (!nearest || p.squaredNorm() < point.squaredNorm()) {
            nearest = k;
            point = p;
        }
    }
    if (inside || !nearest)
        return inside;
    return distanceTo(plane.frame.toWorld(point)) < point.norm() - kElsewhere ? std::nullopt
                                                                              : nearest;
}

} // namespace fff
