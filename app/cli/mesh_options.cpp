#include "app/cli/mesh_options.h"

#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/io/template_file.h"
#include "core/session/message_text.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <cmath>

namespace fff::cli {

namespace {

constexpr double kLeastMeshSize = 0.001; // mm

QString tr(const char *text)
{
    return QCoreApplication::translate("CommandLine", text);
}

/// "ball.stl@80": a file and how large it is to be, mm; 0: as its file says.
struct NamedMesh
{
    QString file;
    double size = 0.0;
};

/// A file may have an @ in its name. Nothing where what stands behind it is no size.
std::optional<NamedMesh> namedMesh(const QString &text)
{
    const qsizetype at = text.lastIndexOf(u'@');
    if (at < 0 || QFileInfo::exists(text))
        return NamedMesh{text, 0.0};
    bool isNumber = false;
    const double size = text.mid(at + 1).toDouble(&isNumber);
    if (!isNumber || !(size >= kLeastMeshSize && size <= kMaxCoordinate))
        return std::nullopt;
    return NamedMesh{text.left(at), size};
}

/// Puts it into the document, and says what was wrong with it, or is not shown.
Result<void> addTemplateFile(Document &document, const NamedMesh &mesh)
{
    io::TemplateFileOptions options;
    options.size = mesh.size;
    const Result<io::LoadedTemplate> loaded = io::readTemplateFile(mesh.file, options);
    if (!loaded)
        return tl::unexpected(loaded.error());
    for (const Message &message : loaded->messages)
        printError(tr("%1: %2").arg(QFileInfo(mesh.file).fileName(), messageText(message)));
    Result<Document> next = loaded->addedTo(std::move(document));
    if (!next)
        return tl::unexpected(std::move(next.error()));
    document = *std::move(next);
    return {};
}

/// Why nothing can be written there; else empty.
QString whyNoModelFile(const QCommandLineParser &parser)
{
    if (!parser.isSet(QStringLiteral("output")))
        return tr("-o is missing: give the file to write.");
    const QString output = parser.value(QStringLiteral("output"));
    if (output.isEmpty())
        return tr("-o: a file needs a name.");
    if (output != QStringLiteral("-") &&
        QFileInfo(output).suffix().toLower() != QStringLiteral("fff"))
        return tr("%1: this kind of file cannot be written; expected %2.")
            .arg(output, QStringLiteral(".fff"));
    return {};
}

} // namespace

void addTemplateOption(QCommandLineParser &parser)
{
    parser.addOption({QStringLiteral("template"),
                      tr("Puts a mesh, a picture or a drawing (SVG) beside the model, its largest "
                         "extent of this size in mm; may be given several times."),
                      QStringLiteral("TEMPLATE[@SIZE]")});
}

std::optional<int> addTemplates(Document &document, const QCommandLineParser &parser,
                                const Verb &verb)
{
    for (const QString &text : parser.values(QStringLiteral("template"))) {
        const std::optional<NamedMesh> mesh = namedMesh(text);
        if (!mesh)
            return wrongUse(verb, tr("--template: found \"%1\", expected a file, or a file and its "
                                     "size in mm, such as ball.stl@80.")
                                      .arg(text));
        if (const Result<void> added = addTemplateFile(document, *mesh); !added)
            return report(added.error());
    }
    return std::nullopt;
}

void addMeshModelOptions(QCommandLineParser &parser)
{
    parser.addOption({{QStringLiteral("o"), QStringLiteral("output")},
                      tr("The .fff file to write; - is standard output."),
                      QStringLiteral("OUT")});
    parser.addOption({QStringLiteral("size"),
                      tr("Scales the mesh to this largest extent; without it as large as its file "
                         "says, else 254."),
                      QStringLiteral("MM")});
}

MeshModel readMeshModel(const QString &file, const QCommandLineParser &parser, const Verb &verb)
{
    MeshModel model;
    if (const QString reason = whyNoModelFile(parser); !reason.isEmpty()) {
        model.status = wrongUse(verb, reason);
        return model;
    }
    const std::optional<double> size = number(parser, verb, "size", kLeastMeshSize, model.status);
    if (model.status)
        return model;
    const std::optional<DocumentOptions> options = documentOptions(parser, verb, model.status);
    if (!options)
        return model;
    model.document = newDocument();
    model.status = applyOptions(model.document, *options, verb);
    if (model.status)
        return model;
    const Result<void> added = addTemplateFile(model.document, {file, size.value_or(0.0)});
    if (!added)
        model.status = report(added.error());
    else if (model.document.templates.front()->kind != TemplateKind::Mesh)
        model.status = report(Error{ErrorCode::BadSyntax,
                                    QFileInfo(file).fileName().toStdString(),
                                    {"", QT_TRANSLATE_NOOP("Error", "a mesh: this is flat")}});
    return model;
}

int writeMeshModel(const Document &document, const QCommandLineParser &parser)
{
    const QString path = parser.value(QStringLiteral("output"));
    const Result<void> written =
        io::modelBytes(document, path.toStdString(), *io::formatWritten(QStringLiteral("fff")), {})
            .and_then([&](const std::string &bytes) { return io::writeFile(path, bytes); });
    return written ? Done : report(written.error());
}

std::optional<int> wholeNumber(const QCommandLineParser &parser, const Verb &verb,
                               const char *option, int least, int most, std::optional<int> &status)
{
    const QString name = QLatin1String(option);
    if (!parser.isSet(name))
        return std::nullopt;
    bool isNumber = false;
    const int value = parser.value(name).toInt(&isNumber);
    if (isNumber && value >= least && value <= most)
        return value;
    status = wrongUse(
        verb, tr("--%1: found \"%2\", expected a whole number from %3 to %4.")
                  .arg(name, parser.value(name), QString::number(least), QString::number(most)));
    return std::nullopt;
}

} // namespace fff::cli
