#include "app/cli/command_line.h"
#include "app/cli/info.h"
#include "core/analysis/plan_checks.h"
#include "core/base/tolerances.h"
#include "core/operations/evaluate.h"

namespace fff::cli {

namespace {

/// The cut sections on chords of another tolerance than the analysis keeps. Errors  NotCutOut.
Result<std::vector<CutSectionPointer>> cutsOnChords(const Analysis &analysis, double chord)
{
    std::vector<CutSectionPointer> cuts;
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const Section &section = *analysis.model.section(i);
        auto parts = cutShape(*section.shape, analysis.assembly.slits[i], chord);
        if (!parts)
            return failure(ErrorCode::NotCutOut, {}, {section.name});
        cuts.push_back(std::make_shared<const CutSection>(*std::move(parts)));
    }
    return cuts;
}

} // namespace

int runParts(const QStringList &arguments)
{
    QCommandLineParser parser;
    const auto tr = [](const char *text) {
        return QCoreApplication::translate("CommandLine", text);
    };
    parser.addOption(
        {QStringLiteral("json"), tr("Prints JSON, for other programs; steps are counted from 0.")});
    parser.addOption({QStringLiteral("tolerance"),
                      tr("Largest distance between chords and curves (0.01)."),
                      QStringLiteral("MM")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("parts");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    constexpr double kFinestChord = 1e-5; // mm: ten steps of the grid that booleans work on
    const double chord =
        number(parser, verb, "tolerance", kFinestChord, status).value_or(kCutChord);
    if (status)
        return *status;
    const auto options = documentOptions(parser, verb, status);
    if (!options)
        return *status;
    Loaded loaded = load(parsed.files.first(), *options, verb);
    if (loaded.status)
        return *loaded.status;
    AnalysisCaches caches;
    Analysis analysis = analyse(evaluate(std::move(loaded.document)), caches);
    const ModelPlan known = planOf(analysis, timeLimit(kPlanningTime));
    if (known.failure)
        return report(*known.failure, parsed.files.first());
    const AssemblyPlan &plan = known.plan;
    if (chord != kCutChord) {
        Result<std::vector<CutSectionPointer>> cuts = cutsOnChords(analysis, chord);
        if (!cuts)
            return report(cuts.error(), parsed.files.first());
        analysis.bodies = bodiesOf(analysis.model, *cuts);
    }
    const std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    return parser.isSet(QStringLiteral("json"))
               ? print(partsJson(parts, analysis.model, plan))
               : printLines(partsText(parts, analysis.model, plan));
}

} // namespace fff::cli
