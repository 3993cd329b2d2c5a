#include "core/skin/patch_judge.h"

#include "core/skin/skin_measures.h"

#include <algorithm>
#include <limits>

namespace fff {

namespace {

/// How far a patch may bulge from the middle of its sides, as times the farthest point of these. On
/// a sphere it is below one.
constexpr double kMostBulge = 1.2;
/// How far a place of a patch may stand out over all of its sides, along its own normal, as a share
/// of how far it is from them. A quarter of a sphere reaches 0.38 of that, half of one all of it.
constexpr double kMostOverSides = 0.5;
/// mm: what stands out by less is nothing that anyone sees.
constexpr double kSeenOver = 0.1;
/// Share of the length of its sides along which a patch may look inwards.
constexpr double kMostFolded = 0.2;

} // namespace

PatchFault PatchJudge::faultOf(const std::vector<SkinCurve> &sides)
{
    const PatchFault fault = found(sides);
    if (fault != PatchFault::None) {
        m_mesh.points.resize(m_points);
        m_mesh.triangles.resize(m_triangles);
    }
    return fault;
}

PatchFault PatchJudge::found(const std::vector<SkinCurve> &sides) const
{
    if (!staysNear(sides))
        return PatchFault::FarOut;
    const Normals normals = normalsOfPatch();
    if (!facesOutwards(sides, normals))
        return PatchFault::Folded;
    return isBalloon(sides, normals) ? PatchFault::Balloon : PatchFault::None;
}

bool PatchJudge::staysNear(const std::vector<SkinCurve> &sides) const
{
    Vec3 middle = Vec3::Zero();
    double length = 0.0, reach = 0.0;
    for (const SkinCurve &side : sides)
        for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
            const double chord = (side.points[i + 1] - side.points[i]).norm();
            middle += 0.5 * chord * (side.points[i] + side.points[i + 1]);
            length += chord;
        }
    middle /= length;
    for (const SkinCurve &side : sides)
        for (const Vec3 &point : side.points)
            reach = std::max(reach, (point - middle).norm());
    return std::all_of(
        m_mesh.points.begin() + static_cast<std::ptrdiff_t>(m_points), m_mesh.points.end(),
        [&](const Vec3 &point) { return (point - middle).norm() <= kMostBulge * reach; });
}

PatchJudge::Normals PatchJudge::normalsOfPatch() const
{
    Normals normals;
    for (std::size_t t = m_triangles; t < m_mesh.triangles.size(); ++t) {
        const auto &[a, b, c] = m_mesh.triangles[t];
        const Vec3 normal =
            (m_mesh.points[b] - m_mesh.points[a]).cross(m_mesh.points[c] - m_mesh.points[a]);
        for (const std::uint32_t vertex : {a, b, c})
            normals.try_emplace(vertex, Vec3::Zero()).first->second += normal;
    }
    return normals;
}

bool PatchJudge::isBalloon(const std::vector<SkinCurve> &sides, const Normals &normals) const
{
    const auto standsOut = [&](std::uint32_t vertex, const Vec3 &normal) {
        const Vec3 &place = m_mesh.points[vertex];
        const double length = normal.norm();
        if (!(length > kSkinNoNormal))
            return false;
        double over = std::numeric_limits<double>::infinity(), near = over;
        for (const SkinCurve &side : sides)
            for (const Vec3 &point : side.points) {
                over = std::min(over, normal.dot(place - point) / length);
                near = std::min(near, (place - point).norm());
            }
        return over > kSeenOver && over > kMostOverSides * near;
    };
    return std::any_of(normals.begin(), normals.end(), [&](const auto &known) {
        return known.first >= m_points && standsOut(known.first, known.second);
    });
}

bool PatchJudge::facesOutwards(const std::vector<SkinCurve> &sides, const Normals &normals) const
{
    double length = 0.0, folded = 0.0;
    for (const SkinCurve &side : sides)
        for (std::size_t i = 1; i + 1 < side.points.size(); ++i) {
            const double near = (side.points[i + 1] - side.points[i - 1]).norm();
            length += near;
            const auto found = normals.find(side.vertices[i]);
            if (found != normals.end() && found->second.dot(side.outwards[i]) < 0.0)
                folded += near;
        }
    return folded <= kMostFolded * length;
}

} // namespace fff
