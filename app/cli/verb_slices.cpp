// A mesh in slices, as a model whose sections go on following it.
#include "app/cli/mesh_options.h"
#include "core/model/operation_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/slices.h"
#include "core/session/operation_commands.h"
#include "core/session/operation_text.h"

#include <QCoreApplication>

namespace fff::cli {

namespace {

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// The planes as asked for. Prints and sets `status` where that makes no sense.
Operation askedSlices(const QCommandLineParser &parser, const Verb &verb,
                      std::optional<int> &status)
{
    Operation slices = newOperation(kSlices);
    const ParameterSpec &direction = *kSlices.parameter("direction");
    const ParameterSpec &counted = *kSlices.parameter("count");
    const ParameterSpec &spaced = *kSlices.parameter("spacing");
    if (parser.isSet(QStringLiteral("along"))) {
        const QString text = parser.value(QStringLiteral("along"));
        const std::string key = text.toLower().toStdString();
        // What runs along a curve, or is like a section, needs one that is drawn.
        if (key == "curve" || key == "section" || !isAllowed(direction, key)) {
            status = wrongUse(verb, tr("--along: found \"%1\", expected X, Y, Z, XY, XZ, YZ or "
                                       "radial.")
                                        .arg(text));
            return slices;
        }
        slices.parameters.insert_or_assign("direction", key);
    }
    const std::optional<int> count =
        wholeNumber(parser, verb, "count", static_cast<int>(counted.least),
                    static_cast<int>(counted.most), status);
    if (status)
        return slices;
    const std::optional<double> spacing =
        number(parser, verb, "spacing", spaced.least, status, spaced.most);
    if (status)
        return slices;
    if (count && spacing)
        status = wrongUse(verb, tr("--count and --spacing were both given; expected one of them."));
    else if (spacing && slices.parameters["direction"] == ParameterValue(std::string("radial")))
        status =
            wrongUse(verb, tr("--spacing: planes around an axis have none; expected --count."));
    const ParameterSpec &wall = *kSlices.parameter("wall");
    const std::optional<double> hollow =
        status ? std::nullopt : number(parser, verb, "hollow", wall.least, status, wall.most);
    if (hollow) {
        slices.parameters.insert_or_assign("hollow", true);
        slices.parameters.insert_or_assign("wall", *hollow);
    }
    if (count)
        slices.parameters.insert_or_assign("count", static_cast<double>(*count));
    if (spacing) {
        slices.parameters.insert_or_assign("planesBy", std::string("spacing"));
        slices.parameters.insert_or_assign("spacing", *spacing);
    }
    return slices;
}

} // namespace

int runSlices(const QStringList &arguments)
{
    QCommandLineParser parser;
    addMeshModelOptions(parser);
    parser.addOption({QStringLiteral("along"),
                      tr("The axes that planes are across: X, Y, Z, two of them for a grid, or "
                         "radial: around the upright axis (XZ)."),
                      QStringLiteral("AXES")});
    parser.addOption(
        {QStringLiteral("count"), tr("Planes in each direction (6)."), QStringLiteral("N")});
    parser.addOption({QStringLiteral("spacing"), tr("From plane to plane."), QStringLiteral("MM")});
    parser.addOption({QStringLiteral("hollow"),
                      tr("Leaves only walls of this width along the contours, and where others "
                         "cross."),
                      QStringLiteral("MM")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("slices");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    Operation slices = askedSlices(parser, verb, status);
    if (status)
        return *status;
    MeshModel started = readMeshModel(parsed.files.first(), parser, verb);
    if (started.status)
        return *started.status;
    slices.subject = started.document.templates.front()->id;
    slices.stock = started.document.currentStock;
    slices.name = freeOperationName(started.document, slices);
    const Model model = evaluate(addOperation(std::move(started.document), std::move(slices)));
    const OperationResult &result = *model.evaluation.results.front();
    if (result.sections.empty()) {
        printError(tr("%1: no plane cuts a section of it that is large enough.")
                       .arg(parsed.files.first()));
        return BadInput;
    }
    for (const OperationNotice &notice : result.notices)
        printError(noticeText(notice, *result.operation));
    printError(tr("Sections: %1").arg(result.sections.size()));
    return writeMeshModel(model.document, parser);
}

} // namespace fff::cli
