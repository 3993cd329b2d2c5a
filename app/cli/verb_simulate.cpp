#include "app/cli/analysed_file.h"
#include "app/cli/strength_text.h"
#include "app/cli/weight_options.h"
#include "core/analysis/checks.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/stress_lines.h"

#include <QElapsedTimer>

namespace fff::cli {

int runSimulate(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption(
        {QStringLiteral("accurate"),
         QCoreApplication::translate(
             "CommandLine",
             "Sections bend where joints share a load, by finite elements; takes seconds.")});
    parser.addOption(
        {QStringLiteral("lasting"),
         QCoreApplication::translate(
             "CommandLine",
             "The load stays for months: each stock keeps only its share of strength for that.")});
    addWeightOptions(parser);
    AnalysedFile model = analysedFile("simulate", arguments, parser);
    if (model.status)
        return *model.status;
    if (const auto status = hangWeights(parser, verbNamed("simulate"), model.analysis))
        return *status;
    StrengthRules rules;
    rules.isLasting = parser.isSet(QStringLiteral("lasting"));
    rules.isElastic = parser.isSet(QStringLiteral("accurate"));
    StrengthCaches caches;
    Simulated simulated;
    const auto milliseconds = [](const QElapsedTimer &timer) {
        return 1e-6 * static_cast<double>(timer.nsecsElapsed());
    };
    QElapsedTimer timer;
    timer.start();
    simulated.strength = forcesIn(model.analysis, rules, caches);
    simulated.millisecondsOfForces = milliseconds(timer);
    timer.restart();
    addStresses(model.analysis, rules, caches, simulated.strength);
    simulated.millisecondsOfStresses = milliseconds(timer);
    simulated.bearable = bearableMass(model.analysis, simulated.strength, rules, caches);
    std::vector<Finding> found = checks(model.analysis);
    for (Finding &finding :
         strengthFindings(model.analysis, simulated.strength, simulated.bearable, rules))
        found.push_back(std::move(finding));
    simulated.doubts = verdictDoubts(found);
    if (rules.isElastic && areStressesKnown(simulated.strength)) {
        const auto shared = std::make_shared<const Analysis>(model.analysis);
        if (auto bent = bentModel(shared, simulated.strength, caches))
            simulated.bent = *std::move(bent);
    }
    return model.asJson ? print(strengthJson(simulated, model.analysis, model.file))
                        : printLines(strengthText(simulated, model.analysis));
}

} // namespace fff::cli
