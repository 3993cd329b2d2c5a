// The skin over a model: it is seen before the light background, too.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/templates/template_mesh.h"
#include "tests/core/templates/made_meshes.h"
#include "tests/test_program.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/skin_scene.h"

#include <QGuiApplication>

#include <algorithm>

using namespace fff;
using namespace fff::ui;

class TestSkinScene : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itIsSeenAllOver();
};

// Wrong: where light falls on it, it is as bright as what is behind it.
void TestSkinScene::itIsSeenAllOver()
{
    constexpr int kSide = 300;       // px
    constexpr double kRadius = 60.0; // mm, of a ball
    constexpr int kLeast = 14;       // of 255
    constexpr double kMean = 30.0;
    OffscreenPainter painter;
    QVERIFY(painter.isUsable());
    Scene scene;
    scene.templates.push_back(sceneSkin(
        makeTemplateMesh(mended(test::sphere(kRadius, 60, 90)).value().mesh, {}).value()));
    const Camera camera = cameraFor(scene, "front", Vec2(kSide, kSide));
    const QImage with = painter.paint(scene, camera, Vec2(kSide, kSide));
    scene.templates.clear();
    const QImage without = painter.paint(scene, camera, Vec2(kSide, kSide));
    QVERIFY(!with.isNull() && with.size() == without.size());
    const Vec2 middle = camera.toScreen(Vec3::Zero(), Vec2(kSide, kSide));
    const int reach = static_cast<int>(0.5 * kRadius / camera.millimetresPerPixel);
    const int across = static_cast<int>(middle.x()), down = static_cast<int>(middle.y());
    int count = 0, least = 255;
    double sum = 0.0;
    for (int y = down - reach; y < std::min(down + reach, kSide); ++y)
        for (int x = across - reach; x < across + reach; ++x) {
            const int darker = qGray(without.pixel(x, y)) - qGray(with.pixel(x, y));
            least = std::min(least, darker);
            sum += darker;
            ++count;
        }
    qInfo("at least %d, on average %.1f", least, sum / count);
    QVERIFY2(least >= kLeast, qPrintable(QString::number(least)));
    QVERIFY2(sum >= kMean * count, qPrintable(QString::number(sum / count)));
}

FFF_TEST_WITH(TestSkinScene, fff::testing::runWithin<TestSkinScene, QGuiApplication>)
#include "tst_skin_scene.moc"
