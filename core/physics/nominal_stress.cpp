#include "core/physics/nominal_stress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fff {

namespace {

/// Of normal stress s and shear stress τ what is compared with the strength.
double equivalent(double s, double tau, bool isDuctile)
{
    return isDuctile ? std::sqrt(s * s + 3.0 * tau * tau)
                     : 0.5 * s + std::sqrt(0.25 * s * s + tau * tau);
}

} // namespace

DiscPart discBeyond(double h)
{
    if (h >= 1.0)
        return {0.0, 1.0};
    if (h <= -1.0)
        return {1.0, 0.0};
    const double root = std::sqrt(1.0 - h * h);
    const double area = std::acos(h) - h * root;
    if (!(area > 0.0))
        return {0.0, 1.0};
    return {area / std::numbers::pi, 2.0 / 3.0 * root * root * root / area};
}

NominalStress nominalStress(const CutForces &forces, const Neck &neck, const SheetMaterial &sheet,
                            const NotchRule &rule)
{
    const double l = neck.length, t = sheet.thickness, area = l * t;
    NominalStress stress;
    if (!(area > 0.0))
        return stress;
    stress.axial = std::abs(forces.axial) / area;
    stress.inPlane = 6.0 * std::abs(forces.inPlane) / (area * l) * neck.bend;
    stress.plate = 6.0 * std::abs(forces.bending) / (area * t);
    const double a = std::min(l, t), b = std::max(l, t);
    const double torsion = std::abs(forces.torsion) * (3.0 + 1.8 * a / b) / (b * a * a);
    stress.shear = torsion + 1.5 * std::max(std::abs(forces.shear), std::abs(forces.plate)) / area;
    stress.neck = equivalent(stress.linear(), stress.shear, sheet.isDuctile);
    stress.corner = stress.neck;
    if (neck.isAtCorner && rule.radius > 0.0) {
        stress.notch =
            std::clamp(0.56 + 0.53 * std::sqrt(l / rule.radius), 1.0, std::max(1.0, rule.cap));
        const double raised = stress.notch * (stress.axial + stress.inPlane) +
                              (1.0 + 0.5 * (stress.notch - 1.0)) * stress.plate;
        stress.corner = equivalent(raised, stress.shear, sheet.isDuctile);
    }
    return stress;
}

} // namespace fff
