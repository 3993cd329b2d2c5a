#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/contour_words.h"
#include "core/interaction/section_editing.h"
#include "core/io/fff_format.h"
#include "core/model/edit_words.h"
#include "core/model/figures.h"
#include "core/model/origin.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

class TestFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSectionOfItsOwn();
    void eachBesideTheOthers();
    void aHoleAtTheMiddle();
    void aHoleWhereItFits();
    void inPlaceOfTheContour();
    void otherNumbers();
    void numbersThatCannotBe_data();
    void numbersThatCannotBe();
    void editedByHandItIsNone();
    void movedAndScaledItIsStillOne();
    void anEditElsewhereLeavesIt();
    void savedAndRead();
    void ofAnImage();
    void lockedIsRefused();
};

// Wrong: a wheel of 60 mm could not be had without drawing.
void TestFigures::aSectionOfItsOwn()
{
    Desk desk;
    desk.run("section.addCircle", {{"diameter", "60"}});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const Section &wheel = *desk.sections().front();
    QVERIFY(std::abs(wheel.shape->bounds().size().x() - 60.0) < 0.01);
    QVERIFY(std::abs(positionOf(wheel).y() - 30.0) < 0.01); // on the ground, whole
    QCOMPARE(figureOf(wheel, 0)->kind, std::string("circle"));
    QCOMPARE(desk.interaction.selection(), std::vector<SectionRef>{wheel.id});
    QCOMPARE(desk.lastStep(), QStringLiteral("Draw Section 1"));
}

// Wrong: the second one would lie in the first one, unseen.
void TestFigures::eachBesideTheOthers()
{
    Desk desk;
    desk.run("section.addStar");
    desk.interaction.select({});
    desk.run("section.addSlot", {{"length", "50"}, {"width", "12"}});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    const auto box = [&](std::size_t i) {
        return worldBounds(*desk.sections()[i]->shape, desk.sections()[i]->frame);
    };
    QVERIFY(box(1).min.x() > box(0).max.x() + 19.0);
    QVERIFY(std::abs(box(1).min.y()) < 0.01);
}

// Wrong: a hole of 20 mm could not be had without drawing.
void TestFigures::aHoleAtTheMiddle()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addRectangle", {{"width", "20"}, {"height", "10"}, {"corner", "2"}});
    const Section &plate = *desk.sections().front();
    QCOMPARE(plate.shape->holes().size(), std::size_t(1));
    const Figure &hole = *figureOf(plate, 1);
    QCOMPARE(hole.numbers, (std::vector<double>{20, 10, 2}));
    QVERIFY(hole.centre.norm() < 1e-9);
    QVERIFY(!figureOf(plate, 0));
    desk.run("section.addCircle", {{"diameter", "8"}, {"x", "60"}, {"y", "-30"}});
    QCOMPARE(figureOf(*desk.sections().front(), 2)->centre, Vec2(60, -30));
    desk.session.history()->undo();
    desk.session.history()->undo();
    QVERIFY(desk.sections().front()->shape->holes().empty());
}

// Wrong: the second hole would become one with the first, or be refused.
void TestFigures::aHoleWhereItFits()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    for (int i = 1; i <= 4; ++i) {
        desk.run("section.addCircle", {{"diameter", "30"}});
        QCOMPARE(desk.sections().front()->shape->holes().size(), std::size_t(i));
        QVERIFY(figureOf(*desk.sections().front(), i));
    }
    // Where nothing is free it says so.
    Desk full;
    full.addPlate(0.0, {20, 20});
    full.interaction.select({full.sections().front()->id});
    full.run("section.addRectangle", {{"width", "39"}, {"height", "39"}, {"x", "0"}});
    full.run("section.addCircle");
    QCOMPARE(full.hint(), hints::kHoleOutside);
}

// Wrong: what was drawn roughly could not be made exact.
void TestFigures::inPlaceOfTheContour()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addEllipse", {{"as", "contour"}});
    const Section &plate = *desk.sections().front();
    QCOMPARE(figureOf(plate, 0)->numbers, (std::vector<double>{200, 120}));
    QCOMPARE(desk.sections().size(), std::size_t(1));
    QCOMPARE(desk.lastStep(), QStringLiteral("Redraw Section 1"));
}

// Wrong: numbers would be good for once only.
void TestFigures::otherNumbers()
{
    Desk desk;
    desk.run("section.addPolygon", {{"diameter", "50"}, {"sides", "6"}});
    desk.run("section.figure", {{"sides", "8"}});
    QCOMPARE(desk.sections().front()->shape->contour().segmentCount(), 8);
    desk.run("section.figure", {{"diameter", "70"}, {"turn", "10"}});
    QCOMPARE(desk.steps(), 2); // changes of one figure are one step
    QCOMPARE(figureOf(*desk.sections().front(), 0)->numbers, (std::vector<double>{70, 8}));
    desk.session.history()->undo();
    QCOMPARE(figureOf(*desk.sections().front(), 0)->numbers, (std::vector<double>{50, 6}));
}

void TestFigures::numbersThatCannotBe_data()
{
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::newRow("negative") << "section.addCircle"
                              << "diameter"
                              << "-5";
    QTest::newRow("no number") << "section.addSlot"
                               << "length"
                               << "long";
    QTest::newRow("half a side") << "section.addPolygon"
                                 << "sides"
                                 << "4.5";
    QTest::newRow("as what") << "section.addStar"
                             << "as"
                             << "cloud";
    QTest::newRow("a hole in nothing") << "section.addStar"
                                       << "as"
                                       << "hole";
}

// Wrong: a script with a slip would go on with something else.
void TestFigures::numbersThatCannotBe()
{
    QFETCH(QString, command);
    QFETCH(QString, key);
    QFETCH(QString, value);
    Desk desk;
    const auto done =
        desk.commands.run(command.toStdString(), {{key.toStdString(), value.toStdString()}});
    QVERIFY(!done);
    QCOMPARE(QString::fromStdString(done.error().place), key);
    QCOMPARE(desk.steps(), 0);
}

// Wrong: a number would throw away what was drawn since.
void TestFigures::editedByHandItIsNone()
{
    Desk desk;
    desk.run("section.addCircle");
    desk.run("point.select", {{"index", "1"}});
    desk.interaction.nudge(Vec2(1, 0), 1.0, desk.time += 8);
    QCOMPARE(desk.steps(), 2);
    QVERIFY(desk.sections().front()->figures.empty());
    const auto changed = desk.commands.run("section.figure", {{"diameter", "70"}});
    QCOMPARE(changed.error().place, std::string("boundary"));
    desk.session.history()->undo();
    QVERIFY(figureOf(*desk.sections().front(), 0));
}

// Wrong: its numbers would be gone after the first move.
void TestFigures::movedAndScaledItIsStillOne()
{
    Desk desk;
    desk.run("section.addRectangle", {{"width", "60"}, {"height", "40"}});
    desk.run("section.move", {{"x", "15"}});
    desk.run("section.turn", {{"axis", "normal"}, {"angle", "30"}});
    QVERIFY(figureOf(*desk.sections().front(), 0));
    desk.run("section.scale", {{"factor", "1.5"}});
    const Figure *scaled = figureOf(*desk.sections().front(), 0);
    QVERIFY(scaled && std::abs(scaled->numbers[0] - 90.0) < 1e-9);
    desk.run("section.turn", {{"axis", "normal"}, {"angle", "-30"}});
    desk.run("edit.duplicate");
    QVERIFY(figureOf(*desk.sections().back(), 0));
}

// Wrong: a hole would make a drawn contour of a circle.
void TestFigures::anEditElsewhereLeavesIt()
{
    Desk desk;
    desk.run("section.addCircle", {{"diameter", "80"}});
    desk.run("section.addStar");
    const Section &wheel = *desk.sections().front();
    QVERIFY(figureOf(wheel, 0) && figureOf(wheel, 1));
    desk.run("section.removeHoles");
    QVERIFY(figureOf(*desk.sections().front(), 0));
    QCOMPARE(desk.sections().front()->figures.size(), std::size_t(1));
}

// Wrong: a file would forget what was made by numbers.
void TestFigures::savedAndRead()
{
    Desk desk;
    desk.run("section.addRectangle", {{"corner", "5"}, {"turn", "20"}});
    desk.run("section.addSlot");
    const Document &document = desk.session.committed().document;
    const std::string text = io::writeFff(document).value();
    const Document again = io::readFff(text).value().document;
    QCOMPARE(again, document);
    QCOMPARE(again.sections.front()->figures.size(), std::size_t(2));
    // What a later version knows is passed over.
    std::string later = text;
    later.replace(later.find("\"slot\""), 6, "\"knob\"");
    QCOMPARE(io::readFff(later).value().document.sections.front()->figures.size(), std::size_t(1));
}

// Wrong: a mirrored wheel could not be made larger.
void TestFigures::ofAnImage()
{
    Desk desk;
    desk.run("section.addCircle", {{"diameter", "40"}});
    desk.run("section.move", {{"x", "80"}});
    desk.run("operation.mirror", {{"plane", "x"}});
    const Model &model = desk.session.committed();
    QCOMPARE(model.sectionCount(), std::size_t(2));
    desk.interaction.select({model.ref(1)});
    desk.run("section.figure", {{"diameter", "50"}});
    QCOMPARE(figureOf(*desk.sections().front(), 0)->numbers.front(), 50.0);
}

// Wrong: what is locked would change its shape.
void TestFigures::lockedIsRefused()
{
    Desk desk;
    desk.run("section.addCircle");
    desk.run("section.lock");
    const Document before = desk.session.committed().document;
    desk.run("section.figure", {{"diameter", "50"}});
    QCOMPARE(desk.hint(), hints::kLocked);
    desk.run("section.addStar");
    QCOMPARE(desk.hint(), hints::kLocked);
    QVERIFY(desk.session.committed().document.isSame(before));
}

FFF_TEST(TestFigures)
#include "tst_figures.moc"
