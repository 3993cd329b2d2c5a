// The sections of a reference case as finite elements, with what holds them and what acts on them.
#pragma once

#include "core/physics/elastic_equilibrium.h"
#include "core/physics/plate_stress.h"
#include "tests/core/physics/reference_section.h"

#include <vector>

namespace fff::test {

struct ReferencePlate
{
    PlateModel model;
    std::vector<MemberAttachment> at;
    std::vector<PlateAttachment> attachments; // as `at`
    std::vector<double> heights;              // mm, of what acts there over the middle of the sheet
    PlateField loads;                         // its weight, and what acts on it besides
};

/// The largest piece of a section. Errors  those of mesh and model.
Result<ReferencePlate> plateOf(const ReferenceCase &found, int section,
                               const PlateMeshOptions &options = {});
/// All of them. Errors  those of the first that has none.
Result<std::vector<ReferencePlate>> platesOf(const ReferenceCase &found);

/// How each gives, for elasticEquilibrium().
std::vector<MemberFlexibility> flexibilitiesOf(const ReferenceCase &found,
                                               const std::vector<ReferencePlate> &plates);

/// Its stresses when its feet and links carry this.
PlateStress stressOf(const ReferenceCase &found, const ReferencePlate &plate, int section,
                     const ReferenceForces &carried);

} // namespace fff::test
