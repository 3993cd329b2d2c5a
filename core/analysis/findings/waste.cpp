#include "core/analysis/findings/waste.h"

namespace fff {

namespace {

Message wasteSentence(const Finding &finding, const Model &model)
{
    if (finding.details<Waste>()->chips == 1)
        //: %1 is the name of a section
        return {FFF_TEXT("Checks", "Slits cut a chip under 1 mm² off %1. It is waste and gets no "
                                   "number."),
                {namesOf(model, finding.sections)}};
    //: %1 names sections
    return {FFF_TEXT_OF_MANY("Checks", "Slits cut %n chips under 1 mm² off %1. They are waste and "
                                       "get no number."),
            {namesOf(model, finding.sections)},
            finding.details<Waste>()->chips};
}

} // namespace

const FindingKind kWaste{"waste", Subject::Joints, FFF_TEXT("Checks", "Waste"), wasteSentence};

void findWaste(const Looked &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    Finding finding = makeFinding(kWaste, Severity::Note);
    Waste waste;
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const std::vector<Vec2> &chips = at.analysis.cuts[i]->waste();
        if (chips.empty())
            continue;
        waste.chips += static_cast<int>(chips.size());
        finding.sections.push_back(model.ref(i));
        if (!finding.at)
            finding.at = model.section(i)->frame.toWorld(chips.front());
    }
    if (waste.chips == 0)
        return;
    finding.setDetails(waste);
    found.push_back(std::move(finding));
}

} // namespace fff
