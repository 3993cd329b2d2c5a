#include "app/cli/cutting_warnings.h"

#include "app/cli/all_found.h"
#include "app/cli/info.h"
#include "app/cli/terminal.h"
#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/findings/of_sections.h"
#include "core/analysis/findings/sheet_fit.h"
#include "core/analysis/mends.h"
#include "core/analysis/plan_checks.h"
#include "core/session/finding_text.h"

#include <algorithm>

namespace fff::cli {

namespace {

bool isWarning(const Finding &finding)
{
    return (finding.severity >= Severity::Warning || finding.severity == Severity::Unknown) &&
           !finding.is(kTooLarge) && !finding.is(kFitsSheet) && !finding.is(kFewSheets);
}

QString textOf(const FindingRow &row, const Model &model)
{
    if (row.count() == 1)
        return findingText(row.finding, model);
    const Message title = titleOf(row.finding);
    if (row.finding.sections.empty())
        return messageText(title);
    return messageText({kOfSections, {namesOf(model, row.finding.sections), title}});
}

} // namespace

void printWarnings(const Analysis &analysis)
{
    std::vector<FindingRow> rows;
    for (FindingRow &row : inRows(allFound(analysis, planOf(analysis, timeLimit(kPlanningTime)))))
        if (isWarning(row.finding))
            rows.push_back(std::move(row));
    std::stable_sort(rows.begin(), rows.end(), [](const FindingRow &a, const FindingRow &b) {
        return a.finding.severity > b.finding.severity;
    });
    for (const FindingRow &row : rows)
        printError(textOf(row, analysis.model));
}

} // namespace fff::cli
