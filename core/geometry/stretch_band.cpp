#include "core/geometry/stretch_band.h"

#include "core/geometry/contour_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace fff {

/// Of the line, the side on which the two places are not.
bool StretchBand::isBeyond(const Vec2 &p) const
{
    if (!mirroredAt)
        return false;
    const Vec2 way = to - from;
    const double side = (0.5 * (from + to) - *mirroredAt).dot(way);
    return side * (p - *mirroredAt).dot(way) < 0.0;
}

double StretchBand::shareAt(const Vec2 &p) const
{
    const Vec2 way = to - from;
    double along = (p - from).dot(way);
    if (isBeyond(p))
        along = 2.0 * (*mirroredAt - from).dot(way) - along;
    return std::clamp(along / way.squaredNorm(), 0.0, 1.0);
}

/// Without regard to what stays.
Vec2 StretchBand::wayOf(const Vec2 &p) const
{
    const double by = length - (to - from).norm();
    const double share = shareAt(p) - (mirroredAt ? shareAt(*mirroredAt) : 0.0);
    return (isBeyond(p) ? -by : by) * share * along();
}

Vec2 StretchBand::operator()(const Vec2 &p) const
{
    return p + wayOf(p) - wayOf(stays);
}

std::optional<Vec2> StretchBand::shiftOf(const Box2 &box) const
{
    const std::array corners{box.min, Vec2(box.max.x(), box.min.y()), box.max,
                             Vec2(box.min.x(), box.max.y())};
    const double share = shareAt(corners[0]);
    const bool isAside = share == 0.0 || share == 1.0;
    if (!isAside || std::any_of(corners.begin(), corners.end(),
                                [&](const Vec2 &corner) { return shareAt(corner) != share; }))
        return std::nullopt;
    return Vec2((*this)(box.min) - box.min);
}

namespace {

/// Of handles at an anchor, how much they are stretched.
struct Around
{
    Vec2 along;
    double factor = 1.0;

    Vec2 operator()(const Vec2 &way) const { return way + (factor - 1.0) * way.dot(along) * along; }
};

class BandMapper
{
public:
    BandMapper(const Contour &contour, const StretchBand &band) : m_contour(contour), m_band(band)
    {
    }

    std::vector<Vec2> points() const
    {
        std::vector<Vec2> points(m_contour.points().size());
        for (int i = 0; i < count(); ++i)
            points[index(i)] = m_band(anchor(m_contour, i));
        for (int i = 0; i < count(); ++i)
            handles(points, i);
        for (int i = 0; i < count(); ++i)
            if (isLineAt(i))
                straighten(points, i);
        return points;
    }

private:
    int count() const { return m_contour.segmentCount(); }
    /// Of an anchor's control point.
    std::size_t index(int anchor) const
    {
        return static_cast<std::size_t>(3 * ((anchor + count()) % count()));
    }
    bool isLineAt(int segment) const
    {
        return isLine(m_contour.segment((segment + count()) % count()));
    }

    /// At the band's ends a corner's handles are those of the side that they are on; those of a
    /// smooth point are stretched alike, and twice by half is once by all.
    double factorAt(int i, HandleSide side, bool isSmooth) const
    {
        const Vec2 at = anchor(m_contour, i);
        const double share = m_band.shareAt(at), factor = m_band.factor();
        if (share > 0.0 && share < 1.0)
            return factor;
        const auto reaches = [&](HandleSide one) {
            const double other = m_band.shareAt(handle(m_contour, i, one));
            return other > 0.0 && other < 1.0;
        };
        if (!isSmooth)
            return reaches(side) ? factor : 1.0;
        const bool in = reaches(HandleSide::In), out = reaches(HandleSide::Out);
        return in && out ? factor : in || out ? std::sqrt(factor) : 1.0;
    }

    void handles(std::vector<Vec2> &points, int i) const
    {
        const bool isSmooth = kindOf(m_contour, i) != PointKind::Corner;
        const Vec2 before = anchor(m_contour, i), now = points[index(i)];
        const auto place = [&](HandleSide side) -> Vec2 & {
            return side == HandleSide::Out ? points[index(i) + 1] : points[index(i - 1) + 2];
        };
        // A line has no handles to agree with: the curve that goes on from it is as long as what is
        // on its own side makes it, or a round corner that becomes small would have ears.
        const bool isIn = isLineAt(i - 1), isOut = isLineAt(i);
        const bool goesOn = isSmooth && isIn != isOut;
        for (const HandleSide side : {HandleSide::In, HandleSide::Out}) {
            const Around around{m_band.along(), factorAt(i, side, isSmooth && !goesOn)};
            place(side) = now + around(handle(m_contour, i, side) - before);
        }
        // And it begins in the line's new direction.
        if (!goesOn)
            return;
        const Vec2 end = points[index(isIn ? i - 1 : i + 1)];
        Vec2 &bent = place(isIn ? HandleSide::Out : HandleSide::In);
        if ((now - end).norm() > kNoHandle)
            bent = now + (bent - now).norm() * (now - end).normalized();
    }

    void straighten(std::vector<Vec2> &points, int segment) const
    {
        const Vec2 a = points[index(segment)], b = points[index(segment + 1)];
        points[index(segment) + 1] = a + (b - a) / 3.0;
        points[index(segment) + 2] = b - (b - a) / 3.0;
    }

    const Contour &m_contour;
    const StretchBand &m_band;
};

} // namespace

Result<Contour> mapped(const Contour &contour, const StretchBand &band)
{
    return Contour::fromPoints(BandMapper(contour, band).points());
}

} // namespace fff
