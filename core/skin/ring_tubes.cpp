#include "core/skin/ring_tubes.h"

#include "core/assembly/crossing.h"
#include "core/base/tolerances.h"
#include "core/geometry/triangulation.h"
#include "core/skin/coons_patch.h"
#include "core/skin/network_curves.h"
#include "core/skin/patch_judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace fff {

namespace {

/// Planes that meet at more than this are not stacked (60°, as a cosine).
constexpr double kStackedCosine = 0.5;
constexpr int kTubeChords = 8;
/// So many starts are tried for the seam between two outlines, by so many points of each.
constexpr int kSeamStarts = 64;

/// A section on one that it crosses.
struct Bead
{
    int section = 0;
    Vec3 middle = Vec3::Zero(); // of what both share
    Vec3 normal = Vec3::UnitZ();
};

/// Of each section those that it crosses.
Result<std::vector<std::vector<Bead>>> beadsOf(const std::vector<SectionPointer> &sections,
                                               const LongWork &work)
{
    std::vector<Box3> boxes;
    for (const SectionPointer &section : sections)
        boxes.push_back(worldBounds(*section->shape, section->frame));
    std::vector<std::vector<Bead>> beads(sections.size());
    for (const auto &[i, j] : meetingPairs(boxes)) {
        if (work.isStopped())
            return failure(ErrorCode::Cancelled);
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
        const Crossing crossing = findCrossing(*sections[a]->shape, sections[a]->frame,
                                               *sections[b]->shape, sections[b]->frame);
        if (crossing.overlaps.empty())
            continue;
        const auto longest = std::max_element(
            crossing.overlaps.begin(), crossing.overlaps.end(),
            [](const Overlap &p, const Overlap &q) { return p.to - p.from < q.to - q.from; });
        const Vec3 middle = crossing.axis.at(0.5 * (longest->from + longest->to));
        beads[a].push_back({j, middle, sections[b]->frame.normal()});
        beads[b].push_back({i, middle, sections[a]->frame.normal()});
    }
    return beads;
}

/// The nearest one that is stacked on this, on the side that its normal points to, or on the other.
const Bead *nearestBead(const std::vector<Bead> &beads, const Bead &of, bool isAhead)
{
    const Bead *nearest = nullptr;
    double least = 0.0;
    for (const Bead &bead : beads) {
        const Vec3 way = bead.middle - of.middle;
        const double ahead = (isAhead ? 1.0 : -1.0) * of.normal.dot(way);
        if (bead.section == of.section || ahead <= 0.0 ||
            std::abs(of.normal.dot(bead.normal)) < kStackedCosine)
            continue;
        if (const double distance = way.norm(); !nearest || distance < least) {
            nearest = &bead;
            least = distance;
        }
    }
    return nearest;
}

/// Where the second outline starts, so that both run beside each other: as near as they can be, if
/// the one was moved to the other.
double seamStart(const SkinOutline &a, const SkinOutline &b, const Vec3 &shift, bool isAlike)
{
    double best = 0.0, least = 0.0;
    for (int start = 0; start < kSeamStarts; ++start) {
        double sum = 0.0;
        for (int k = 0; k < kSeamStarts; ++k) {
            const double share = static_cast<double>(k) / kSeamStarts;
            const double along =
                static_cast<double>(start) / kSeamStarts + (isAlike ? share : -share);
            sum += (a.worldAt(share * a.length()) + shift - b.worldAt(along * b.length()))
                       .squaredNorm();
        }
        if (start == 0 || sum < least) {
            least = sum;
            best = static_cast<double>(start) / kSeamStarts * b.length();
        }
    }
    return best;
}

SkinCurve seam(GrowingMesh &mesh, const SkinCurve &from, const SkinCurve &to)
{
    const Vec3 way = (to.points.front() - from.points.front()).normalized();
    return bridge(mesh, from.vertices.front(), way, from.normals.front(), to.vertices.front(), way,
                  to.normals.front(), kTubeChords);
}

/// The same ring from another of its points.
SkinCurve startedAt(const SkinCurve &ring, double share)
{
    const std::size_t count = ring.points.size() - 1;
    const auto nearest =
        std::min_element(ring.at.begin(), ring.at.end() - 1, [share](double a, double b) {
            return std::abs(a - share) < std::abs(b - share);
        });
    const auto first = static_cast<std::size_t>(nearest - ring.at.begin());
    SkinCurve turned;
    for (std::size_t i = 0; i <= count; ++i) {
        const std::size_t at = (first + i) % count;
        turned.vertices.push_back(ring.vertices[at]);
        turned.points.push_back(ring.points[at]);
        turned.normals.push_back(ring.normals[at]);
    }
    turned.outwards = turned.normals;
    measure(turned);
    return turned;
}

} // namespace

Result<std::vector<RingPair>> ringPairs(const std::vector<SectionPointer> &sections,
                                        const ContourNetwork &network, const LongWork &work)
{
    std::vector<RingPair> pairs;
    if (network.loose.size() < 2)
        return pairs;
    const auto beads = beadsOf(sections, work);
    if (!beads)
        return tl::unexpected(beads.error());
    const std::set<int> loose(network.loose.begin(), network.loose.end());
    std::set<std::pair<int, bool>> taken; // sides of sections
    for (const std::vector<Bead> &string : *beads)
        for (const Bead &bead : string)
            for (const bool isAhead : {false, true}) {
                const Bead *next = nearestBead(string, bead, isAhead);
                if (!next || bead.section > next->section || !loose.contains(bead.section) ||
                    !loose.contains(next->section))
                    continue;
                const bool isFrontal = next->normal.dot(bead.middle - next->middle) > 0.0;
                const Bead *back = nearestBead(string, *next, isFrontal);
                if (!back || back->section != bead.section ||
                    taken.contains({bead.section, isAhead}) ||
                    taken.contains({next->section, isFrontal}))
                    continue;
                taken.insert({bead.section, isAhead});
                taken.insert({next->section, isFrontal});
                pairs.push_back(
                    {bead.section, next->section, isAhead, isFrontal, next->middle - bead.middle});
            }
    return pairs;
}

bool fillFlat(GrowingMesh &mesh, const SkinCurve &ring, const Frame &frame)
{
    Polygon polygon;
    std::map<std::pair<double, double>, std::uint32_t> vertices;
    for (std::size_t i = 0; i + 1 < ring.points.size(); ++i) {
        polygon.push_back(frame.toLocal(ring.points[i]));
        vertices.emplace(std::pair(polygon.back().x(), polygon.back().y()), ring.vertices[i]);
    }
    const bool isTurned = signedArea(polygon) < 0.0;
    const Result<Triangulation> flat = triangulate({polygon, {}});
    if (!flat)
        return false;
    std::vector<std::uint32_t> of;
    for (const Vec2 &p : flat->points) {
        const auto known = vertices.find({p.x(), p.y()});
        of.push_back(known != vertices.end() ? known->second : mesh.add(frame.toWorld(p)));
    }
    const auto at = [&of](int i) { return of[static_cast<std::size_t>(i)]; };
    for (const auto &[a, b, c] : flat->triangles) {
        if (isTurned)
            mesh.face(at(a), at(c), at(b));
        else
            mesh.face(at(a), at(b), at(c));
    }
    return true;
}

FilledTubes fillTubes(GrowingMesh &mesh, const std::vector<RingPair> &pairs,
                      const ContourNetwork &network)
{
    std::map<int, SkinCurve> rings; // counter-clockwise about the section's normal
    const auto outline = [&](int section) -> const SkinOutline & {
        return network.outlines[static_cast<std::size_t>(section)];
    };
    for (const RingPair &pair : pairs)
        for (const int section : {pair.a, pair.b})
            if (!rings.contains(section))
                rings.emplace(section, ringCurve(outline(section), 0.0, mesh));
    std::map<int, int> sides; // of sections: 1 behind, 2 ahead, 3 both are covered
    FilledTubes filled;
    for (const RingPair &pair : pairs) {
        const SkinOutline &a = outline(pair.a), &b = outline(pair.b);
        // Both counter-clockwise about the way from a to b.
        const bool isAlike = pair.isAhead != pair.isFrontal;
        const double start = seamStart(a, b, pair.shift, isAlike);
        const SkinCurve from = pair.isAhead ? rings.at(pair.a) : rings.at(pair.a).reversed();
        const SkinCurve turned = startedAt(rings.at(pair.b), start / b.length());
        const SkinCurve to = pair.isFrontal ? turned.reversed() : turned;
        PatchJudge judge(mesh);
        const SkinCurve along = seam(mesh, from, to);
        fillPatch(mesh, {from, along, to, along});
        if (const PatchFault fault = judge.faultOf({from, to}); fault != PatchFault::None) {
            filled.open.push_back({pair.a, pair.b, fault});
            continue;
        }
        sides[pair.a] |= pair.isAhead ? 2 : 1;
        sides[pair.b] |= pair.isFrontal ? 2 : 1;
        ++filled.patches;
    }
    for (const auto &[section, covered] : sides) {
        if (covered == 3)
            continue;
        const SkinCurve &ring = rings.at(section);
        if (fillFlat(mesh, covered == 1 ? ring : ring.reversed(), outline(section).frame()))
            ++filled.patches;
    }
    return filled;
}

} // namespace fff
