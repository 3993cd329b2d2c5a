#include "core/analysis/findings/thin_webs.h"

#include "core/analysis/findings/ending_before.h"
#include "core/analysis/findings/moving_slits.h"

namespace fff {

namespace {

Message slitsMeetSentence(const Finding &finding, const Model &model)
{
    return {FFF_TEXT("Checks", "%1: its slits for %2 run into each other."),
            {nameAt(finding, model, 0), namesOf(model, finding.others)}};
}

/// It would be told as 0.00 mm.
constexpr double kLeastTold = 0.005; // mm

Text thinText(const Finding &finding, const ThinWeb &web)
{
    const bool isBetweenSlits = finding.others.size() > 1;
    if (web.width < kLeastTold)
        return isBetweenSlits ? FFF_TEXT("Checks", "%1: nothing is left between its slits for %2.")
               : web.isByAHole
                   ? FFF_TEXT("Checks", "%1: nothing is left between its slit for %2 and a hole.")
                   : FFF_TEXT("Checks",
                              "%1: nothing is left between its slit for %2 and its edge.");
    return isBetweenSlits
               ? FFF_TEXT("Checks", "%1: only %2 of material is left between its slits for %3.")
           : web.isByAHole
               ? FFF_TEXT("Checks",
                          "%1: only %2 of material is left between its slit for %3 and a hole.")
               : FFF_TEXT("Checks",
                          "%1: only %2 of material is left between its slit for %3 and its edge.");
}

Message thinSentence(const Finding &finding, const Model &model)
{
    const ThinWeb &web = *finding.details<ThinWeb>();
    const Text text = thinText(finding, web);
    if (web.width < kLeastTold)
        return {text, {nameAt(finding, model, 0), namesOf(model, finding.others)}};
    // Lengths are said to a tenth, widths to a hundredth: what is left must not read as nothing.
    const Quantity width =
        web.width < 0.1 ? widthOf(std::max(web.width, 0.01)) : lengthOf(web.width);
    return {text, {nameAt(finding, model, 0), width, namesOf(model, finding.others)}};
}

Message thinTitle(const Finding &finding)
{
    return {finding.severity >= Severity::Warning ? FFF_TEXT("Checks", "Too little material")
                                                  : FFF_TEXT("Checks", "Rather thin"),
            {}};
}

std::vector<FindingAction> widenWeb(const Finding &, const Analysis &)
{
    return {{&kCutLessDeep}, {&kMoveSlit}};
}

/// The webs of each section, worked out anew where its slits or its stock are other ones.
void refresh(const Analysis &analysis, PlanCheckCaches &caches)
{
    caches.sections.resize(analysis.model.sectionCount());
    for (std::size_t i = 0; i < caches.sections.size(); ++i) {
        PlanCheckCaches::OfSection &known = caches.sections[i];
        const double thickness = analysis.model.stockOf(i).thickness;
        if (known.cut == analysis.cuts[i] && known.thickness == thickness)
            continue;
        known = {analysis.cuts[i], thickness,
                 thinWebs(analysis.model.section(i)->shape->region(), analysis.assembly.slits[i],
                          thickness)};
    }
}

/// mm: what is thinner burns away, or breaks in the hand: the slit has no wall there.
constexpr double kLeastWeb = 0.3;

Severity severityOf(double width, double thickness)
{
    if (width < kLeastWeb)
        return Severity::Error;
    return width >= 0.5 * thickness ? Severity::Note : Severity::Warning;
}

Finding foundOf(const Web &web, std::size_t section, const Analysis &analysis)
{
    const Model &model = analysis.model;
    const auto guestOf = [&](int slit) {
        const Slit &of = analysis.assembly.slits[section].at(static_cast<std::size_t>(slit));
        return model.ref(static_cast<std::size_t>(of.guest));
    };
    const bool isBetweenSlits = web.between == Web::Between::Slits;
    const bool isTouching = isBetweenSlits && !(web.width > 0.0);
    Finding finding = makeFinding(
        isTouching ? kSlitsMeet : kThinWeb,
        isTouching ? Severity::Warning : severityOf(web.width, model.stockOf(section).thickness),
        ThinWeb{web.width, web.between == Web::Between::SlitAndHole});
    finding.sections = {model.ref(section)};
    finding.others = {guestOf(web.slit)};
    if (isBetweenSlits)
        finding.others.push_back(guestOf(web.other));
    else
        finding.joint = JointRef(finding.sections.front(), finding.others.front());
    finding.at = model.section(section)->frame.toWorld(web.at);
    return finding;
}

std::vector<FindingAction> endEither(const Finding &, const Analysis &)
{
    return {{&kEndBefore}};
}

} // namespace

const FindingKind kThinWeb{
    .name = "thinWeb",
    .subject = Subject::Joints,
    .title = FFF_TEXT("Checks", "Too little material"),
    .sentence = thinSentence,
    .actions = widenWeb,
    .advice = FFF_TEXT("Checks", "Make the section wider there, or move the slit."),
    .titled = thinTitle};
const FindingKind kSlitsMeet{
    .name = "slitsMeet",
    .subject = Subject::Joints,
    .title = FFF_TEXT("Checks", "Slits run into each other"),
    .sentence = slitsMeetSentence,
    .actions = endEither,
    .advice = FFF_TEXT("Checks", "Let one of the sections that cross there end before the others, "
                                 "or move it aside.")};

void findThinWebs(const LookedAtPlan &at, std::vector<Finding> &found)
{
    refresh(at.analysis, at.caches);
    for (std::size_t i = 0; i < at.caches.sections.size(); ++i)
        for (const Web &web : at.caches.sections[i].webs)
            found.push_back(foundOf(web, i, at.analysis));
}

} // namespace fff
