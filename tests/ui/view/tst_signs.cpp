// Signs that gestures and tools add are painted by kind and role, with nothing that knows the tool.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/units.h"
#include "core/interaction/snapping.h"
#include "core/model/symmetric_section.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"
#include "tests/ui/push_tool.h"
#include "ui/view/overlay_painter.h"
#include "ui/view/point_marks.h"
#include "ui/view/sign_looks.h"
#include "ui/view/sign_painter.h"
#include "ui/view/stroke_marks.h"

#include <QGuiApplication>
#include <QImage>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <utility>
#include <vector>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

const ViewStyle kStyle;

QImage painted(const Interaction &interaction)
{
    const Vec2 size = interaction.viewport();
    QImage image(static_cast<int>(size.x()), static_cast<int>(size.y()),
                 QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    OverlayScene scene{interaction.overlay(), interaction.hovered(), interaction.camera(), size};
    scene.selected = interaction.overlay().selected;
    paintOverlay(painter, scene, kStyle, QLocale::c());
    return image;
}

QImage painted(const std::vector<const Signs *> &all)
{
    const Camera camera;
    const Vec2 size(400.0, 300.0);
    QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    MarkPen pen(painter, camera, size, kStyle);
    paintSigns(pen, all, {}, QLocale::c());
    pen.paintChips();
    return image;
}

/// How many pixels there are that this colour covers whole.
int count(const QImage &image, const QColor &colour, const QRect &where)
{
    int found = 0;
    for (int y = where.top(); y <= where.bottom(); ++y)
        for (int x = where.left(); x <= where.right(); ++x)
            found += image.rect().contains(x, y) && image.pixelColor(x, y) == colour ? 1 : 0;
    return found;
}

/// One of each of the kinds that need no section.
std::vector<Sign> oneOfEach()
{
    const Contour contour =
        Contour::fromPolygon({{-40, -20}, {30, -25}, {35, 30}, {-30, 25}}).value();
    const Frame canvas;
    return {sign::Line{SignRole::Measured, {{-50, 10, 0}, {60, 20, 0}}, true},
            sign::Curve{SignRole::Refused, canvas, contour},
            sign::Region{SignRole::Plane, {{-60, -40, 0}, {50, -40, 0}, {50, 40, 0}}},
            sign::Capsule{SignRole::DeadZone, canvas, 40.0, 20.0},
            sign::Band{{{100, 100}, {260, 210}}},
            sign::Slit{{0, 0, 0}, {40, 0, 0}, true, "Rib", {}, 20.0},
            sign::Ground{{0, -20, 0}, Vec3::UnitX()},
            sign::Rulers{canvas}};
}

/// A rectangle of 60 x 50 mm with its points.
QImage paintedPoints(std::optional<MirrorAxis> axis, std::vector<PointAddress> selected)
{
    Document document =
        withSection(newDocument(), polygonShape(rectangle(-30, -25, 30, 25)), Frame());
    document = *setSymmetry(document, document.sections.front()->id, axis);
    const Section &section = *document.sections.front();
    const Vec2 size(400.0, 300.0);
    QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    const Camera camera;
    MarkPen pen(painter, camera, size, kStyle);
    paintPoints(pen, section, {section.ref(), std::move(selected), {}});
    return image;
}

/// In the middle of a stroke, which has left a plate and draws.
struct MirroredStroke : Desk
{
    MirroredStroke()
    {
        addPlate();
        press(plate(20, 0));
        moveTo(plate(110, 0));
        wait(kTurnTime);
        const Vec2 start = cursor;
        for (const Vec2 &by : {Vec2(120, -40), Vec2(120, -160), Vec2(0, -160)})
            moveTo(start + by);
    }
};

} // namespace

class TestSigns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyRoleHasALook();
    void aToolOfItsOwnIsSeen();
    void aLabelSaysItsMessage();
    void everyKindIsSeen();
    void rulersKeepOffWhatIsDrawn();
    void wordsOfACutStandBesideIt();
    void aLengthStandsBesideItsLine();
    void whatLiesUnderWhatIsNoMatterOfTheOrder();
    void wordsOfAStrokeStandBesideIt();
    void theSlitIsSilentWhileTheOutlineIsDrawn();
    void aSymmetricSectionShowsItsAxis();
    void pointsLightWithTheirImages();
};

// Wrong: a role without a line in the table would take the program down where it is first seen.
void TestSigns::everyRoleHasALook()
{
    for (const SignRole role :
         {SignRole::Measured, SignRole::Dimension, SignRole::Place, SignRole::Figure,
          SignRole::Refused, SignRole::Plane, SignRole::DeadZone, SignRole::Slit})
        QVERIFY((kStyle.*lookOf(role).colour).isValid());
}

// Wrong: a new tool would need fields and a painter of its own to be seen.
void TestSigns::aToolOfItsOwnIsSeen()
{
    Desk desk;
    desk.interaction.setCamera(desk.interaction.camera());
    desk.moveTo({10.0, 10.0});
    const QImage without = painted(desk.interaction);
    desk.interaction.pickUp(std::make_unique<PushTool>(), desk.time);
    desk.moveTo({10.0, 10.0});
    const QImage with = painted(desk.interaction);
    const Vec2 foot = desk.interaction.camera().toScreen(kFoot, desk.interaction.viewport());
    const QPoint at(static_cast<int>(foot.x()), static_cast<int>(foot.y()));
    // A whole arrow to the right, of which the handle hides the beginning.
    QVERIFY(count(with, kStyle.slit, {at + QPoint(8, -8), QSize(30, 17)}) > 30);
    QCOMPARE(count(with, kStyle.slit, {at + QPoint(-60, -8), QSize(50, 17)}), 0);
    QVERIFY(count(with, kStyle.guide, {at - QPoint(6, 6), QSize(13, 13)}) > 4);
    QVERIFY(count(with, kStyle.panel, {at - QPoint(2, 2), QSize(4, 4)}) > 8); // within the ring
    QVERIFY(count(with, kStyle.accent, {at + QPoint(-80, 45), QSize(160, 30)}) > 60);
    // Laid down it leaves nothing.
    desk.interaction.layDown(desk.time);
    desk.moveTo({10.0, 10.0});
    QVERIFY(desk.interaction.overlay().held.isEmpty());
    const QRect where(at - QPoint(100, 60),
                      QSize(200, 160)); // letters elsewhere: a shade off at times
    QCOMPARE(painted(desk.interaction).copy(where), without.copy(where));
    QVERIFY(with.copy(where) != without.copy(where));
}

// Wrong: another message would look the same, or a length would not be in the person's unit.
void TestSigns::aLabelSaysItsMessage()
{
    const auto labelled = [](const Message &words) {
        Signs signs;
        signs.add(sign::Label{SignRole::Measured, {Vec3::Zero()}, words});
        return painted({&signs});
    };
    const Text text{"Test", "%1 sideways"};
    QCOMPARE(labelled({text, {lengthOf(25.0)}}), labelled({text, {lengthOf(25.0)}}));
    QVERIFY(labelled({text, {lengthOf(25.0)}}) != labelled({text, {lengthOf(52.0)}}));
}

void TestSigns::everyKindIsSeen()
{
    const Signs none;
    const QImage empty = painted({&none});
    for (const Sign &sign : oneOfEach()) {
        Signs signs;
        signs.add(sign);
        QVERIFY2(painted({&signs}) != empty, qPrintable(QString::number(sign.index())));
    }
}

// Wrong: which tool came first would decide whether one sees a slit over its dead zone.
void TestSigns::whatLiesUnderWhatIsNoMatterOfTheOrder()
{
    std::mt19937 random(20260801);
    std::vector<Sign> all = oneOfEach();
    const auto together = [&all](std::size_t held) {
        Signs drawn, rest;
        for (std::size_t i = 0; i < all.size(); ++i)
            (i < held ? drawn : rest).add(all[i]);
        return painted({&drawn, &rest});
    };
    const QImage first = together(all.size());
    for (int i = 0; i < 20; ++i) {
        std::shuffle(all.begin(), all.end(), random);
        // Of those that share a layer the later one lies over the earlier one.
        std::stable_partition(all.begin(), all.end(), [](const Sign &sign) {
            return std::holds_alternative<sign::Line>(sign);
        });
        QCOMPARE(together(static_cast<std::size_t>(i) % (all.size() + 1)), first);
    }
}

// Wrong: a ruler runs through the middle of the section that it measures, or through the scale bar.
void TestSigns::rulersKeepOffWhatIsDrawn()
{
    for (const Vec2 &size : {Vec2(860.0, 760.0), Vec2(713.0, 496.0)})
        for (const char *view : {"front", "back", "right", "left", "top", "bottom"})
            for (const double height : {30.0, 90.0, 400.0}) { // of the section's middle
                Camera camera;
                QVERIFY(orientationOfView(view, camera.orientation));
                // A square of 60 mm that faces the eye.
                Frame canvas{{0.0, height, 0.0}, camera.right(), camera.up()};
                camera.target = canvas.origin;
                camera.millimetresPerPixel = 0.25;
                canvas = ownGrid(canvas, camera.orientation);
                QImage image(static_cast<int>(size.x()), static_cast<int>(size.y()),
                             QImage::Format_ARGB32_Premultiplied);
                image.fill(Qt::transparent);
                QPainter painter(&image);
                MarkPen pen(painter, camera, size, kStyle);
                Signs signs;
                signs.add(sign::Rulers{canvas});
                paintSigns(pen, {&signs}, {}, QLocale::c());
                painter.end();
                const auto ink = [&image](const QRect &where) {
                    int found = 0;
                    for (int y = where.top(); y <= where.bottom(); ++y)
                        for (int x = where.left(); x <= where.right(); ++x)
                            found += qAlpha(image.pixel(x, y)) > 0 ? 1 : 0;
                    return found;
                };
                const QPoint middle(image.width() / 2, image.height() / 2);
                QCOMPARE(ink({middle - QPoint(119, 119), QSize(238, 238)}), 0);
                // Bar and number, at the lower left.
                QCOMPARE(ink({0, image.height() - 37, 180, 37}), 0);
                QVERIFY(ink(image.rect()) > 1000);
            }
}

// Wrong: the words stand far from the cut, by a control point that nobody sees.
void TestSigns::wordsOfACutStandBesideIt()
{
    // A leg that is 40 mm wide at the ground, and bulges below it.
    const Contour leg = Contour::ofSegments({{{-20, 60}, {-20, 40}, {-20, 20}, {-20, 0}},
                                             {{-20, 0}, {-120, -80}, {120, -80}, {20, 0}},
                                             {{20, 0}, {20, 20}, {20, 40}, {20, 60}},
                                             {{20, 60}, {10, 60}, {-10, 60}, {-20, 60}}});
    Camera camera;
    camera.target = Vec3(0.0, 20.0, 0.0);
    camera.millimetresPerPixel = 0.4;
    const Vec2 size(800.0, 600.0);
    QImage image(800, 600, QImage::Format_ARGB32_Premultiplied);
    for (const double cursor : {-30.0, 30.0}) {
        QPainter painter(&image);
        MarkPen pen(painter, camera, size, kStyle);
        paintCutChip(pen, leg, Frame(), {cursor, 40.0});
        const std::vector<QRectF> boxes = pen.paintChips();
        QCOMPARE(boxes.size(), std::size_t(1));
        const Vec2 cut = camera.toScreen({cursor < 0.0 ? 20.0 : -20.0, 0.0, 0.0}, size);
        const QRectF &box = boxes.front();
        const double off = cursor < 0.0 ? box.left() - cut.x() : cut.x() - box.right();
        QVERIFY(off > 0.0 && off < 20.0);
        QVERIFY(box.top() >= cut.y() && box.top() < cut.y() + 12.0);
    }
}

// Wrong: a chip that hides the line whose length it says.
void TestSigns::aLengthStandsBesideItsLine()
{
    Camera camera;
    camera.target = Vec3::Zero();
    camera.millimetresPerPixel = 0.4;
    const Vec2 size(800.0, 600.0);
    QImage image(800, 600, QImage::Format_ARGB32_Premultiplied);
    for (int turn = 0; turn < 180; turn += 15)
        for (const double half : {1.0, 15.0, 60.0}) { // also one that is shorter than its words
            const double angle = radians(static_cast<double>(turn));
            const Vec3 end(half * std::cos(angle), half * std::sin(angle), 0.0);
            Signs signs;
            signs.add(sign::Line{SignRole::Measured, {-end, end}, true});
            signs.add(sign::Label{SignRole::Measured, {-end, end}, sign::Way{2.0 * end}});
            QPainter painter(&image);
            MarkPen pen(painter, camera, size, kStyle);
            paintSigns(pen, {&signs}, {}, QLocale::c());
            const std::vector<QRectF> boxes = pen.paintChips();
            QCOMPARE(boxes.size(), std::size_t(1));
            for (int i = 0; i <= 200; ++i) {
                const Vec2 p = camera.toScreen((i / 100.0 - 1.0) * end, size);
                QVERIFY(!boxes.front().contains(QPointF(p.x(), p.y())));
            }
            const QPointF off = boxes.front().center() - QPointF(400.0, 300.0);
            QVERIFY(std::hypot(off.x(), off.y()) < 140.0);
        }
}

// Wrong: the size lies on the line that is drawn.
void TestSigns::wordsOfAStrokeStandBesideIt()
{
    // The hand is at the left of what it draws, which goes on to the right of the cursor.
    sign::Stroke stroke;
    stroke.samples = {{-40, -20}, {30, -25}, {35, 30}, {-30, 25}, {-38, 0}};
    const auto drawn = [&stroke] {
        Signs signs;
        signs.add(stroke);
        return painted({&signs});
    };
    const QImage bare = drawn();
    stroke.size = Vec2(75.0, 55.0);
    const QImage sized = drawn();
    QVERIFY(sized != bare);
    const Camera camera;
    const Vec2 size(400.0, 300.0);
    Box2 box;
    for (const Vec2 &p : stroke.samples)
        box.extend(camera.toScreen(Vec3(p.x(), p.y(), 0.0), size));
    const QRect inside(QPoint(int(box.min.x()), int(box.min.y())),
                       QPoint(int(box.max.x()), int(box.max.y())));
    QVERIFY(inside.width() > 40);
    QCOMPARE(sized.copy(inside), bare.copy(inside));
}

// Wrong: the slit's length stands in the middle of the outline.
void TestSigns::theSlitIsSilentWhileTheOutlineIsDrawn()
{
    sign::Slit slit{{0, 0, 0}, {40, 0, 0}, true, "Rib", {}, 20.0};
    const auto ink = [&slit] {
        Signs signs;
        signs.add(slit);
        return count(painted({&signs}), kStyle.slit, {0, 0, 400, 300});
    };
    const int with = ink();
    slit.hasWords = false;
    QVERIFY(ink() > 20); // its line
    QVERIFY(ink() < with - 20);
    MirroredStroke desk;
    QVERIFY(desk.interaction.overlay().find<sign::Stroke>());
    QVERIFY(!desk.interaction.overlay().find<sign::Slit>()->hasWords);
}

// Wrong: that it is symmetric, and to what, is not seen once it is drawn.
void TestSigns::aSymmetricSectionShowsItsAxis()
{
    const auto ink = [](std::optional<MirrorAxis> axis) {
        return count(paintedPoints(axis, {}), kStyle.symmetry, {0, 0, 400, 300});
    };
    QCOMPARE(ink({}), 0);
    QVERIFY(ink(MirrorAxis{Vec2::Zero(), Vec2::UnitY()}) > 30);
}

// Wrong: a point is dragged, and what moves with it on the other side stays dark.
void TestSigns::pointsLightWithTheirImages()
{
    const auto lit = [](std::optional<MirrorAxis> axis, double x, double y) {
        const Vec2 at = Camera().toScreen(Vec3(x, y, 0.0), {400.0, 300.0});
        return count(paintedPoints(axis, {{0, 2}}), kStyle.accent,
                     {QPoint(int(at.x()) - 2, int(at.y()) - 2), QSize(4, 4)}) > 8;
    };
    const MirrorAxis axis{Vec2::Zero(), Vec2::UnitY()};
    QVERIFY(lit({}, 30, 25) && lit(axis, 30, 25));
    QVERIFY(!lit({}, -30, 25) && lit(axis, -30, 25));
    QVERIFY(!lit(axis, -30, -25) && !lit(axis, 30, -25));
}

FFF_TEST_WITH(TestSigns, fff::testing::runWithin<TestSigns, QGuiApplication>)
#include "tst_signs.moc"
