// The loops in which a plane cuts a mesh, and what was wrong with the mesh.
#include "app/cli/command_line.h"
#include "core/io/json_writer.h"
#include "core/io/mesh_file.h"
#include "core/session/message_text.h"
#include "core/templates/placed_mesh.h"
#include "core/templates/plane_cut.h"

namespace fff::cli {

namespace {

using io::JsonWriter;

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// "0,0,10,0,0,1": a point and a normal.
std::optional<CutPlane> planeOf(const QString &text)
{
    const QStringList words = text.split(u',');
    std::array<double, 6> numbers{};
    if (words.size() != std::ssize(numbers))
        return std::nullopt;
    for (qsizetype i = 0; i < words.size(); ++i) {
        bool isNumber = false;
        numbers[static_cast<std::size_t>(i)] = words[i].toDouble(&isNumber);
        if (!isNumber)
            return std::nullopt;
    }
    const Result<CutPlane> plane =
        makeCutPlane({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]});
    return plane ? std::optional(*plane) : std::nullopt;
}

/// What was mended in the mesh, then what was closed in the cut.
std::vector<Message> reportOf(const MeshReport &mesh, const PlaneCut &cut)
{
    std::vector<Message> messages = mesh.messages();
    for (Message &message : cut.messages())
        messages.push_back(std::move(message));
    return messages;
}

std::string cutJson(const PlaneCut &cut, const std::vector<Message> &messages)
{
    JsonWriter json;
    json.beginObject();
    json.key("loops");
    json.beginArray();
    for (const CutLoop &loop : cut.loops) {
        json.beginObject();
        json.key("points");
        json.beginArray();
        for (const Vec3 &p : loop.points)
            json.value(p);
        json.endArray();
        json.member("closed", loop.isClosed());
        json.member("hole", loop.isHole);
        json.member("area", loop.area);
        json.endObject();
    }
    json.endArray();
    json.member("area", cut.area());
    json.key("plane");
    json.beginObject();
    json.member("origin", cut.plane.origin);
    json.member("normal", cut.plane.normal);
    json.endObject();
    json.key("report");
    json.beginArray();
    for (const Message &message : messages)
        json.value(messageText(message).toStdString());
    json.endArray();
    json.endObject();
    return json.take();
}

QStringList cutText(const PlaneCut &cut, const std::vector<Message> &messages,
                    const io::LoadedMesh &loaded)
{
    QStringList lines;
    lines += tr("Faces: %1, shells: %2")
                 .arg(QString::number(loaded.mesh->triangles().size()),
                      QString::number(loaded.report.shells));
    if (cut.loops.empty())
        lines += tr("The plane does not cut it.");
    for (const CutLoop &loop : cut.loops) {
        const QString area = QString::number(loop.area, 'f', 2);
        const QString points = QString::number(loop.points.size());
        lines += (loop.isHole ? tr("Hole: %1 mm², %2 points") : tr("Loop: %1 mm², %2 points"))
                     .arg(area, points);
    }
    if (!cut.loops.empty())
        lines += tr("Area: %1 mm²").arg(QString::number(cut.area(), 'f', 2));
    for (const Message &message : messages)
        lines += messageText(message);
    return lines;
}

} // namespace

int runCut(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.addOption({QStringLiteral("plane"),
                      tr("A point of the plane and its normal, six numbers with commas."),
                      QStringLiteral("OX,OY,OZ,NX,NY,NZ")});
    parser.addOption(
        {QStringLiteral("size"),
         tr("Scales the mesh to this largest extent and stands it on the ground first."),
         QStringLiteral("MM")});
    parser.addOption({QStringLiteral("json"), tr("Prints JSON, for other programs.")});
    const Verb &verb = verbNamed("cut");
    const Arguments parsed = parse(parser, verb, arguments, 1);
    if (parsed.status)
        return *parsed.status;
    if (!parser.isSet(QStringLiteral("plane")))
        return wrongUse(verb, tr("--plane is missing."));
    const QString asked = parser.value(QStringLiteral("plane"));
    const std::optional<CutPlane> plane = planeOf(asked);
    if (!plane)
        return wrongUse(verb, tr("--plane: found \"%1\", expected six numbers, of which the last "
                                 "three are a direction.")
                                  .arg(asked));
    std::optional<int> status;
    constexpr double kLeastSize = 0.001; // mm
    const std::optional<double> size = number(parser, verb, "size", kLeastSize, status);
    if (status)
        return *status;
    const Result<io::LoadedMesh> loaded = io::readMesh(parsed.files.first());
    if (!loaded)
        return report(loaded.error());
    const TriangleMeshPointer mesh = size ? placedMesh(*loaded->mesh, *size) : loaded->mesh;
    const PlaneCut cut = planeCut(*mesh, *plane);
    const std::vector<Message> messages = reportOf(loaded->report, cut);
    return parser.isSet(QStringLiteral("json")) ? print(cutJson(cut, messages))
                                                : printLines(cutText(cut, messages, *loaded));
}

} // namespace fff::cli
