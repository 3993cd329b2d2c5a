#include "core/assembly/finger_grips.h"

#include "core/assembly/fingers.h"
#include "core/assembly/intervals.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// A section of the joint, along its axis.
struct FingerSide
{
    FingerSide(const Joint &joint, const GripSide &grip)
        : side(grip), axis(lineInFrame(joint.crossing->axis, grip.frame)),
          slits(slitsOfJoint(grip.slits, joint.id))
    {
    }

    /// How much material each piece has across the axis at a place of it, as far as the section is
    /// cut back there, mm.
    std::vector<double> depthsAt(double along) const
    {
        std::vector<double> depths(side.cut.parts().size(), 0.0);
        for (const Slit &slit : slits) {
            if (slit.role != SlitRole::Shoulder)
                continue;
            const double middle = axis.across(slit.inner), half = 0.5 * slit.width;
            const double from = axis.along(slit.inner), to = axis.along(slit.mouth);
            if (along < std::min(from, to) || along > std::max(from, to))
                continue;
            const Vec2 way = perpendicular(axis.direction);
            const PlaneLine line{axis.at(along) + (middle - half) * way, way};
            for (std::size_t i = 0; i < depths.size(); ++i)
                for (const Interval &interval : intervalsOn(line, side.cut.parts()[i].region))
                    depths[i] += std::max(0.0, std::min(interval.to.at, slit.width) -
                                                   std::max(interval.from.at, 0.0));
        }
        return depths;
    }

    const GripSide &side;
    PlaneLine axis;
    std::span<const Slit> slits;
};

/// What the host has of the guest's fingers between its own: [its piece][the guest's piece], mm.
std::vector<std::vector<double>> heldBetween(const FingerSide &host, const FingerSide &guest)
{
    std::vector<std::vector<double>> held(host.side.cut.parts().size(),
                                          std::vector<double>(guest.side.cut.parts().size(), 0.0));
    const double beside = std::max({0.0, host.side.clearance, guest.side.clearance}) + kGripWall;
    for (const Slit &finger : guest.slits) {
        if (finger.role != SlitRole::Tab)
            continue;
        const double middle = guest.axis.along(finger.inner), half = 0.5 * finger.width;
        const std::vector<double> low = host.depthsAt(middle - half - beside),
                                  high = host.depthsAt(middle + half + beside),
                                  own = guest.depthsAt(middle);
        for (std::size_t i = 0; i < low.size(); ++i)
            for (std::size_t k = 0; k < own.size(); ++k)
                held[i][k] += std::min({low[i], high[i], own[k]});
    }
    return held;
}

} // namespace

JointGrips fingerGrips(const Joint &joint, const GripSide &a, const GripSide &b)
{
    const FingerSide inA(joint, a), inB(joint, b);
    const auto heldOfB = heldBetween(inA, inB), heldOfA = heldBetween(inB, inA);
    const double neededInA = gripDepth(b.thickness, a.clearance);
    const double neededInB = gripDepth(a.thickness, b.clearance);
    JointGrips grips;
    for (std::size_t i = 0; i < heldOfB.size(); ++i)
        for (std::size_t k = 0; k < heldOfA.size(); ++k) {
            const Grip grip{static_cast<int>(i), static_cast<int>(k), heldOfB[i][k], heldOfA[k][i]};
            if (grip.inA >= neededInA || grip.inB >= neededInB)
                grips.held.push_back(grip);
        }
    if (grips.held.empty())
        grips.loose = LooseSlit{NoGrip::CutThrough};
    return grips;
}

} // namespace fff
