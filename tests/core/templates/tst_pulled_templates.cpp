// What magnets make of the templates of a model. If this fails, what is shown of a mesh, or what
// guides are cut of, is not what the sections on it ask for, or the mesh itself was touched.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/model/edits.h"
#include "core/model/magnet_edits.h"
#include "core/model/template_edits.h"
#include "core/operations/evaluate.h"
#include "core/templates/pulled_templates.h"
#include "core/templates/template_cut.h"
#include "core/templates/vertex_normals.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kBallRadius = 50.0; // units of its file

/// A ball that is turned, scaled and moved, and two plates: one upright through its middle, one
/// level and off it.
struct PullCase
{
    Document document = newDocument();
    TemplateId ball;
    SectionId upright, level;

    PullCase()
    {
        Template one;
        one.name = "Ball";
        one.file = "ball.stl";
        one.mesh = makeTemplateMesh(mended(sphere(kBallRadius, 60, 90)).value().mesh, {}).value();
        one.scale = 1.6;
        one.frame = makeFrame({20, 90, -5}, {0.8, 0.0, 0.6}, {0.0, 1.0, 0.0}).value();
        document = addTemplate(document, one).value();
        ball = document.templates.back()->id;
        upright = plate(makeFrame({20, 90, -5}, Vec3::UnitX(), Vec3::UnitY()).value());
        level = plate(makeFrame({20, 60, -5}, Vec3::UnitZ(), Vec3::UnitX()).value());
    }
    SectionId plate(const Frame &frame)
    {
        NewSection section;
        section.stock = document.stocks.front()->id;
        section.frame = frame;
        section.shape =
            Shape::make(Contour::ofPolygon({{-30, -30}, {30, -30}, {30, 30}, {-30, 30}})).value();
        document = addSection(document, std::move(section)).value();
        return document.sections.back()->id;
    }
    void pull(SectionId section, std::optional<double> radius)
    {
        document = setMagnet(document, SectionRef(section), radius).value();
    }
    PulledTemplates pulled(const PulledTemplates *before = nullptr) const
    {
        return pullTemplates(evaluate(document), before).value();
    }
    const Template &one() const { return *document.find(ball); }
};

} // namespace

class TestPulledTemplates : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void withoutMagnetsThereAreNone();
    void asInTheWorld();
    void guidesFollow();
    void whatStaysIsKept();
    void lockedOnesStay();
    void stopped();
};

void TestPulledTemplates::withoutMagnetsThereAreNone()
{
    PullCase made;
    QVERIFY(made.pulled().all.empty());
    QVERIFY(!magnetOf(made.document, SectionRef(made.upright)));
    made.pull(made.upright, 20.0);
    QCOMPARE(magnetOf(made.document, SectionRef(made.upright)).value(), 20.0);
    QCOMPARE(made.pulled().all.size(), std::size_t(1));
    const Document with = made.document;
    made.pull(made.upright, std::nullopt);
    QVERIFY(made.pulled().all.empty());
    QCOMPARE(made.pulled().meshOf(made.one()), made.one().mesh);
    QVERIFY(with.find(made.ball)->mesh == made.one().mesh);
}

// Wrong: a template that is scaled or turned is pulled by another rule than the one that is written
// down, in which all is in the world.
void TestPulledTemplates::asInTheWorld()
{
    PullCase made;
    made.pull(made.upright, 25.0);
    made.pull(made.level, 18.0);
    const PulledTemplates pulled = made.pulled();
    const TemplateMesh &before = *made.one().mesh, &after = *pulled.meshOf(made.one());
    QVERIFY(&before != &after);
    const Similarity toWorld = worldPlacement(made.one(), before);
    const std::vector<Vec3> normals = vertexNormals(*before.mesh);
    double most = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Vec3 p = toWorld(before.mesh->positions()[i]), n = toWorld.turn * normals[i];
        Vec3 way = Vec3::Zero();
        double weights = 0.0;
        for (const auto &[id, r] : {std::pair(made.upright, 25.0), std::pair(made.level, 18.0)}) {
            const Frame &frame = made.document.find(id)->frame;
            const Vec3 plane = frame.normal();
            const double off = plane.dot(frame.origin - p);
            double w = (1.0 - std::abs(off) / r) / 0.2;
            w = std::clamp(w, 0.0, 1.0);
            w = w * w * (3.0 - 2.0 * w);
            way += w * w * plane * (off + n.dot(plane) * r);
            weights += w;
        }
        const Vec3 wanted = weights > 0.0 ? Vec3(p + way / weights) : p;
        most = std::max(most, (toWorld(after.mesh->positions()[i]) - wanted).norm());
        moved = std::max(moved, (wanted - p).norm());
    }
    QVERIFY2(most < 1e-9 && moved > 1.0, qPrintable(QStringLiteral("%1 %2").arg(most).arg(moved)));
}

// Wrong: the guide of a plane beside a magnet is that of the mesh as it was.
void TestPulledTemplates::guidesFollow()
{
    PullCase made;
    const Frame beside = makeFrame({20, 90, 5}, Vec3::UnitX(), Vec3::UnitY()).value();
    const auto outline = [&](const TemplateMesh &mesh) {
        const std::vector<TemplateLoop> loops = loopsOn(beside, made.one(), mesh);
        return loops.empty() ? 0.0 : signedArea(loops.front().points);
    };
    const double before = outline(*made.one().mesh);
    made.pull(made.upright, 25.0);
    const PulledTemplates pulled = made.pulled();
    // 10 mm off, most of what is near goes into the magnet's plane, the ball's rim stays round.
    const double after = outline(*pulled.meshOf(made.one()));
    QVERIFY2(before > 0.0 && after > 0.0 && std::abs(after - before) > 1.0,
             qPrintable(QStringLiteral("%1 %2").arg(before).arg(after)));
}

void TestPulledTemplates::whatStaysIsKept()
{
    PullCase made;
    made.pull(made.upright, 25.0);
    const PulledTemplates first = made.pulled();
    // Another section comes: nothing is worked out again.
    made.plate(makeFrame({0, 10, 0}, Vec3::UnitX(), Vec3::UnitZ()).value());
    const PulledTemplates same = made.pulled(&first);
    QCOMPARE(same.meshOf(made.one()), first.meshOf(made.one()));
    // The magnet moves.
    Frame moved = made.document.find(made.upright)->frame;
    moved.origin.z() += 3.0;
    made.document = moveSection(made.document, made.upright, moved).value();
    const PulledTemplates other = made.pulled(&same);
    QVERIFY(other.meshOf(made.one()) != first.meshOf(made.one()));
    QCOMPARE(other.all.front().normals, first.all.front().normals);
    const PulledTemplates anew = made.pulled();
    QVERIFY(other.meshOf(made.one())->mesh->positions() ==
            anew.meshOf(made.one())->mesh->positions());
    // It goes.
    made.document = removeSections(made.document, std::array{made.upright}).value();
    QVERIFY(made.pulled(&other).all.empty());
}

void TestPulledTemplates::lockedOnesStay()
{
    PullCase made;
    Template locked = made.one();
    locked.isLocked = true;
    made.document = setTemplate(made.document, locked).value();
    QVERIFY(!canPullTemplates(made.document));
    QVERIFY(!setMagnet(made.document, SectionRef(made.upright), 20.0));
    locked.isLocked = false;
    made.document = setTemplate(made.document, locked).value();
    QVERIFY(!setMagnet(made.document, SectionRef(made.upright), 0.0)); // nothing pulls from nowhere
    QVERIFY(!setMagnet(made.document, SectionRef(SectionId{9999}), 20.0));
}

void TestPulledTemplates::stopped()
{
    PullCase made;
    made.pull(made.upright, 25.0);
    std::stop_source source;
    source.request_stop();
    const auto result = pullTemplates(evaluate(made.document), nullptr, {source.get_token(), {}});
    QVERIFY(!result && result.error().code == ErrorCode::Cancelled);
}

FFF_TEST(TestPulledTemplates)
#include "tst_pulled_templates.moc"
