// The formats of meshes as a table, which dialogs, the command line and what is dropped on the
// window are read by. A format is a file of its own and its line in mesh_formats.cpp. They are not
// in formats.h: a model's file and a template's may have the same ending, and mean different
// things.
#pragma once

#include "core/base/long_work.h"
#include "core/templates/mended_mesh.h"

#include <QtCore/QString>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fff::io {

struct MeshOptions
{
    std::string name; // how errors call the file
    /// More are refused, where a file says so before memory is taken for them.
    std::size_t mostTriangles = kMostTriangles;
    /// Bytes of a file beside this one, by the name that it has in this one, in UTF-8; empty: there
    /// are none.
    std::function<Result<std::string>(const std::string &)> beside = {};
    LongWork work = {};
};

/// Errors of readers are at name:LINE, or at name:byte N of what is no text:
///     Truncated, BadSyntax, BadValue, BadArchive  with what was found and what was expected
///     BadCount     more triangles than may be, or counts that the file has no room for
///     Unsupported  what no reader here knows: a compression, a binary variant
///     Cancelled
/// Faces that name vertices that are not there come as kNoVertex, or as they are: mended() counts
/// them.
struct MeshFormat
{
    const char *key = "";
    std::vector<const char *> suffixes; // without a dot
    const char *title = "";             // as a file dialog calls it; context "Format"

    /// By the first bytes, whatever the file is called.
    bool (*recognises)(std::string_view head) = nullptr;
    Result<MeshDraft> (*read)(std::string_view bytes, const MeshOptions &options) = nullptr;
    /// Triangles that the first bytes of a file of so many say are in it; 0: they do not say.
    std::uint64_t (*claimed)(std::string_view head, std::uint64_t size) = nullptr;
};

/// In the order in which they are offered.
std::span<const MeshFormat *const> meshFormats();

/// By what is in the file, else by the end of its name. Errors  Truncated for no bytes, BadSyntax
/// for what is no mesh.
Result<const MeshFormat *> meshFormatOf(std::string_view head, const std::string &name);

/// "*.stl *.obj …": what can be read.
QString meshPatterns();

const MeshFormat &stlMeshFormat();
const MeshFormat &objMeshFormat();
const MeshFormat &plyMeshFormat();
const MeshFormat &offMeshFormat();
const MeshFormat &threeMfMeshFormat();
const MeshFormat &gltfMeshFormat();

} // namespace fff::io
