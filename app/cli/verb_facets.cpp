// A mesh of few faces as a box of flat sheets with fingers along their edges.
#include "app/cli/mesh_options.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/facet_model.h"
#include "core/templates/simplified_mesh.h"
#include "core/templates/template_mesh.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff::cli {

namespace {

constexpr int kFewestFaces = 4; // of what encloses anything

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// As the template lies in the world, outwards.
TriangleMeshPointer inWorld(const Template &one)
{
    const TriangleMesh &mesh = *one.mesh->mesh;
    const Similarity placement = worldPlacement(one, *one.mesh);
    std::vector<Vec3> positions;
    positions.reserve(mesh.positions().size());
    for (const Vec3 &p : mesh.positions())
        positions.push_back(placement(p));
    std::vector<Triangle> triangles = mesh.triangles();
    if (mesh.volume() < 0.0)
        for (Triangle &triangle : triangles)
            std::swap(triangle[1], triangle[2]);
    return std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles), 1.0);
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

/// Down to the ground: corners of sheets end before those of the mesh.
Document onTheGround(const Document &document)
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(document), caches);
    double lowest = std::numeric_limits<double>::infinity();
    for (const Body &body : analysis.bodies)
        lowest = std::min(lowest, body.box().min.y());
    return std::isfinite(lowest) ? moveAll(document, Vec3(0.0, -lowest, 0.0)) : document;
}

int reportFacets(const Error &error, const QString &file)
{
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
    addDocumentOptions(parser);
    const Verb &verb = verbNamed("facets");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    std::optional<int> status;
    const std::optional<int> faces =
        wholeNumber(parser, verb, "faces", kFewestFaces, int(kMostFacets), status);
    if (status)
        return *status;
    MeshModel started = readMeshModel(parsed.files.first(), parser, verb);
    if (started.status)
        return *started.status;
    const QString file = parsed.files.first();
    const TemplatePointer drawn = started.document.templates.front();
    Result<TriangleMeshPointer> mesh = inWorld(*drawn);
    if (faces)
        mesh = simplified(*mesh, static_cast<std::size_t>(*faces))
                   .map([&](const TriangleMeshPointer &few) { // as large, and on the ground again
                       return placedMesh(*few, (*mesh)->size());
                   });
    if (!mesh)
        return report(mesh.error(), file);
    Document document = *removeTemplate(std::move(started.document), drawn->id);
    const Result<FacetModel> model = facetModel(std::move(document), **mesh, drawn->name);
    if (!model)
        return reportFacets(model.error(), file);
    if (model->tooSmall > 0)
        printError(tr("Pieces too small for a section: %1").arg(model->tooSmall));
    printBare(*model);
    printError(tr("Sections: %1, joints: %2").arg(model->sections.size()).arg(model->joints));
    return writeMeshModel(onTheGround(model->document), parser);
}

} // namespace fff::cli
