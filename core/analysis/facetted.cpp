#include "core/analysis/facetted.h"

#include "core/analysis/analysis.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "core/templates/simplified_mesh.h"
#include "core/templates/stood_mesh.h"
#include "core/templates/template_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// As the template lies in the world, outwards.
TriangleMeshPointer inWorld(const Template &one)
{
    const TriangleMesh &mesh = *one.mesh->mesh;
    const Similarity placement = worldPlacement(one, *one.mesh);
    std::vector<Vec3> positions;
    positions.reserve(mesh.positions().size());
    for (const Vec3 &p : mesh.positions())
        positions.push_back(placement(p));
    std::vector<Triangle> triangles = mesh.triangles();
    if (mesh.volume() < 0.0)
        for (Triangle &triangle : triangles)
            std::swap(triangle[1], triangle[2]);
    return std::make_shared<const TriangleMesh>(std::move(positions), std::move(triangles), 1.0);
}

Vec3 footOf(const TriangleMesh &mesh)
{
    const Vec3 middle = mesh.bounds().center();
    return {middle.x(), mesh.bounds().min.y(), middle.z()};
}

/// As large as the other one, on the same foot.
TriangleMeshPointer inPlaceOf(const TriangleMesh &mesh, const TriangleMesh &other)
{
    const TriangleMeshPointer placed = placedMesh(mesh, other.size());
    std::vector<Vec3> positions = placed->positions();
    for (Vec3 &p : positions)
        p += footOf(other);
    return std::make_shared<const TriangleMesh>(std::move(positions), placed->triangles(), 1.0);
}

double lowestOf(const FacetModel &model)
{
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(model.document), caches);
    const std::size_t first = model.document.sections.size() - model.sections.size();
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < model.document.sections.size(); ++i)
        for (const BodyPointer &body : analysis.bodies.of(static_cast<int>(i)))
            lowest = std::min(lowest, body->box().min.y());
    return lowest;
}

Result<Document> moved(Document document, const std::vector<SectionId> &sections, const Vec3 &way)
{
    for (const SectionId id : sections) {
        Frame frame = document.find(id)->frame;
        frame.origin += way;
        Result<Document> next = moveSection(std::move(document), id, frame);
        if (!next)
            return next;
        document = *std::move(next);
    }
    return document;
}

/// The template's mesh in its place, of no more triangles than wanted.
Result<TriangleMeshPointer> meshOf(const Template *one, std::optional<std::size_t> faces,
                                   const LongWork &work)
{
    if (!one || !one->mesh)
        return failure(ErrorCode::UnknownReference, "template");
    const TriangleMeshPointer whole = inWorld(*one);
    if (!faces || *faces >= whole->triangles().size())
        return whole;
    const Result<TriangleMeshPointer> few = simplified(whole, *faces, work);
    if (!few)
        return tl::unexpected(few.error());
    const TriangleMeshPointer stood = stoodOnFacet(**few);
    return inPlaceOf(stood ? *stood : **few, *whole);
}

} // namespace

Result<FacetModel> facetted(const Document &document, TemplateId of,
                            std::optional<std::size_t> faces, const LongWork &work)
{
    const Template *one = document.find(of);
    const Result<TriangleMeshPointer> mesh = meshOf(one, faces, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    Result<FacetModel> model = facetModel(document, **mesh, one->name, work);
    if (!model)
        return model;
    const double lowest = lowestOf(*model), foot = footOf(**mesh).y();
    if (!std::isfinite(lowest))
        return model;
    Result<Document> next =
        moved(std::move(model->document), model->sections, Vec3(0.0, foot - lowest, 0.0));
    if (!next)
        return tl::unexpected(std::move(next.error()));
    model->document = *std::move(next);
    return model;
}

Result<NetModel> unfolded(const Document &document, TemplateId of, std::optional<std::size_t> faces,
                          double flap, const LongWork &work)
{
    const Template *one = document.find(of);
    const Result<TriangleMeshPointer> mesh = meshOf(one, faces, work);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const Box3 &box = (*mesh)->bounds();
    const Vec3 beside(box.max.x() + kNetMargin, 0.0, box.max.z());
    return netModel(document, **mesh, one->name, beside, flap, work);
}

} // namespace fff
