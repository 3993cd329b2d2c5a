#include "core/analysis/findings/total_mass.h"

namespace fff {

namespace {

Message massSentence(const Finding &finding, const Model &)
{
    const MassProperties &all = *finding.details<MassProperties>();
    return {FFF_TEXT("Checks", "Mass %1. The centre of mass lies %2 above the ground."),
            {massOf(all.mass), lengthOf(all.centre.y())}};
}

} // namespace

const FindingKind kMass{"mass", Subject::Mass, FFF_TEXT("Checks", "Mass"), massSentence};

void findMass(const Looked &at, std::vector<Finding> &found)
{
    const MassProperties all = at.analysis.bodies.mass();
    Finding finding = makeFinding(kMass, Severity::Good, all);
    finding.at = all.centre;
    found.push_back(std::move(finding));
}

} // namespace fff
