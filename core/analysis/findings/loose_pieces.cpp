#include "core/analysis/findings/loose_pieces.h"

#include "core/analysis/findings/ending_before.h"
#include "core/assembly/joint_editing.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

Message loosePiecesSentence(const Finding &finding, const Model &model)
{
    const LoosePieces &pieces = *finding.details<LoosePieces>();
    const Named name = nameAt(finding, model, 0);
    const WidthAndHeight size{pieces.width, pieces.height};
    if (pieces.loose == 1)
        //: %1 is the name of a section, %2 a number from 2 on, %3 a size
        return {FFF_TEXT("Checks", "Slits cut %1 into %2 parts; nothing holds one of them, %3."),
                {name, pieces.parts, size}};
    if (pieces.loose == pieces.parts)
        //: %1 is the name of a section, %2 a number from 2 on, %3 a size
        return {FFF_TEXT("Checks",
                         "Slits cut %1 into %2 parts; nothing holds them, the largest being %3."),
                {name, pieces.parts, size}};
    //: %1 is the name of a section, %2 and %3 are numbers from 2 on, %4 is a size
    return {FFF_TEXT("Checks",
                     "Slits cut %1 into %2 parts; nothing holds %3 of them, the largest being %4."),
            {name, pieces.parts, pieces.loose, size}};
}

Message severedSentence(const Finding &finding, const Model &model)
{
    const SeveredPiece &piece = *finding.details<SeveredPiece>();
    //: %1 is the name of a section, %2 a size, %3 names of sections
    return {FFF_TEXT("Checks", "Slits cut %1 apart. Nothing holds its part of %2 with %3."),
            {nameAt(finding, model, 0), WidthAndHeight{piece.width, piece.height},
             namesOf(model, {finding.sections.begin() + 1, finding.sections.end()})}};
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

std::vector<FindingAction> turnSlits(const Finding &, const Analysis &)
{
    return {{&kTurnSlits}, {&kEndBefore}};
}

constexpr Text kLetOneEnd =
    FFF_TEXT("Checks", "Let one of the sections that cross there end before the others, or move it "
                       "aside.");

Vec2 sizeOf(const Body &piece)
{
    return bounds(piece.outline().region.outer).size();
}

/// What slits cut off and what hangs on it.
Finding severedOf(const Analysis &analysis, const std::vector<int> &group, int piece)
{
    const Bodies &bodies = analysis.bodies;
    const Body &body = bodies.at(piece);
    const Vec2 size = sizeOf(body);
    Finding finding = makeFinding(kSevered, Severity::Error, SeveredPiece{size.x(), size.y()});
    finding.sections = {analysis.model.ref(static_cast<std::size_t>(bodies.sectionOf(piece)))};
    for (const SectionRef &other : analysis.model.refs(sectionsOf(bodies, group)))
        if (!(other == finding.sections.front()))
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
    .advice = kLetOneEnd};
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

std::optional<int> severedPiece(const Bodies &bodies, const std::vector<int> &group)
{
    if (group.size() < 2)
        return {};
    std::map<int, int> inside; // pieces, by their sections
    for (const int body : group)
        ++inside[bodies.sectionOf(body)];
    const auto severed = std::find_if(group.begin(), group.end(), [&](int body) {
        const int section = bodies.sectionOf(body);
        return inside[section] < bodies.countOf(section);
    });
    return severed == group.end() ? std::nullopt : std::optional(*severed);
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
                                    size.x(), size.y()});
        finding.sections = {at.analysis.model.ref(static_cast<std::size_t>(section))};
        finding.at = largest.mass().centre;
        found.push_back(std::move(finding));
    }
    for (std::size_t g = 1; g < at.groups.size(); ++g)
        if (const auto piece = severedPiece(bodies, at.groups[g]))
            found.push_back(severedOf(at.analysis, at.groups[g], *piece));
}

} // namespace fff
