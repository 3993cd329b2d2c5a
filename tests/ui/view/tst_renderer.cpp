// Pictures by the renderer itself, where a law says what must be in them.
#include <QTest>

#include "core/interaction/view_fit.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"
#include "ui/view/marks_over.h"
#include "ui/view/renderer.h"

#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QPainter>

#include <algorithm>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

constexpr int kSide = 200; // px
const Vec2 kViewport(kSide, kSide);
/// A step of a colour that two ways of computing it may differ by.
constexpr int kRounding = 3;

ShapePointer plate(double half = 40.0)
{
    return polygonShape(rectangle(-half, 60 - half, half, 60 + half));
}

Scene sceneOf(const Model &model, AnalysisCaches &caches, SceneBuilder &builder)
{
    builder.setAnalysis(std::make_shared<const Analysis>(analyse(model, caches)));
    return builder.build(model);
}

Scene sceneOf(const Model &model)
{
    AnalysisCaches caches;
    SceneBuilder builder;
    return sceneOf(model, caches, builder);
}

Camera frontView(const Scene &scene)
{
    Camera camera;
    return fitted(camera, scene.bounds, kViewport);
}

Camera named(const Scene &scene, const char *view)
{
    Camera camera;
    orientationOfView(view, camera.orientation);
    return fitted(camera, scene.bounds, kViewport);
}

int differing(const QImage &a, const QImage &b, int by = kRounding)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                       std::abs(qBlue(p) - qBlue(q))});
            count += most > by;
        }
    }
    return count;
}

bool isNear(QRgb p, const QColor &c, int by)
{
    return std::abs(qRed(p) - c.red()) <= by && std::abs(qGreen(p) - c.green()) <= by &&
           std::abs(qBlue(p) - c.blue()) <= by;
}

/// Three plates behind each other and one across them, of acrylics.
std::vector<std::pair<ShapePointer, Frame>> acrylicParts()
{
    return {{plate(45.0), front(-30.0)},
            {plate(35.0), front(0.0)},
            {plate(25.0), front(30.0)},
            {plate(20.0), side(5.0)}};
}

} // namespace

class TestRenderer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void cleanupTestCase();

    void hiddenSectionsAreNotDrawn();
    void xrayShowsWhatIsBehind();
    void ghostsStandBack();
    void problemsAreHatched();
    void cutsAreFilled();
    void acrylicHangsOnNoOrder_data();
    void acrylicHangsOnNoOrder();
    void acrylicInFrontTintsWhatIsBehind();
    void jointsDoNotFlicker_data();
    void jointsDoNotFlicker();
    void perspectiveAgreesWithTheCamera();
    void outlinesDrawNothingAnew();
    void onlyWhatChangedIsUploaded();
    void simplerPicturesAreAlike();
    void coarseAcrylicHasItsTone();
    void tidyingChangesNothingSeen_data();
    void tidyingChangesNothingSeen();
    void marksLieOverIt();
    void aNewShadowChangesNothingElse_data();
    void aNewShadowChangesNothingElse();
    void aNewContextDrawsTheSame();
    void groundCanBeLeftOut();

private:
    QImage paint(const Scene &scene, const Camera &camera, const RenderOptions &options = {});

    QOffscreenSurface m_surface;
    QOpenGLContext m_context;
    std::unique_ptr<Renderer> m_renderer;
};

void TestRenderer::initTestCase()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    m_surface.setFormat(format);
    m_surface.create();
    m_context.setFormat(format);
    QVERIFY(m_context.create());
    QVERIFY(m_context.makeCurrent(&m_surface));
    m_renderer = std::make_unique<Renderer>();
    QVERIFY(m_renderer->initialize());
}

void TestRenderer::cleanupTestCase()
{
    m_renderer->release();
}

QImage TestRenderer::paint(const Scene &scene, const Camera &camera, const RenderOptions &options)
{
    QOpenGLFramebufferObject target(kSide, kSide);
    target.bind();
    m_renderer->render(scene, camera, kViewport, 1.0, ViewStyle(), options);
    return target.toImage().convertToFormat(QImage::Format_RGB32);
}

void TestRenderer::hiddenSectionsAreNotDrawn()
{
    const Model model = twoSections(plate(20.0), front(0.0), plate(40.0), front(30.0));
    Scene scene = sceneOf(model);
    const Camera camera = frontView(scene);
    ViewState view;
    view.hidden.insert(model.ref(1));
    applyView(scene, model, view);
    const QImage without = paint(scene, camera);
    // The same as a model that never had it, seen by the same camera.
    Scene alone = scene;
    alone.sections.pop_back();
    QCOMPARE(differing(without, paint(alone, camera)), 0);
    applyView(scene, model, {});
    QVERIFY(differing(without, paint(scene, camera)) > 1000);
}

void TestRenderer::xrayShowsWhatIsBehind()
{
    const Model model = twoSections(plate(20.0), front(0.0), plate(40.0), front(30.0));
    Scene scene = sceneOf(model);
    Scene alone = scene;
    alone.sections.erase(alone.sections.begin());
    const Camera camera = frontView(scene);
    RenderOptions options;
    options.hasGround = false;
    QCOMPARE(differing(paint(scene, camera, options), paint(alone, camera, options)), 0);
    options.isXray = true;
    QVERIFY(differing(paint(scene, camera, options), paint(alone, camera, options)) > 500);
}

void TestRenderer::ghostsStandBack()
{
    const Model model = twoSections(plate(20.0), front(0.0), plate(40.0), front(30.0));
    Scene scene = sceneOf(model);
    const Camera camera = frontView(scene);
    const QImage solid = paint(scene, camera);
    ViewState view;
    view.isolated.insert(model.ref(0));
    applyView(scene, model, view);
    const QImage ghosted = paint(scene, camera);
    QVERIFY(differing(solid, ghosted) > 1000);
    // What is isolated is seen through the ghost before it.
    Scene alone = scene;
    alone.sections.erase(alone.sections.begin());
    QVERIFY(differing(ghosted, paint(alone, camera)) > 500);
}

void TestRenderer::problemsAreHatched()
{
    const Model model = evaluate(withSection(newDocument(), plate(), front()));
    Scene scene = sceneOf(model);
    ViewState view;
    view.problems.insert(model.ref(0));
    applyView(scene, model, view);
    const QImage image = paint(scene, frontView(scene));
    // Along a line in the face, hatch and face take turns.
    int changes = 0;
    const ViewStyle style;
    bool wasHatch = false;
    for (int x = 60; x < 140; ++x) {
        const QRgb p = image.pixel(x, kSide / 2);
        QVERIFY(qRed(p) > qGreen(p) + 30);
        const bool isHatch =
            qGreen(p) < (style.problemFace.green() + style.problemHatch.green()) / 2;
        changes += isHatch != wasHatch;
        wasHatch = isHatch;
    }
    QVERIFY(changes >= 10);
}

/// Looking into a slab that is cut open one sees its side colour, not its inside.
void TestRenderer::cutsAreFilled()
{
    const Model model = evaluate(withSection(newDocument(), plate(), side()));
    Scene scene = sceneOf(model);
    Camera camera = frontView(scene);
    camera.target = Vec3(0, 60, 0);
    camera.millimetresPerPixel = 0.05; // the 3 mm of its thickness are 60 px
    RenderOptions options;
    options.hasGround = false;
    options.clip = ClipPlane{Vec3(0, 60, 10), Vec3::UnitZ()};
    const QImage image = paint(scene, camera, options);
    for (const int x : {80, 100, 120})
        QVERIFY(isNear(image.pixel(x, kSide / 2), scene.sections[0].look.side, kRounding));
    // What lies before the cut is gone: from behind the plane, nothing at all.
    options.clip = ClipPlane{Vec3(0, 60, -60), Vec3::UnitZ()};
    Scene none = scene;
    none.sections.clear();
    QCOMPARE(differing(paint(scene, camera, options), paint(none, camera, options)), 0);
}

void TestRenderer::acrylicHangsOnNoOrder_data()
{
    QTest::addColumn<std::vector<int>>("order");
    QTest::newRow("back to front") << std::vector{0, 1, 2, 3};
    QTest::newRow("front to back") << std::vector{3, 2, 1, 0};
    QTest::newRow("mixed") << std::vector{2, 0, 3, 1};
}

void TestRenderer::acrylicHangsOnNoOrder()
{
    QFETCH(std::vector<int>, order);
    const auto picture = [&](const std::vector<int> &indices) {
        Scene scene;
        for (const int i : indices) {
            const auto part = acrylicParts()[static_cast<std::size_t>(i)];
            SceneSection section;
            section.shape = part.first;
            section.frame = part.second;
            section.thickness = 3.0;
            section.look = i == 1
                               ? StockLook{QColor(0xd9, 0x56, 0x4a), QColor(0xa5, 0x3a, 0x31), 0.7}
                               : StockLook{QColor(0xbf, 0xdd, 0xe8), QColor(0x7f, 0xb2, 0xc6), 0.7};
            section.bounds = worldBounds(*section.shape, section.frame);
            section.bounds.min -= Vec3::Constant(1.5);
            section.bounds.max += Vec3::Constant(1.5);
            scene.bounds.extend(section.bounds);
            scene.sections.push_back(section);
        }
        return paint(scene, named(scene, "iso1"));
    };
    QCOMPARE(differing(picture(order), picture({0, 1, 2, 3}), 1), 0);
}

void TestRenderer::acrylicInFrontTintsWhatIsBehind()
{
    Scene scene = sceneOf(twoSections(plate(40.0), front(0.0), plate(20.0), front(30.0)));
    const StockLook red{QColor(0xd9, 0x56, 0x4a), QColor(0xa5, 0x3a, 0x31), 0.7};
    const StockLook clear{QColor(0xbf, 0xdd, 0xe8), QColor(0x7f, 0xb2, 0xc6), 0.7};
    const Camera camera = frontView(scene);
    scene.sections[0].look = red;
    scene.sections[1].look = clear;
    const QRgb clearBefore = paint(scene, camera).pixel(kSide / 2, kSide / 2);
    scene.sections[0].look = clear;
    scene.sections[1].look = red;
    const QRgb redBefore = paint(scene, camera).pixel(kSide / 2, kSide / 2);
    // The nearer of two counts more.
    QVERIFY(qRed(redBefore) - qBlue(redBefore) > qRed(clearBefore) - qBlue(clearBefore) + 40);
}

void TestRenderer::jointsDoNotFlicker_data()
{
    QTest::addColumn<double>("zoom");
    QTest::newRow("from near") << 6.0;
    QTest::newRow("as fitted") << 1.0;
    QTest::newRow("from far") << 0.3;
}

/// Where a slab fills a slit, walls of one lie in faces of the other. That the walls are not drawn
/// must not be seen, but for some points on the seam itself: surfaces that flicker would differ in
/// hundreds.
void TestRenderer::jointsDoNotFlicker()
{
    QFETCH(double, zoom);
    const ShapePointer shape = polygonShape(rectangle(-60, 0, 60, 40));
    Scene scene = sceneOf(twoSections(shape, front(), shape, side()));
    QVERIFY(!scene.sections[0].covers->empty());
    Scene walls = scene;
    for (SceneSection &section : walls.sections)
        section.guests.assign(section.guests.size(), -1); // draws all walls
    for (int turn = 0; turn < 12; ++turn) {
        Camera camera = named(scene, turn % 2 ? "iso1" : "iso3");
        camera = orbited(camera, Vec2(7.3 * turn, 2.9 * turn), scene.bounds.center(), kViewport);
        camera = zoomed(camera, zoom, 0.5 * kViewport, kViewport);
        RenderOptions options;
        options.quality = FrameQuality::Plain;
        QVERIFY(differing(paint(scene, camera, options), paint(walls, camera, options), 24) <= 25);
    }
}

/// Where the camera says that a corner is, the picture has one.
void TestRenderer::perspectiveAgreesWithTheCamera()
{
    const Scene scene = sceneOf(evaluate(withSection(newDocument(), plate(), front(25.0))));
    Camera camera = named(scene, "front");
    camera.projection = Projection::Perspective;
    camera = fitted(camera, scene.bounds, kViewport);
    camera.target.z() += 60.0; // so that depth matters
    Scene none = scene;
    none.sections.clear();
    RenderOptions options;
    options.hasGround = false;
    const QImage with = paint(scene, camera, options), without = paint(none, camera, options);
    QRect seen;
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            if (!isNear(with.pixel(x, y), QColor(without.pixel(x, y)), 12))
                seen |= QRect(x, y, 1, 1);
        }
    }
    const Vec2 low = camera.toScreen({-40, 20, 26.5}, kViewport);
    const Vec2 high = camera.toScreen({40, 100, 26.5}, kViewport);
    QVERIFY(std::abs(seen.left() - low.x()) < 2.5);
    QVERIFY(std::abs(seen.right() + 1 - high.x()) < 2.5);
    QVERIFY(std::abs(seen.top() - high.y()) < 2.5);
    QVERIFY(std::abs(seen.bottom() + 1 - low.y()) < 2.5);
}

void TestRenderer::outlinesDrawNothingAnew()
{
    Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    const Camera camera = named(scene, "iso1");
    const QImage before = paint(scene, camera);
    const int draws = m_renderer->drawCount();
    scene.sections[0].isHovered = true;
    const QImage hovered = paint(scene, camera);
    QVERIFY(differing(before, hovered) > 100);
    scene.sections[0].isSelected = true;
    QVERIFY(differing(paint(scene, camera), hovered) > 100);
    scene.sections[0].isHovered = scene.sections[0].isSelected = false;
    QCOMPARE(differing(paint(scene, camera), before), 0);
    QCOMPARE(m_renderer->drawCount(), draws);
}

/// 40 x 40 plates: an edit of one sends that one and those that it meets, 41 at most.
void TestRenderer::onlyWhatChangedIsUploaded()
{
    constexpr int kCount = 40;
    Document document = newDocument();
    const ShapePointer shape = polygonShape(rectangle(-420, 0, 420, 30));
    for (int i = 0; i < kCount; ++i) {
        document = withSection(document, shape, front(20.0 * i - 390.0));
        document = withSection(document, shape, side(20.0 * i - 390.0));
    }
    AnalysisCaches caches;
    SceneBuilder builder;
    const Model before = evaluate(document);
    Scene scene = sceneOf(before, caches, builder);
    const Camera camera = named(scene, "iso1");
    paint(scene, camera);
    const int uploaded = m_renderer->uploadCount();
    paint(scene, orbited(camera, {5, 5}, Vec3::Zero(), kViewport));
    QCOMPARE(m_renderer->uploadCount(), uploaded); // turning sends nothing

    // Lengthen the last one by a little: it meets all that run the other way, as before.
    Frame frame = document.sections.back()->frame;
    frame.origin.x() += 3.0;
    const Model after =
        evaluate(*moveSection(document, document.sections.back()->id, frame), before);
    scene = sceneOf(after, caches, builder);
    paint(scene, camera);
    const int sent = m_renderer->uploadCount() - uploaded;
    QVERIFY(sent >= 1);
    QVERIFY2(sent <= kCount + 1, QByteArray::number(sent).constData());
    paint(scene, camera);
    QCOMPARE(m_renderer->uploadCount() - uploaded, sent);
}

void TestRenderer::simplerPicturesAreAlike()
{
    const Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    const Camera camera = named(scene, "iso1");
    const QImage full = paint(scene, camera);
    RenderOptions options;
    for (const FrameQuality quality : {FrameQuality::Plain, FrameQuality::Coarse}) {
        options.quality = quality;
        // Edges and corners differ, nothing is missing or elsewhere.
        QVERIFY(differing(full, paint(scene, camera, options), 60) < kSide * kSide / 20);
    }
}

/// Wrong: while it is turned on a slow machine clear acrylic is as dark as plywood.
void TestRenderer::coarseAcrylicHasItsTone()
{
    Scene scene = sceneOf(twoSections(plate(40.0), front(0.0), plate(40.0), side(0.0)));
    const Camera camera = frontView(scene);
    const QPoint inside(kSide / 2 + 40, kSide / 2 - 20);
    RenderOptions options;
    options.hasGround = false;
    options.quality = FrameQuality::Coarse;
    const QImage opaque = paint(scene, camera, options);
    for (SceneSection &section : scene.sections)
        section.look.alpha = 0.5;
    const QImage coarse = paint(scene, camera, options);
    options.quality = FrameQuality::Full;
    const QImage full = paint(scene, camera, options);
    QVERIFY(isNear(coarse.pixel(inside), QColor(full.pixel(inside)), 20));
    QVERIFY(!isNear(coarse.pixel(inside), QColor(opaque.pixel(inside)), 20));
}

void TestRenderer::tidyingChangesNothingSeen_data()
{
    QTest::addColumn<double>("alpha");
    QTest::newRow("opaque") << 1.0;
    QTest::newRow("lets light through") << 0.6;
}

/// What is given back at rest is neither seen nor what outlines need.
void TestRenderer::tidyingChangesNothingSeen()
{
    QFETCH(const double, alpha);
    Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    for (SceneSection &section : scene.sections)
        section.look.alpha = alpha;
    const Camera camera = named(scene, "iso1"), turned = named(scene, "iso3");
    Scene selected = scene;
    selected.sections[0].isSelected = true;
    const QImage plain = paint(scene, camera), outlined = paint(selected, camera);
    const QImage other = paint(scene, turned);
    paint(scene, camera);
    const int draws = m_renderer->drawCount();
    for (int i = 0; i < 2; ++i) {
        m_renderer->tidy();
        QCOMPARE(differing(paint(scene, camera), plain), 0);
        QCOMPARE(differing(paint(selected, camera), outlined), 0);
    }
    QCOMPARE(m_renderer->drawCount(), draws);
    QCOMPARE(differing(paint(scene, turned), other), 0);
    m_renderer->tidy();
    QCOMPARE(differing(paint(scene, camera), plain), 0);
}

/// Wrong: a mark is left out, stands on its head, or is blended otherwise than QPainter does.
void TestRenderer::marksLieOverIt()
{
    const Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    const Camera camera = named(scene, "iso1");
    QImage marks(kSide, kSide, QImage::Format_ARGB32_Premultiplied);
    marks.fill(Qt::transparent);
    QPainter painter(&marks);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(3, 5, 40, 20, QColor(200, 30, 30));
    painter.fillRect(kSide - 1, kSide - 1, 1, 1, QColor(30, 200, 30)); // the last corner
    painter.setPen(QPen(QColor(20, 20, 220, 120), 3.0));
    painter.drawLine(0, kSide / 2, kSide / 3, kSide / 4);
    painter.end();
    QOpenGLFramebufferObject target(kSide, kSide);
    target.bind();
    QImage expected = paint(scene, camera);
    QPainter over(&expected);
    over.drawImage(0, 0, marks);
    over.end();
    target.bind();
    m_renderer->render(scene, camera, kViewport, 1.0, ViewStyle());
    m_renderer->drawOver(marks);
    const QImage seen = target.toImage().convertToFormat(QImage::Format_RGB32);
    int worst = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const QColor a = seen.pixelColor(i % kSide, i / kSide),
                     b = expected.pixelColor(i % kSide, i / kSide);
        worst = std::max({worst, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()),
                          std::abs(a.blue() - b.blue())});
    }
    QVERIFY2(worst <= 1, qPrintable(QString::number(worst))); // rounding
    std::vector<QRect> parts = paintedParts(marks);
    qint64 area = 0;
    for (const QRect &part : parts)
        area += qint64(part.width()) * part.height();
    QVERIFY(!parts.empty() && area < kSide * kSide / 2); // of what is empty nothing is drawn
    marks.fill(Qt::transparent);
    QVERIFY(paintedParts(marks).empty());
}

void TestRenderer::aNewShadowChangesNothingElse_data()
{
    QTest::addColumn<int>("quality");
    QTest::newRow("full") << int(FrameQuality::Full);
    QTest::newRow("plain") << int(FrameQuality::Plain);
    QTest::newRow("coarse") << int(FrameQuality::Coarse);
}

/// Grid and ghosts were white in the frame that made the shadow anew, and for as long as it stood.
void TestRenderer::aNewShadowChangesNothingElse()
{
    QFETCH(const int, quality);
    Scene scene = sceneOf(twoSections(plate(20.0), side(0.0), plate(), front(-30.0)));
    const Camera camera = named(scene, "iso1");
    RenderOptions options;
    options.quality = static_cast<FrameQuality>(quality);
    paint(scene, camera, options);
    scene.sections[1].isGhost = true;
    const QImage first = paint(scene, camera, options);
    // Drawn again without a new shadow.
    paint(scene, named(scene, "iso2"), options);
    const QImage second = paint(scene, camera, options);
    QCOMPARE(differing(first, second), 0);
}

void TestRenderer::aNewContextDrawsTheSame()
{
    const Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    const Camera camera = named(scene, "iso2");
    const QImage before = paint(scene, camera);
    m_renderer->release();
    QVERIFY(m_renderer->initialize());
    QCOMPARE(differing(paint(scene, camera), before), 0);
}

void TestRenderer::groundCanBeLeftOut()
{
    const Scene scene = sceneOf(twoSections(plate(), front(), plate(), side()));
    const Camera camera = named(scene, "iso1");
    RenderOptions options;
    options.hasGround = false;
    const QImage without = paint(scene, camera, options);
    QVERIFY(differing(paint(scene, camera), without, 6) > 200);
    // Nothing but the gradient in the lower corner then.
    QVERIFY(isNear(without.pixel(3, kSide - 4), QColor(without.pixel(40, kSide - 4)), 2));
}

FFF_TEST_WITH(TestRenderer, fff::testing::runWithin<TestRenderer, QGuiApplication>)
#include "tst_renderer.moc"
