#include "core/analysis/suggesting/form_samples.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace fff {

namespace {

constexpr int kAround = 12, kViews = kAround + 2;
/// Pixels over the size of the mesh.
constexpr double kPixels = 254.0;
constexpr int kSurfaceSamples = 3000;
/// Of all that is to be shown; the rest is the surface's.
constexpr double kOutlineWeight = 0.7;
/// Shown by nothing from so many times the near distance on.
constexpr double kFarOutline = 4.0, kFarSurface = 2.5;

/// Spread evenly over the upper half of all directions, since a lower one shows the same outline;
/// and from the side and the front, from where people look first.
/// Source  R. Swinbank, R. Purser 2006, Fibonacci grids, Q. J. R. Meteorol. Soc. 132.
Vec3 viewDirection(int index)
{
    if (index >= kAround)
        return index == kAround ? Vec3::UnitX() : Vec3::UnitZ();
    const double height = (index + 0.5) / kAround;
    const double around = index * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double radius = std::sqrt(1.0 - height * height);
    return {radius * std::cos(around), height, radius * std::sin(around)};
}

/// What of a plane triangles cover, in pixels.
class CoveredPixels
{
public:
    CoveredPixels(const Vec2 &low, const Vec2 &high, double pixel)
        : m_low(low), m_pixel(pixel), m_width(columnsOf(high.x() - low.x(), pixel)),
          m_height(columnsOf(high.y() - low.y(), pixel)),
          m_covered(static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height), 0)
    {
    }

    void add(const Vec2 &a, const Vec2 &b, const Vec2 &c)
    {
        const Vec2 p = place(a), q = place(b), r = place(c);
        const Vec2 least = p.cwiseMin(q).cwiseMin(r), most = p.cwiseMax(q).cwiseMax(r);
        const int left = static_cast<int>(least.x()), right = static_cast<int>(most.x());
        const int bottom = static_cast<int>(least.y()), top = static_cast<int>(most.y());
        if (right - left <= 1 && top - bottom <= 1) { // its corners are all there is to see
            for (const Vec2 &corner : {p, q, r})
                mark(static_cast<int>(corner.x()), static_cast<int>(corner.y()));
            return;
        }
        // What is seen on edge has no inside.
        for (const auto &[from, to] : {std::pair(p, q), std::pair(q, r), std::pair(r, p)})
            markLine(from, to);
        const double turn = cross(q - p, r - p) < 0.0 ? -1.0 : 1.0;
        for (int y = bottom; y <= top; ++y)
            for (int x = left; x <= right; ++x) {
                const Vec2 middle(x + 0.5, y + 0.5);
                if (turn * cross(q - p, middle - p) >= 0.0 &&
                    turn * cross(r - q, middle - q) >= 0.0 &&
                    turn * cross(p - r, middle - r) >= 0.0)
                    mark(x, y);
            }
    }

    /// Middles of covered pixels beside uncovered ones.
    std::vector<Vec3> outline() const
    {
        std::vector<Vec3> points;
        for (int y = 1; y + 1 < m_height; ++y)
            for (int x = 1; x + 1 < m_width; ++x)
                if (is(x, y) && !(is(x - 1, y) && is(x + 1, y) && is(x, y - 1) && is(x, y + 1)))
                    points.emplace_back(m_low.x() + (x - 0.5) * m_pixel,
                                        m_low.y() + (y - 0.5) * m_pixel, 0.0);
        return points;
    }

private:
    /// With one that is empty on either side.
    static int columnsOf(double length, double pixel)
    {
        return static_cast<int>(length / pixel) + 4;
    }
    Vec2 place(const Vec2 &p) const { return (p - m_low) / m_pixel + Vec2::Ones(); }
    std::size_t index(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
               static_cast<std::size_t>(x);
    }
    bool is(int x, int y) const { return m_covered[index(x, y)] != 0; }
    void mark(int x, int y) { m_covered[index(x, y)] = 1; }
    void markLine(const Vec2 &from, const Vec2 &to)
    {
        const int steps = static_cast<int>(2.0 * (to - from).norm()) + 1;
        for (int i = 0; i <= steps; ++i) {
            const Vec2 p = from + (to - from) * i / steps;
            mark(static_cast<int>(p.x()), static_cast<int>(p.y()));
        }
    }

    Vec2 m_low;
    double m_pixel;
    int m_width, m_height;
    std::vector<unsigned char> m_covered;
};

std::vector<Vec3> outlineSeen(const std::vector<Vec3> &positions,
                              const std::vector<Triangle> &triangles, const Vec3 &right,
                              const Vec3 &up, double pixel)
{
    std::vector<Vec2> seen;
    seen.reserve(positions.size());
    Box2 box;
    for (const Vec3 &p : positions) {
        seen.emplace_back(right.dot(p), up.dot(p));
        box.extend(seen.back());
    }
    CoveredPixels pixels(box.min, box.max, pixel);
    for (const Triangle &t : triangles)
        pixels.add(seen[t[0]], seen[t[1]], seen[t[2]]);
    return pixels.outline();
}

struct SurfaceSpread
{
    std::vector<Vec3> points, normals;
    double area = 0.0; // mm²
};

/// So many points, spread evenly: at equal steps of the area, and within a triangle by the
/// fractions of multiples of two numbers.
/// Source  M. Roberts 2018, The unreasonable effectiveness of quasirandom sequences (R2).
SurfaceSpread spreadOver(const std::vector<Vec3> &positions, const std::vector<Triangle> &triangles,
                         int count)
{
    const auto across = [&](const Triangle &t) -> Vec3 {
        const Vec3 &a = positions[t[0]];
        return 0.5 * (positions[t[1]] - a).cross(positions[t[2]] - a);
    };
    SurfaceSpread spread;
    for (const Triangle &t : triangles)
        spread.area += across(t).norm();
    std::vector<Vec3> &points = spread.points;
    double passed = 0.0;
    constexpr double kFirst = 0.7548776662466927, kSecond = 0.5698402909980532;
    for (const Triangle &t : triangles) {
        const Vec3 normal = across(t);
        passed += normal.norm();
        while (static_cast<int>(points.size()) < count &&
               passed * count >= (static_cast<double>(points.size()) + 0.5) * spread.area) {
            double whole = 0.0;
            const auto n = static_cast<double>(points.size());
            double u = std::modf(n * kFirst, &whole), v = std::modf(n * kSecond, &whole);
            if (u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            const Vec3 &a = positions[t[0]];
            points.push_back(a + u * (positions[t[1]] - a) + v * (positions[t[2]] - a));
            spread.normals.push_back(normal.stableNormalized());
        }
    }
    return spread;
}

/// 1 up to `near`, 0 from `far` times that on.
float shownAt(float squared, double near, double far)
{
    const double distance = std::sqrt(static_cast<double>(squared)) / near;
    return static_cast<float>(std::clamp((far - distance) / (far - 1.0), 0.0, 1.0));
}

} // namespace

Result<FormSamples> FormSamples::of(const std::vector<Vec3> &positions,
                                    const std::vector<Triangle> &triangles, const LongWork &work)
{
    Box3 box;
    for (const Vec3 &p : positions)
        box.extend(p);
    const double size = box.size().maxCoeff();
    FormSamples samples;
    samples.m_meshSize = size;
    samples.m_nearOutline = kNearOutline * size;
    samples.m_nearSurface = kNearSurface * size;
    samples.m_step = 0.8 * samples.m_nearOutline;
    std::uint32_t first = 0;
    for (int i = 0; i < kViews; ++i) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        View view;
        const Vec3 from = viewDirection(i);
        view.right = Vec3::UnitY().cross(from).normalized();
        view.up = from.cross(view.right);
        view.outline =
            PointBuckets(outlineSeen(positions, triangles, view.right, view.up, size / kPixels),
                         kFarOutline * samples.m_nearOutline);
        view.first = first;
        first += static_cast<std::uint32_t>(view.outline.points().size());
        samples.m_views.push_back(std::move(view));
        work.tell(static_cast<double>(i + 1) / kViews);
    }
    SurfaceSpread spread = spreadOver(positions, triangles, kSurfaceSamples);
    samples.m_faces = mainFaces(spread.points, spread.normals, samples.m_nearOutline);
    samples.m_surface = PointBuckets(std::move(spread.points), kFarSurface * samples.m_nearSurface);
    samples.m_spacing = std::sqrt(spread.area / kSurfaceSamples);
    samples.m_firstOfSurface = first;
    samples.m_weights.assign(first, kOutlineWeight / std::max<std::uint32_t>(first, 1));
    const std::size_t onSurface = samples.surface().size();
    samples.m_weights.insert(samples.m_weights.end(), onSurface,
                             (1.0 - kOutlineWeight) / static_cast<double>(onSurface));
    return samples;
}

std::vector<FormSamples::Shown> FormSamples::shownBy(const std::vector<Vec3> &points) const
{
    constexpr float kNowhere = std::numeric_limits<float>::infinity();
    std::vector<float> squared(size(), kNowhere);
    const auto look = [&](const PointBuckets &buckets, std::uint32_t first, const Vec3 &p) {
        buckets.visitNear(p, [&](std::uint32_t i) {
            const auto distance = static_cast<float>((buckets.points()[i] - p).squaredNorm());
            squared[first + i] = std::min(squared[first + i], distance);
        });
    };
    for (const Vec3 &p : points) {
        for (const View &view : m_views)
            look(view.outline, view.first, view.seen(p));
        look(m_surface, m_firstOfSurface, p);
    }
    std::vector<Shown> shown;
    for (std::uint32_t i = 0; i < size(); ++i) {
        if (squared[i] == kNowhere)
            continue;
        const bool isOfOutline = i < m_firstOfSurface;
        const float share = isOfOutline ? shownAt(squared[i], m_nearOutline, kFarOutline)
                                        : shownAt(squared[i], m_nearSurface, kFarSurface);
        if (share > 0.0F)
            shown.push_back({i, share});
    }
    return shown;
}

} // namespace fff
