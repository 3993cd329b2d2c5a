#include "core/skin/contour_network.h"

#include "core/base/tolerances.h"
#include "core/skin/outline_meetings.h"
#include "core/skin/skin_measures.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// An outline at a corner.
struct Pass
{
    int corner = 0;
    double along = 0.0;
};

/// Where the outline passes corners, in its order; places that are one corner as one.
std::vector<Pass> passesOf(const SkinOutline &outline, std::vector<Pass> places)
{
    std::sort(places.begin(), places.end(),
              [](const Pass &a, const Pass &b) { return a.along < b.along; });
    std::vector<std::vector<Pass>> runs;
    for (const Pass &place : places) {
        if (!runs.empty() && runs.back().back().corner == place.corner &&
            place.along - runs.back().back().along < kSkinReach)
            runs.back().push_back(place);
        else
            runs.push_back({place});
    }
    if (runs.size() > 1 && runs.front().front().corner == runs.back().back().corner &&
        runs.front().front().along + outline.length() - runs.back().back().along < kSkinReach) {
        for (Pass place : runs.front()) {
            place.along += outline.length();
            runs.back().push_back(place);
        }
        runs.erase(runs.begin());
    }
    std::vector<Pass> passes;
    for (const std::vector<Pass> &run : runs) {
        double sum = 0.0;
        for (const Pass &place : run)
            sum += place.along;
        passes.push_back({run.front().corner, sum / static_cast<double>(run.size())});
    }
    return passes;
}

/// Least squares plane of the directions in which outlines pass; which side is outside they say
/// together.
Vec3 normalAt(const std::vector<Vec3> &tangents, const Vec3 &outwards)
{
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3 &t : tangents)
        spread += t * t.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
    const Vec3 normal = solver.eigenvectors().col(0);
    return normal.dot(outwards) < 0.0 ? Vec3(-normal) : normal;
}

/// What outlines make of one of the corners.
struct Gathered
{
    Vec3 sum = Vec3::Zero(), outwards = Vec3::Zero();
    std::vector<Vec3> tangents;
};

void gather(Gathered &corner, const SkinOutline &outline, double along)
{
    const Vec2 tangent = outline.tangentAt(along, std::min(kSkinReach, 0.1 * outline.length()));
    corner.sum += outline.worldAt(along);
    corner.outwards -= outline.frame().directionToWorld(perpendicular(tangent));
    corner.tangents.push_back(outline.frame().directionToWorld(tangent));
}

void addEdges(ContourNetwork &network, int outline, const std::vector<Pass> &passes)
{
    const double length = network.outlines[static_cast<std::size_t>(outline)].length();
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const Pass &from = passes[i], &to = passes[(i + 1) % passes.size()];
        const double end = i + 1 < passes.size() ? to.along : to.along + length;
        if (end - from.along > kSkinSame) // it passes twice at the same place
            network.edges.push_back({outline, from.corner, to.corner, from.along, end});
    }
}

/// Sorted by their angle about the corner's normal.
void turnRound(ContourNetwork &network)
{
    network.round.resize(network.corners.size());
    for (std::size_t e = 0; e < network.edges.size(); ++e) {
        network.round[static_cast<std::size_t>(network.edges[e].from)].push_back(
            2 * static_cast<int>(e));
        network.round[static_cast<std::size_t>(network.edges[e].to)].push_back(
            2 * static_cast<int>(e) + 1);
    }
    for (std::size_t c = 0; c < network.corners.size(); ++c) {
        const Vec3 &normal = network.corners[c].normal;
        const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
        std::vector<std::pair<double, HalfEdge>> byAngle;
        for (const HalfEdge half : network.round[c]) {
            const Vec3 way = network.directionOf(half);
            byAngle.emplace_back(std::atan2(y.dot(way), x.dot(way)), half);
        }
        std::sort(byAngle.begin(), byAngle.end());
        std::transform(byAngle.begin(), byAngle.end(), network.round[c].begin(),
                       [](const auto &one) { return one.second; });
    }
}

} // namespace

int ContourNetwork::startOf(HalfEdge half) const
{
    const NetEdge &edge = edges[static_cast<std::size_t>(half / 2)];
    return half % 2 == 0 ? edge.from : edge.to;
}

Vec3 ContourNetwork::directionOf(HalfEdge half) const
{
    const NetEdge &edge = edges[static_cast<std::size_t>(half / 2)];
    const SkinOutline &outline = outlines[static_cast<std::size_t>(edge.outline)];
    const double step = std::min(kSkinReach, 0.25 * edge.length());
    const Vec3 way = half % 2 == 0
                         ? outline.worldAt(edge.start + step) - outline.worldAt(edge.start)
                         : outline.worldAt(edge.end - step) - outline.worldAt(edge.end);
    return way.normalized();
}

Result<ContourNetwork> contourNetwork(const std::vector<SectionPointer> &sections,
                                      const LongWork &work)
{
    ContourNetwork network;
    for (const SectionPointer &section : sections)
        network.outlines.emplace_back(*section->shape, section->frame);
    const Result<std::vector<OutlineMeeting>> meetings =
        outlineMeetings(sections, network.outlines, work);
    if (!meetings)
        return tl::unexpected(meetings.error());

    std::vector<std::vector<Pass>> places(sections.size());
    for (const OutlineMeeting &meeting : *meetings)
        for (const OutlinePlace &place : meeting.places)
            places[static_cast<std::size_t>(place.outline)].push_back(
                {meeting.corner, place.along});
    std::vector<Gathered> gathered;
    for (std::size_t i = 0; i < sections.size(); ++i) {
        const std::vector<Pass> passes = passesOf(network.outlines[i], places[i]);
        for (const Pass &pass : passes) {
            gathered.resize(std::max(gathered.size(), static_cast<std::size_t>(pass.corner) + 1));
            gather(gathered[static_cast<std::size_t>(pass.corner)], network.outlines[i],
                   pass.along);
        }
        addEdges(network, static_cast<int>(i), passes);
        if (passes.empty())
            network.loose.push_back(static_cast<int>(i));
    }
    for (const Gathered &corner : gathered)
        network.corners.push_back({corner.sum / static_cast<double>(corner.tangents.size()),
                                   normalAt(corner.tangents, corner.outwards)});
    turnRound(network);
    return network;
}

std::vector<std::vector<HalfEdge>> cyclesOf(const ContourNetwork &network)
{
    std::vector<HalfEdge> next(2 * network.edges.size(), -1);
    for (const std::vector<HalfEdge> &round : network.round)
        for (std::size_t i = 0; i < round.size(); ++i)
            next[static_cast<std::size_t>(round[i] ^ 1)] =
                round[(i + round.size() - 1) % round.size()];
    std::vector<std::vector<HalfEdge>> cycles;
    std::vector<bool> isWalked(next.size(), false);
    for (std::size_t first = 0; first < next.size(); ++first) {
        if (isWalked[first])
            continue;
        std::vector<HalfEdge> &cycle = cycles.emplace_back();
        for (std::size_t half = first; !isWalked[half];
             half = static_cast<std::size_t>(next[half])) {
            isWalked[half] = true;
            cycle.push_back(static_cast<HalfEdge>(half));
        }
    }
    return cycles;
}

} // namespace fff
