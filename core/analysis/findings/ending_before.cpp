#include "core/analysis/findings/ending_before.h"

#include "core/assembly/joint_editing.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace fff {

namespace {

constexpr Text kEndText = FFF_TEXT("Checks", "End one at the other");
//: %1 and %2 are names of sections
constexpr Text kEndAtText = FFF_TEXT("Checks", "End %1 at %2");

/// So many sections that cross there, and so many ways to end one at another, are tried.
constexpr std::size_t kMostCrossing = 4, kMostEnds = 8;

/// What is wrong where too many sections cross; the less, the better.
struct Tangle
{
    std::size_t groups = 0, pieces = 0, looseJoints = 0;
    auto operator<=>(const Tangle &) const = default;
};

Tangle tangleOf(const Analysis &analysis)
{
    Tangle tangle;
    tangle.groups = heldGroups(analysis).size();
    tangle.pieces = analysis.bodies.size();
    for (const Joint &joint : analysis.assembly.joints) {
        tangle.looseJoints += joint.kind != JointKind::None && analysis.grips.of(joint).loose;
        tangle.looseJoints += joint.kind == JointKind::None;
    }
    return tangle;
}

/// The finding's sections, and of a single one those that it has joints with.
std::vector<SectionRef> crossingAt(const Finding &finding, const Analysis &analysis)
{
    std::vector<SectionRef> all = finding.sections;
    const auto add = [&all](const SectionRef &ref) {
        if (std::find(all.begin(), all.end(), ref) == all.end() && all.size() < kMostCrossing)
            all.push_back(ref);
    };
    for (const SectionRef &other : finding.others)
        add(other);
    for (const SectionRef &own : finding.sections) {
        const int section = analysis.model.indexOf(own);
        for (const Joint &joint : analysis.assembly.joints)
            if (joint.a == section || joint.b == section)
                add(analysis.model.ref(
                    static_cast<std::size_t>(joint.a == section ? joint.b : joint.a)));
    }
    return all;
}

/// Those who cross, who ends first: the one that was drawn last.
std::vector<std::pair<SectionRef, SectionRef>> endsOf(const std::vector<SectionRef> &all,
                                                      const Analysis &analysis)
{
    std::vector<std::pair<SectionRef, SectionRef>> ends;
    std::vector<SectionRef> byAge = all;
    std::sort(byAge.begin(), byAge.end(), [&](const SectionRef &a, const SectionRef &b) {
        return analysis.model.indexOf(a) > analysis.model.indexOf(b);
    });
    for (const SectionRef &who : byAge)
        for (const SectionRef &at : byAge) {
            const int i = analysis.model.indexOf(who), k = analysis.model.indexOf(at);
            if (i != k && i >= 0 && k >= 0 && who.drawn.isValid() &&
                analysis.assembly.joints.find(std::min(i, k), std::max(i, k)) &&
                ends.size() < kMostEnds)
                ends.emplace_back(who, at);
        }
    return ends;
}

std::optional<FindingEdit> endedBefore(const FindingAction &, const Finding &finding,
                                       const Analysis &analysis, const Flips *)
{
    const Model &model = analysis.model;
    std::optional<FindingEdit> best;
    Tangle least = tangleOf(analysis);
    for (const auto &[who, at] : endsOf(crossingAt(finding, analysis), analysis)) {
        JointEdit edit = trimTo(model, who, at);
        if (!edit || edit->document.isSame(model.document))
            continue;
        AnalysisCaches caches;
        caches.last = AnalysisPointer(AnalysisPointer(), &analysis); // it outlives them
        const Tangle then = tangleOf(analyse(evaluate(edit->document, model), caches));
        if (!(then < least))
            continue;
        least = then;
        best = FindingEdit{std::move(edit->step),
                           std::move(edit->document),
                           {},
                           {kEndAtText, {nameOf(model, who), nameOf(model, at)}}};
    }
    return best;
}

} // namespace

const ActionKind kEndBefore{plainWords<kEndText>, endedBefore};

} // namespace fff
