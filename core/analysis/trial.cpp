#include "core/analysis/trial.h"

#include "core/analysis/analysed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace fff {

namespace {

/// Problems of joints, and of what holds together, are told apart by their kinds, all others by
/// what their badges are about: fewer loose parts are no price for a section that comes loose.
using Matter = std::pair<Subject, std::string_view>;

Matter matterOf(const Finding &finding)
{
    const bool isByKind =
        finding.subject() == Subject::Joints || finding.subject() == Subject::Connection;
    return {finding.subject(), isByKind ? finding.kind->name : std::string_view()};
}

int weightOf(const Finding &finding)
{
    return finding.kind->weight ? finding.kind->weight(finding) : 1;
}

void add(const Finding &finding, Burden &burden)
{
    if (finding.severity == Severity::Good || finding.severity == Severity::Note)
        return;
    int &count = finding.severity == Severity::Error     ? burden.errors
                 : finding.severity == Severity::Warning ? burden.warnings
                                                         : burden.unknown;
    count += weightOf(finding);
}

std::map<Matter, Burden> burdensOf(std::span<const Finding> found)
{
    std::map<Matter, Burden> burdens;
    for (const Finding &finding : found)
        if (finding.severity != Severity::Good && finding.severity != Severity::Note)
            add(finding, burdens[matterOf(finding)]);
    return burdens;
}

Burden burdenOf(const std::map<Matter, Burden> &burdens, const Matter &matter)
{
    const auto found = burdens.find(matter);
    return found == burdens.end() ? Burden() : found->second;
}

/// Of what is said of the very same sections. Nothing where nothing is.
std::optional<Burden> burdenOfSame(std::span<const Finding> found, const Finding &finding)
{
    std::optional<Burden> burden;
    for (const Finding &other : found)
        if (isSameVerdict(finding, other))
            add(other, burden ? *burden : burden.emplace());
    return burden;
}

/// So much of the distance from what is graver has to stay.
constexpr double kKeptSpare = 0.9;

/// Nearer to what is graver than anything that is said alike was before.
bool isNearer(const Finding &finding, std::span<const Finding> before)
{
    if (!finding.kind->spare || finding.severity < Severity::Warning)
        return false;
    std::optional<double> was;
    for (const Finding &other : before)
        if (other.is(*finding.kind) && other.severity >= Severity::Warning)
            was = std::min(was.value_or(other.kind->spare(other)), other.kind->spare(other));
    // What is beyond it already has less than nothing to spare.
    return was && finding.kind->spare(finding) < *was - (1.0 - kKeptSpare) * std::abs(*was);
}

bool isNewLoss(const Finding &finding, std::span<const Finding> before)
{
    return finding.kind->isLoss && !isAmong(finding, before);
}

/// Nobody could say before: of what does not stand it is not known whether it holds. What comes out
/// then was so all along.
bool wasSilent(Subject subject, std::span<const Finding> before)
{
    return subject == Subject::Strength &&
           std::none_of(before.begin(), before.end(), [subject](const Finding &finding) {
               return finding.subject() == subject && finding.severity != Severity::Note;
           });
}

/// What takes too long to be asked of each edit is not.
bool judges(const Stage &stage)
{
    return stage.findings && !stage.isRefining();
}

} // namespace

Trials::Trials(const std::vector<Stage> &stages)
{
    std::set<std::string_view> wanted;
    for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage)
        if (judges(*stage) || wanted.contains(stage->name))
            wanted.insert(stage->inputs.begin(), stage->inputs.end());
    for (const Stage &stage : stages)
        if (judges(stage) || wanted.contains(stage.name))
            m_stages.push_back(stage);
}

std::optional<Trials::Outcome> Trials::of(Model model, const CheckRules &rules,
                                          std::stop_token stop)
{
    Snapshot::Results results{{kModel.name, std::make_shared<const Model>(std::move(model))},
                              {kRules.name, std::make_shared<const CheckRules>(rules)}};
    Outcome outcome;
    Progress progress;
    for (const Stage &stage : m_stages) {
        Snapshot::Results inputs;
        for (const std::string_view input : stage.inputs)
            inputs[input] = results.at(input);
        const auto before = m_before.find(stage.name);
        Result<std::shared_ptr<const void>> result = failure(ErrorCode::StageFailed);
        try {
            result = stage.compute(Snapshot(0, std::move(inputs)),
                                   before == m_before.end() ? nullptr : before->second.get(),
                                   progress, stop);
        } catch (...) { // the stage says so of the model that is there
        }
        if (!result) {
            m_before.clear();
            return {};
        }
        results[stage.name] = *result;
        if (stage.findings) {
            const std::vector<Finding> &found = stage.findings(result->get());
            outcome.findings.insert(outcome.findings.end(), found.begin(), found.end());
        }
    }
    if (const auto analysed = results.find(kAnalysed.name); analysed != results.end())
        outcome.analysis = static_cast<const Analysed *>(analysed->second.get())->analysis;
    m_before = std::move(results);
    return outcome;
}

bool isNoWorse(std::span<const Finding> before, std::span<const Finding> after)
{
    const std::map<Matter, Burden> was = burdensOf(before), is = burdensOf(after);
    return std::all_of(is.begin(), is.end(),
                       [&](const auto &of) {
                           return !(burdenOf(was, of.first) < of.second) ||
                                  wasSilent(of.first.first, before);
                       }) &&
           std::all_of(after.begin(), after.end(), [&](const Finding &finding) {
               const std::optional<Burden> known = burdenOfSame(before, finding);
               return !isNewLoss(finding, before) && !isNearer(finding, before) &&
                      (!known || !(*known < *burdenOfSame(after, finding)));
           });
}

bool helps(const Finding &finding, std::span<const Finding> before, std::span<const Finding> after)
{
    const std::optional<Burden> still = burdenOfSame(after, finding);
    // What weighs nothing, a note, is mended when it is not said any more.
    if (finding.severity <= Severity::Note)
        return !still;
    const std::optional<Burden> was = burdenOfSame(before, finding);
    const Matter matter = matterOf(finding);
    const Burden all = burdenOf(burdensOf(before), matter),
                 rest = burdenOf(burdensOf(after), matter);
    return (!still || !was || *still < *was) &&
           (rest < all || (finding.kind->hidesOthers && !(all < rest)));
}

} // namespace fff
