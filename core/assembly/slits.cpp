#include "core/assembly/slits.h"

#include "core/assembly/intervals.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

// A slit's rectangle reaches this far beyond the contour, so that no skin of rounding closes its
// mouth.
constexpr double kMouthOvershoot = 0.05; // mm
// Components of a unit direction below this are rounding when deciding what is "up".
constexpr double kLevel = 1e-6;

/// Upwards is +Y; for a level axis +X, then +Z, so that the answer does not hang on rounding.
bool pointsUp(const Vec3 &direction)
{
    for (const double component : {direction.y(), direction.x(), direction.z()}) {
        if (std::abs(component) > kLevel)
            return component > 0.0;
    }
    return true;
}

/// One of the two ways to slide: a opens towards the axis' direction (+1) or against it (−1).
struct Way
{
    bool isOpen = true;  // all slits end outside
    double excess = 0.0; // mm cut beyond the overlaps
};

Way wayOf(const Crossing &crossing, int sign)
{
    Way way;
    for (const Overlap &o : crossing.overlaps) {
        const AxisEnd &endA = sign > 0 ? o.a.to : o.a.from;
        const AxisEnd &endB = sign > 0 ? o.b.from : o.b.to;
        way.isOpen &= !endA.isOnHole() && !endB.isOnHole();
        way.excess += sign > 0 ? (endA.at - o.to) + (o.from - endB.at)
                               : (o.from - endA.at) + (endB.at - o.to);
    }
    return way;
}

struct Host
{
    const Section &section;
    PlaneLine line;
    double width = 0.0;
};

/// The open slit of one section for one overlap: from the meeting point to its end towards `sign`.
Slit openSlit(const Host &host, const Interval &interval, double meet, int sign, int overlap)
{
    const AxisEnd &end = sign > 0 ? interval.to : interval.from;
    const double reach = mouthReach(host.line, host.section.shape->region(), end, 0.5 * host.width,
                                    sign * meet, sign);
    Slit slit;
    slit.inner = host.line.at(meet);
    slit.mouth = host.line.at(sign * (reach + kMouthOvershoot));
    slit.width = host.width;
    slit.overlap = overlap;
    return slit;
}

/// Whether the guest, slid square through the host, fits through the slot between `from` and `to`:
/// on one side of the line all of it lies within the slot.
bool fitsThrough(const Region &guest, const PlaneLine &line, double from, double to)
{
    bool fits[2] = {true, true};
    for (const Vec2 &p : guest.outer) {
        const double s = line.along(p);
        if (s < from - kEqualEnds || s > to + kEqualEnds)
            fits[line.across(p) > 0.0] = false;
    }
    return fits[0] || fits[1];
}

/// A closed slit in `host` for a guest that ends inside of it both ways, or nothing when it does
/// not fit. The slot holds the guest's whole width within the host's thickness, also where its
/// contour is oblique.
bool cutMortise(const Crossing &crossing, const Host &host, const Host &guest, bool hostIsA,
                std::vector<Slit> &slits)
{
    if (crossing.overlaps.size() != 1)
        return false;
    const Overlap &o = crossing.overlaps.front();
    const Interval &inHost = hostIsA ? o.a : o.b;
    const Interval &inGuest = hostIsA ? o.b : o.a;
    const Region &guestRegion = guest.section.shape->region();
    const double halfTrace =
        0.5 * guest.width; // what the host's slab takes up in the guest's plane
    const double from =
        -mouthReach(guest.line, guestRegion, inGuest.from, halfTrace, -inGuest.to.at, -1);
    const double to =
        mouthReach(guest.line, guestRegion, inGuest.to, halfTrace, inGuest.from.at, 1);
    if (from <= inHost.from.at || to >= inHost.to.at ||
        !fitsThrough(guestRegion, guest.line, from, to))
        return false;
    Slit slit;
    slit.inner = host.line.at(from);
    slit.mouth = host.line.at(to);
    slit.width = host.width;
    slit.isOpen = false;
    slits.push_back(slit);
    return true;
}

} // namespace

Result<double> slitWidth(double hostThickness, double guestThickness, double angle,
                         double clearance)
{
    if (angle < kMinJointAngle)
        return failure(ErrorCode::NearlyParallel);
    return (guestThickness + hostThickness * std::abs(std::cos(angle))) / std::sin(angle) +
           clearance;
}

JointSlits cutSlits(const Crossing &crossing, const JointSide &a, const JointSide &b, bool aIsLower)
{
    JointSlits result;
    for (const Overlap &o : crossing.overlaps)
        result.meets.push_back(0.5 * (o.from + o.to));
    const Result<double> widthA = slitWidth(a.thickness, b.thickness, crossing.angle, a.clearance);
    const Result<double> widthB = slitWidth(b.thickness, a.thickness, crossing.angle, b.clearance);
    if (!widthA || !widthB || crossing.overlaps.empty())
        return result;
    const Host hostA{a.section, lineInFrame(crossing.axis, a.section.frame), *widthA};
    const Host hostB{b.section, lineInFrame(crossing.axis, b.section.frame), *widthB};

    const Way plus = wayOf(crossing, 1), minus = wayOf(crossing, -1);
    if (!plus.isOpen && !minus.isOpen) {
        if (cutMortise(crossing, hostB, hostA, false, result.b) ||
            cutMortise(crossing, hostA, hostB, true, result.a))
            result.kind = JointKind::Mortise;
        return result;
    }
    int sign = 1;
    if (plus.isOpen != minus.isOpen)
        sign = plus.isOpen ? 1 : -1;
    else if (std::abs(plus.excess - minus.excess) > kEqualEnds)
        sign = plus.excess < minus.excess ? 1 : -1;
    else
        sign = pointsUp(crossing.axis.direction) == aIsLower ? 1 : -1;

    const double excess = sign > 0 ? plus.excess : minus.excess;
    result.kind = excess > kEqualEnds * static_cast<double>(crossing.overlaps.size())
                      ? JointKind::ExtendedCrossLap
                      : JointKind::CrossLap;
    for (std::size_t i = 0; i < crossing.overlaps.size(); ++i) {
        const Overlap &o = crossing.overlaps[i];
        const int index = static_cast<int>(i);
        result.a.push_back(openSlit(hostA, o.a, result.meets[i], sign, index));
        result.b.push_back(openSlit(hostB, o.b, result.meets[i], -sign, index));
    }
    return result;
}

} // namespace fff
