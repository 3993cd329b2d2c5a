#include "core/physics/component_net.h"

#include "core/base/tolerances.h"
#include "core/physics/link_stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

constexpr double kLeastFootStiffness = 1e-3; // N/mm
/// A grip of more than so many times all forces is never reached (no unit).
constexpr double kGripBeyondReach = 1e3;

int localOf(const Component &component, int member)
{
    return static_cast<int>(
        std::lower_bound(component.members.begin(), component.members.end(), member) -
        component.members.begin());
}

double footStiffness(const Foot &foot)
{
    return std::isfinite(foot.stiffness) ? std::max(foot.stiffness, kLeastFootStiffness)
                                         : kLeastFootStiffness;
}

SpringNet::Spring footSpring(const Structure &structure, const Component &component, int foot,
                             const Vec3 &direction, const SpringNet &net)
{
    SpringNet::Spring spring;
    const Foot &at = structure.feet[foot];
    spring.a = localOf(component, at.member);
    spring.rowA = net.row(at.point - structure.members[at.member].centroid, direction);
    spring.stiffness = footStiffness(at);
    return spring;
}

/// Horizontal springs that hold what the feet that are held do not: with one of these a turn about
/// it, without any all three motions. They carry nothing when no load is horizontal.
void addAnchors(const Structure &structure, const Component &component, ComponentNet &found)
{
    const auto flat = [&structure](const Vec3 &v) {
        return Vec3(v - structure.up.dot(v) * structure.up);
    };
    const int first = found.held.empty() ? component.feet.front() : found.held.front();
    const Vec3 from = structure.feet[first].point;
    for (int i : found.held) {
        if (flat(structure.feet[i].point - from).norm() > kTouchingDepth)
            return;
    }
    int farthest = first;
    double most = -1.0;
    for (int i : component.feet) {
        if (const double distance = flat(structure.feet[i].point - from).norm(); distance > most) {
            most = distance;
            farthest = i;
        }
    }
    const std::array<Vec3, 2> axes = groundAxes(structure.up);
    const auto add = [&](int foot, const Vec3 &direction) {
        found.net.holding.push_back(footSpring(structure, component, foot, direction, found.net));
        found.anchors.push_back(foot);
    };
    if (found.held.empty()) {
        add(first, axes[0]);
        add(first, axes[1]);
    }
    const Vec3 way = flat(structure.feet[farthest].point - from);
    if (way.norm() > 0.0)
        add(farthest, structure.up.cross(way).normalized());
}

} // namespace

ComponentNet componentNet(const Structure &structure, const Component &component,
                          const BodyBalance &body, bool isAxisFree, bool isBounded)
{
    ComponentNet found;
    SpringNet &net = found.net;
    net.members = static_cast<int>(component.members.size());
    net.size = structure.size;
    const std::array<Vec3, 2> axes = groundAxes(structure.up);
    for (int i : component.feet) {
        net.pressing.push_back(footSpring(structure, component, i, structure.up, net));
        if (!body.areAllHeld && !structure.feet[i].isPinned)
            continue;
        found.held.push_back(i);
        for (const Vec3 &axis : axes)
            net.holding.push_back(footSpring(structure, component, i, axis, net));
    }
    addAnchors(structure, component, found);

    for (std::size_t i = 0; i < component.links.size(); ++i) {
        const Link &link = structure.links[component.links[i]];
        const LinkSprings springs = linkSprings(link, isAxisFree);
        const Vec3 axis = link.axis.normalized();
        SpringNet::Joint joint;
        joint.a = localOf(component, link.a);
        joint.b = localOf(component, link.b);
        joint.armA = link.point - structure.members[link.a].centroid;
        joint.armB = link.point - structure.members[link.b].centroid;
        joint.stiffness = springs.across;
        const double grip = std::max(0.0, link.grip);
        const bool isReached = isBounded && grip <= kGripBeyondReach * body.scale;
        found.grips.push_back(isReached ? grip : std::numeric_limits<double>::infinity());
        if (isReached) {
            // What bears presses a along −axis; it does so from where the grip is used up.
            SpringNet::Spring bearing;
            bearing.a = joint.a;
            bearing.b = joint.b;
            bearing.rowA = -net.row(joint.armA, axis);
            bearing.rowB = net.row(joint.armB, axis);
            bearing.stiffness = springs.along;
            bearing.start = grip / springs.along;
            net.pressing.push_back(bearing);
            found.bounded.push_back(static_cast<int>(i));
        } else {
            joint.stiffness.topLeftCorner<3, 3>() += springs.along * axis * axis.transpose();
        }
        net.joints.push_back(joint);
    }
    return found;
}

Eigen::VectorXd componentLoad(const Structure &structure, const Component &component,
                              const ComponentNet &net)
{
    Eigen::VectorXd load = Eigen::VectorXd::Zero(6 * net.net.members);
    const auto add = [&](int local, const Vec3 &arm, const Vec3 &force, const Vec3 &moment) {
        load.segment<3>(6 * local) += force;
        load.segment<3>(6 * local + 3) += (arm.cross(force) + moment) / net.net.size;
    };
    for (std::size_t i = 0; i < component.members.size(); ++i)
        add(static_cast<int>(i), Vec3::Zero(),
            structure.members[component.members[i]].mass * structure.gravity, Vec3::Zero());
    for (int i : component.loads) {
        const MemberLoad &given = structure.loads[i];
        add(localOf(component, given.member),
            given.point - structure.members[given.member].centroid, given.force, given.moment);
    }
    for (int i : net.bounded) {
        const SpringNet::Joint &joint = net.net.joints[i];
        const Vec3 grip = net.grips[i] * structure.links[component.links[i]].axis.normalized();
        add(joint.a, joint.armA, grip, Vec3::Zero());
        add(joint.b, joint.armB, -grip, Vec3::Zero());
    }
    return load;
}

} // namespace fff
