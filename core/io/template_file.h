// Files that sections are drawn after, as templates of a document; and what their bytes are, when a
// document comes back.
#pragma once

#include "core/base/long_work.h"
#include "core/base/result.h"
#include "core/model/document.h"
#include "core/templates/template_mesh.h"
#include "core/templates/template_picture.h"

#include <QtCore/QString>

namespace fff::io {

struct TemplateFileOptions
{
    bool isByReference = false;    // its bytes stay where they are
    std::optional<UpAxis> up = {}; // of a mesh; none: as is usual in such files
    double size = 0.0;             // mm; 0: as its file says, else kTemplateSize
    std::size_t mostTriangles = kMostTriangles;
    LongWork work = {};
};

/// What adds it to a document: addBlob(), where there is one, then addTemplate().
struct LoadedTemplate
{
    Template made;
    BlobPointer blob; // null by reference
    /// What in it was mended, or is not shown.
    std::vector<Message> messages;
    /// Errors  those of addTemplate().
    Result<Document> addedTo(Document document) const;
};

/// What the file is is told by its first bytes: a picture (picture_file.h), a drawing (SVG) or a
/// mesh. What is flat stands in the plane of the front, above the world's origin, on the ground.
///
/// Errors  CannotOpen; those of the readers (mesh_formats.h, picture_file.h, svg_reader.h);
///         BadCount, above mostTriangles
Result<LoadedTemplate> readTemplateFile(const QString &path, const TemplateFileOptions &options);

/// The same of bytes that come without a file, as from the clipboard: pictures and drawings. name:
/// what the template is called.
Result<LoadedTemplate> readTemplateBytes(std::string bytes, const std::string &name,
                                         const TemplateFileOptions &options);

/// The template with what its blob, or its file, is. Errors  CannotOpen, place = the file, or
/// BadArchive where the blob is missing; those of the readers.
Result<Template> readTemplateContent(Template one, const Document &document,
                                     std::int64_t mostPixels = kMostPicturePixels,
                                     const LongWork &work = {});

/// All templates of the document that are not read yet, each file once. What cannot be read, and
/// pictures beyond kMostPixelsOfAll, stay templates without it, with a warning.
Document withTemplateContents(Document document, std::vector<Warning> &warnings,
                              const LongWork &work = {});

} // namespace fff::io
