#include "core/templates/traced_picture.h"

#include <potracelib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fff {

namespace {

constexpr int kShades = 256;
/// Potrace's parameter of corners goes from 0 to this: beyond there are none.
constexpr double kMostAlpha = 4.0 / 3.0;
/// By how much of a pixel pieces of curves may be off when they are joined, with all smoothing.
constexpr double kMostJoined = 0.4;
constexpr int kWordBits = std::numeric_limits<potrace_word>::digits;

/// What counts, in the form that Potrace reads: the lowest row first, bits from the left.
class DarkPixels
{
public:
    DarkPixels(int width, int height)
        : m_words((width + kWordBits - 1) / kWordBits),
          m_map(static_cast<std::size_t>(m_words) * static_cast<std::size_t>(height), 0),
          m_bitmap{width, height, m_words, m_map.data()}
    {
    }
    DarkPixels(const DarkPixels &) = delete;
    DarkPixels &operator=(const DarkPixels &) = delete;

    void set(int x, int row)
    {
        m_map[static_cast<std::size_t>(row) * static_cast<std::size_t>(m_words) +
              static_cast<std::size_t>(x / kWordBits)] |= potrace_word(1)
                                                          << (kWordBits - 1 - x % kWordBits);
    }
    const potrace_bitmap_t &bitmap() const { return m_bitmap; }

private:
    int m_words;
    std::vector<potrace_word> m_map;
    potrace_bitmap_t m_bitmap;
};

/// The picture with so many pixels of each side made into one.
GreyPicture shrunk(const GreyPicture &picture, int by)
{
    GreyPicture small{(picture.width + by - 1) / by, (picture.height + by - 1) / by, {}};
    small.grey.reserve(static_cast<std::size_t>(small.width) *
                       static_cast<std::size_t>(small.height));
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            int sum = 0, count = 0;
            for (int dy = y * by; dy < std::min((y + 1) * by, picture.height); ++dy)
                for (int dx = x * by; dx < std::min((x + 1) * by, picture.width); ++dx) {
                    sum += picture.at(dx, dy);
                    ++count;
                }
            small.grey.push_back(static_cast<std::uint8_t>(sum / count));
        }
    return small;
}

/// From Potrace's places, which count from the lower left, to those about the middle.
struct PixelMap
{
    Vec2 middle = Vec2::Zero();
    double scale = 1.0;

    Vec2 operator()(const potrace_dpoint_t &p) const { return scale * (Vec2(p.x, p.y) - middle); }
};

std::vector<CubicBezier> segmentsOf(const potrace_curve_t &curve, const PixelMap &map)
{
    std::vector<CubicBezier> segments;
    Vec2 from = map(curve.c[curve.n - 1][2]);
    for (int i = 0; i < curve.n; ++i) {
        const Vec2 end = map(curve.c[i][2]);
        if (curve.tag[i] == POTRACE_CORNER) {
            const Vec2 corner = map(curve.c[i][1]);
            segments.push_back(CubicBezier::line(from, corner));
            segments.push_back(CubicBezier::line(corner, end));
        } else {
            segments.push_back({from, map(curve.c[i][0]), map(curve.c[i][1]), end});
        }
        from = end;
    }
    std::erase_if(segments, [](const CubicBezier &s) { return s.p0 == s.p3 && s.p1 == s.p2; });
    return segments;
}

/// Of a path, and what lies in it as its children: in these are holes, in those other regions.
void addRegions(const potrace_path_t *path, const PixelMap &map, std::vector<TracedRegion> &regions)
{
    for (; path; path = path->sibling) {
        Result<Contour> outer = Contour::fromSegments(segmentsOf(path->curve, map));
        if (!outer)
            continue;
        TracedRegion region{*std::move(outer), {}};
        for (const potrace_path_t *hole = path->childlist; hole; hole = hole->sibling) {
            if (Result<Contour> inner = Contour::fromSegments(segmentsOf(hole->curve, map)))
                region.holes.push_back(*std::move(inner));
            addRegions(hole->childlist, map, regions);
        }
        regions.push_back(std::move(region));
    }
}

void tellProgress(double share, void *work)
{
    static_cast<const LongWork *>(work)->tell(share);
}

} // namespace

Result<std::vector<TracedRegion>> traced(const GreyPicture &given, const TraceOptions &options,
                                         const LongWork &work)
{
    const double pixels = static_cast<double>(given.width) * given.height;
    if (!(given.width > 0 && given.height > 0) || pixels != static_cast<double>(given.grey.size()))
        return failure(ErrorCode::BadValue, "picture");
    const int by = static_cast<int>(std::ceil(std::sqrt(pixels / kMostTracedPixels)));
    const GreyPicture &picture = by > 1 ? shrunk(given, by) : given;

    DarkPixels dark(picture.width, picture.height);
    const double limit = options.threshold * (kShades - 1);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if ((picture.at(x, y) < limit) != options.isInverted)
                dark.set(x, picture.height - 1 - y);
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);

    potrace_param_t *parameters = potrace_param_default();
    const double smoothing = std::clamp(options.smoothing, 0.0, 1.0);
    parameters->turdsize = std::max(0, options.smallest / (by * by));
    parameters->alphamax = kMostAlpha * smoothing;
    parameters->opttolerance = kMostJoined * smoothing;
    LongWork told = work;
    parameters->progress = {tellProgress, &told, 0.0, 1.0, 0.01};
    potrace_state_t *state = potrace_trace(parameters, &dark.bitmap());
    potrace_param_free(parameters);
    if (!state)
        return failure(ErrorCode::BadValue, "picture");
    std::vector<TracedRegion> regions;
    const bool isWhole = state->status == POTRACE_STATUS_OK;
    if (isWhole)
        addRegions(state->plist,
                   {Vec2(0.5 * given.width / by, picture.height - 0.5 * given.height / by),
                    static_cast<double>(by)},
                   regions);
    potrace_state_free(state);
    if (!isWhole)
        return failure(ErrorCode::BadValue, "picture");
    if (work.isStopped())
        return failure(ErrorCode::Cancelled);
    std::stable_sort(regions.begin(), regions.end(),
                     [](const TracedRegion &a, const TracedRegion &b) {
                         return std::abs(a.outer.signedArea()) > std::abs(b.outer.signedArea());
                     });
    return regions;
}

double suggestedThreshold(const GreyPicture &picture)
{
    std::array<double, kShades> count{};
    for (const std::uint8_t shade : picture.grey)
        count[shade] += 1.0;
    double all = 0.0, sum = 0.0;
    for (int i = 0; i < kShades; ++i) {
        all += count[static_cast<std::size_t>(i)];
        sum += i * count[static_cast<std::size_t>(i)];
    }
    double below = 0.0, sumBelow = 0.0, best = 0.0, threshold = 0.5;
    int first = -1, last = -1; // shades after which the classes are furthest apart
    for (int i = 0; i + 1 < kShades; ++i) {
        below += count[static_cast<std::size_t>(i)];
        sumBelow += i * count[static_cast<std::size_t>(i)];
        const double above = all - below;
        if (below <= 0.0 || above <= 0.0)
            continue;
        const double apart = sumBelow / below - (sum - sumBelow) / above;
        const double between = below * above * apart * apart;
        if (between > best) {
            best = between;
            first = last = i;
        } else if (between == best) {
            last = i;
        }
    }
    if (first >= 0)
        threshold = (0.5 * (first + last) + 0.5) / (kShades - 1);
    return threshold;
}

} // namespace fff
