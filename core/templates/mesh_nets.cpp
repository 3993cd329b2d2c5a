#include "core/templates/mesh_nets.h"

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/templates/net_gap.h"
#include "core/templates/unfolding.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>
#include <utility>

namespace fff {

namespace {

/// A seam's flap ends at 45°, and is no narrower at its end than this, mm.
constexpr double kLeastFlapEnd = 2.0;

double lengthOf(const NetLine &line)
{
    return (line.to - line.from).norm();
}

/// What lies side by side already.
class Sheet
{
public:
    explicit Sheet(const NetOptions &options) : m_room(options.room), m_gap(options.gap) {}

    /// Adds what lies beside it along that line and nowhere else; null: the first. False: it would
    /// not.
    Result<bool> add(const std::vector<Polygon> &rings, const NetLine *fold);
    bool isEmpty() const { return m_rings.empty(); }
    const std::vector<Polygon> &rings() const { return m_rings; } // the outer one first

private:
    bool hasRoomFor(const std::vector<Polygon> &rings) const;

    Vec2 m_room;
    double m_gap;
    std::vector<Polygon> m_rings;
    double m_area = 0.0, m_perimeter = 0.0;
};

double perimeterOf(const std::vector<Polygon> &rings)
{
    double sum = 0.0;
    for (const Polygon &ring : rings)
        for (std::size_t i = 0; i < ring.size(); ++i)
            sum += (ring[(i + 1) % ring.size()] - ring[i]).norm();
    return sum;
}

double areaOf(const std::vector<Polygon> &rings)
{
    double sum = 0.0;
    for (const Polygon &ring : rings)
        sum += signedArea(ring);
    return sum;
}

bool Sheet::hasRoomFor(const std::vector<Polygon> &rings) const
{
    Box2 box;
    for (const auto *all : {&m_rings, &rings})
        if (!all->empty())
            box.extend(bounds(all->front()));
    const Vec2 size = box.size();
    return (size.x() <= m_room.x() && size.y() <= m_room.y()) ||
           (size.x() <= m_room.y() && size.y() <= m_room.x());
}

Result<bool> Sheet::add(const std::vector<Polygon> &rings, const NetLine *fold)
{
    const double shared = fold ? lengthOf(*fold) : 0.0;
    if (!m_rings.empty() && !hasRoomFor(rings))
        return false;
    std::vector<Contour> contours;
    for (const auto *all : {&std::as_const(m_rings), &rings})
        for (const Polygon &ring : *all) {
            Result<Contour> contour = Contour::fromPolygon(ring);
            if (!contour)
                return false;
            contours.push_back(*std::move(contour));
        }
    const Result<std::vector<CurvedRegion>> united =
        windingRegions(contours, WindingRule::NonZero, kCutChord);
    if (!united)
        return tl::unexpected(united.error());
    if (united->size() != 1)
        return false;
    std::vector<Polygon> all{united->front().region.outer};
    for (const Polygon &hole : united->front().region.holes)
        all.push_back(hole);
    // Nothing lies on anything, and nothing along anything but there.
    const double perimeter = perimeterOf(all), area = areaOf(all);
    const double wanted = m_perimeter + perimeterOf(rings) - 2.0 * shared;
    const double slack = 2.0 * kCoplanarDepth;
    if (std::abs(perimeter - wanted) > slack ||
        std::abs(area - m_area - areaOf(rings)) > kMinArea + kClipSlack * perimeter)
        return false;
    if (fold && !keepsGap(m_rings, rings, *fold, m_gap))
        return false;
    m_rings = std::move(all);
    m_area = area;
    m_perimeter = perimeter;
    return true;
}

/// A net while it grows.
struct GrowingNet
{
    Sheet sheet;
    MeshNet net;
};

class Netter
{
public:
    Netter(const TriangleMesh &mesh, const std::vector<MeshFacet> &facets,
           const NetOptions &options)
        : m_options(options), m_unfolding(mesh, facets), m_netOf(facets.size(), -1)
    {
    }

    Result<std::vector<MeshNet>> make(const LongWork &work);

private:
    struct Candidate
    {
        double length = 0.0;
        std::size_t hinge = 0;

        /// The longest first; of equal ones the first.
        bool operator<(const Candidate &other) const
        {
            return std::pair(length, other.hinge) < std::pair(other.length, hinge);
        }
    };

    Result<void> grow(std::size_t first, const LongWork &work);
    Result<bool> attach(const Hinge &hinge, GrowingNet &net);
    void sew();
    Result<void> addFlaps();
    Result<bool> addFlap(const NetLine &seam, GrowingNet &net);

    const NetOptions &m_options;
    Unfolding m_unfolding;
    std::vector<int> m_netOf; // by facets; −1: in none yet
    std::vector<GrowingNet> m_nets;
    std::set<std::size_t> m_folded; // hinges, from both of their sides
    std::size_t m_placed = 0;
};

Result<bool> Netter::attach(const Hinge &hinge, GrowingNet &net)
{
    m_unfolding.placeBeyond(hinge);
    const std::vector<Polygon> &rings = m_unfolding.rings(hinge.beyond);
    const NetLine line = m_unfolding.lineOf(hinge);
    const Result<bool> added = net.sheet.add(rings, &line);
    if (added && *added)
        net.net.folds.push_back({line, m_unfolding.isValley(hinge)});
    return added;
}

Result<void> Netter::grow(std::size_t first, const LongWork &work)
{
    const int number = static_cast<int>(m_nets.size());
    GrowingNet net{Sheet(m_options), {}};
    std::priority_queue<Candidate> waiting;
    const auto take = [&](std::size_t facet) {
        m_netOf[facet] = number;
        ++net.net.facets;
        for (const std::size_t hinge : m_unfolding.hingesOf(facet))
            waiting.push({m_unfolding.hinge(hinge).length, hinge});
        work.tell(static_cast<double>(++m_placed) / static_cast<double>(m_netOf.size()));
    };
    m_unfolding.place(first);
    const Result<bool> began = net.sheet.add(m_unfolding.rings(first), nullptr);
    if (!began)
        return tl::unexpected(began.error());
    m_netOf[first] = number;
    if (!*began)
        return {}; // a facet that bounds nothing
    take(first);
    while (!waiting.empty()) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        const std::size_t index = waiting.top().hinge;
        const Hinge &hinge = m_unfolding.hinge(index);
        waiting.pop();
        if (m_netOf[hinge.beyond] >= 0)
            continue;
        const Result<bool> added = attach(hinge, net);
        if (!added)
            return tl::unexpected(added.error());
        if (!*added)
            continue;
        m_folded.insert(index);
        m_folded.insert(hinge.opposite);
        take(hinge.beyond);
    }
    m_nets.push_back(std::move(net));
    return {};
}

/// Edges that are not folded are numbered in the order of the nets.
void Netter::sew()
{
    int number = 0;
    for (std::size_t i = 0; i < m_unfolding.hingeCount(); ++i) {
        const Hinge &hinge = m_unfolding.hinge(i);
        const std::size_t other = hinge.opposite;
        if (other < i || m_folded.contains(i))
            continue;
        ++number;
        for (const Hinge *side : {&hinge, &m_unfolding.hinge(other)})
            if (const int net = m_netOf[side->facet]; net >= 0)
                m_nets[static_cast<std::size_t>(net)].net.seams.push_back(
                    {m_unfolding.lineOf(*side), number});
    }
}

/// As wide as wanted, or as its edge has room for.
Result<bool> Netter::addFlap(const NetLine &seam, GrowingNet &net)
{
    const double length = lengthOf(seam);
    const double width = std::min(m_options.flap, 0.5 * (length - kLeastFlapEnd));
    if (width < kLeastFlap)
        return true; // on neither side
    const Vec2 along = (seam.to - seam.from) / length, out = -perpendicular(along);
    const Polygon flap{seam.to, seam.from, seam.from + width * (out + along),
                       seam.to + width * (out - along)};
    const Result<bool> added = net.sheet.add({flap}, &seam);
    if (added && *added)
        net.net.folds.push_back({seam, false});
    return added;
}

Result<void> Netter::addFlaps()
{
    if (m_options.flap < kLeastFlap)
        return {};
    std::set<int> done;
    for (GrowingNet &net : m_nets)
        for (const NetSeam &seam : std::vector(net.net.seams)) {
            if (done.contains(seam.number))
                continue;
            const Result<bool> added = addFlap(seam.line, net);
            if (!added)
                return tl::unexpected(added.error());
            if (*added)
                done.insert(seam.number);
        }
    return {};
}

Result<std::vector<MeshNet>> Netter::make(const LongWork &work)
{
    for (std::size_t i = 0; i < m_netOf.size(); ++i)
        if (m_netOf[i] < 0 && m_unfolding.hasRings(i))
            if (Result<void> grown = grow(i, work); !grown)
                return tl::unexpected(std::move(grown.error()));
    sew();
    if (Result<void> flapped = addFlaps(); !flapped)
        return tl::unexpected(std::move(flapped.error()));
    std::vector<MeshNet> nets;
    for (GrowingNet &grown : m_nets) {
        const std::vector<Polygon> &rings = grown.sheet.rings();
        Result<Contour> outline = Contour::fromPolygon(rings.front());
        if (!outline)
            return tl::unexpected(std::move(outline.error()));
        grown.net.outline = *std::move(outline);
        for (std::size_t k = 1; k < rings.size(); ++k)
            if (Result<Contour> hole = Contour::fromPolygon(rings[k]))
                grown.net.holes.push_back(*std::move(hole));
        nets.push_back(std::move(grown.net));
    }
    return nets;
}

} // namespace

Result<std::vector<MeshNet>> meshNets(const TriangleMesh &mesh,
                                      const std::vector<MeshFacet> &facets,
                                      const NetOptions &options, const LongWork &work)
{
    return Netter(mesh, facets, options).make(work);
}

} // namespace fff
