// Sections that were drawn mirrored stay so when their points are edited.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/geometry/mirrored_boundaries.h"
#include "core/interaction/section_editing.h"
#include "core/interaction/symmetry_editing.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/model/symmetric_section.h"
#include "core/model/transformed.h"
#include "tests/core/interaction/desk.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <cmath>
#include <numbers>
#include <random>

using namespace fff;
using namespace fff::test;

namespace {

/// A plate and, drawn as one half across its right edge, a section that stands on it.
struct MirroredDesk : Desk
{
    explicit MirroredDesk(double rise = 0.0)
    {
        addPlate();
        press(plate(20, 0));
        moveTo(plate(110, rise));
        wait(kTurnTime);
        const Vec2 start = cursor;
        for (int i = 1; i <= 60; ++i) {
            const double angle = std::numbers::pi * i / 60;
            send(Type::Move, start + Vec2(110.0 * (std::cos(angle) - 1.0) + 40.0 * std::sin(angle),
                                          -90.0 * std::sin(angle) - 12.0 * std::sin(3.0 * angle)));
        }
        release(cursor);
    }
    const SectionPointer &drawn() const { return sections().back(); }
};

/// Largest distance of a control point's image from the nearest control point, mm.
double asymmetry(const Shape &shape, const MirrorAxis &axis)
{
    std::vector<Vec2> points = shape.contour().points();
    for (const Contour &hole : shape.holes())
        points.insert(points.end(), hole.points().begin(), hole.points().end());
    double most = 0.0;
    for (const Vec2 &p : points) {
        double least = 1e9;
        for (const Vec2 &q : points)
            least = std::min(least, (q - axis.mirrored(p)).norm());
        most = std::max(most, least);
    }
    return most;
}

PointSelection selectionOf(const Section &section, const PointAddress &point)
{
    PointSelection points;
    points.select(section, {point});
    return points;
}

/// One edit of a point of some kind; what a person may do.
PointEdit randomEdit(const Document &document, const Section &section, std::mt19937 &random)
{
    const auto in = [&](int count) { return static_cast<int>(random() % unsigned(count)); };
    const auto mm = [&] { return 0.1 * (in(161) - 80); };
    const Shape &shape = *section.shape;
    const int ring = in(boundaryCount(shape));
    const PointAddress at{ring, in(boundary(shape, ring).segmentCount())};
    const PointSelection points = selectionOf(section, at);
    const PointRules rules{.cutsAtGround = false};
    switch (in(6)) {
    case 0:
    case 1:
        return movedSelection(document, points, {mm(), mm()}, rules);
    case 2:
        return withInsertedPoint(document, section.id, ring, {at.index, 0.1 + 0.1 * in(9)}, rules);
    case 3:
        return withoutSelection(document, points, rules);
    case 4:
        return withSelectionOfKind(document, points,
                                   std::array{PointKind::Corner, PointKind::Smooth,
                                              PointKind::Symmetric}[std::size_t(in(3))],
                                   rules);
    default: {
        const Vec2 handleAt = handle(boundary(shape, ring), at.index, HandleSide::Out);
        return withEditedShape(
            document, section.id,
            movedHandle(shape, at, HandleSide::Out, handleAt + Vec2(mm(), mm()), false), {}, {},
            rules);
    }
    }
}

} // namespace

class TestSymmetricSection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsDrawnMirroredStaysSo();
    void whatIsNotMirroredIsFree();
    void noOtherPointLightsInADrag();
    void imagesHoldAfterManyEdits_data();
    void imagesHoldAfterManyEdits();
    void undoGivesTheVeryObjectsBack();
    void aPointMovesItsImage();
    void switchedOffAndOn();
    void aHoleOnOneSideEndsItForAsLong();
    void savedAndRead();
    void goesAlong();
    void xIsRightAndYIsUp();
    void sizesAreTheSameEverywhere();
};

void TestSymmetricSection::whatIsDrawnMirroredStaysSo()
{
    for (const double rise : {0.0, 14.0, -23.0}) {
        MirroredDesk desk(rise);
        QCOMPARE(desk.sections().size(), std::size_t(2));
        const MirrorAxis *axis = symmetryOf(*desk.drawn());
        QVERIFY(axis);
        // It is the slit's.
        const Frame &plate = desk.sections().front()->frame;
        for (const Vec2 &end : {desk.drawn()->parent->slitFrom, desk.drawn()->parent->slitTo})
            QVERIFY(std::abs(axis->height(desk.drawn()->frame.toLocal(plate.toWorld(end)))) < 1e-9);
        QVERIFY(asymmetry(*desk.drawn()->shape, *axis) < 1e-9);
    }
}

void TestSymmetricSection::whatIsNotMirroredIsFree()
{
    Desk desk;
    desk.interaction.settings().mirrors = false;
    desk.addPlate();
    desk.press(desk.plate(20, 0));
    desk.moveTo(desk.plate(110, 0));
    desk.wait(kTurnTime);
    const Vec2 start = desk.cursor;
    for (const Vec2 &p : {Vec2(90, 60), Vec2(90, -80), Vec2(-80, -80)})
        desk.moveTo(start + p);
    desk.release(desk.cursor);
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(!desk.sections().back()->symmetry);
}

void TestSymmetricSection::imagesHoldAfterManyEdits_data()
{
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 8; ++seed)
        QTest::addRow("seed %d", seed) << seed;
}

// Wrong: halves drift apart, or grow points that nobody set.
void TestSymmetricSection::imagesHoldAfterManyEdits()
{
    QFETCH(int, seed);
    MirroredDesk desk(seed % 2 ? 0.0 : 14.0);
    std::mt19937 random(static_cast<unsigned>(seed));
    Document document = desk.session.committed().document;
    const SectionId id = desk.drawn()->id;
    const MirrorAxis axis = *desk.drawn()->symmetry;
    int done = 0;
    for (int tries = 0; done < 100 && tries < 1000; ++tries) {
        const Section &section = *document.find(id);
        PointEdit edit = randomEdit(document, section, random);
        if (!edit || edit->document.find(id)->shape == section.shape)
            continue;
        document = std::move(edit->document);
        ++done;
        const Section &now = *document.find(id);
        const double off = asymmetry(*now.shape, axis);
        QVERIFY2(off < 1e-9, qPrintable(QStringLiteral("edit %1: %2 mm").arg(done).arg(off)));
        QVERIFY(symmetryOf(now));
        QVERIFY(now.shape->isPlain());
    }
    QCOMPARE(done, 100);
}

void TestSymmetricSection::undoGivesTheVeryObjectsBack()
{
    MirroredDesk desk;
    std::mt19937 random(3);
    std::vector<SectionPointer> before;
    for (int tries = 0; before.size() < 20 && tries < 300; ++tries) {
        const SectionPointer section = desk.drawn();
        PointEdit edit = randomEdit(desk.session.committed().document, *section, random);
        if (!edit || edit->document.find(section->id)->shape == section->shape)
            continue;
        before.push_back(section);
        desk.session.commit(QStringLiteral("Edit"), std::move(edit->document));
    }
    QCOMPARE(before.size(), std::size_t(20));
    while (!before.empty()) {
        desk.session.history()->undo();
        QCOMPARE(desk.drawn(), before.back());
        before.pop_back();
    }
}

void TestSymmetricSection::aPointMovesItsImage()
{
    MirroredDesk desk;
    const Section &section = *desk.drawn();
    const MirrorAxis axis = *section.symmetry;
    const Contour &contour = section.shape->contour();
    int index = 0; // the one farthest from the axis
    for (int i = 0; i < contour.segmentCount(); ++i)
        if (axis.height(anchor(contour, i)) > axis.height(anchor(contour, index)))
            index = i;
    const Vec2 was = anchor(contour, index), by(3.0, 2.0);
    const PointEdit edit =
        movedSelection(desk.session.committed().document, selectionOf(section, {0, index}), by, {});
    QVERIFY(edit);
    const Section &now = *edit->document.find(section.id);
    const auto has = [&](const Vec2 &p) {
        for (int i = 0; i < now.shape->contour().segmentCount(); ++i)
            if ((anchor(now.shape->contour(), i) - p).norm() < 1e-9)
                return true;
        return false;
    };
    QVERIFY(has(was + by));
    QVERIFY(has(axis.mirrored(was + by)));
    QVERIFY(!has(was) && !has(axis.mirrored(was)));
    QCOMPARE(now.shape->contour().segmentCount(), contour.segmentCount());
    QCOMPARE(edit->points.size(), std::size_t(1)); // it is selected still, its image is not
}

void TestSymmetricSection::switchedOffAndOn()
{
    MirroredDesk desk;
    desk.interaction.select({desk.drawn()->id});
    QVERIFY(desk.commands.isOn("section.symmetric") == true);
    desk.run("section.symmetric", {{"on", "false"}});
    QVERIFY(!symmetryOf(*desk.drawn()));
    QCOMPARE(desk.lastStep(), QStringLiteral("Let the halves of Section 2 differ"));
    desk.run("section.symmetric", {{"on", "true"}});
    QVERIFY(symmetryOf(*desk.drawn())); // to its slit, as it is that still
    desk.session.history()->undo();
    const PointEdit edit = movedSelection(desk.session.committed().document,
                                          selectionOf(*desk.drawn(), {0, 1}), {1.0, 1.5}, {});
    QVERIFY(edit);
    const Section &now = *edit->document.find(desk.drawn()->id);
    QVERIFY(!symmetryAxis(now, edit->document));
    desk.session.commit(QStringLiteral("Edit"), edit->document);
    QVERIFY(!desk.commands.isEnabled("section.symmetric"));
    // A plate is symmetric, and can be kept so.
    desk.interaction.select({desk.sections().front()->id});
    QVERIFY(desk.commands.isOn("section.symmetric") == false);
    desk.run("section.symmetric");
    QVERIFY(symmetryOf(*desk.sections().front()));
}

/// It counts as long as it is true, as a figure does.
void TestSymmetricSection::aHoleOnOneSideEndsItForAsLong()
{
    MirroredDesk desk;
    const Section section = *desk.drawn();
    const MirrorAxis axis = *section.symmetry;
    const Vec2 off = section.shape->bounds().center() + 12.0 * perpendicular(axis.direction);
    const Result<ShapePointer> holed =
        Shape::make(section.shape->contour(), {test::circle(off, 4.0)});
    QVERIFY(holed);
    const Document document = *setShape(desk.session.committed().document, section.id, *holed);
    QVERIFY(!symmetryOf(*document.find(section.id)));
    // An edit then leaves the other half and the hole alone.
    const PointEdit edit =
        movedSelection(document, selectionOf(*document.find(section.id), {0, 1}), {0.5, 0.5}, {});
    QVERIFY(edit);
    QCOMPARE(edit->document.find(section.id)->shape->holes().size(), std::size_t(1));
    QVERIFY(symmetryOf(*setShape(document, section.id, section.shape)->find(section.id)));
}

void TestSymmetricSection::savedAndRead()
{
    MirroredDesk desk(14.0);
    const Document &document = desk.session.committed().document;
    const Result<std::string> text = io::writeFff(document);
    QVERIFY(text);
    const auto loaded = io::readFff(*text);
    QVERIFY(loaded);
    QVERIFY(*loaded->document.sections.back() == *document.sections.back());
    QVERIFY(symmetryOf(*loaded->document.sections.back()));
    // What is no direction is none.
    std::string spoilt = *text;
    const std::size_t at = spoilt.find("\"direction\": [");
    QVERIFY(at != std::string::npos);
    spoilt.insert(at + 14, "7");
    QVERIFY(!io::readFff(spoilt));
}

void TestSymmetricSection::goesAlong()
{
    MirroredDesk desk(14.0);
    const Model &model = desk.session.committed();
    const SectionRef ref = desk.drawn()->id;
    const auto lastOf = [](const SectionEdit &edit) -> const Section & {
        return *edit->document.sections.back();
    };
    const SectionEdit copy = duplicated(model, {ref}, {10, 20, 30});
    QVERIFY(copy && symmetryOf(lastOf(copy)));
    const SectionEdit image = mirroredCopy(model, {ref}, {200, 0, 0}, Vec3::UnitX());
    QVERIFY(image && symmetryOf(lastOf(image)));
    Transform transform;
    transform.pivot = {10, 20, 30};
    transform.factor = 1.7;
    transform.way = {5, 6, 7};
    const SectionEdit scaled =
        fff::transformed(model, {ref}, transform, desk.drawn()->frame, false);
    QVERIFY(scaled && symmetryOf(lastOf(scaled)));
    // Stretched along or across it still is, stretched askew it is not.
    const Section &section = *desk.drawn();
    const Vec2 along = section.symmetry->direction, across = perpendicular(along);
    const auto stretchedBy = [&](const Vec2 &way) {
        PlaneMap map;
        map.matrix = Eigen::Matrix2d::Identity() + 0.4 * way * way.transpose();
        map.about = {3, 4};
        return *stretched(section, map);
    };
    QVERIFY(symmetryOf(stretchedBy(along)) && symmetryOf(stretchedBy(across)));
    QVERIFY(!symmetryOf(stretchedBy((along + across).normalized())));
}

// Wrong: "X 20" of a point is a place below it, or the other way round.
void TestSymmetricSection::xIsRightAndYIsUp()
{
    for (const double rise : {0.0, 14.0, -23.0, 300.0}) {
        MirroredDesk desk(rise);
        const Frame &frame = desk.drawn()->frame;
        const Camera &camera = desk.interaction.camera();
        QVERIFY(frame.x.dot(camera.right()) > 0.999);
        QVERIFY(frame.y.dot(camera.up()) > 0.999);
        QVERIFY(frame.normal().dot(camera.backward()) > 0.999);
        const Frame &plate = desk.sections().front()->frame;
        QVERIFY((frame.origin - plate.toWorld(desk.drawn()->parent->slitFrom)).norm() < 1e-9);
    }
}

void TestSymmetricSection::sizesAreTheSameEverywhere()
{
    Desk desk;
    desk.addPlate();
    for (const Vec2 &to : {Vec2(110, 0), Vec2(20, 70), Vec2(-110, 30)}) {
        desk.wait(1000.0);
        desk.run("view.front");
        desk.wait(2000.0);
        desk.press(desk.plate(20, 0));
        desk.moveTo(desk.plate(to.x(), to.y()));
        desk.wait(kTurnTime);
        const Vec2 start = desk.cursor;
        // Beside its slit, and not in the way of the next one.
        const Modifiers ctrl{.control = true};
        for (const Vec2 &p : {Vec2(60, 160), Vec2(60, -180), Vec2(-80, -180)})
            desk.moveTo(start + p, ctrl);
        const auto *stroke = desk.interaction.overlay().find<sign::Stroke>();
        QVERIFY(stroke && stroke->size);
        const Vec2 said = *stroke->size;
        desk.release(desk.cursor, Button::Left, ctrl);
        QVERIFY((desk.sections().back()->shape->bounds().size() - said).norm() < 1e-9);
        const Vec3 right = desk.interaction.camera().right();
        QVERIFY(std::abs(desk.sections().back()->frame.x.dot(right)) > 0.999);
    }
}

// Wrong: the edit gives points other numbers, and the one that was pressed lights elsewhere.
void TestSymmetricSection::noOtherPointLightsInADrag()
{
    MirroredDesk desk;
    desk.interaction.select({desk.drawn()->ref()});
    const auto at = [&](int i) {
        return desk.screen(desk.drawn()->frame.toWorld(anchor(desk.drawn()->shape->contour(), i)));
    };
    int tried = 0;
    for (int i = 0; i < desk.drawn()->shape->contour().segmentCount(); ++i) {
        const Vec2 from = at(i);
        desk.moveTo(from);
        const auto hovered = desk.interaction.hoveredPoint();
        if (!hovered || hovered->kind != PointTarget::Kind::Anchor)
            continue;
        ++tried;
        desk.press(from);
        desk.moveTo(from + Vec2(9, -9));
        const sign::Points *points = desk.interaction.overlay().find<sign::Points>();
        QVERIFY(points && !points->hovered);
        QVERIFY(desk.interaction.escape(desk.time += 8.0));
        desk.release(desk.cursor);
    }
    QVERIFY(tried > 2);
}

FFF_TEST(TestSymmetricSection)
#include "tst_symmetric_section.moc"
