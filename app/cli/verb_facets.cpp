// A mesh of few faces as a box of flat sheets with fingers along their edges, or as nets to fold.
#include "app/cli/mesh_options.h"
#include "core/analysis/facetted.h"
#include "core/model/template_edits.h"

#include <QCoreApplication>

namespace fff::cli {

namespace {

constexpr double kMostFlap = 100.0; // mm

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

QString whyBare(NoTabs why)
{
    switch (why) {
    case NoTabs::TooOblique:
        return tr("No fingers where sheets meet at less than 30° or more than 150°: %1");
    case NoTabs::NoWidth:
    case NoTabs::EndsNowhere:
        return tr("No fingers where one sheet goes past the other or does not "
                  "reach it: %1");
    case NoTabs::NoRoom:
        break;
    }
    return tr("No fingers on edges that are too short for three of them: %1");
}

/// Which edges have no joint, a line for each reason.
void printBare(const FacetModel &model)
{
    for (const NoTabs why :
         {NoTabs::TooOblique, NoTabs::NoWidth, NoTabs::EndsNowhere, NoTabs::NoRoom}) {
        QStringList pairs;
        for (const BareEdge &edge : model.bare)
            if (edge.why == why)
                //: %1 and %2 are names of sections that share an edge
                pairs += tr("%1 and %2")
                             .arg(QString::fromStdString(model.document.find(edge.a)->name),
                                  QString::fromStdString(model.document.find(edge.b)->name));
        if (!pairs.isEmpty())
            printError(whyBare(why).arg(pairs.join(QStringLiteral(", "))));
    }
}

int reportFacets(const Error &error, const QString &file)
{
    if (error.code == ErrorCode::BadValue && error.place == "thickness" && error.args.size() == 2) {
        printError(tr("A sheet of %1 mm does not fold, expected at most %2 mm; --stock chooses "
                      "another.")
                       .arg(QString::fromStdString(error.args[0]).toDouble())
                       .arg(QString::fromStdString(error.args[1]).toDouble()));
        return BadInput;
    }
    if (error.code == ErrorCode::BadCount && error.args.size() == 2)
        printError(tr("%1: it has %2 flat pieces, expected at most %3; --faces "
                      "makes them fewer.")
                       .arg(file, QString::fromStdString(error.args[0]),
                            QString::fromStdString(error.args[1])));
    else if (error.code == ErrorCode::EmptyContour)
        printError(tr("%1: no flat piece of it is large enough for a section; "
                      "--size makes it larger.")
                       .arg(file));
    else
        return report(error, file);
    return BadInput;
}

int writeNets(const MeshModel &started, std::optional<std::size_t> faces, double flap,
              const QCommandLineParser &parser)
{
    const TemplateId of = started.document.templates.front()->id;
    const Result<NetModel> model = unfolded(started.document, of, faces, flap);
    if (!model)
        return reportFacets(model.error(), parser.positionalArguments().first());
    printError(tr("Nets: %1, folds: %2, seams: %3")
                   .arg(model->sections.size())
                   .arg(model->folds)
                   .arg(model->seams));
    return writeMeshModel(*removeTemplate(model->document, of), parser);
}

} // namespace

int runFacets(const QStringList &arguments)
{
    QCommandLineParser parser;
    addMeshModelOptions(parser);
    parser.addOption({QStringLiteral("faces"),
                      tr("Simplifies the mesh to this many triangles first; "
                         "those that are flat "
                         "together are one piece."),
                      QStringLiteral("N")});
    parser.addOption({QStringLiteral("unfold"),
                      tr("Nets to fold along scored lines, of sheet up to 3 mm, instead of flat "
                         "sheets.")});
    parser.addOption({QStringLiteral("flap"),
                      tr("With --unfold: width of the flaps to glue; 8 mm for sheet up to 1.5 mm, "
                         "else 0 mm."),
                      QStringLiteral("MM")});
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("facets");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const std::optional<int> faces =
        wholeNumber(parser, verb, "faces", int(kFewestFaces), int(kMostFacets), status);
    const std::optional<double> wanted = number(parser, verb, "flap", 0.0, status, kMostFlap);
    if (status)
        return *status;
    if (wanted && !parser.isSet(QStringLiteral("unfold")))
        return wrongUse(verb, tr("--flap is of --unfold."));
    MeshModel started = readMeshModel(parsed.files.first(), parser, verb);
    if (started.status)
        return *started.status;
    const QString file = parsed.files.first();
    const TemplateId of = started.document.templates.front()->id;
    const std::optional<std::size_t> few =
        faces ? std::optional(static_cast<std::size_t>(*faces)) : std::nullopt;
    const Stock &stock = *started.document.find(started.document.currentStock);
    if (parser.isSet(QStringLiteral("unfold")))
        return writeNets(started, few, wanted.value_or(usualFlap(stock)), parser);
    const Result<FacetModel> model = facetted(started.document, of, few);
    if (!model)
        return reportFacets(model.error(), file);
    if (model->tooSmall > 0)
        printError(tr("Pieces too small for a section: %1").arg(model->tooSmall));
    printBare(*model);
    printError(tr("Sections: %1, joints: %2").arg(model->sections.size()).arg(model->joints));
    return writeMeshModel(*removeTemplate(model->document, of), parser);
}

} // namespace fff::cli
