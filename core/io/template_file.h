// Files that sections are drawn after, as templates of a document; and what their bytes are, when a
// document comes back.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/templates/template_mesh.h"

#include <QtCore/QString>

namespace fff::io {

struct TemplateFileOptions
{
    bool isByReference = false;    // its bytes stay where they are
    std::optional<UpAxis> up = {}; // none: as is usual in such files
    double size = 0.0;             // mm; 0: as its file says, else kTemplateSize
    std::size_t mostTriangles = kMostTriangles;
    LongWork work = {};
};

/// What adds it to a document: addBlob(), where there is one, then addTemplate().
struct LoadedTemplate
{
    Template made;
    BlobPointer blob; // null by reference
    /// Errors  those of addTemplate().
    Result<Document> addedTo(Document document) const;
};

/// Errors  CannotOpen; those of the readers (mesh_formats.h); BadCount, above mostTriangles.
Result<LoadedTemplate> readTemplateFile(const QString &path, const TemplateFileOptions &options);

/// The mesh of a template from its blob, or from its file. Errors  CannotOpen, place = the file, or
/// BadArchive where the blob is missing; those of the readers.
Result<TemplateMeshPointer> readTemplateMesh(const Template &one, const Document &document,
                                             const LongWork &work = {});

/// All meshes of the document that are not there yet, each once. What cannot be read stays a
/// template without a mesh, with a warning.
Document withTemplateMeshes(Document document, std::vector<Warning> &warnings,
                            const LongWork &work = {});

} // namespace fff::io
