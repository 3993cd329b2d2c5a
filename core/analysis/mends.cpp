#include "core/analysis/mends.h"

#include "core/analysis/analysed.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/planned.h"
#include "core/operations/evaluate.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

/// What all edits are compared with, and who judges them.
struct Judge
{
    const Analysis &analysis;
    const std::vector<Finding> &findings;
    const std::vector<Finding> &told; // the same as a person reads them
    const Flips *flips;
    const CheckRules &rules;
    Trials &trials;
    std::stop_token stop;

    /// Nothing where it does not help, or makes something worse.
    std::optional<Mend> mend(const FindingAction &action, const Finding &finding) const
    {
        if (!fff::isEdit(*action.kind))
            return Mend{action, {}, nullptr};
        std::optional<FindingEdit> edit = carriedOut(action, finding, analysis, flips);
        if (!edit)
            return {};
        std::optional<Trials::Outcome> tried =
            trials.of(evaluate(edit->document, analysis.model), rules, stop);
        if (!tried || !isNoWorse(findings, tried->findings) ||
            !helps(finding, findings, tried->findings))
            return {};
        doubtVerdicts(tried->findings); // from here on they are told
        Message changes = changesBetween(analysis, *tried->analysis, told, tried->findings);
        return Mend{action, std::move(edit),
                    std::make_shared<const Trials::Outcome>(*std::move(tried)), std::move(changes)};
    }

    std::vector<Mend> mendsOf(const std::vector<FindingAction> &actions,
                              const Finding &finding) const
    {
        std::vector<Mend> mends;
        for (const FindingAction &action : actions) {
            const bool isNeeded = !action.kind->isLastResort ||
                                  std::none_of(mends.begin(), mends.end(),
                                               [](const Mend &one) { return one.isEdit(); });
            if (isNeeded && !stop.stop_requested())
                if (auto made = mend(action, finding))
                    mends.push_back(*std::move(made));
        }
        return mends;
    }
    std::vector<Mend> mendsOf(const Finding &finding) const
    {
        if (!finding.kind->actions)
            return {};
        return mendsOf(finding.kind->actions(finding, analysis), finding);
    }
    /// Of many about all of them.
    std::vector<Mend> mendsOfAll(const FindingRow &row) const
    {
        const ActionKind *forAll = row.finding.kind->forAll;
        return forAll ? mendsOf({{forAll}}, row.finding) : std::vector<Mend>();
    }
};

/// One for all of them.
Finding inOne(const std::vector<Finding> &all)
{
    Finding one = all.front();
    one.at.reset();
    one.joint.reset();
    for (std::size_t i = 1; i < all.size(); ++i)
        for (const SectionRef &section : all[i].sections)
            if (std::find(one.sections.begin(), one.sections.end(), section) == one.sections.end())
                one.sections.push_back(section);
    return one;
}

} // namespace

std::vector<FindingRow> inRows(const std::vector<Finding> &findings)
{
    const auto kindOf = [](const Finding &finding) {
        return std::pair(finding.kind, finding.severity);
    };
    std::map<std::pair<const FindingKind *, Severity>, std::vector<Finding>> alike;
    for (const Finding &finding : findings)
        alike[kindOf(finding)].push_back(finding);
    std::vector<FindingRow> rows;
    for (const Finding &finding : findings) {
        std::vector<Finding> &all = alike[kindOf(finding)];
        if (all.empty())
            continue; // they have their row
        if (static_cast<int>(all.size()) <= kMostAlike) {
            rows.push_back({finding, {finding}});
            continue;
        }
        rows.push_back({inOne(all), all});
        all.clear();
    }
    return rows;
}

const std::vector<Mend> *Mends::of(const Finding &finding) const
{
    const std::vector<Mend> *same = nullptr;
    for (const auto &[mended, mends] : ofFindings) {
        if (!isSameVerdict(mended, finding))
            continue;
        if (mended.at == finding.at)
            return &mends; // of several between the same sections it is this one
        same = same ? same : &mends;
    }
    return same;
}

Stage mendsOf(const std::vector<Stage> &others)
{
    std::vector<std::string_view> inputs{kAnalysed.name, kFlips.name, kRules.name};
    std::vector<Stage> finding;
    for (const Stage &stage : others) {
        if (!stage.findings || stage.isRefining())
            continue;
        finding.push_back(stage);
        inputs.push_back(stage.name);
    }
    return makeStage(kMends, FFF_TEXT("Stage", "what can be done about problems"),
                     std::move(inputs), Stage::Runs::WhenSettled,
                     [others, finding](const Snapshot &snapshot, const Mends *previous,
                                       Progress &progress, std::stop_token stop) -> Result<Mends> {
                         std::vector<Finding> all;
                         for (const Stage &stage : finding) {
                             const auto &found = stage.findings(snapshot.result(stage.name).get());
                             all.insert(all.end(), found.begin(), found.end());
                         }
                         Mends out{snapshot.get(kAnalysed).analysis,
                                   {},
                                   previous ? previous->trials : std::make_shared<Trials>(others)};
                         const std::optional<Flips> &flips = snapshot.get(kFlips).flips;
                         std::vector<Finding> told = all;
                         doubtVerdicts(told);
                         const Judge judge{
                             *out.analysis,        all,         told, flips ? &*flips : nullptr,
                             snapshot.get(kRules), *out.trials, stop};
                         const std::vector<FindingRow> rows = inRows(all);
                         for (const FindingRow &row : rows) {
                             progress.set(static_cast<double>(&row - rows.data()) /
                                          static_cast<double>(rows.size()));
                             if (row.count() > 1)
                                 out.ofFindings.emplace_back(row.finding, judge.mendsOfAll(row));
                             for (int i = 0; i < std::min(row.count(), kMostTried); ++i) {
                                 const Finding &one = row.all[static_cast<std::size_t>(i)];
                                 out.ofFindings.emplace_back(one, judge.mendsOf(one));
                             }
                             if (stop.stop_requested())
                                 return failure(ErrorCode::Cancelled);
                         }
                         return out;
                     });
}

} // namespace fff
