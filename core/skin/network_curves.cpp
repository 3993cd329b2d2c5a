#include "core/skin/network_curves.h"

#include "core/base/tolerances.h"
#include "core/skin/skin_measures.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A curve has at least so many chords, a power of two.
constexpr int kLeastChords = 8;
/// Largest angle between the normal of the skin and the section's plane (80°, radians).
constexpr double kMostLean = 1.3962634015954636;

/// Places along the outline: those of its chords, no farther from each other than a share of the
/// stretch, and one in the middle of it.
std::vector<double> samplesOf(const SkinOutline &outline, double start, double end)
{
    const double middle = 0.5 * (start + end);
    std::vector<double> fixed = {start};
    for (const double corner : outline.cornersBetween(start, end)) {
        if (corner > middle && fixed.back() < middle) {
            if (middle - fixed.back() < kSkinSame && fixed.size() > 1)
                fixed.pop_back();
            fixed.push_back(middle);
        }
        if (corner - fixed.back() >= kSkinSame && end - corner >= kSkinSame)
            fixed.push_back(corner);
    }
    if (fixed.back() < middle)
        fixed.push_back(middle);
    fixed.push_back(end);
    const double most = (end - start) / kLeastChords;
    std::vector<double> samples = {start};
    for (std::size_t i = 0; i + 1 < fixed.size(); ++i) {
        const double span = fixed[i + 1] - fixed[i];
        // Rounding must not add a point to one of two curves that are alike.
        const int pieces =
            std::max(1, static_cast<int>(std::ceil(span / most - kSkinCountRounding)));
        for (int k = 1; k <= pieces; ++k)
            samples.push_back(k == pieces ? fixed[i + 1] : fixed[i] + span * k / pieces);
    }
    return samples;
}

/// In the section's plane, to the outside.
Vec3 outwardsAt(const SkinOutline &outline, double along, double reach)
{
    return outline.frame().directionToWorld(-perpendicular(outline.tangentAt(along, reach)));
}

double leanOf(const Vec3 &normal, const Vec3 &outwards, const Vec3 &plane)
{
    return std::clamp(std::atan2(normal.dot(plane), normal.dot(outwards)), -kMostLean, kMostLean);
}

/// 1 at the start with no slope, 0 at the end with none.
double fading(double t)
{
    return (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t);
}

SkinCurve curveOf(const NetEdge &edge, const ContourNetwork &network, GrowingMesh &mesh)
{
    const SkinOutline &outline = network.outlines[static_cast<std::size_t>(edge.outline)];
    const NetCorner &from = network.corners[static_cast<std::size_t>(edge.from)];
    const NetCorner &to = network.corners[static_cast<std::size_t>(edge.to)];
    const Vec3 plane = outline.frame().normal();
    const double reach = 0.02 * edge.length();
    const Vec3 startShift = from.point - outline.worldAt(edge.start);
    const Vec3 endShift = to.point - outline.worldAt(edge.end);
    const double startLean = leanOf(from.normal, outwardsAt(outline, edge.start, reach), plane);
    const double endLean = leanOf(to.normal, outwardsAt(outline, edge.end, reach), plane);
    SkinCurve curve;
    const std::vector<double> samples = samplesOf(outline, edge.start, edge.end);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = (samples[i] - edge.start) / edge.length();
        const bool isFirst = i == 0, isLast = i + 1 == samples.size();
        const Vec3 point = isFirst  ? from.point
                           : isLast ? to.point
                                    : Vec3(outline.worldAt(samples[i]) + fading(t) * startShift +
                                           fading(1.0 - t) * endShift);
        const double lean = (1.0 - t) * startLean + t * endLean;
        curve.points.push_back(point);
        curve.outwards.push_back(outwardsAt(outline, samples[i], reach));
        curve.normals.push_back(std::cos(lean) * curve.outwards.back() + std::sin(lean) * plane);
        curve.vertices.push_back(isFirst  ? static_cast<std::uint32_t>(edge.from)
                                 : isLast ? static_cast<std::uint32_t>(edge.to)
                                          : mesh.add(point));
    }
    measure(curve);
    return curve;
}

} // namespace

std::vector<SkinCurve> networkCurves(const ContourNetwork &network, GrowingMesh &mesh)
{
    for (const NetCorner &corner : network.corners)
        mesh.add(corner.point);
    std::vector<SkinCurve> curves;
    for (const NetEdge &edge : network.edges)
        curves.push_back(curveOf(edge, network, mesh));
    return curves;
}

SkinCurve ringCurve(const SkinOutline &outline, double start, GrowingMesh &mesh)
{
    const double end = start + outline.length(), reach = 0.01 * outline.length();
    SkinCurve curve;
    for (const double along : samplesOf(outline, start, end)) {
        curve.points.push_back(along == end ? curve.points.front() : outline.worldAt(along));
        curve.normals.push_back(outwardsAt(outline, along, reach));
        curve.vertices.push_back(along == end ? curve.vertices.front()
                                              : mesh.add(curve.points.back()));
    }
    curve.outwards = curve.normals;
    measure(curve);
    return curve;
}

SkinCurve walked(const std::vector<SkinCurve> &curves, HalfEdge half)
{
    const SkinCurve &curve = curves[static_cast<std::size_t>(half / 2)];
    return half % 2 == 0 ? curve : curve.reversed();
}

} // namespace fff
