// A line over a template that is said to be so long.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/base/tolerances.h"
#include "core/interaction/template_words.h"
#include "core/templates/moved_template.h"
#include "tests/core/interaction/template_desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

#include <random>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

struct LineDesk : TemplateDesk
{
    using TemplateDesk::TemplateDesk;

    void draw(const Vec2 &from, const Vec2 &to, Modifiers modifiers = {})
    {
        run("template.sizeByLine");
        drag({from, to}, Button::Left, modifiers);
    }
    const sign::Line *line() const { return interaction.overlay().find<sign::Line>(); }
    double length() const { return (line()->points.back() - line()->points.front()).norm(); }
    void say(double length)
    {
        interaction.setNumbers({{ToolNumber::Kind::Wanted, length}}, time);
        QVERIFY(interaction.key(ToolKey::Enter, time));
    }
    /// In the file: what is there stays there when the template is another size.
    Vec3 inFile(const Vec3 &world) const
    {
        return worldPlacement(one(), session.committed())->inverse()(world);
    }
    Vec3 inWorld(const Vec3 &file) const
    {
        return (*worldPlacement(one(), session.committed()))(file);
    }
};

Box3 boxOf(const Template &one, const Model &model)
{
    Box3 box;
    for (const Vec3 &p : alignedPointsOf(one, model))
        box.extend(p);
    return box;
}

double lowestOf(const Template &one, const Model &model)
{
    return boxOf(one, model).min.y();
}

double highestOf(const Template &one, const Model &model)
{
    return boxOf(one, model).max.y();
}

} // namespace

class TestSizeLineTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLineIsAsLongAsSaid_data();
    void theLineIsAsLongAsSaid();
    void aMeshIsSizedAcrossTheView();
    void anyLineOfAnyTemplate();
    void whatStandsKeepsStanding();
    void clicksDrawItToo();
    void shiftKeepsItLevel();
    void escGoesBackStepByStep();
    void drawnAnewItIsAnotherLine();
    void besideTheTemplateTheViewTurns();
    void lockedIsRefused();
    void aPointIsNoLine();
    void tooLargeIsRefused();
};

void TestSizeLineTool::theLineIsAsLongAsSaid_data()
{
    QTest::addColumn<QString>("plane");
    QTest::addColumn<double>("turn");
    for (const char *plane : {"front", "side", "ground", "section"})
        for (const double turn : {0.0, 33.0})
            QTest::addRow("%s %g", plane, turn) << QString::fromLatin1(plane) << turn;
}

void TestSizeLineTool::theLineIsAsLongAsSaid()
{
    QFETCH(const QString, plane);
    QFETCH(const double, turn);
    LineDesk desk(pictureTemplate(discPicture()));
    desk.run("template.lay",
             {{"plane", plane.toStdString()}, {"section", desk.sections().front()->name}});
    desk.run("template.set", {{"turn", std::to_string(turn)}});
    desk.look(0.6, 0.5);
    const Document before = desk.session.committed().document;
    const TemplatePointer stood = before.templates.front();
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.draw(middle + Vec2(-23, 5), middle + Vec2(31, -12));
    QVERIFY(desk.line());
    const Vec3 from = desk.line()->points.front(), to = desk.line()->points.back();
    const Vec3 a = desk.inFile(from), b = desk.inFile(to);
    QVERIFY(std::abs(a.z()) < 1e-9 && std::abs(b.z()) < 1e-9); // it lies in the picture
    QCOMPARE(desk.hint(), hints::kLineLength);
    const auto numbers = desk.interaction.numbers();
    QCOMPARE(numbers.size(), std::size_t(1));
    QVERIFY(std::abs(numbers.front().value - (to - from).norm()) < 1e-12);
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 123.4}}, desk.time);
    QVERIFY(desk.session.hasPreview());
    QVERIFY(std::abs(desk.length() - 123.4) < 1e-9); // it grows with the picture
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time));
    QVERIFY(std::abs((desk.inWorld(b) - desk.inWorld(a)).norm() - 123.4) < 1e-9);
    if (plane == u"ground"_s || plane == u"section"_s) {
        QVERIFY((desk.inWorld(a) - from).norm() < 1e-9); // the first end stays
    } else {
        const double low = lowestOf(desk.one(), desk.session.committed());
        const double lowBefore = lowestOf(*stood, desk.session.committed());
        QVERIFY(std::abs(low - desk.one().scale / stood->scale * lowBefore) < 1e-6);
    }
    QVERIFY(!desk.interaction.tool()); // nothing is left to do
    QCOMPARE(desk.lastStep(), QStringLiteral("Scale template Disc"));
    desk.session.history()->undo();
    QVERIFY(desk.session.committed().document.isSame(before));
}

void TestSizeLineTool::aMeshIsSizedAcrossTheView()
{
    LineDesk desk(ballTemplate(60.0));
    desk.look(0.7, 0.3);
    const Vec2 middle = desk.screen(desk.one().frame.origin);
    const double radius = 60.0 / 0.4; // px
    desk.draw(middle - Vec2(radius, 0), middle + Vec2(radius, 0));
    QVERIFY(std::abs(desk.length() - 120.0) < 1e-6);
    desk.say(30.0);
    const Box3 box = worldBounds(desk.one(), *desk.one().mesh);
    QVERIFY(std::abs(box.size().y() - 30.0) < 0.05);
}

void TestSizeLineTool::anyLineOfAnyTemplate()
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    LineDesk desk(pictureTemplate(discPicture()));
    const Model &model = desk.session.committed();
    for (int i = 0; i < 500; ++i) {
        Template one = desk.one();
        one.frame.origin = 300.0 * Vec3(number(random), number(random), number(random));
        one.isFlipped = i % 2 == 0;
        one = turned(one, 3.0 * number(random));
        const Vec3 a(90 * number(random), 90 * number(random), 0);
        const Vec3 b(90 * number(random), 90 * number(random), 0);
        const double length = std::exp(3.0 + 3.0 * number(random));
        const Template sized =
            sizedByLine(one, one.placement()(a), one.placement()(b), length, model).value();
        const Vec3 from = sized.placement()(a), to = sized.placement()(b);
        QVERIFY(std::abs((to - from).norm() - length) < 1e-9 * std::max(1.0, length));
        const double lowest = lowestOf(one, model);
        if (lowest <= 0.0 && highestOf(one, model) > 0.0)
            QVERIFY(std::abs(lowestOf(sized, model) - sized.scale / one.scale * lowest) < 1e-6);
        else
            QVERIFY((from - one.placement()(a)).norm() < 1e-9);
    }
}

/// A photograph that was laid there comes 254 mm large and stands on the ground: whatever is
/// measured in it, and made larger or smaller by that, it stands there still.
void TestSizeLineTool::whatStandsKeepsStanding()
{
    LineDesk desk(pictureTemplate(discPicture()));
    desk.run("template.lay", {{"plane", "front"}});
    desk.change([](Template &one) { one.frame.origin.x() = 35.0; });
    const Model &model = desk.session.committed();
    QVERIFY(std::abs(lowestOf(desk.one(), model)) < 1e-9);
    for (const double length : {500.0, 20.0}) {
        const Vec3 middle = desk.one().frame.origin;
        const double scale = desk.one().scale;
        desk.draw(desk.screen(middle), desk.screen(middle + Vec3(10, 10, 0)));
        desk.say(length);
        QVERIFY(std::abs(desk.one().scale / scale - length / std::hypot(10.0, 10.0)) <
                1e-6 * length);
        QVERIFY(std::abs(lowestOf(desk.one(), model)) < 1e-6);
        QVERIFY(std::abs(desk.one().frame.origin.x() - 35.0) < 1e-9);
    }
}

void TestSizeLineTool::clicksDrawItToo()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.run("template.sizeByLine");
    desk.click(middle);
    desk.click(middle + Vec2(50, 0));
    QVERIFY(std::abs(desk.length() - 20.0) < 1e-6);
    desk.say(40.0);
    QCOMPARE(desk.one().scale, 1.0);
}

void TestSizeLineTool::shiftKeepsItLevel()
{
    LineDesk desk(pictureTemplate(discPicture()));
    desk.run("template.set", {{"turn", "20"}});
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.draw(middle, middle + Vec2(50, 9), kShift);
    const Vec3 way = desk.line()->points.back() - desk.line()->points.front();
    QVERIFY(std::abs(way.y()) < 1e-9 && way.x() > 15.0);
}

void TestSizeLineTool::escGoesBackStepByStep()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Document before = desk.session.committed().document;
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.draw(middle, middle + Vec2(50, 9));
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 77.0}}, desk.time);
    QVERIFY(desk.session.hasPreview());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.session.hasPreview());
    QVERIFY(desk.line());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.line());
    QVERIFY(desk.interaction.tool());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
    QVERIFY(desk.session.committed().document.isSame(before));
}

void TestSizeLineTool::drawnAnewItIsAnotherLine()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.draw(middle, middle + Vec2(50, 0));
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 77.0}}, desk.time);
    desk.wait(1000.0);
    desk.drag({middle + Vec2(-20, 10), middle + Vec2(-20, -15)});
    QVERIFY(!desk.session.hasPreview());
    QVERIFY(std::abs(desk.length() - 10.0) < 1e-6);
}

void TestSizeLineTool::besideTheTemplateTheViewTurns()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Camera before = desk.interaction.camera();
    desk.draw({30, 760}, {130, 700});
    QVERIFY(!desk.line());
    QVERIFY(!isSameCamera(desk.interaction.camera(), before));
    QVERIFY(desk.interaction.tool());
}

void TestSizeLineTool::lockedIsRefused()
{
    LineDesk desk(pictureTemplate(discPicture()));
    desk.change([](Template &one) { one.isLocked = true; });
    desk.run("template.sizeByLine");
    QVERIFY(!desk.interaction.tool());
    QCOMPARE(desk.hint(), hints::kTemplateLocked);
}

void TestSizeLineTool::aPointIsNoLine()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.run("template.sizeByLine");
    desk.click(middle);
    desk.click(middle);
    QVERIFY(!desk.line() || desk.length() < 1e-6);
    QVERIFY(desk.interaction.numbers().empty());
}

void TestSizeLineTool::tooLargeIsRefused()
{
    LineDesk desk(pictureTemplate(discPicture()));
    const Document before = desk.session.committed().document;
    const Vec2 middle = desk.screen(desk.inWorld(Vec3::Zero()));
    desk.draw(middle, middle + Vec2(5, 0)); // 2 mm
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, kMaxCoordinate}}, desk.time);
    QVERIFY(!desk.session.hasPreview());
    desk.interaction.key(ToolKey::Enter, desk.time);
    QCOMPARE(desk.hint(), hints::kTemplateNotMoved);
    QVERIFY(desk.session.committed().document.isSame(before));
}

FFF_TEST(TestSizeLineTool)
#include "tst_size_line_tool.moc"
