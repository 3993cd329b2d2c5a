#include "core/io/template_file.h"

#include "core/base/tolerances.h"
#include "core/io/blobs.h"
#include "core/io/compressed.h"
#include "core/io/document_file.h"
#include "core/io/formats.h"
#include "core/io/loaded_document.h"
#include "core/io/mesh_file.h"
#include "core/io/picture_file.h"
#include "core/io/picture_header.h"
#include "core/io/ply_writer.h"
#include "core/io/svg_format.h"
#include "core/io/svg_reader.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"
#include "core/templates/flat_template.h"
#include "core/templates/template_curves.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>

#include <map>

namespace fff::io {

namespace {

/// Drawings of parts and prints have Z upwards, what comes from modellers for pictures has Y.
UpAxis usualUpAxis(const MeshFormat &format)
{
    const std::string_view key = format.key;
    return key == "stl" || key == "3mf" ? UpAxis::Z : UpAxis::Y;
}

/// The bytes that were read; of a format that may be spread over several files the mesh as one.
BlobPointer blobOf(LoadedMesh &mesh, const std::string &name)
{
    const bool isSpread = mesh.format == &gltfMeshFormat();
    const MeshFormat &format = isSpread ? plyMeshFormat() : *mesh.format;
    std::string bytes = isSpread ? plyBytes(*mesh.mesh) : std::move(mesh.bytes);
    return makeBlob(std::move(bytes), std::string("model/") + format.key, name);
}

/// Of how many bytes kinds are told.
constexpr qint64 kTellingBytes = 4096;

//: of a picture
constexpr Text kAnimated = FFF_TEXT("Template", "It moves; only its first picture is shown.");
//: of a drawing
constexpr Text kTextsLeft = FFF_TEXT_OF_MANY("Template", "%n texts were left out.");
//: of a drawing
constexpr Text kPicturesLeft = FFF_TEXT_OF_MANY("Template", "%n pictures were left out.");

TemplateKind kindOf(std::string_view head)
{
    if (looksLikePicture(head))
        return TemplateKind::Picture;
    return svgFormat().recognises(head) ? TemplateKind::Curves : TemplateKind::Mesh;
}

/// What a template shows, and what is said of it.
struct Content
{
    Template one; // with it, and as large as the file says; scale 0: the file does not say
    std::string mediaType;
    std::vector<Message> messages;
};

Result<Content> pictureContent(std::string_view bytes, const std::string &name, Template one,
                               std::int64_t mostPixels, const LongWork &work)
{
    Result<LoadedPicture> loaded = readPicture(bytes, name, mostPixels, work);
    if (!loaded)
        return tl::unexpected(std::move(loaded.error()));
    one.picture = std::move(loaded->picture);
    one.scale = loaded->millimetresPerPixel;
    Content content{std::move(one), loaded->mediaType, {}};
    if (loaded->isAnimated)
        content.messages.push_back({kAnimated, {}});
    return content;
}

Result<Content> curvesContent(std::string_view bytes, const std::string &name, Template one)
{
    const Result<SvgDrawing> drawing = svgFormat().readDrawing(bytes, name);
    if (!drawing)
        return tl::unexpected(drawing.error());
    std::vector<CurvePath> lines;
    for (const SvgDrawing::Line &line : drawing->lines)
        lines.push_back(line.path);
    Result<TemplateCurvesPointer> curves = makeTemplateCurves(std::move(lines));
    if (!curves)
        return failure(curves.error().code, name, curves.error().args);
    one.curves = *std::move(curves);
    one.scale = 1.0;
    Content content{
        std::move(one), isCompressed(bytes) ? "image/svg+xml+gzip" : "image/svg+xml", {}};
    if (drawing->texts > 0)
        content.messages.push_back({kTextsLeft, {}, drawing->texts});
    if (drawing->pictures > 0)
        content.messages.push_back({kPicturesLeft, {}, drawing->pictures});
    return content;
}

Result<Content> flatContent(std::string_view bytes, const std::string &name, Template one,
                            std::int64_t mostPixels, const LongWork &work)
{
    return one.kind == TemplateKind::Picture
               ? pictureContent(bytes, name, std::move(one), mostPixels, work)
               : curvesContent(bytes, name, std::move(one));
}

/// As what is flat comes in.
Result<LoadedTemplate> loadedFlat(std::string bytes, Template made, const std::string &fileName,
                                  const TemplateFileOptions &options)
{
    Result<Content> content =
        flatContent(bytes, fileName, std::move(made), kMostPicturePixels, options.work);
    if (!content)
        return tl::unexpected(std::move(content.error()));
    LoadedTemplate loaded;
    loaded.messages = std::move(content->messages);
    made = std::move(content->one);
    made.opacity = kPictureOpacity;
    const double extent = flatExtent(made).maxCoeff();
    if (options.size > 0.0)
        made = sizedTo(std::move(made), options.size);
    else if (!(made.scale > 0.0) || made.scale * extent > kMaxCoordinate)
        made = sizedTo(std::move(made), kTemplateSize);
    loaded.made = laidOn(std::move(made), StandardPlane::Front);
    if (!options.isByReference) {
        loaded.blob = makeBlob(std::move(bytes), std::move(content->mediaType), fileName);
        loaded.made.blob = loaded.blob->sha256;
    }
    return loaded;
}

Result<LoadedTemplate> readMeshFile(const QString &path, Template made, const std::string &fileName,
                                    const TemplateFileOptions &options)
{
    MeshOptions reading;
    reading.name = fileName;
    reading.mostTriangles = options.mostTriangles;
    reading.work = options.work;
    Result<LoadedMesh> mesh = readMesh(path, reading);
    if (!mesh)
        return tl::unexpected(std::move(mesh.error()));
    const UpAxis up = options.up.value_or(usualUpAxis(*mesh->format));
    LoadedTemplate loaded;
    if (!options.isByReference)
        loaded.blob = blobOf(*mesh, reading.name);
    Result<TemplateMeshPointer> ready =
        makeTemplateMesh(std::move(mesh->mesh), std::move(mesh->report), options.work);
    if (!ready)
        return tl::unexpected(std::move(ready.error()));
    loaded.messages = (*ready)->report.messages();
    made.blob = loaded.blob ? loaded.blob->sha256 : std::string();
    made.mesh = *std::move(ready);
    loaded.made = stood(made, *made.mesh, up, options.size);
    return loaded;
}

/// By the first bytes of a file; a pipe, which has them once, is a mesh.
TemplateKind kindOfFile(const QString &path)
{
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly))
        return TemplateKind::Mesh;
    return kindOf(file.read(kTellingBytes).toStdString());
}

Result<Template> readTemplateMesh(Template one, const Document &document, const LongWork &work)
{
    MeshOptions reading;
    reading.work = work;
    Result<LoadedMesh> mesh = failure(ErrorCode::BadArchive);
    if (const Blob *blob = document.findBlob(one.blob)) {
        reading.name = blob->name;
        mesh = readMeshBytes(*blob->bytes, reading);
    } else {
        mesh = readMesh(QString::fromStdString(one.file), reading);
    }
    if (!mesh)
        return tl::unexpected(std::move(mesh.error()));
    Result<TemplateMeshPointer> ready =
        makeTemplateMesh(std::move(mesh->mesh), std::move(mesh->report), work);
    if (!ready)
        return tl::unexpected(std::move(ready.error()));
    one.mesh = *std::move(ready);
    return one;
}

} // namespace

Result<Document> LoadedTemplate::addedTo(Document document) const
{
    if (blob)
        document = addBlob(std::move(document), blob);
    return addTemplate(std::move(document), made);
}

Result<LoadedTemplate> readTemplateFile(const QString &path, const TemplateFileOptions &options)
{
    const QFileInfo file(path);
    const std::string fileName = file.fileName().toStdString();
    Template made;
    made.kind = kindOfFile(path);
    made.name = file.completeBaseName().toStdString();
    made.file = options.isByReference ? file.absoluteFilePath().toStdString() : fileName;
    if (made.kind == TemplateKind::Mesh)
        return readMeshFile(path, std::move(made), fileName, options);
    Result<std::string> bytes = readFile(path, fileName);
    if (!bytes)
        return tl::unexpected(std::move(bytes.error()));
    return loadedFlat(*std::move(bytes), std::move(made), fileName, options);
}

Result<LoadedTemplate> readTemplateBytes(std::string bytes, const std::string &name,
                                         const TemplateFileOptions &options)
{
    Template made;
    made.kind = kindOf(bytes);
    made.name = made.file = name;
    if (made.kind == TemplateKind::Mesh)
        return failure(ErrorCode::BadSyntax, name,
                       {io::quoted(std::string_view(bytes)),
                        QT_TRANSLATE_NOOP("Error", "a picture or a drawing")});
    TemplateFileOptions kept = options;
    kept.isByReference = false; // there is nothing to refer to
    return loadedFlat(std::move(bytes), std::move(made), name, kept);
}

Result<Template> readTemplateContent(Template one, const Document &document,
                                     std::int64_t mostPixels, const LongWork &work)
{
    const Blob *blob = document.findBlob(one.blob);
    if (!blob && !one.blob.empty())
        return failure(ErrorCode::BadArchive, one.name,
                       {QT_TRANSLATE_NOOP("Error", "its data is missing")});
    if (one.kind == TemplateKind::Mesh)
        return readTemplateMesh(std::move(one), document, work);
    Result<std::string> read;
    if (!blob)
        read = readFile(QString::fromStdString(one.file));
    if (!read)
        return tl::unexpected(std::move(read.error()));
    const std::string name = blob ? blob->name : one.file;
    const double scale = one.scale;
    Result<Content> content =
        flatContent(blob ? *blob->bytes : *read, name, std::move(one), mostPixels, work);
    if (!content)
        return tl::unexpected(std::move(content.error()));
    content->one.scale = scale;
    return std::move(content->one);
}

Document withTemplateContents(Document document, std::vector<Warning> &warnings,
                              const LongWork &work)
{
    // Several templates of one file share what it shows.
    std::map<std::pair<TemplateKind, std::string>, Template> known;
    std::int64_t pixelsLeft = kMostPixelsOfAll;
    for (TemplatePointer &pointer : document.templates) {
        if (pointer->isRead() || work.isStopped())
            continue;
        const std::string source = pointer->blob.empty() ? pointer->file : pointer->blob;
        auto found = known.find({pointer->kind, source});
        if (found == known.end()) {
            Result<Template> read = readTemplateContent(
                *pointer, document, std::min(pixelsLeft, kMostPicturePixels), work);
            if (!read && read.error().code != ErrorCode::Cancelled)
                warnings.push_back({WarningCode::MissingTemplate, {}, {pointer->name}});
            if (read && read->picture)
                pixelsLeft -= read->picture->pixels();
            found =
                known
                    .emplace(std::pair(pointer->kind, source), read ? *std::move(read) : Template())
                    .first;
        }
        if (!found->second.isRead())
            continue;
        Template next = *pointer;
        next.mesh = found->second.mesh;
        next.picture = found->second.picture;
        next.curves = found->second.curves;
        pointer = std::make_shared<const Template>(std::move(next));
    }
    return document;
}

} // namespace fff::io
