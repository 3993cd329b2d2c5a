#include "core/analysis/findings/loose_pieces.h"

#include "core/analysis/findings/ending_before.h"
#include "core/analysis/findings/moved_planes.h"
#include "core/assembly/cut_section.h"
#include "core/assembly/joint_editing.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace fff {

namespace {

Message loosePiecesSentence(const Finding &finding, const Model &model)
{
    const LoosePieces &pieces = *finding.details<LoosePieces>();
    const Named name = nameAt(finding, model, 0);
    const WidthAndHeight size{pieces.width, pieces.height};
    //: %1 is the name of a section, %2 a number from 2 on
    const Message apart{pieces.isBySlits ? FFF_TEXT("Checks", "Slits cut %1 into %2 parts")
                                         : FFF_TEXT("Checks", "%1 comes out in %2 parts"),
                        {name, pieces.parts}};
    if (pieces.loose == 1)
        //: %1 is such as "Slits cut Body into 2 parts", %2 a size
        return {FFF_TEXT("Checks", "%1; nothing holds one of them, %2."), {apart, size}};
    if (pieces.loose == pieces.parts)
        //: %1 is such as "Slits cut Body into 2 parts", %2 a size
        return {FFF_TEXT("Checks", "%1; nothing holds them, the largest being %2."), {apart, size}};
    //: %1 is such as "Slits cut Body into 4 parts", %2 a number from 2 on, %3 a size
    return {FFF_TEXT("Checks", "%1; nothing holds %2 of them, the largest being %3."),
            {apart, pieces.loose, size}};
}

Message severedSentence(const Finding &finding, const Model &model)
{
    const SeveredPiece &piece = *finding.details<SeveredPiece>();
    const auto hanging = finding.sections.begin() + piece.sections;
    if (piece.sections > 1) {
        const NamedSections cut = namesOf(model, {finding.sections.begin(), hanging});
        if (hanging == finding.sections.end())
            //: %1 names sections
            return {FFF_TEXT("Checks", "Slits cut %1 apart. Nothing holds what is cut off, which "
                                       "hangs together."),
                    {cut}};
        //: %1 and %2 name sections
        return {FFF_TEXT("Checks",
                         "Slits cut %1 apart. Nothing holds what is cut off, together with %2."),
                {cut, namesOf(model, {hanging, finding.sections.end()})}};
    }
    //: %1 is the name of a section, %2 a size, %3 names of sections
    return {FFF_TEXT("Checks", "Slits cut %1 apart. Nothing holds its part of %2 with %3."),
            {nameAt(finding, model, 0), WidthAndHeight{piece.width, piece.height},
             namesOf(model, {hanging, finding.sections.end()})}};
}

constexpr Text kTurnText = FFF_TEXT("Checks", "Flip slits");
//: %1 is the name of a section
constexpr Text kTurnStep = FFF_TEXT("Step", "Flip slits of %1");

/// So many of its joints are turned round, one at a time.
constexpr int kMostTurned = 24;

int loosePiecesOf(const Analysis &analysis)
{
    const auto groups = heldGroups(analysis);
    return static_cast<int>(groups.size());
}

/// Of the joints of the section that fell apart the one that leaves least loose when its slits open
/// to the other side.
std::optional<FindingEdit> turned(const FindingAction &, const Finding &finding,
                                  const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    const int section = model.indexOf(finding.sections.front());
    std::optional<FindingEdit> best;
    int least = loosePiecesOf(analysis), tried = 0;
    for (const Joint &joint : analysis.assembly.joints) {
        if ((joint.a != section && joint.b != section) || tried >= kMostTurned)
            continue;
        const JointRef ref(model.ref(static_cast<std::size_t>(joint.a)),
                           model.ref(static_cast<std::size_t>(joint.b)));
        const JointEdit edit = flipSlits(model, ref);
        if (!edit || edit->document.isSame(model.document))
            continue;
        ++tried;
        AnalysisCaches caches;
        caches.last = AnalysisPointer(AnalysisPointer(), &analysis); // it outlives them
        const int loose = loosePiecesOf(analyse(evaluate(edit->document, model), caches));
        if (loose < least) {
            least = loose;
            best = FindingEdit{Step(kTurnStep, {nameAt(finding, model, 0)}), edit->document};
        }
    }
    return best;
}

std::vector<FindingAction> turnSlits(const Finding &finding, const Analysis &analysis)
{
    std::vector<FindingAction> actions{{&kTurnSlits}, {&kEndBefore}};
    for (const FindingAction &action : movedPlanes(finding, analysis.model.document))
        actions.push_back(action);
    return actions;
}

constexpr Text kLetOneEnd =
    FFF_TEXT("Checks", "Let one of the sections that cross there end before the others, or move it "
                       "aside.");

Vec2 sizeOf(const Body &piece)
{
    return bounds(piece.outline().region.outer).size();
}

/// A hole that reaches the contour on both of its sides needs no slits for it.
bool isCutBySlits(const Analysis &analysis, int section)
{
    const auto i = static_cast<std::size_t>(section);
    return !analysis.assembly.slits[i].empty() &&
           CutSection(*analysis.model.section(i)->shape, {}, nullptr).parts().size() == 1;
}

/// What slits cut off, of those sections, and what hangs on it.
Finding severedOf(const Analysis &analysis, const std::vector<int> &group,
                  const std::vector<int> &pieces)
{
    const Bodies &bodies = analysis.bodies;
    const Body &body = bodies.at(pieces.front());
    const Vec2 size = sizeOf(body);
    Finding finding = makeFinding(kSevered, Severity::Error);
    finding.sections = analysis.model.refs(sectionsOf(bodies, pieces));
    finding.setDetails(SeveredPiece{size.x(), size.y(), static_cast<int>(finding.sections.size())});
    const std::vector<SectionRef> cut = finding.sections;
    for (const SectionRef &other : analysis.model.refs(sectionsOf(bodies, group)))
        if (std::find(cut.begin(), cut.end(), other) == cut.end())
            finding.sections.push_back(other);
    finding.at = body.mass().centre;
    return finding;
}

} // namespace

const ActionKind kTurnSlits{plainWords<kTurnText>, turned};

const FindingKind kLoosePieces{
    .name = "loosePieces",
    .subject = Subject::Connection,
    .title = FFF_TEXT("Checks", "Loose parts"),
    .sentence = loosePiecesSentence,
    .actions = turnSlits,
    .weight = [](const Finding &finding) { return finding.details<LoosePieces>()->loose; },
    .advice = kLetOneEnd,
    .isLoss = true};
const FindingKind kSevered{.name = "loosePieces",
                           .subject = Subject::Connection,
                           .title = FFF_TEXT("Checks", "Loose parts"),
                           .sentence = severedSentence,
                           .actions = turnSlits,
                           .advice = kLetOneEnd};

bool isLoosePiece(const Bodies &bodies, const std::vector<int> &group)
{
    return group.size() == 1 && bodies.countOf(bodies.sectionOf(group.front())) > 1;
}

std::vector<int> severedPieces(const Bodies &bodies, const std::vector<int> &group)
{
    if (group.size() < 2)
        return {};
    std::map<int, int> inside; // pieces, by their sections
    for (const int body : group)
        ++inside[bodies.sectionOf(body)];
    std::vector<int> severed;
    std::copy_if(group.begin(), group.end(), std::back_inserter(severed), [&](int body) {
        const int section = bodies.sectionOf(body);
        return inside[section] < bodies.countOf(section);
    });
    return severed;
}

void findLoosePieces(const Looked &at, std::vector<Finding> &found)
{
    const Bodies &bodies = at.analysis.bodies;
    std::map<int, std::vector<int>> loose; // bodies by their sections
    for (std::size_t g = 1; g < at.groups.size(); ++g)
        if (isLoosePiece(bodies, at.groups[g]))
            loose[bodies.sectionOf(at.groups[g].front())].push_back(at.groups[g].front());
    for (const auto &[section, pieces] : loose) {
        // Bodies of a section come the largest first.
        const Body &largest = bodies.at(*std::min_element(pieces.begin(), pieces.end()));
        const Vec2 size = sizeOf(largest);
        Finding finding =
            makeFinding(kLoosePieces, Severity::Error,
                        LoosePieces{bodies.countOf(section), static_cast<int>(pieces.size()),
                                    size.x(), size.y(), isCutBySlits(at.analysis, section)});
        finding.sections = {at.analysis.model.ref(static_cast<std::size_t>(section))};
        finding.at = largest.mass().centre;
        found.push_back(std::move(finding));
    }
    for (std::size_t g = 1; g < at.groups.size(); ++g)
        if (const auto pieces = severedPieces(bodies, at.groups[g]); !pieces.empty())
            found.push_back(severedOf(at.analysis, at.groups[g], pieces));
}

} // namespace fff
