#include <QGuiApplication>
#include <QTest>

#include "core/analysis/analysis.h"
#include "core/operations/evaluate.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/view/offscreen_image.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

Analysis crossedPlates()
{
    AnalysisCaches caches;
    return analyse(twoSections(polygonShape(rectangle(-60, 0, 60, 40)), front(),
                               polygonShape(rectangle(-60, 0, 60, 40)), side()),
                   caches);
}

/// The box of what differs from the picture of nothing, in pixels.
QRect painted(const QImage &image, const QImage &empty)
{
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixel(x, y) != empty.pixel(x, y))
                box |= QRect(x, y, 1, 1);
    return box;
}

} // namespace

class TestOffscreenImage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void modelFillsThePicture_data();
    void modelFillsThePicture();
    void pixelRatioMakesMorePixels();
    void samePictureEveryTime();
    void whatWasCurrentStaysCurrent();
    void impossibleSizesGiveNone();
    void emptyModelHasAPicture();
    void weightsAreSeenWhole();
};

void TestOffscreenImage::modelFillsThePicture_data()
{
    QTest::addColumn<QString>("view");
    for (const char *view : {"front", "right", "left", "back"})
        QTest::newRow(view) << QString::fromLatin1(view);
}

// A thumbnail in which the model is a speck, or cut off, shows nothing.
void TestOffscreenImage::modelFillsThePicture()
{
    QFETCH(QString, view);
    OffscreenPainter painter;
    QVERIFY(painter.isUsable());
    const Vec2 size(320, 200);
    const Scene scene = sceneOf(crossedPlates());
    const Camera camera = cameraFor(scene, view.toStdString(), size);
    const QImage image = painter.paint(scene, camera, size);
    QCOMPARE(image.size(), QSize(320, 200));
    const QRect box = painted(image, painter.paint(Scene(), camera, size));
    QVERIFY2(box.width() > 250 && box.width() < 290, qPrintable(QString::number(box.width())));
    QVERIFY(std::abs(box.center().x() - 160) <= 3 && std::abs(box.center().y() - 100) <= 3);
}

void TestOffscreenImage::pixelRatioMakesMorePixels()
{
    OffscreenPainter painter;
    const Scene scene = sceneOf(crossedPlates());
    const Vec2 size(176, 132);
    const QImage image = painter.paint(scene, cameraFor(scene, "iso1", size), size, 2.0);
    QCOMPARE(image.size(), QSize(352, 264));
    QCOMPARE(image.devicePixelRatio(), 2.0);
}

// Also after another painter and another size, whose leftovers must not show.
void TestOffscreenImage::samePictureEveryTime()
{
    const Scene scene = sceneOf(crossedPlates());
    const Vec2 size(200, 150);
    const Camera camera = cameraFor(scene, "iso2", size);
    OffscreenPainter painter;
    const QImage first = painter.paint(scene, camera, size);
    painter.paint(Scene(), camera, {300, 300});
    QVERIFY(painter.paint(scene, camera, size) == first);
    QVERIFY(OffscreenPainter().paint(scene, camera, size) == first);
}

// The window paints with its own context while the start page asks for pictures.
void TestOffscreenImage::whatWasCurrentStaysCurrent()
{
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    QVERIFY(context.create() && context.makeCurrent(&surface));
    {
        OffscreenPainter painter;
        QCOMPARE(QOpenGLContext::currentContext(), &context);
        painter.paint(sceneOf(crossedPlates()), Camera(), {50, 50});
        QCOMPARE(QOpenGLContext::currentContext(), &context);
    }
    QCOMPARE(QOpenGLContext::currentContext(), &context);
    context.doneCurrent();
}

void TestOffscreenImage::impossibleSizesGiveNone()
{
    OffscreenPainter painter;
    QVERIFY(painter.paint(Scene(), Camera(), {0, 100}).isNull());
    QVERIFY(painter.paint(Scene(), Camera(), {100000, 100}).isNull());
    QVERIFY(!painter.paint(Scene(), Camera(), {1, 1}).isNull());
}

void TestOffscreenImage::emptyModelHasAPicture()
{
    AnalysisCaches caches;
    const Scene scene = sceneOf(analyse(evaluate(newDocument()), caches));
    OffscreenPainter painter;
    QVERIFY(!painter.paint(scene, cameraFor(scene, "iso1", {64, 64}), {64, 64}).isNull());
}

// Wrong: a glass on a low stand is cut off by the picture's border.
void TestOffscreenImage::weightsAreSeenWhole()
{
    Scene scene;
    scene.bounds = {Vec3(-10.0, 0.0, -10.0), Vec3(10.0, 5.0, 10.0)};
    SceneThing glass;
    glass.preset = "glass";
    glass.mass = 0.3;
    glass.at = Vec3(0.0, 5.0, 0.0);
    scene.things = {glass};
    const Vec2 size(320, 200);
    std::vector<ThingVertex> vertices;
    addTriangles(glass, vertices);
    QVERIFY(!vertices.empty());
    for (const char *view : {"front", "iso1", "top"}) {
        const Camera camera = cameraFor(scene, view, size);
        for (const ThingVertex &vertex : vertices) {
            const Vec2 at = camera.toScreen(
                Vec3(vertex.position[0], vertex.position[1], vertex.position[2]), size);
            QVERIFY(at.minCoeff() >= 0.0 && at.x() <= size.x() && at.y() <= size.y());
        }
    }
    scene.things.front().isHidden = true;
    QVERIFY(cameraFor(scene, "front", size).millimetresPerPixel < 0.2);
}

FFF_TEST_WITH(TestOffscreenImage, fff::testing::runWithin<TestOffscreenImage, QGuiApplication>)
#include "tst_offscreen_image.moc"
