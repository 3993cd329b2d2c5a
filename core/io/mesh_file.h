// Meshes from files, ready to draw over.
#pragma once

#include "core/io/mesh_formats.h"

namespace fff::io {

struct LoadedMesh
{
    TriangleMeshPointer mesh;
    MeshReport report;
    const MeshFormat *format = nullptr;
    std::string bytes; // of the file, of readMesh() alone
};

/// Largest file of a mesh, bytes: one of kMostTriangles in most formats.
inline constexpr std::int64_t kMostMeshBytes = std::int64_t(3) << 29;

/// Reads and mends a mesh of whatever format. Before all of the file is read, its first bytes have
/// to be those of a mesh, and of one that is not too large. `options.name`, where it is empty, is
/// the path as given; files beside are looked for in its folder.
/// Errors  CannotOpen, BadCount, those of meshFormatOf(), of the format and of mended().
Result<LoadedMesh> readMesh(const QString &path, MeshOptions options = {});

/// The same of bytes that are there, and that stay with the caller.
Result<LoadedMesh> readMeshBytes(std::string_view bytes, const MeshOptions &options);

} // namespace fff::io
