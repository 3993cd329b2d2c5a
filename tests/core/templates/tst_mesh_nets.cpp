// Meshes of few faces laid flat: nothing overlaps, all edges are there, and what is folded comes to
// where it was.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/base/tolerances.h"
#include "core/geometry/boolean.h"
#include "core/templates/mended_mesh.h"
#include "core/templates/mesh_nets.h"
#include "core/templates/simplified_mesh.h"
#include "tests/core/templates/made_forms.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

TriangleMeshPointer meshOf(const MeshDraft &draft, std::size_t faces)
{
    const TriangleMeshPointer mesh = mended(draft).value().mesh;
    return faces < mesh->triangles().size() ? simplified(mesh, faces).value() : mesh;
}

struct Unfolded
{
    TriangleMeshPointer mesh;
    std::vector<MeshFacet> facets;
    std::vector<MeshNet> nets;
};

Unfolded unfoldedOf(const MeshDraft &draft, std::size_t faces, const NetOptions &options)
{
    Unfolded all;
    all.mesh = meshOf(draft, faces);
    all.facets = meshFacets(*all.mesh);
    all.nets = meshNets(*all.mesh, all.facets, options).value();
    return all;
}

double areaOf(const MeshNet &net)
{
    double area = net.outline.signedArea();
    for (const Contour &hole : net.holes)
        area -= std::abs(hole.signedArea());
    return area;
}

constexpr double kNetTestGap = 0.5; // mm

/// How near two places of its outline come to each other, mm, that are not about the end of one
/// fold; kNetTestGap where that is more. By points along the outline, which share nothing with how
/// nets are laid.
double nearestPassage(const MeshNet &net)
{
    constexpr double kStep = 0.25, kMeeting = 2.0 * 6.0 * kNetTestGap + 2.0 * kStep;
    struct Sample
    {
        Vec2 at;
        double along;
    };
    std::vector<Sample> samples;
    double length = 0.0;
    const Polygon outline = net.outline.polygon(kCutChord);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 &from = outline[i], &to = outline[(i + 1) % outline.size()];
        const double edge = (to - from).norm();
        const int steps = std::max(1, static_cast<int>(std::ceil(edge / kStep)));
        for (int k = 0; k < steps; ++k)
            samples.push_back({from + (to - from) * k / steps, length + edge * k / steps});
        length += edge;
    }
    std::sort(samples.begin(), samples.end(),
              [](const Sample &a, const Sample &b) { return a.at.x() < b.at.x(); });
    double nearest = kNetTestGap;
    for (std::size_t i = 0; i < samples.size(); ++i)
        for (std::size_t k = i + 1;
             k < samples.size() && samples[k].at.x() - samples[i].at.x() < nearest; ++k) {
            const double way = std::abs(samples[k].along - samples[i].along);
            if (std::min(way, length - way) > kMeeting)
                nearest = std::min(nearest, (samples[k].at - samples[i].at).norm());
        }
    return nearest;
}

MeshDraft formOf(const QString &name)
{
    if (name == QLatin1String("ball"))
        return sphere(60.0, 30, 45);
    if (name == QLatin1String("egg"))
        return ellipsoid(Vec3::Zero(), {40.0, 90.0, 55.0});
    return head(48, 61);
}

} // namespace

class TestMeshNets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBoxIsACross();
    void formsInFewNets_data();
    void formsInFewNets();
    void flapsOnOneSideOfEachSeam();
    void partsKeepTheGap_data();
    void partsKeepTheGap();
    void whatThatIsFor();
    void whatIsTooLargeIsCutInMore();
    void theSameEachTime();

private:
    bool m_isNearWithout = false;
};

void TestMeshNets::aBoxIsACross()
{
    const Unfolded all = unfoldedOf(box(Vec3::Zero(), {60.0, 40.0, 20.0}), 100, {});
    QCOMPARE(all.facets.size(), std::size_t(6));
    QCOMPARE(all.nets.size(), std::size_t(1));
    const MeshNet &net = all.nets.front();
    QCOMPARE(net.facets, 6);
    QCOMPARE(net.folds.size(), std::size_t(5));
    QCOMPARE(net.seams.size(), std::size_t(14)); // 7 edges, both sides
    QVERIFY(std::abs(areaOf(net) - 2.0 * (60 * 40 + 40 * 20 + 60 * 20)) < 1e-6);
    for (const NetFold &fold : net.folds)
        QVERIFY(!fold.isValley);
}

void TestMeshNets::formsInFewNets_data()
{
    QTest::addColumn<QString>("form");
    QTest::addColumn<int>("faces");
    QTest::addColumn<double>("flap");
    for (const char *form : {"ball", "egg", "head"})
        for (const int faces : {4, 12, 40, 120})
            for (const double flap : {0.0, 6.0})
                QTest::addRow("%s, %d faces%s", form, faces, flap > 0.0 ? ", flaps" : "")
                    << QString::fromLatin1(form) << faces << flap;
}

// An independent count: each facet is in one net, each edge of the mesh folded once or sewn once.
void TestMeshNets::formsInFewNets()
{
    QFETCH(const QString, form);
    QFETCH(const int, faces);
    QFETCH(const double, flap);
    const Unfolded all =
        unfoldedOf(formOf(form), static_cast<std::size_t>(faces), {Vec2(600.0, 400.0), flap});
    int facets = 0, folds = 0, flaps = 0;
    double area = 0.0, meshArea = 0.0;
    std::map<int, std::vector<double>> seams; // lengths, by numbers
    for (const MeshNet &net : all.nets) {
        facets += net.facets;
        folds += net.facets - 1;
        flaps += static_cast<int>(net.folds.size()) - (net.facets - 1);
        area += areaOf(net);
        QVERIFY(isPlain(net.outline, net.holes, kCutChord));
        for (const NetSeam &seam : net.seams)
            seams[seam.number].push_back((seam.line.to - seam.line.from).norm());
    }
    QCOMPARE(facets, static_cast<int>(all.facets.size()));
    for (const MeshFacet &facet : all.facets)
        meshArea += facet.area;
    if (flap > 0.0)
        QVERIFY(flaps > 0 && area > meshArea);
    else {
        QCOMPARE(flaps, 0);
        QVERIFY2(std::abs(area / meshArea - 1.0) < 0.01,
                 qPrintable(QString::number(area / meshArea)));
    }
    for (const auto &[number, lengths] : seams) {
        QCOMPARE(lengths.size(), std::size_t(2));
        QVERIFY(std::abs(lengths[0] - lengths[1]) < 2.0 * kCoplanarDepth);
    }
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const MeshFacet &facet : all.facets)
        for (const auto &loop : facet.loops)
            for (const FacetEdge &edge : loop)
                edges.insert(std::minmax({edge.from, edge.to}));
    QVERIFY(folds + static_cast<int>(seams.size()) <= static_cast<int>(edges.size()));
    // Few are enough: a person cuts and folds them.
    QVERIFY2(all.nets.size() <= 1 + all.facets.size() / 8,
             qPrintable(QString::number(all.nets.size())));
}

void TestMeshNets::flapsOnOneSideOfEachSeam()
{
    const Unfolded all =
        unfoldedOf(box(Vec3::Zero(), {60.0, 40.0, 20.0}), 100, {Vec2(600.0, 400.0), 6.0});
    const MeshNet &net = all.nets.front();
    const std::size_t flaps = net.folds.size() - 5;
    QCOMPARE(flaps, std::size_t(7));
}

void TestMeshNets::partsKeepTheGap_data()
{
    QTest::addColumn<QString>("form");
    QTest::addColumn<int>("faces");
    QTest::addColumn<double>("flap");
    for (const char *form : {"ball", "egg", "head"})
        for (const int faces : {40, 120})
            for (const double flap : {0.0, 6.0})
                QTest::addRow("%s, %d faces%s", form, faces, flap > 0.0 ? ", flaps" : "")
                    << QString::fromLatin1(form) << faces << flap;
}

// Wrong: the beam takes the wall between two cuts away, or a cut is none.
void TestMeshNets::partsKeepTheGap()
{
    QFETCH(const QString, form);
    QFETCH(const int, faces);
    QFETCH(const double, flap);
    const auto nearestOf = [&](double gap) {
        double nearest = kNetTestGap;
        for (const MeshNet &net : unfoldedOf(formOf(form), static_cast<std::size_t>(faces),
                                             {Vec2(600.0, 400.0), flap, gap})
                                      .nets)
            nearest = std::min(nearest, nearestPassage(net));
        return nearest;
    };
    m_isNearWithout = m_isNearWithout || nearestOf(0.0) < 0.5 * kNetTestGap;
    QVERIFY2(nearestOf(kNetTestGap) > kNetTestGap - kClipGrid,
             qPrintable(QString::number(nearestOf(kNetTestGap))));
}

void TestMeshNets::whatThatIsFor()
{
    QVERIFY(m_isNearWithout); // else the rows above say nothing
}

void TestMeshNets::whatIsTooLargeIsCutInMore()
{
    const Vec2 room(100.0, 70.0);
    const Unfolded all = unfoldedOf(box(Vec3::Zero(), {60.0, 40.0, 20.0}), 100, {room, 0.0});
    QVERIFY(all.nets.size() > 1);
    for (const MeshNet &net : all.nets) {
        const Vec2 size = net.outline.bounds().size();
        QVERIFY(std::max(size.x(), size.y()) <= 100.0 && std::min(size.x(), size.y()) <= 70.0);
    }
}

void TestMeshNets::theSameEachTime()
{
    const Unfolded one = unfoldedOf(head(48, 61), 60, {}), other = unfoldedOf(head(48, 61), 60, {});
    QCOMPARE(one.nets.size(), other.nets.size());
    for (std::size_t i = 0; i < one.nets.size(); ++i)
        QVERIFY(one.nets[i].outline == other.nets[i].outline);
}

FFF_TEST(TestMeshNets)
#include "tst_mesh_nets.moc"
