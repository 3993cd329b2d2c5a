#include "core/analysis/findings/thin_necks.h"

namespace fff {

namespace {

/// mm: what is thinner is not there any more when the part is cut.
constexpr double kLeastCut = 0.1;

/// Of kThinNeck.
struct ThinNeck
{
    double length = 0.0; // mm
};

Message hangsSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "Falls apart. %1 is held together by less than can be cut."),
            {nameAt(finding, model, 0)}};
}

Message thinNeckSentence(const Finding &finding, const Model &model)
{
    const double length = finding.details<ThinNeck>()->length;
    return {FFF_TEXT("Checks", "Too little material. %1 is only %2 wide at one place."),
            {nameAt(finding, model, 0), widthOf(length)}};
}

} // namespace

const FindingKind kHangsByNothing{
    .name = "hangsByNothing",
    .subject = Subject::Strength,
    .title = FFF_TEXT("Checks", "Falls apart"),
    .sentence = hangsSentence,
    .advice = FFF_TEXT("Checks", "Make it wider there, or move apart what touches it."),
    .isLoss = true};
const FindingKind kThinNeck{.name = "thinNeck",
                            .subject = Subject::Strength,
                            .title = FFF_TEXT("Checks", "Too little material"),
                            .sentence = thinNeckSentence,
                            .advice = FFF_TEXT("Checks", "Make it wider there.")};

void findThinNecks(const Analysis &analysis, const Strength &strength, std::vector<Finding> &found)
{
    for (std::size_t i = 0; i < strength.bodies.size(); ++i) {
        const BodyStrength &body = strength.bodies[i];
        const bool isThin = body.thinnest && body.thinnest->length < kLeastNeck;
        if (!body.isPinched && !isThin)
            continue;
        const bool isLost = body.isPinched || body.thinnest->length < kLeastCut;
        Finding finding =
            isLost ? makeFinding(kHangsByNothing, Severity::Error)
                   : makeFinding(kThinNeck, Severity::Warning, ThinNeck{body.thinnest->length});
        const int section = analysis.bodies.sectionOf(static_cast<int>(i));
        finding.sections = {analysis.model.ref(static_cast<std::size_t>(section))};
        if (isThin)
            finding.at =
                analysis.bodies.at(static_cast<int>(i)).frame().toWorld(body.thinnest->middle());
        found.push_back(std::move(finding));
    }
}

} // namespace fff
