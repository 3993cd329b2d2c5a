#include "ui/files/mesh_import.h"

#include "core/base/tolerances.h"
#include "core/io/error_text.h"
#include "core/io/mesh_formats.h"
#include "core/io/template_file.h"
#include "core/session/message_text.h"
#include "core/session/session.h"
#include "core/session/template_commands.h"
#include "ui/base/lengths.h"
#include "ui/bench/workbench.h"
#include "ui/files/clipboard_picture.h"
#include "ui/files/progress.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

namespace fff::ui {

namespace {

struct MeshTexts
{
    Q_DECLARE_TR_FUNCTIONS(fff::ui::MeshImport)
};

/// An SVG that is dropped becomes sections; as a template it is asked for.
const QString kFlatPatterns = QStringLiteral("*.png *.jpg *.jpeg *.webp *.svg");

QString remarksOf(const std::vector<Message> &messages)
{
    QStringList lines;
    for (const Message &message : messages)
        lines += messageText(message);
    return lines.join(QLatin1Char(' '));
}

using ReadTemplate =
    std::function<Result<io::LoadedTemplate>(const io::TemplateFileOptions &options)>;

/// Nothing where it was given up.
std::optional<Result<io::LoadedTemplate>> readInBackground(QWidget &window, const QString &name,
                                                           ReadTemplate read)
{
    std::stop_source stop;
    const auto share = std::make_shared<std::atomic<double>>(-1.0);
    auto loaded = inBackground<Result<io::LoadedTemplate>>(
        window, MeshTexts::tr("Reading %1…").arg(name), MayCancel::Yes,
        [read = std::move(read), token = stop.get_token(), share] {
            io::TemplateFileOptions options;
            options.work.stop = token;
            options.work.progress = [share](double done) { share->store(done); };
            return read(options);
        },
        share);
    if (!loaded)
        stop.request_stop();
    return loaded;
}

/// The last one besides of which nobody knows the unit either; null where there is none, or the two
/// are at the same scale.
TemplatePointer otherUnscaled(const Document &document, const Template &one)
{
    constexpr double kSame = 1e-9; // of a scale
    for (auto other = document.templates.rbegin(); other != document.templates.rend(); ++other)
        if ((*other)->id != one.id && (*other)->mesh && !(*other)->mesh->mesh->unit())
            return std::abs((*other)->scale - one.scale) > kSame * one.scale ? *other : nullptr;
    return nullptr;
}

/// What was drawn together may come in several files, and belongs together still.
void offerScale(Workbench &bench, MeshImported &imported)
{
    const Document &document = bench.session().committed().document;
    const TemplatePointer one = document.templates.back();
    const TemplatePointer other = otherUnscaled(document, *one);
    if (!other)
        return;
    const double size = other->scale * one->mesh->mesh->size();
    if (!(size <= kMaxCoordinate))
        return;
    //: a button; %1 is the name of a mesh
    imported.likeOther = MeshTexts::tr("Scale it like %1").arg(QString::fromStdString(other->name));
    imported.takeScale = [&bench, name = one->name, size] {
        bench.run(QStringLiteral("template.set"),
                  {{"template", name}, {"size", QString::number(size, 'g', 17).toStdString()}});
        bench.run(QStringLiteral("view.fitAll"));
    };
}

MeshImported importTemplate(QWidget &window, Workbench &bench, const QString &name,
                            ReadTemplate read)
{
    const auto loaded = readInBackground(window, name, std::move(read));
    if (!loaded)
        return {};
    if (!*loaded)
        return {.error = io::errorText(loaded->error())};
    auto added = addedTemplate(bench.session().committed().document, **loaded);
    if (!added)
        return {.error = io::errorText(added.error())};
    bench.editSections(*std::move(added));
    const Template &made = (*loaded)->made;
    MeshImported imported{.isAdded = true, .remarks = remarksOf((*loaded)->messages)};
    if (!made.mesh)
        return imported;
    const QString size = lengthText(made.scale * made.mesh->mesh->size(), 1, 1, QLocale());
    if (made.mesh->mesh->unit() && made.scale != 1.0)
        //: %1 is the name of a file, %2 a length
        imported.sized = MeshTexts::tr("%1 is too large for a model, so it was scaled to %2. Its "
                                       "size can be changed under Templates.")
                             .arg(name, size);
    else if (!made.mesh->mesh->unit())
        //: %1 is the name of a file, %2 a length
        imported.sized = MeshTexts::tr("%1 does not say its unit, so it was scaled to %2. Its size "
                                       "can be changed under Templates.")
                             .arg(name, size);
    if (!made.mesh->mesh->unit())
        offerScale(bench, imported);
    return imported;
}

} // namespace

QString meshFilter()
{
    const QString all = io::meshPatterns() + QLatin1Char(' ') + kFlatPatterns;
    //: %1 is a list of patterns such as *.stl
    return MeshTexts::tr("Meshes, pictures and drawings (%1)").arg(all) + QStringLiteral(";;") +
           MeshTexts::tr("All files (*)");
}

bool isMeshFile(const QString &path)
{
    const QString suffix = QStringLiteral("*.") + QFileInfo(path).suffix().toLower();
    return io::meshPatterns().split(QLatin1Char(' ')).contains(suffix) ||
           (kFlatPatterns.split(QLatin1Char(' ')).contains(suffix));
}

MeshImported importMesh(QWidget &window, Workbench &bench, const QString &path)
{
    return importTemplate(window, bench, QFileInfo(path).fileName(),
                          [path](const io::TemplateFileOptions &options) {
                              return io::readTemplateFile(path, options);
                          });
}

MeshImported refillTemplate(QWidget &window, Workbench &bench, TemplateId id, const QString &path,
                            bool isByReference)
{
    const auto loaded = readInBackground(window, QFileInfo(path).fileName(),
                                         [path, isByReference](io::TemplateFileOptions options) {
                                             options.isByReference = isByReference;
                                             return io::readTemplateFile(path, options);
                                         });
    if (!loaded)
        return {};
    if (!*loaded)
        return {.error = io::errorText(loaded->error())};
    auto refilled = refilledTemplate(bench.session().committed().document, id, **loaded);
    if (!refilled)
        return {.error = io::errorText(refilled.error())};
    bench.editSections(*std::move(refilled));
    return {.isAdded = true, .remarks = remarksOf((*loaded)->messages)};
}

MeshImported importPicture(QWidget &window, Workbench &bench, const ClipboardPicture &picture)
{
    if (!picture.path.isEmpty())
        return importMesh(window, bench, picture.path);
    const QString name = MeshTexts::tr("Pasted picture");
    return importTemplate(
        window, bench, name,
        [picture, name = name.toStdString()](
            const io::TemplateFileOptions &options) -> Result<io::LoadedTemplate> {
            Result<std::string> bytes = bytesOf(picture, name);
            if (!bytes)
                return tl::unexpected(std::move(bytes.error()));
            return io::readTemplateBytes(*std::move(bytes), name, options);
        });
}

} // namespace fff::ui
