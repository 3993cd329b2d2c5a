#include "core/analysis/suggesting/suggested_cut.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/halfplane_clip.h"
#include "core/geometry/simplified_line.h"
#include "core/model/section.h"
#include "core/templates/template_cut.h"

#include <cmath>
#include <limits>
#include <optional>

namespace fff {

namespace {

Polygon fewer(const Polygon &polygon, double error)
{
    std::vector<Vec2> line(polygon);
    line.push_back(polygon.front());
    Polygon points;
    for (const std::size_t i : simplified(line, error))
        points.push_back(line[i]);
    points.pop_back();
    return points;
}

/// y upwards, or as it is seen from above.
Frame uprightFrame(const SuggestedPlane &plane)
{
    const Vec3 origin = plane.offset * plane.normal;
    const Vec3 x = Vec3::UnitY().cross(plane.normal);
    constexpr double kLevel = 1e-6; // sine
    if (x.norm() < kLevel)
        return {origin, Vec3::UnitX(), -Vec3::UnitZ()};
    return {origin, x.normalized(), plane.normal.cross(x).normalized()};
}

struct CutPiece
{
    Contour outer;
    std::vector<Contour> holes;
};

/// Loops by the pieces that they bound.
template <class Curve>
std::vector<CutPiece> piecesOf(const std::vector<TemplateLoop> &loops, double chord, Curve curve)
{
    std::vector<CutPiece> pieces;
    std::vector<Contour> all;
    std::vector<int> pieceOf(loops.size(), -1);
    std::vector<Box2> boxes;
    bool mayMeet = false;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const std::optional<Contour> contour = curve(loops[i]);
        if (!contour)
            continue;
        all.push_back(*contour);
        // Shells that share vertices have loops that run over into each other.
        mayMeet = mayMeet || !isPlain(*contour, {}, chord);
        if (!loops[i].isHole) {
            const Box2 box = contour->bounds();
            for (const Box2 &other : boxes)
                mayMeet = mayMeet || box.intersects(other);
            boxes.push_back(box);
            pieceOf[i] = static_cast<int>(pieces.size());
            pieces.push_back({*contour, {}});
        } else if (loops[i].around >= 0) {
            const int piece = pieceOf[static_cast<std::size_t>(loops[i].around)];
            if (piece >= 0)
                pieces[static_cast<std::size_t>(piece)].holes.push_back(*contour);
        }
    }
    if (!mayMeet)
        return pieces;
    const Result<std::vector<CurvedRegion>> together =
        windingRegions(all, WindingRule::NonZero, chord);
    if (!together)
        return pieces;
    pieces.clear();
    for (const CurvedRegion &region : *together)
        pieces.push_back({region.outer, region.holes});
    return pieces;
}

/// Its area, and the first moments of that.
struct RegionSums
{
    double area = 0.0;
    Vec2 first = Vec2::Zero();

    explicit RegionSums(const Region &region)
    {
        add(region.outer);
        for (const Polygon &hole : region.holes)
            add(hole);
    }
    void add(const Polygon &ring)
    {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            const double twice = cross(a, b);
            area += 0.5 * twice;
            first += twice / 6.0 * (a + b);
        }
    }
};

SuggestedCut cutOf(const Frame &frame, Region region)
{
    SuggestedCut cut{frame, std::move(region)};
    const RegionSums sums(cut.region);
    cut.area = sums.area;
    if (sums.area > 0.0)
        cut.centre = frame.toWorld(sums.first / sums.area);
    return cut;
}

std::vector<SuggestedCut> cutsOn(const SuggestedPlane &plane, const Template &one, double error)
{
    const Frame frame = uprightFrame(plane);
    const std::vector<TemplateLoop> loops = loopsOn(frame, one, *one.mesh);
    const auto coarse = [error](const TemplateLoop &loop) -> std::optional<Contour> {
        Polygon points = fewer(loop.points, error);
        constexpr std::size_t kFewest = 3;
        return points.size() < kFewest ? std::nullopt : std::optional(Contour::ofPolygon(points));
    };
    std::vector<SuggestedCut> cuts;
    for (const CutPiece &piece : piecesOf(loops, error, coarse)) {
        Region region{piece.outer.polygon(error), {}};
        for (const Contour &hole : piece.holes)
            region.holes.push_back(hole.polygon(error));
        cuts.push_back(cutOf(frame, std::move(region)));
        cuts.back().preference = plane.preference;
    }
    return cuts;
}

/// With the feet that it has on this ground.
Result<ShapePointer> footed(const Frame &frame, ClippedPiece piece, const SuggestedGround &ground)
{
    Region region{piece.outer.polygon(kCutChord), {}};
    for (const Contour &hole : piece.holes)
        region.holes.push_back(hole.polygon(kCutChord));
    const std::vector<SuggestedFoot> feet = feetOn(ground, frame, region);
    if (feet.empty())
        return Shape::make(std::move(piece.outer), std::move(piece.holes));
    std::vector<Contour> all = std::move(piece.holes);
    all.push_back(std::move(piece.outer));
    for (const SuggestedFoot &foot : feet)
        all.push_back(Contour::ofPolygon(foot.outline()));
    Result<std::vector<CurvedRegion>> whole = windingRegions(all, WindingRule::NonZero, kCutChord);
    if (!whole)
        return tl::unexpected(std::move(whole.error()));
    if (whole->empty())
        return failure(ErrorCode::EmptyContour);
    return Shape::make(std::move(whole->front().outer), std::move(whole->front().holes));
}

} // namespace

std::vector<Vec3> pointsAlong(const Frame &frame, const Region &region, double step)
{
    std::vector<Vec3> points;
    const auto add = [&](const Polygon &ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 &a = ring[i], way = ring[(i + 1) % ring.size()] - a;
            const int steps = static_cast<int>(std::ceil(way.norm() / step));
            for (int k = 0; k < steps; ++k)
                points.push_back(frame.toWorld(a + way * k / steps));
        }
    };
    add(region.outer);
    for (const Polygon &hole : region.holes)
        add(hole);
    return points;
}

Result<std::vector<SuggestedCut>> suggestedCuts(const Template &one,
                                                const std::vector<SuggestedPlane> &planes,
                                                const FormSamples &samples, double leastArea,
                                                const LongWork &work)
{
    const double error = kCutError * samples.meshSize();
    std::vector<SuggestedCut> cuts;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        for (SuggestedCut &cut : cutsOn(planes[i], one, error)) {
            if (cut.area < leastArea)
                continue;
            cut.shown = samples.shownBy(pointsAlong(cut.frame, cut.region, samples.step()));
            cuts.push_back(std::move(cut));
        }
        work.tell(static_cast<double>(i + 1) / static_cast<double>(planes.size()));
    }
    return cuts;
}

Result<ShapePointer> shapeOf(const SuggestedCut &cut, const Template &one,
                             const SuggestedGround &ground)
{
    const auto fitted = [](const TemplateLoop &loop) -> std::optional<Contour> {
        Result<Contour> contour = curveOf(loop);
        return contour ? std::optional(*std::move(contour)) : std::nullopt;
    };
    const std::vector<CutPiece> pieces =
        piecesOf(loopsOn(cut.frame, one, *one.mesh), kCutChord, fitted);
    // The one that the cut is of, by its box: pieces of a plane lie apart, or one in the other.
    const Box2 box = bounds(cut.region.outer);
    const CutPiece *best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const CutPiece &piece : pieces) {
        const Box2 other = bounds(piece.outer.polygon(kDrawChord));
        const double off = (other.min - box.min).norm() + (other.max - box.max).norm();
        if (off < least) {
            least = off;
            best = &piece;
        }
    }
    if (!best)
        return failure(ErrorCode::EmptyContour);
    const Vec2 up = cut.frame.directionToLocal(Vec3::UnitY());
    constexpr double kLevel = 1e-6; // sine: the plane lies
    if (up.norm() < kLevel)
        return Shape::make(best->outer, best->holes);
    const Halfplane above{up / up.squaredNorm() * (ground.level - cut.frame.origin.y()),
                          up.normalized()};
    Result<std::vector<ClippedPiece>> left = clip(best->outer, best->holes, above);
    if (!left)
        return tl::unexpected(std::move(left.error()));
    if (left->empty())
        return failure(ErrorCode::EmptyContour);
    return footed(cut.frame, std::move(left->front()), ground);
}

SuggestedCut cutOfSection(const Section &section, double error)
{
    Region region = section.shape->flatten(error);
    return cutOf(section.frame, std::move(region));
}

} // namespace fff
