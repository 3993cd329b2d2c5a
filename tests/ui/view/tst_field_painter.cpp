// Stress as a colour over the faces of sections.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
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

FFF_TEST_WITH(TestFieldPainter, fff::testing::runWithin<TestFieldPainter, QGuiApplication>)
#include "tst_field_painter.moc"
