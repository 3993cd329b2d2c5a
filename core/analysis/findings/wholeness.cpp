#include "core/analysis/findings/wholeness.h"

#include "core/fabrication/wholeness.h"

#include <set>

namespace fff {

namespace {

Message dividedSentence(const Finding &finding, const Model &model)
{
    const int parts = finding.details<DividedSection>()->parts;
    return {
        FFF_TEXT("Checks",
                 "The slits of %1 divide it into %2, which other sections hold together."),
        {nameAt(finding, model, 0), Message{FFF_TEXT_OF_MANY("Checks", "%n parts"), {}, parts}}};
}

Message nothingLeftSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "The slits of %1 leave nothing of it."),
            {nameAt(finding, model, 0)}};
}

Message notCutOutSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "%1 could not be cut out: what its slits leave of it could not be "
                               "worked out. Nothing can be exported; its mass counts without "
                               "slits."),
            {nameAt(finding, model, 0)}};
}

Message notMadeSentence(const Finding &finding, const Model &)
{
    //: %1 is the name of an operation
    return {FFF_TEXT("Checks", "%1 could not be worked out: sections of it are missing. Nothing "
                               "can be exported."),
            {*finding.details<Named>()}};
}

/// About the section, in its middle.
Finding aboutSection(Finding finding, const Section &section)
{
    finding.sections = {section.ref()};
    finding.at = section.frame.toWorld(section.shape->centroid());
    return finding;
}

} // namespace

const FindingKind kDivided{"divided", Subject::Joints, FFF_TEXT("Checks", "Divided by slits"),
                           dividedSentence};
const FindingKind kNothingLeft{"nothingLeft", Subject::Joints, FFF_TEXT("Checks", "Nothing left"),
                               nothingLeftSentence};
const FindingKind kNotCutOut{"notCutOut", Subject::Joints, FFF_TEXT("Checks", "Not cut out"),
                             notCutOutSentence};
const FindingKind kNotMade{"notMade", Subject::Joints, FFF_TEXT("Checks", "Operation failed"),
                           notMadeSentence};

void findFailures(const Looked &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    for (const Operation *operation : failedOperations(model))
        found.push_back(makeFinding(kNotMade, Severity::Error, Named{operation->name}));
    for (const int index : uncutSections(at.analysis.bodies))
        found.push_back(aboutSection(makeFinding(kNotCutOut, Severity::Error),
                                     *model.section(static_cast<std::size_t>(index))));
}

void findDivided(const Looked &at, std::vector<Finding> &found)
{
    const Model &model = at.analysis.model;
    const Bodies &bodies = at.analysis.bodies;
    std::set<int> loose; // of these it is said that they fall apart
    for (std::size_t g = 1; g < at.groups.size(); ++g)
        for (const int section : sectionsOf(bodies, at.groups[g]))
            loose.insert(section);
    for (std::size_t i = 0; i < model.sectionCount(); ++i) {
        const std::size_t parts = at.analysis.cuts[i]->parts().size();
        if (parts == 1 || (parts > 1 && loose.contains(static_cast<int>(i))))
            continue;
        Finding finding = parts == 0 ? makeFinding(kNothingLeft, Severity::Error)
                                     : makeFinding(kDivided, Severity::Warning,
                                                   DividedSection{static_cast<int>(parts)});
        found.push_back(aboutSection(std::move(finding), *model.section(i)));
    }
}

} // namespace fff
