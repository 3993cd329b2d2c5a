#include "app/cli/all_found.h"
#include "app/cli/analysed_file.h"
#include "app/cli/info.h"
#include "core/analysis/plan_checks.h"
#include "core/io/json_writer.h"
#include "core/io/warning_summary.h"
#include "core/session/finding_text.h"

#include <algorithm>

namespace fff::cli {

namespace {

using io::JsonWriter;

/// What is listed as a problem: all that is not simply good.
struct Problem
{
    QString code, severity, text;
    std::vector<std::string> sections;
    std::optional<Vec3> at;
    bool isError = false;
};

std::vector<Problem> problemsOf(const std::vector<Finding> &found, const Model &model)
{
    std::vector<Problem> problems;
    for (const Finding &finding : found) {
        if (finding.severity == Severity::Good)
            continue;
        Problem problem{QString::fromLatin1(finding.kind->name),
                        QString::fromLatin1(nameOf(finding.severity)),
                        findingText(finding, model),
                        {},
                        finding.at,
                        finding.severity == Severity::Error};
        for (const SectionRef &ref : finding.sections)
            problem.sections.push_back(
                model.section(static_cast<std::size_t>(model.indexOf(ref)))->name);
        problems.push_back(std::move(problem));
    }
    return problems;
}

/// What the reader mended is no longer wrong, but is not what was drawn.
std::vector<Problem> problemsOf(const std::vector<Warning> &warnings)
{
    std::vector<Problem> problems;
    for (const Warning &warning : warnings) {
        const bool crosses = warning.code == WarningCode::SelfCrossingContour;
        Problem problem{crosses ? QStringLiteral("selfCrossing") : QStringLiteral("mended"),
                        crosses ? QStringLiteral("warning") : QStringLiteral("note"),
                        io::wholeSentence(warning),
                        {},
                        std::nullopt,
                        false};
        if (!warning.args.empty() && warning.code != WarningCode::TrailingLines)
            problem.sections.push_back(warning.args.front());
        problems.push_back(std::move(problem));
    }
    return problems;
}

std::string problemsJson(const std::vector<Problem> &problems)
{
    JsonWriter json;
    json.beginObject();
    json.key("problems");
    json.beginArray();
    for (const Problem &problem : problems) {
        json.beginObject();
        json.member("code", problem.code.toStdString());
        json.member("severity", problem.severity.toStdString());
        json.key("sections");
        json.beginArray(JsonWriter::Layout::Line);
        for (const std::string &name : problem.sections)
            json.value(name);
        json.endArray();
        if (problem.at)
            json.member("at", *problem.at);
        json.member("text", problem.text.toStdString());
        json.endObject();
    }
    json.endArray();
    json.endObject();
    return json.take();
}

/// Worst first, good last, as the window lists them.
QStringList checksText(const std::vector<Finding> &found, const std::vector<Problem> &problems,
                       const Model &model)
{
    QStringList lines;
    for (const char *severity : {"error", "warning", "note", "unknown"})
        for (const Problem &problem : problems)
            if (problem.severity == QLatin1String(severity))
                lines += QStringLiteral("%1: %2").arg(problem.severity, problem.text);
    for (const Finding &finding : found)
        if (finding.severity == Severity::Good)
            lines += findingText(finding, model);
    if (lines.isEmpty())
        lines += QCoreApplication::translate("CommandLine",
                                             "Nothing to check: the model has no sections.");
    return lines;
}

} // namespace

int runCheck(const QStringList &arguments)
{
    const AnalysedFile model = analysedFile("check", arguments);
    if (model.status)
        return *model.status;
    const std::vector<Finding> found =
        allFound(model.analysis, planOf(model.analysis, timeLimit(kPlanningTime)));
    std::vector<Problem> problems = problemsOf(found, model.analysis.model);
    for (Problem &problem : problemsOf(model.warnings))
        problems.push_back(std::move(problem));
    if (const int printed = model.asJson
                                ? print(problemsJson(problems))
                                : printLines(checksText(found, problems, model.analysis.model)))
        return printed;
    return std::any_of(problems.begin(), problems.end(),
                       [](const Problem &problem) { return problem.isError; })
               ? ProblemsFound
               : Done;
}

} // namespace fff::cli
