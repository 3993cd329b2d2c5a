// Any bytes as a mesh, one program for each reader. If this stops, a file from the net takes the
// window down, or a mesh that loads cannot be cut.
#include "core/io/mesh_file.h"
#include "core/templates/plane_cut.h"
#include "tests/fuzz/properties.h"

#include <cstring>

using namespace fff;

namespace {

const io::MeshFormat &format()
{
    for (const io::MeshFormat *one : io::meshFormats())
        if (std::strcmp(one->key, FFF_MESH_FORMAT) == 0)
            return *one;
    std::abort();
}

void requireCut(const TriangleMesh &mesh, const Vec3 &normal)
{
    const CutPlane plane = makeCutPlane(mesh.positions().front(), normal).value();
    const PlaneCut cut = planeCut(mesh, plane);
    const Result<MeshTree> tree = MeshTree::make(mesh);
    fuzz::require(planeCut(mesh, plane, &*tree).loops.size() == cut.loops.size(),
                  "with a tree the same loops are found");
    for (const CutLoop &loop : cut.loops) {
        fuzz::require(loop.points.size() >= 3, "a loop has three points");
        for (const Vec3 &p : loop.points)
            fuzz::require(p.allFinite(), "places are numbers");
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const std::string_view bytes(reinterpret_cast<const char *>(data), size);
    io::MeshOptions options;
    options.name = "input";
    options.mostTriangles = 100'000;
    Result<MeshDraft> draft = format().read(bytes, options);
    if (!draft) {
        fuzz::requireClear(draft.error());
        return 0;
    }
    const Result<MendedMesh> mesh = mended(*std::move(draft));
    if (!mesh)
        return 0;
    for (const Vec3 &p : mesh->mesh->positions())
        fuzz::require(p.allFinite(), "places are numbers");
    requireCut(*mesh->mesh, Vec3::UnitX());
    requireCut(*mesh->mesh, {0.3, -0.5, 0.7});
    return 0;
}
