// Structures for the tests of physics: small ones by hand, and any number at random.
#pragma once

#include "core/physics/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace fff::test {

inline constexpr double kUnlimitedGrip = std::numeric_limits<double>::infinity(); // N

class StructureSource
{
public:
    explicit StructureSource(unsigned seed) : m_random(seed) {}

    double between(double least, double most)
    {
        return std::uniform_real_distribution<double>(least, most)(m_random);
    }
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(m_random); }
    Vec3 point(double reach)
    {
        const double x = between(-reach, reach), y = between(0.0, reach);
        return {x, y, between(-reach, reach)};
    }
    Vec3 direction()
    {
        Vec3 v;
        do {
            v = {between(-1, 1), between(-1, 1), between(-1, 1)};
        } while (v.norm() > 1.0 || v.norm() < 0.1);
        return v.normalized();
    }
    Eigen::Matrix3d turn()
    {
        const double angle = between(-3.0, 3.0);
        return Eigen::AngleAxisd(angle, direction()).toRotationMatrix();
    }
    /// Two plates square to each other, turned anyhow.
    Link link(int a, int b)
    {
        const Eigen::Matrix3d axes = turn();
        Link link;
        link.a = a;
        link.b = b;
        link.point = point(80.0);
        link.normalA = axes.col(0);
        link.normalB = axes.col(1);
        link.axis = axes.col(2);
        link.depthA = between(10, 40);
        link.depthB = between(10, 40);
        link.thicknessA = between(3, 8);
        link.thicknessB = between(3, 8);
        link.modulusA = link.modulusB = 3200.0;
        link.isTight = upTo(1) == 0;
        link.grip = kUnlimitedGrip;
        return link;
    }
    /// Connected: a tree and so many links more; feet all round, loads that press.
    Structure stand(int members, int moreLinks, int feet, int loads)
    {
        Structure structure;
        structure.size = 200.0;
        for (int i = 0; i < members; ++i)
            structure.members.push_back({between(0.05, 0.5), point(60.0)});
        for (int i = 1; i < members; ++i)
            structure.links.push_back(upTo(1) == 0 ? link(upTo(i - 1), i) : link(i, upTo(i - 1)));
        for (int i = 0; i < moreLinks && members > 1; ++i) {
            const int a = upTo(members - 1);
            structure.links.push_back(link(a, (a + 1 + upTo(members - 2)) % members));
        }
        for (int i = 0; i < feet; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + between(-0.3, 0.3)) / feet;
            const double radius = between(40, 90);
            const int member = upTo(members - 1);
            structure.feet.push_back(
                {member, {radius * std::cos(angle), 0.0, radius * std::sin(angle)}, 1e4, false});
        }
        for (int i = 0; i < loads; ++i) {
            const int member = upTo(members - 1);
            const Vec3 at = point(50.0);
            structure.loads.push_back({member, at, {0.0, -between(0, 10), 0.0}, Vec3::Zero()});
        }
        return structure;
    }

private:
    std::mt19937 m_random;
};

/// One member on feet at these places of the ground (x, z), its centroid above (x, z).
inline Structure block(const std::vector<Vec2> &feet, const Vec2 &centroid, double mass = 1.0)
{
    Structure structure;
    structure.members.push_back({mass, {centroid.x(), 30.0, centroid.y()}});
    for (const Vec2 &foot : feet)
        structure.feet.push_back({0, {foot.x(), 0.0, foot.y()}, 1e4, false});
    return structure;
}

/// Feet of a square table about the origin.
inline std::vector<Vec2> fourFeet(double half = 50.0)
{
    return {{half, half}, {half, -half}, {-half, -half}, {-half, half}};
}

/// A link at a point whose slit axis is vertical: `b` hangs in `a` or stands on it.
inline Link upright(int a, int b, const Vec3 &point, const Vec3 &axis)
{
    Link link;
    link.a = a;
    link.b = b;
    link.point = point;
    link.axis = axis;
    link.normalA = Vec3::UnitX();
    link.normalB = Vec3::UnitZ();
    link.depthA = link.depthB = 25.0;
    link.thicknessA = link.thicknessB = 3.0;
    link.modulusA = link.modulusB = 3200.0;
    link.grip = kUnlimitedGrip;
    return link;
}

/// The largest force, or moment by the structure's size.
inline double largest(const Structure &structure, const Equilibrium &solution)
{
    double most = 0.0;
    for (const LinkForce &link : solution.links)
        most = std::max({most, link.onA.force.norm(), link.onA.moment.norm() / structure.size});
    for (const FootForce &foot : solution.feet)
        most = std::max(most, foot.force.norm());
    return most;
}

inline Vec3 sumOfReactions(const Equilibrium &found)
{
    Vec3 sum = Vec3::Zero();
    for (const FootForce &foot : found.feet)
        sum += foot.force;
    return sum;
}

inline Vec3 sumOfLoads(const Structure &structure)
{
    Vec3 sum = Vec3::Zero();
    for (const Member &member : structure.members)
        sum += member.mass * structure.gravity;
    for (const MemberLoad &load : structure.loads)
        sum += load.force;
    return sum;
}

/// How far apart two solutions of a structure are, by its largest force (no unit).
inline double difference(const Structure &structure, const Equilibrium &a, const Equilibrium &b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.links.size(); ++i) {
        most = std::max(most, (a.links[i].onA.force - b.links[i].onA.force).norm());
        most =
            std::max(most, (a.links[i].onA.moment - b.links[i].onA.moment).norm() / structure.size);
    }
    for (std::size_t i = 0; i < a.feet.size(); ++i)
        most = std::max(most, (a.feet[i].force - b.feet[i].force).norm());
    const double scale = largest(structure, a);
    return scale > 0.0 ? most / scale : most;
}

} // namespace fff::test
