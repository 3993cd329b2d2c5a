// What readers of meshes collect vertices and faces in. Internal to io.
#pragma once

#include "core/io/mesh_formats.h"
#include "core/templates/vertex_merger.h"

#include <optional>
#include <span>

namespace fff::io {

/// The first thing that is wrong counts; after it nothing is added.
class MeshBuilder
{
public:
    explicit MeshBuilder(const MeshOptions &options) : m_options(options) {}

    MeshDraft draft;

    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        draft.triangles.push_back({a, b, c});
        if (draft.triangles.size() > m_options.mostTriangles)
            tooMany(draft.triangles.size());
    }
    /// Cut into triangles when all vertices are there: in the plane that fits best, also where it
    /// is not convex. Fewer than three corners are no face.
    void addPolygon(std::span<const std::uint32_t> corners);

    /// The vertices are those of the merger; a corner kNowhere is one that is no number.
    void takeVertices(VertexMerger &merger);
    static constexpr std::uint32_t kNowhere = kNoVertex - 1;

    /// Of what a file says it has: so many triangles at least, each taking `bytesEach` of the
    /// `bytes` that there are. False, and an error, where that cannot be.
    bool expectTriangles(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                         const std::string &where);
    bool expectVertices(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                        const std::string &where);

    void fail(ErrorCode code, const std::string &where, std::vector<std::string> args = {});
    bool failed() const { return m_error.has_value(); }

    /// Now and then, with the share of the file that was read: false when somebody stopped it.
    bool goOn(double share);

    const MeshOptions &options() const { return m_options; }
    /// What was read, or the error.
    Result<MeshDraft> finish();

private:
    void tooMany(std::uint64_t count);
    bool expect(std::uint64_t count, std::uint64_t bytesEach, std::uint64_t bytes,
                const std::string &where, const char *what);

    const MeshOptions &m_options;
    std::optional<Error> m_error;
    std::vector<std::uint32_t> m_corners; // of all polygons
    std::vector<std::size_t> m_ends;      // of each polygon in these
};

/// Triangles of a simple polygon in space, by its corners' places in `corners`; a fan where it
/// crosses itself or has too many corners for the square of their number.
void cutPolygon(std::span<const std::uint32_t> corners, const std::vector<Vec3> &positions,
                const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)> &add);

/// "byte 84".
std::string byteAt(std::uint64_t offset);

} // namespace fff::io
