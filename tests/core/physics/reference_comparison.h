// What a reference case is asked, one file a method: rigid sections, beams, sections that bend and
// sections as finite elements.
#pragma once

#include "tests/core/physics/reference_plates.h"
#include "tests/core/physics/reference_report.h"

#include <optional>

namespace fff::test {

struct Comparison
{
    const ReferenceCase &given;
    const Tolerances &tolerances;
    Report &report;
};

/// Masses, verdicts, reactions and joint forces of rigid sections. Nothing where a section is
/// clamped: it does not stand, and nobody asks whether.
std::optional<Equilibrium> compareRigid(const Comparison &comparison);

/// The stresses of named cuts by the formulas of beams, for the forces that the solver found, or,
/// where it does not say them, for ours of what is determinate.
void compareBeams(const Comparison &comparison, const std::optional<Equilibrium> &rigid);

/// Reactions, joint forces and stresses of sections as finite elements: for glued slits where
/// forces can be shared in one way only, for those that press where the file has them.
void comparePlates(const Comparison &comparison, const std::optional<Equilibrium> &rigid);

/// Stresses on the cuts of a truth by finite elements, of sections that carry its forces.
/// isGlued  by slits that were glued, while ours press
void comparePlateCuts(const Comparison &comparison, const std::string &kind,
                      const std::vector<ReferencePlate> &plates, const ReferenceForces &carried,
                      const ReferenceTruth &truth, bool isGlued);

/// Forces on rigid sections follow from statics alone.
bool isDeterminate(const std::optional<Equilibrium> &rigid);

} // namespace fff::test
