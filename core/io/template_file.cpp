#include "core/io/template_file.h"

#include "core/io/blobs.h"
#include "core/io/document_file.h"
#include "core/io/mesh_file.h"
#include "core/io/ply_writer.h"
#include "core/model/edits.h"
#include "core/model/template_edits.h"

#include <QtCore/QCoreApplication>
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
    MeshOptions reading;
    reading.name = file.fileName().toStdString();
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
    Template made;
    made.name = file.completeBaseName().toStdString();
    made.blob = loaded.blob ? loaded.blob->sha256 : std::string();
    made.file = (options.isByReference ? file.absoluteFilePath() : file.fileName()).toStdString();
    made.mesh = *std::move(ready);
    loaded.made = stood(made, *made.mesh, up, options.size);
    return loaded;
}

Result<TemplateMeshPointer> readTemplateMesh(const Template &one, const Document &document,
                                             const LongWork &work)
{
    MeshOptions reading;
    reading.work = work;
    Result<LoadedMesh> mesh = failure(ErrorCode::BadArchive, one.name,
                                      {QT_TRANSLATE_NOOP("Error", "its data is missing")});
    if (const Blob *blob = document.findBlob(one.blob)) {
        reading.name = blob->name;
        mesh = readMeshBytes(*blob->bytes, reading);
    } else if (one.blob.empty()) {
        mesh = readMesh(QString::fromStdString(one.file), reading);
    }
    if (!mesh)
        return tl::unexpected(std::move(mesh.error()));
    return makeTemplateMesh(std::move(mesh->mesh), std::move(mesh->report), work);
}

Document withTemplateMeshes(Document document, std::vector<Warning> &warnings, const LongWork &work)
{
    // Several templates of one file are one mesh.
    std::map<std::string, TemplateMeshPointer> known;
    for (TemplatePointer &pointer : document.templates) {
        if (pointer->kind != TemplateKind::Mesh || pointer->mesh || work.isStopped())
            continue;
        const std::string source = pointer->blob.empty() ? pointer->file : pointer->blob;
        auto found = known.find(source);
        if (found == known.end()) {
            Result<TemplateMeshPointer> mesh = readTemplateMesh(*pointer, document, work);
            if (!mesh) {
                if (mesh.error().code != ErrorCode::Cancelled)
                    warnings.push_back({WarningCode::MissingTemplate, {}, {pointer->name}});
                found = known.emplace(source, nullptr).first;
            } else {
                found = known.emplace(source, *std::move(mesh)).first;
            }
        }
        if (!found->second)
            continue;
        Template next = *pointer;
        next.mesh = found->second;
        pointer = std::make_shared<const Template>(std::move(next));
    }
    return document;
}

} // namespace fff::io
