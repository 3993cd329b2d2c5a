// Shapes that are dragged out of their middle.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/contour_words.h"
#include "core/interaction/figure_tool.h"
#include "core/model/figures.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

const Figure *lastFigure(const Desk &desk, int boundary)
{
    return desk.sections().empty() ? nullptr : figureOf(*desk.sections().back(), boundary);
}

} // namespace

class TestFigureTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstSection();
    void aHoleInTheSelectedSection();
    void aHoleInTheSectionOfTheCanvas();
    void whatIsHiddenIsNotCut();
    void shiftKeepsBothSidesAlike();
    void aClickMakesTheUsualSize();
    void theMiddleSnaps();
    void theKindIsChosen_data();
    void theKindIsChosen();
    void besideTheSectionItIsRefused();
    void itsLineIsSeenWhileDragged();
    void escTakesItBack();
    void onAPlaneThatIsPicked();
};

// Wrong: an exact rectangle could not be the beginning of a model.
void TestFigureTool::theFirstSection()
{
    Desk desk;
    desk.run("section.addShape", {{"figure", "rectangle"}});
    const double y = kFirstPlaneHeight;
    desk.drag({desk.front(0, y), desk.front(40, y + 30)});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const Figure *figure = lastFigure(desk, 0);
    QVERIFY(figure);
    QCOMPARE(figure->kind, std::string("rectangle"));
    QVERIFY((fff::sizeOf(*figure) - Vec2(80, 60)).norm() < 1.1); // the grid's steps
    QVERIFY(desk.interaction.tool());
    desk.session.history()->undo();
    QVERIFY(desk.sections().empty());
}

void TestFigureTool::aHoleInTheSelectedSection()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "ellipse"}});
    desk.wait(2000.0);
    QCOMPARE(desk.hint(), hints::kPlaceHole);
    desk.drag({desk.plate(20, 10), desk.plate(50, 30)});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const Figure *hole = lastFigure(desk, 1);
    QVERIFY(hole);
    QVERIFY((hole->centre - Vec2(20, 10)).norm() < 1.1);
    QVERIFY((fff::sizeOf(*hole) - Vec2(60, 40)).norm() < 2.1);
}

// Wrong: the second shape would be a section inside the first, which could never be cut.
void TestFigureTool::aHoleInTheSectionOfTheCanvas()
{
    Desk desk;
    desk.run("section.addShape", {{"figure", "rectangle"}});
    const double y = kFirstPlaneHeight;
    desk.drag({desk.front(0, y), desk.front(60, y + 60)});
    desk.interaction.settings().figure = "circle";
    desk.drag({desk.front(20, y + 10), desk.front(30, y + 10)});
    QCOMPARE(desk.sections().size(), std::size_t(1));
    const Figure *hole = lastFigure(desk, 1);
    QVERIFY(hole);
    QCOMPARE(hole->kind, std::string("circle"));
    const Vec3 middle = desk.sections().front()->frame.toWorld(hole->centre);
    QVERIFY((middle - Vec3(20, y + 10, 0)).norm() < 1.1);
    // Beside it there is nothing to cut.
    desk.drag({desk.front(-100, y), desk.front(-90, y + 10)});
    QCOMPARE(desk.sections().size(), std::size_t(2));
}

void TestFigureTool::whatIsHiddenIsNotCut()
{
    Desk desk;
    desk.run("section.addShape", {{"figure", "rectangle"}});
    const double y = kFirstPlaneHeight;
    desk.drag({desk.front(0, y), desk.front(60, y + 60)});
    ViewState view = desk.interaction.view();
    view.hidden.insert(desk.sections().front()->ref());
    desk.interaction.setView(view);
    desk.drag({desk.front(20, y + 10), desk.front(30, y + 20)});
    QCOMPARE(desk.sections().size(), std::size_t(2));
}

void TestFigureTool::shiftKeepsBothSidesAlike()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "rectangle"}});
    desk.wait(2000.0);
    desk.drag({desk.plate(0, 0), desk.plate(30, 10)}, Button::Left, kShift);
    const Vec2 size = fff::sizeOf(*lastFigure(desk, 1));
    QCOMPARE(size.x(), size.y());
}

void TestFigureTool::aClickMakesTheUsualSize()
{
    Desk desk;
    desk.addPlate(0.0, {200, 160});
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "circle"}});
    desk.wait(2000.0);
    desk.click(desk.plate(0, 0));
    QCOMPARE(lastFigure(desk, 1)->numbers, newFigure(*figureKind("circle")).numbers);
}

// Wrong: a hole could not be set exactly at a corner's distance.
void TestFigureTool::theMiddleSnaps()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "circle"}});
    desk.wait(2000.0);
    desk.moveTo(desk.plate(20.2, 9.7));
    QVERIFY(desk.interaction.overlay().find<sign::Handle>());
    QVERIFY(desk.interaction.overlay().find<sign::Rulers>());
    desk.drag({desk.plate(20.2, 9.7), desk.plate(30, 9.7)});
    // Counted from the section's origin, as the rulers do.
    const Vec2 middle = lastFigure(desk, 1)->centre;
    QVERIFY(std::abs(middle.x() - std::round(middle.x())) < 1e-9);
    QVERIFY(std::abs(middle.y() - std::round(middle.y())) < 1e-9);
}

void TestFigureTool::theKindIsChosen_data()
{
    QTest::addColumn<QString>("kind");
    for (const FigureKind &kind : figureKinds())
        QTest::newRow(kind.key) << QString::fromLatin1(kind.key);
}

// Wrong: with the tool in the hand its buttons would add shapes in the middle, one after the other.
void TestFigureTool::theKindIsChosen()
{
    QFETCH(QString, kind);
    Desk desk;
    desk.run("section.addShape");
    std::string command = kind.toStdString();
    command.front() = static_cast<char>(std::toupper(command.front()));
    desk.run("section.add" + command);
    QVERIFY(desk.sections().empty());
    QVERIFY(desk.interaction.hint().words.arguments.front() ==
            Argument(Text{"Figure", figureKind(kind.toStdString())->name}));
    desk.drag({desk.front(0, kFirstPlaneHeight), desk.front(40, kFirstPlaneHeight + 30)});
    QCOMPARE(lastFigure(desk, 0)->kind, kind.toStdString());
    QVERIFY(!desk.commands.run("section.addShape", {{"figure", "blob"}}, desk.time));
}

void TestFigureTool::besideTheSectionItIsRefused()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "circle"}});
    desk.wait(2000.0);
    desk.drag({desk.plate(160, 0), desk.plate(170, 0)});
    QCOMPARE(desk.hint(), hints::kHoleOutside);
    QCOMPARE(desk.steps(), 1);
}

// Wrong: where it cannot be, one would drag nothing, and not know why.
void TestFigureTool::itsLineIsSeenWhileDragged()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.addShape", {{"figure", "circle"}});
    desk.wait(2000.0);
    const auto line = [&desk] { return desk.interaction.overlay().find<sign::Curve>(); };
    desk.moveTo(desk.plate(0, 0));
    QVERIFY(!line());
    desk.press(desk.plate(0, 0));
    desk.moveTo(desk.plate(20, 0));
    QVERIFY(line() && line()->role == SignRole::Figure);
    desk.interaction.escape(desk.time);
    QVERIFY(!line());
    desk.release(desk.plate(20, 0));
    desk.moveTo(desk.plate(160, 0));
    desk.press(desk.plate(160, 0));
    desk.moveTo(desk.plate(175, 0));
    QVERIFY(line() && line()->role == SignRole::Refused);
    desk.release(desk.plate(175, 0));
    QVERIFY(!line());
}

void TestFigureTool::escTakesItBack()
{
    Desk desk;
    desk.run("section.addShape", {{"figure", "star"}});
    desk.moveTo(desk.front(0, 100));
    desk.press(desk.front(0, 100));
    desk.moveTo(desk.front(40, 130));
    QCOMPARE(desk.session.model().sectionCount(), std::size_t(1)); // shown
    desk.interaction.escape(desk.time);
    QCOMPARE(desk.session.model().sectionCount(), std::size_t(0));
    QVERIFY(desk.interaction.tool());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
}

void TestFigureTool::onAPlaneThatIsPicked()
{
    Desk desk;
    desk.addPlate();
    desk.run("section.addShape", {{"figure", "circle"}});
    desk.run("section.planeGround");
    desk.wait(2000.0);
    const Vec3 middle(150, 1.5, 80);
    desk.drag({desk.screen(middle), desk.screen(middle + Vec3(30, 0, 0))});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(std::abs(std::abs(desk.sections()[1]->frame.normal().y()) - 1.0) < 1e-9);
}

FFF_TEST(TestFigureTool)
#include "tst_figure_tool.moc"
