#include "core/analysis/findings/connection.h"

#include "core/analysis/findings/joining.h"
#include "core/analysis/findings/moved_planes.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/gap.h"
#include "core/model/edit_words.h"
#include "core/model/edits.h"

#include <algorithm>

namespace fff {

namespace {

// Beyond this many loose groups nobody reads how far each is from the rest.
constexpr std::size_t kMaxMeasuredGroups = 32;

Message connectedSentence(const Finding &finding, const Model &)
{
    const Connection &all = *finding.details<Connection>();
    if (all.sections == 1)
        return {FFF_TEXT("Checks", "Connected. Only one section so far."), {}};
    const Message joints = all.joints == 1
                               ? Message{FFF_TEXT("Checks", "1 joint"), {}}
                               : Message{FFF_TEXT_OF_MANY("Checks", "%n joints"), {}, all.joints};
    if (all.sections == 2)
        return {FFF_TEXT("Checks", "Connected. Both sections, by %1."), {joints}};
    return {FFF_TEXT("Checks", "Connected. All %1 sections, by %2."), {all.sections, joints}};
}

Message wouldConnectSentence(const Finding &finding, const Model &)
{
    //: %1 is such as "if nothing fell apart"
    return {FFF_TEXT("Checks", "Would be connected %1."),
            {Message{finding.details<Connection>()->provided, {}}}};
}

Message notConnectedSentence(const Finding &finding, const Model &model)
{
    const Gap &gap = *finding.details<Gap>();
    const bool isOne = finding.sections.size() == 1;
    const NamedSections names = namesOf(model, finding.sections);
    if (!gap.other || gap.distance < 0.0)
        return {isOne ? FFF_TEXT("Checks", "%1 is not joined to the rest.")
                      : FFF_TEXT("Checks", "%1 are not joined to the rest."),
                {names}};
    const Named other = nameOf(model, *gap.other);
    // Below what anyone can see they touch.
    constexpr double kTouching = 0.05; // mm
    if (gap.distance <= kTouching)
        return {isOne ? FFF_TEXT("Checks", "%1 meets %2, but nothing holds them together.")
                      : FFF_TEXT("Checks", "%1 meet %2, but nothing holds them together."),
                {names, other}};
    return {isOne ? FFF_TEXT("Checks", "Nothing touches %1. It is %2 away from %3.")
                  : FFF_TEXT("Checks", "Nothing else touches %1. They are %2 away from %3."),
            {names, lengthOf(gap.distance), other}};
}

Message deleteWords(const FindingAction &, const Finding &finding, const Model &)
{
    return {finding.sections.size() == 1 ? FFF_TEXT("Checks", "Delete it")
                                         : FFF_TEXT("Checks", "Delete them"),
            {}};
}

std::optional<FindingEdit> deleted(const FindingAction &, const Finding &finding,
                                   const Analysis &analysis, const Flips *)
{
    const Document &document = analysis.model.document;
    std::vector<SectionId> ids;
    std::vector<std::string> names;
    for (const SectionRef &ref : finding.sections) {
        if (const Section *section = document.find(ref.drawn)) {
            ids.push_back(section->id);
            names.push_back(section->name);
        }
    }
    Result<Document> next = removeSections(document, ids);
    if (ids.empty() || !next)
        return {};
    return FindingEdit{ofSections(steps::kDeleteSections, names), *std::move(next)};
}

/// What only touches is held by tabs, which moves nothing.
std::vector<FindingAction> mendsOf(const Finding &finding, const Analysis &analysis)
{
    const std::optional<SectionRef> &nearest = finding.details<Gap>()->other;
    std::vector<FindingAction> all = joinAgain(finding, analysis.model.document);
    if (nearest)
        all.push_back({&kJoinWithTabs, *nearest});
    if (const auto move = moveToNearest(finding, nearest, analysis))
        all.push_back(*move);
    for (const FindingAction &action : movedPlanes(finding, analysis.model.document))
        all.push_back(action);
    all.push_back({&kDeleteSections});
    return all;
}

/// The groups that are said to be loose; of pieces it is said elsewhere.
std::vector<const std::vector<int> *> looseGroups(const Looked &at)
{
    std::vector<const std::vector<int> *> loose;
    for (std::size_t g = 1; g < at.groups.size(); ++g)
        if (!isLoosePiece(at.analysis.bodies, at.groups[g]) &&
            severedPieces(at.analysis.bodies, at.groups[g]).empty())
            loose.push_back(&at.groups[g]);
    return loose;
}

/// How far the first of these are from all other bodies. What is known stays so.
void refreshGaps(const Looked &at, const std::vector<const std::vector<int> *> &loose)
{
    std::vector<CheckCaches::OfGroup> gaps;
    for (std::size_t i = 0; i < std::min(loose.size(), kMaxMeasuredGroups); ++i) {
        const auto known = std::find_if(at.caches.gaps.begin(), at.caches.gaps.end(),
                                        [&](const auto &gap) { return gap.group == *loose[i]; });
        gaps.push_back(known != at.caches.gaps.end() ? std::move(*known)
                                                     : measuredGap(at.analysis.bodies, *loose[i]));
    }
    at.caches.gaps = std::move(gaps);
}

int holdingJoints(const Analysis &analysis)
{
    const auto &joints = analysis.assembly.joints;
    return static_cast<int>(std::count_if(joints.begin(), joints.end(), [&](const Joint &joint) {
        return !analysis.grips.of(joint).held.empty();
    }));
}

} // namespace

const ActionKind kDeleteSections{deleteWords, deleted};

const FindingKind kConnected{"connected", Subject::Connection, FFF_TEXT("Checks", "Connected"),
                             connectedSentence};
const FindingKind kWouldConnect{"connected", Subject::Connection,
                                FFF_TEXT("Checks", "Would be connected"), wouldConnectSentence};
const FindingKind kNotConnected{
    .name = "notConnected",
    .subject = Subject::Connection,
    .title = FFF_TEXT("Checks", "Not connected"),
    .sentence = notConnectedSentence,
    .actions = mendsOf,
    .forAll = &kDeleteSections,
    .advice =
        FFF_TEXT("Checks", "Draw a section that crosses both, or move one of them to the other."),
    .yet = FFF_TEXT("Checks", "Not connected yet")};

void findConnection(const Looked &at, std::vector<Finding> &found)
{
    const auto loose = looseGroups(at);
    refreshGaps(at, loose);
    const Bodies &bodies = at.analysis.bodies;
    const Model &model = at.analysis.model;
    if (at.groups.size() == 1) {
        found.push_back(makeFinding(
            kConnected, Severity::Good,
            Connection{static_cast<int>(model.sectionCount()), holdingJoints(at.analysis)}));
    }
    for (std::size_t i = 0; i < loose.size(); ++i) {
        Finding finding = makeFinding(kNotConnected, Severity::Error);
        finding.sections = model.refs(sectionsOf(bodies, *loose[i]));
        Gap gap;
        if (i < at.caches.gaps.size() && at.caches.gaps[i].other >= 0) {
            const CheckCaches::OfGroup &known = at.caches.gaps[i];
            gap = {model.ref(static_cast<std::size_t>(known.other)), known.distance};
            finding.at = known.at;
            finding.others = {*gap.other};
        }
        finding.setDetails(gap);
        found.push_back(std::move(finding));
    }
}

} // namespace fff
