// Stress as a colour over the faces of sections.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/view/field_mesh.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/stress_colours.h"

#include <QGuiApplication>
#include <QImage>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

const Vec2 kView(240.0, 240.0);

/// Over a square from (−40, 20) to (40, 100), of the same stress all over each face.
StressFieldPointer evenField(float front, float back)
{
    StressField field;
    field.points = {{-40, 20}, {40, 20}, {40, 100}, {-40, 100}};
    field.triangles = {{0, 1, 2}, {0, 2, 3}};
    field.use = {std::vector<float>(4, front), std::vector<float>(4, back)};
    field.moved.assign(4, Eigen::Vector3f::Zero());
    field.most = std::max(front, back);
    return std::make_shared<const StressField>(std::move(field));
}

Scene plateScene(std::vector<double> places)
{
    Document document = newDocument();
    for (const double z : places) {
        NewSection made;
        made.shape = polygonShape(rectangle(-40, 20, 40, 100));
        made.frame.origin = Vec3(0, 0, z);
        made.stock = document.currentStock;
        document = *addSection(std::move(document), made);
    }
    return ui::sceneOf(analysed(document));
}

QImage painted(const Scene &scene, const char *view, const RenderOptions &options = {},
               const ViewStyle &style = {})
{
    return OffscreenPainter().paint(scene, cameraFor(scene, view, kView), kView, 1.0, style,
                                    options);
}

/// Of the middle of the picture, on a face between all lines.
QColor middleOf(const QImage &image)
{
    return image.pixelColor(image.width() / 2, image.height() / 2);
}

/// But for light and shade.
bool isHueOf(const QColor &seen, const QColor &wanted)
{
    return std::abs(seen.hue() - wanted.hue()) % 360 < 6 && seen.saturation() > 100;
}

} // namespace

class TestFieldPainter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void littleStressIsNotSeen();
    void eachFaceHasItsOwn();
    void inThePalettes();
    void seenThroughNoOther();
    void onWhatLetsLightThrough();
    void cutOpen();
    void wallsHaveWhatTheirEdgeHas();
    void wallsOfOtherPiecesHaveNone();
    void bentOnTheCard();
    void fadedWhileItIsOlder();
};

void TestFieldPainter::littleStressIsNotSeen()
{
    Scene scene = plateScene({0.0});
    const QImage plain = painted(scene, "front");
    QVERIFY(!plain.isNull());
    scene.sections.front().fields = {evenField(0.19f, 0.19f)};
    QCOMPARE(painted(scene, "front"), plain);
}

void TestFieldPainter::eachFaceHasItsOwn()
{
    Scene scene = plateScene({0.0});
    scene.sections.front().fields = {evenField(1.0f, 0.2001f)};
    // Wrong: the stress of the face that is turned away, or of both the same.
    const QColor front = middleOf(painted(scene, "front"));
    QVERIFY2(isHueOf(front, stressColour(1.0, false)), qPrintable(front.name()));
    std::swap(scene.sections.front().frame.x, scene.sections.front().frame.y);
    scene.sections.front().frame.x = -Vec3::UnitX();
    scene.sections.front().frame.y = Vec3::UnitY();
    const QColor back = middleOf(painted(scene, "front"));
    QVERIFY2(isHueOf(back, stressColour(0.2, false)), qPrintable(back.name()));
}

void TestFieldPainter::inThePalettes()
{
    for (const bool isForColourBlind : {false, true}) {
        ViewStyle style;
        style.isForColourBlind = isForColourBlind;
        for (const float use : {0.25f, 0.4f, 0.6f, 0.8f, 1.0f}) {
            Scene scene = plateScene({0.0});
            scene.sections.front().fields = {evenField(use, use)};
            const QColor seen = middleOf(painted(scene, "front", {}, style));
            const QColor wanted = stressColour(static_cast<double>(use), isForColourBlind);
            // Wrong: another number than the legend's.
            QVERIFY2(isHueOf(seen, wanted),
                     qPrintable(seen.name() + QStringLiteral(" for ") + wanted.name()));
        }
    }
}

void TestFieldPainter::seenThroughNoOther()
{
    Scene scene = plateScene({0.0, 30.0});
    const QImage plain = painted(scene, "front");
    const bool isFirstBehind =
        scene.sections[0].frame.origin.z() < scene.sections[1].frame.origin.z();
    scene.sections[isFirstBehind ? 0 : 1].fields = {evenField(1.0f, 1.0f)};
    QCOMPARE(middleOf(painted(scene, "front")), middleOf(plain));
    // Of two in one plane it is on its own.
    Scene one = plateScene({0.0, 0.0});
    one.sections[1].fields = {evenField(1.0f, 1.0f)};
    one.sections[0].isHidden = true;
    QVERIFY(isHueOf(middleOf(painted(one, "front")), stressColour(1.0, false)));
}

void TestFieldPainter::onWhatLetsLightThrough()
{
    for (const auto quality : {FrameQuality::Full, FrameQuality::Plain}) {
        Scene scene = plateScene({0.0});
        scene.sections.front().look.alpha = 0.5;
        scene.sections.front().fields = {evenField(1.0f, 1.0f)};
        RenderOptions options;
        options.quality = quality;
        const QColor seen = middleOf(painted(scene, "front", options));
        QVERIFY2(isHueOf(seen, stressColour(1.0, false)), qPrintable(seen.name()));
    }
}

void TestFieldPainter::cutOpen()
{
    Scene scene = plateScene({0.0});
    RenderOptions options;
    options.clip = ClipPlane{Vec3(-10.0, 0.0, 0.0), Vec3::UnitX()}; // the right half is gone
    const QImage gone = painted(scene, "front", options);
    scene.sections.front().fields = {evenField(1.0f, 1.0f)};
    const QImage cut = painted(scene, "front", options);
    QCOMPARE(middleOf(cut), middleOf(gone));
    QVERIFY(
        isHueOf(cut.pixelColor(cut.width() / 4 + 8, cut.height() / 2), stressColour(1.0, false)));
}

void TestFieldPainter::fadedWhileItIsOlder()
{
    Scene scene = plateScene({0.0});
    const QColor plain = middleOf(painted(scene, "front"));
    scene.sections.front().fields = {evenField(1.0f, 1.0f)};
    const QColor full = middleOf(painted(scene, "front"));
    RenderOptions options;
    options.stressAlpha = 0.4;
    const QColor faded = middleOf(painted(scene, "front", options));
    // Wrong: what is known of an older model looks as sure as the rest.
    QVERIFY(faded.green() > full.green() && faded.green() < plain.green());
}

// Wrong: of a thin leg, of which one sees the wall, one sees nothing.
void TestFieldPainter::wallsHaveWhatTheirEdgeHas()
{
    Scene scene = plateScene({0.0});
    StressField field = *evenField(0.5f, 0.5f);
    field.use = {std::vector<float>{1.0f, 1.0f, 0.3f, 0.3f}, {1.0f, 1.0f, 0.3f, 0.3f}};
    const auto shared = std::make_shared<const StressField>(field);
    scene.sections.front().fields = {shared};
    const FieldMesh mesh = fieldMesh(scene.sections.front(), field);
    QCOMPARE(mesh.vertices.size(), mesh.shares.size());
    int walls = 0;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const double up = (mesh.vertices[i].position[1] - 20.0) / 80.0;
        QVERIFY(std::abs(mesh.shares[i] - (1.0 - 0.7 * up)) < 1e-5);
        walls += mesh.vertices[i].normal[3] == 127 ? 1 : 0;
    }
    QVERIFY(walls >= 16);
    // From the top one sees its upper wall alone.
    const auto wall = [&](float use) {
        scene.sections.front().fields = {evenField(use, use)};
        return middleOf(painted(scene, "top"));
    };
    QVERIFY(isHueOf(wall(1.0f), stressColour(1.0, false)));
    QVERIFY(isHueOf(wall(0.6f), stressColour(0.6, false)));
    const QColor little = wall(0.1f);
    scene.sections.front().fields.clear();
    QCOMPARE(little, middleOf(painted(scene, "top")));
}

void TestFieldPainter::wallsOfOtherPiecesHaveNone()
{
    Scene scene = plateScene({0.0});
    StressField field = *evenField(1.0f, 1.0f);
    for (Vec2 &point : field.points)
        point.x() += 90.0;
    for (const SlabVertex &vertex : fieldMesh(scene.sections.front(), field).vertices)
        QVERIFY(vertex.normal[3] == 0);
}

// Wrong: a vertex, a line or a colour that stays where it was, or goes another way.
void TestFieldPainter::bentOnTheCard()
{
    constexpr double kWay = 12.0, kTimes = 4.0; // mm
    for (const bool hasField : {false, true}) {
        Scene there = plateScene({0.0}), bent = there;
        const Camera camera = cameraFor(there, "iso1", kView);
        const StressFieldPointer field = evenField(0.8f, 0.8f);
        SceneSection &section = bent.sections.front();
        section.bent = std::make_shared<const BentSlab>(bentSlab(
            *field, std::vector<Vec3>(4, Vec3(kWay, 2.0, -1.0) / kTimes), 0.5 * section.thickness));
        section.bentTimes = kTimes;
        SceneSection &moved = there.sections.front();
        moved.frame.origin = moved.frame.toWorld(Vec2(kWay, 2.0)) - moved.frame.normal();
        for (Scene *scene : {&there, &bent}) {
            scene->bounds.extend(scene->bounds.max + Vec3::Constant(20.0));
            scene->sections.front().bounds = scene->bounds;
            if (hasField)
                scene->sections.front().fields = {field};
        }
        const auto picture = [&](const Scene &scene) {
            return OffscreenPainter().paint(scene, camera, kView, 1.0, {}, {});
        };
        const QImage a = picture(there), b = picture(bent);
        int different = 0;
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x) {
                const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
                different += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                                         std::abs(p.blue() - q.blue()) >
                                     24
                                 ? 1
                                 : 0;
            }
        QVERIFY2(different < 30, qPrintable(QString::number(different)));
    }
}

FFF_TEST_WITH(TestFieldPainter, fff::testing::runWithin<TestFieldPainter, QGuiApplication>)
#include "tst_field_painter.moc"
