#include "core/model/mended_shape.h"

#include "core/base/groups.h"
#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/geometry/ring_nesting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace fff {

namespace {

double perimeter(const Polygon &polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        sum += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
    return sum;
}

double areaOf(const std::vector<CurvedRegion> &regions)
{
    double sum = 0.0;
    for (const CurvedRegion &piece : regions)
        sum += area(piece.region);
    return sum;
}

/// The same curve, begun at another of its anchors.
bool isTurned(const Contour &a, const Contour &b)
{
    const std::vector<Vec2> &p = a.points(), &q = b.points();
    if (p.size() != q.size())
        return false;
    for (std::size_t start = 0; start < q.size(); start += 3) {
        const auto turn = q.begin() + static_cast<std::ptrdiff_t>(start);
        const auto rest = p.begin() + (q.end() - turn);
        if (std::equal(turn, q.end(), p.begin()) && std::equal(q.begin(), turn, rest))
            return true;
    }
    return false;
}

/// Resolved; but where that found nothing to leave out and only begins elsewhere, as it was drawn:
/// it would begin elsewhere again each time that a file of it is read.
Result<ResolvedContour> resolvedInPlace(const Contour &drawn)
{
    Result<ResolvedContour> resolved = resolveCrossings(drawn);
    if (resolved && resolved->wasCrossing &&
        (isTurned(resolved->contour, drawn) || isTurned(resolved->contour, drawn.reversed()))) {
        resolved->contour = drawn;
        resolved->chords = {};
        resolved->isPlain = false;
    }
    return resolved;
}

/// Something was left out. Pieces that meet within rounding may be found to cross once more in a
/// file that was mended when it was first opened; nobody needs to hear of that again.
bool isMended(const ResolvedContour &resolved, const Contour &drawn)
{
    return resolved.wasCrossing && resolved.contour.points() != drawn.points();
}

class Mender
{
public:
    Mender(const std::string &name, std::vector<Warning> &warnings)
        : m_name(name), m_warnings(warnings)
    {
    }

    Result<ShapePointer> mend(const PlacedContour &contour,
                              const std::vector<PlacedContour> &holes);

private:
    void warn(WarningCode code, const std::string &where);
    std::vector<CurvedRegion> known(Result<std::vector<CurvedRegion>> regions);
    bool liesInside(const Contour &hole);
    bool overlap(const Contour &a, const Contour &b);
    std::optional<Contour> notched(const Contour &contour, const Contour &hole);
    void addHole(const PlacedContour &drawn);
    Groups overlapping();
    bool uniteOverlapping();
    void cutOut();

    const std::string m_name;
    std::vector<Warning> &m_warnings;
    std::optional<Error> m_error; // of the first boolean that failed: then nothing can be told
    struct Hole
    {
        Contour contour;
        std::string where;
        Box2 bounds; // contains it
    };

    Contour m_contour;
    std::optional<RingInterior> m_interior; // of the contour, once it is asked for
    Polyline m_chords;                      // of the contour, until it is notched
    std::vector<Hole> m_holes;
};

void Mender::warn(WarningCode code, const std::string &where)
{
    m_warnings.push_back(
        {code, where, m_name.empty() ? std::vector<std::string>{} : std::vector{m_name}});
}

/// What a boolean came to. Where it failed nothing, and mend() says so in the end.
std::vector<CurvedRegion> Mender::known(Result<std::vector<CurvedRegion>> regions)
{
    if (regions)
        return *std::move(regions);
    if (!m_error)
        m_error = std::move(regions.error());
    return {};
}

/// What reaches beyond the contour is no more than a rim of the width of kCutChord.
bool Mender::liesInside(const Contour &hole)
{
    if (!m_interior)
        m_interior.emplace(m_contour);
    // Nearly all holes are well inside, and that is soon seen.
    return m_interior->hasAll(RingInterior(hole)) ||
           areaOf(known(subtract(hole, {m_contour}, {}, kCutChord))) <=
               kMinArea + kCutChord * perimeter(hole.flatten(kCutChord).points);
}

/// They share more than a rim of the width of kResolveChord, or the dust that booleans leave out.
bool Mender::overlap(const Contour &a, const Contour &b)
{
    if (nesting(a, b, kResolveChord) == Nesting::Apart)
        return false;
    const Polygon whole = a.flatten(kResolveChord).points;
    const double shared =
        std::abs(signedArea(whole)) - areaOf(known(subtract(a, {b}, {}, kResolveChord)));
    return shared > 2.0 * kMinArea + kResolveChord * perimeter(whole);
}

/// The contour without the hole, when that is one piece and less than the contour.
std::optional<Contour> Mender::notched(const Contour &contour, const Contour &hole)
{
    std::vector<CurvedRegion> pieces = known(subtract(contour, {hole}, {}, kResolveChord));
    if (pieces.size() != 1 || !pieces.front().holes.empty() || !overlap(contour, hole))
        return std::nullopt;
    return std::move(pieces.front().outer);
}

/// A hole that cannot be one is left out with a warning.
void Mender::addHole(const PlacedContour &drawn)
{
    Result<ResolvedContour> hole = resolvedInPlace(drawn.contour);
    if (!hole && hole.error().code != ErrorCode::EmptyContour) {
        m_error = hole.error();
        return;
    }
    if (!hole || std::abs(hole->contour.signedArea()) < kMinArea) {
        warn(WarningCode::DegenerateHole, drawn.where);
        return;
    }
    if (!liesInside(hole->contour) && !notched(m_contour, hole->contour)) {
        warn(WarningCode::HoleOutside, drawn.where);
        return;
    }
    if (isMended(*hole, drawn.contour))
        warn(WarningCode::SelfCrossingContour, drawn.where);
    const Box2 box = hole->contour.bounds();
    m_holes.push_back({std::move(hole->contour), drawn.where, box});
}

/// Which holes overlap, directly or by way of others.
Groups Mender::overlapping()
{
    Groups groups(m_holes.size());
    // Along the side of the page that the holes take less of, few of them stand beside each other.
    Vec2 widths = Vec2::Zero();
    Box2 all;
    for (const Hole &hole : m_holes) {
        widths += hole.bounds.size();
        all.extend(hole.bounds);
    }
    const int axis = widths.x() * all.size().y() <= widths.y() * all.size().x() ? 0 : 1;
    std::vector<std::size_t> order(m_holes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return m_holes[a].bounds.min[axis] < m_holes[b].bounds.min[axis];
    });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Hole &hole = m_holes[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Hole &other = m_holes[order[j]];
            if (other.bounds.min[axis] > hole.bounds.max[axis])
                break;
            if (groups.firstOf(order[i]) != groups.firstOf(order[j]) &&
                hole.bounds.intersects(other.bounds) && overlap(hole.contour, other.contour))
                groups.join(order[i], order[j]);
        }
    }
    return groups;
}

/// Holes that overlap become one. What they enclose between them falls out, too. Whether there were
/// any.
bool Mender::uniteOverlapping()
{
    std::vector<Hole> united;
    bool isAny = false;
    for (const std::vector<std::size_t> &group : overlapping().all()) {
        std::vector<Contour> contours;
        for (const std::size_t i : group)
            contours.push_back(m_holes[i].contour.signedArea() < 0.0 ? m_holes[i].contour.reversed()
                                                                     : m_holes[i].contour);
        std::vector<CurvedRegion> regions;
        if (group.size() > 1)
            regions = known(windingRegions(contours, WindingRule::NonZero, kResolveChord));
        for (std::size_t i = 1; i < group.size() && !regions.empty(); ++i)
            warn(WarningCode::MergedHoles, m_holes[group[i]].where);
        if (regions.empty()) {
            for (const std::size_t i : group)
                united.push_back(std::move(m_holes[i]));
            continue;
        }
        isAny = true;
        const Box2 box = regions.front().outer.bounds();
        united.push_back(
            {std::move(regions.front().outer), std::move(m_holes[group.front()].where), box});
    }
    m_holes = std::move(united);
    return isAny;
}

/// Holes that cross the contour become notches of it. Holes do not meet each other by now, so that
/// a notch leaves the others where they are: inside.
void Mender::cutOut()
{
    std::vector<Hole> inside;
    for (Hole &hole : m_holes) {
        if (liesInside(hole.contour)) {
            inside.push_back(std::move(hole));
        } else if (std::optional<Contour> rest = notched(m_contour, hole.contour)) {
            m_contour = *std::move(rest);
            m_interior.reset();
            m_chords = {};
            warn(WarningCode::NotchedContour, hole.where);
        } else {
            warn(WarningCode::HoleOutside, hole.where);
        }
    }
    m_holes = std::move(inside);
}

Result<ShapePointer> Mender::mend(const PlacedContour &contour,
                                  const std::vector<PlacedContour> &holes)
{
    Result<ResolvedContour> resolved = resolvedInPlace(contour.contour);
    if (!resolved)
        return tl::unexpected(resolved.error());
    if (isMended(*resolved, contour.contour))
        warn(WarningCode::SelfCrossingContour, contour.where);
    m_contour = std::move(resolved->contour);
    m_chords = std::move(resolved->chords);
    for (const PlacedContour &hole : holes)
        addHole(hole);
    // One that has grown may reach others.
    while (uniteOverlapping())
        ;
    cutOut();
    if (m_error)
        return tl::unexpected(*m_error);
    std::vector<Contour> mended;
    for (Hole &hole : m_holes)
        mended.push_back(std::move(hole.contour));
    const bool isPlain = resolved->isPlain && !m_chords.points.empty();
    return Shape::make(std::move(m_contour), std::move(mended), std::move(m_chords), isPlain);
}

/// Mending moves crossings by up to the grid's rounding and may leave others behind: this many
/// times more, until nothing changes, so that a file of the mended shape is read as it was written.
constexpr int kMaxPasses = 8;

Result<ShapePointer> mendedAgain(const Shape &shape)
{
    std::vector<PlacedContour> holes;
    for (const Contour &hole : shape.holes())
        holes.push_back({hole, {}});
    std::vector<Warning> ignored;
    return Mender({}, ignored).mend({shape.contour(), {}}, holes);
}

} // namespace

Result<ShapePointer> makeMendedShape(const PlacedContour &contour,
                                     const std::vector<PlacedContour> &holes,
                                     const std::string &name, std::vector<Warning> &warnings)
{
    const std::size_t warningsBefore = warnings.size();
    Result<ShapePointer> shape = Mender(name, warnings).mend(contour, holes);
    if (warnings.size() == warningsBefore)
        return shape;
    for (int pass = 0; shape && pass < kMaxPasses; ++pass) {
        Result<ShapePointer> again = mendedAgain(**shape);
        if (!again && again.error().code != ErrorCode::EmptyContour)
            return again;
        if (!again || **again == **shape)
            break;
        shape = std::move(again);
    }
    return shape;
}

} // namespace fff
