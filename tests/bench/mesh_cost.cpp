#include "tests/bench/mesh_cost.h"

#include "core/io/mesh_file.h"
#include "core/model/operation_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/operations/slices.h"
#include "core/templates/guide_curve.h"
#include "core/templates/magnetic_cut.h"
#include "core/templates/template_mesh.h"
#include "core/templates/vertex_normals.h"
#include "tests/bench/growth_table.h"
#include "tests/bench/stopwatch.h"
#include "tests/core/io/written_meshes.h"
#include "tests/core/templates/made_meshes.h"

#include <QTextStream>

#include <limits>

namespace fff::bench {

namespace {

constexpr int kMovedPlanes = 50; // of which the mean counts

template <class Work>
void shortest(double &milliseconds, int runs, Work work)
{
    milliseconds = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        double once = 0.0;
        timed(once, work);
        milliseconds = std::min(milliseconds, once);
    }
}

MeshCost meshCost(int rows, int columns, int runs)
{
    MeshDraft draft = test::torus(80.0, 30.0, rows, columns);
    // Not round in any direction, so that cuts are of all kinds.
    for (Vec3 &p : draft.positions)
        p += 2.0 * Vec3(std::sin(0.2 * p.y()), std::sin(0.3 * p.z()), std::sin(0.25 * p.x()));
    MeshCost cost;
    cost.size = draft.triangles.size();
    cost.name = std::to_string(cost.size) + " triangles";
    io::MeshOptions options;
    options.name = "ring";
    {
        const std::string stl = test::stlBytes(draft);
        shortest(cost.stl, runs, [&] { return io::readMeshBytes(stl, options); });
    }
    {
        // As programs write it, six digits.
        std::string obj;
        char line[100];
        for (const Vec3 &p : draft.positions) {
            std::snprintf(line, sizeof line, "v %.6f %.6f %.6f\n", p.x(), p.y(), p.z());
            obj += line;
        }
        for (const Triangle &t : draft.triangles) {
            std::snprintf(line, sizeof line, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
            obj += line;
        }
        shortest(cost.obj, runs, [&] { return io::readMeshBytes(obj, options); });
    }
    const TriangleMeshPointer mesh = test::meshOf(draft);
    const auto planeAt = [](int i) {
        return makeCutPlane({0.9 * i - 20.0, 0.3 * i, 1.0}, {1.0, 0.2, 0.05 * i - 1.0}).value();
    };
    shortest(cost.first, runs, [&] { return planeCut(*mesh, planeAt(7)); });
    shortest(cost.tree, runs, [&] { return MeshTree::make(*mesh); });
    const MeshTree tree = MeshTree::make(*mesh).value();
    shortest(cost.cut, runs, [&] {
        std::size_t points = 0;
        for (int i = 0; i < kMovedPlanes; ++i)
            for (const CutLoop &loop : planeCut(*mesh, planeAt(i), &tree).loops)
                points += loop.points.size();
        return points;
    });
    cost.cut /= kMovedPlanes;
    const PlaneCut cut = planeCut(*mesh, planeAt(7), &tree);
    shortest(cost.guide, runs, [&] {
        int segments = 0;
        for (const CutLoop &loop : cut.loops)
            if (const Result<Contour> contour = guideCurve(loop, frameOn(cut.plane)))
                segments += contour->segmentCount();
        return segments;
    });
    const std::vector<Vec3> normals = vertexNormals(*mesh);
    std::vector<MagneticPlane> magnets;
    for (int i = 0; i < 4; ++i)
        magnets.push_back({planeAt(10 * i), 25.4});
    shortest(cost.magnetic, runs, [&] { return magneticCut(*mesh, normals, magnets); });
    Template shown;
    shown.file = "ring.stl";
    shown.mesh = makeTemplateMesh(mesh, {}).value();
    shortest(cost.pulled, runs,
             [&] { return movedTemplateMesh(*shown.mesh, magneticCut(*mesh, normals, magnets)); });
    const TemplateMeshPointer pulled =
        movedTemplateMesh(*shown.mesh, magneticCut(*mesh, normals, magnets)).value();
    shortest(cost.pulledCut, runs, [&] {
        std::size_t points = 0;
        for (int i = 0; i < kMovedPlanes; ++i)
            for (const CutLoop &loop : planeCut(*pulled->mesh, planeAt(i), &pulled->tree).loops)
                points += loop.points.size();
        return points;
    });
    cost.pulledCut /= kMovedPlanes;
    Document document =
        addTemplate(newDocument(), stood(shown, *shown.mesh, UpAxis::Y, 250.0)).value();
    Operation slices = newOperation(kSlices);
    slices.subject = document.templates.front()->id;
    slices.parameters.insert_or_assign("direction", std::string("x"));
    slices.parameters.insert_or_assign("count", 100.0);
    document = addOperation(std::move(document), std::move(slices));
    shortest(cost.slices, runs, [&] { return evaluate(document).sectionCount(); });
    return cost;
}

constexpr std::array<GrowthColumn<MeshCost>, 10> kMeshColumns{{{"STL", &MeshCost::stl},
                                                               {"OBJ", &MeshCost::obj},
                                                               {"first cut", &MeshCost::first},
                                                               {"tree", &MeshCost::tree},
                                                               {"cut", &MeshCost::cut},
                                                               {"guide", &MeshCost::guide},
                                                               {"magnetic", &MeshCost::magnetic},
                                                               {"pulled", &MeshCost::pulled},
                                                               {"its cut", &MeshCost::pulledCut},
                                                               {"100 slices", &MeshCost::slices}}};

} // namespace

std::vector<MeshCost> meshCosts(int runs, const std::optional<Kernel> &kernel)
{
    std::vector<MeshCost> costs;
    for (const auto &[rows, columns] :
         {std::pair(500, 100), std::pair(250, 125), std::pair(500, 250), std::pair(1000, 500)}) {
        const double before = kernel ? kernel->run() : 0.0;
        costs.push_back(meshCost(rows, columns, runs));
        costs.back().kernel = kernel ? 0.5 * (before + kernel->run()) : 0.0;
        QTextStream(stderr) << QString::fromStdString(costs.back().name) << Qt::endl;
    }
    return costs;
}

std::string meshTable(const std::vector<MeshCost> &costs)
{
    return growthTable("Meshes", kMeshColumns, costs);
}

} // namespace fff::bench
