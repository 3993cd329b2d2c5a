// What is drawn on sections: the tool, the commands, files and cutting files.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/fabrication/marks.h"
#include "core/interaction/mark_words.h"
#include "core/io/cutting_file.h"
#include "core/io/fff_format.h"
#include "core/model/edit_words.h"
#include "core/model/lettering.h"
#include "core/model/marks.h"
#include "core/operations/moving_model.h"
#include "tests/core/analysed.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QUndoStack>

using namespace fff;
using namespace fff::test;

namespace {

/// The tool in the hand, over a plate that is seen from its front.
struct MarkDesk : Desk
{
    MarkDesk()
    {
        addPlate();
        interaction.select({sections().front()->id});
        run("section.mark");
        wait(2000.0);
    }
    const Section &marked() const { return *sections().front(); }
};

Box2 boxOf(const Mark &mark)
{
    Box2 box;
    for (const CurvePath &path : mark.paths)
        for (const Vec2 &p : path.flatten(0.01))
            box.extend(p);
    return box;
}

} // namespace

class TestMarkTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aLineAsTheHandGoes();
    void aStraightLine();
    void aClickSetsWords();
    void besideTheSectionNothingIsLeft();
    void othersStandBack();
    void withoutASectionOneIsPicked();
    void theFirstDragDrawsOnWhereItBegins();
    void fromBehindTheFirstDragTurnsTheView();
    void lookedAtFromTheFront();
    void escGoesOneStepBack();
    void undoGivesTheVeryObjectBack();
    void wordsAreWrittenAnew();
    void scoredOrEngraved();
    void unknownLettersAreNamed();
    void lettersStandAsTheyAreWritten();
    void accentsStandOnTheirLetters();
    void movedAlongAndScaled();
    void mirroredWordsStayReadable();
    void savedAndRead();
    void inTheCuttingFile();
    void cutAtTheEdgeOfThePart();
    void numbersKeepOffThem();
    void lockedIsRefused();
};

// Wrong: nobody could draw an eye on a fish.
void TestMarkTool::aLineAsTheHandGoes()
{
    MarkDesk desk;
    desk.drag({desk.plate(-40, 0), desk.plate(0, 20), desk.plate(40, 0)});
    QCOMPARE(desk.marked().marks.size(), std::size_t(1));
    const Mark &mark = *desk.marked().marks.front();
    QCOMPARE(mark.kind, Mark::Kind::Engraved);
    QVERIFY((mark.paths.front().points().front() - Vec2(-40, 0)).norm() < 0.5);
    QVERIFY((mark.paths.front().points().back() - Vec2(40, 0)).norm() < 0.5);
    QCOMPARE(desk.lastStep(), QStringLiteral("Mark Section 1"));
    QVERIFY(desk.interaction.tool());
    desk.drag({desk.plate(-40, -20), desk.plate(40, -20)});
    QCOMPARE(desk.marked().marks.size(), std::size_t(2));
}

// Wrong: a line to fold along would wobble.
void TestMarkTool::aStraightLine()
{
    MarkDesk desk;
    desk.drag({desk.plate(-40, 0), desk.plate(0, 9), desk.plate(40, 3)}, Button::Left, kShift);
    const CurvePath &line = desk.marked().marks.front()->paths.front();
    QCOMPARE(line.segmentCount(), 1);
    QVERIFY(std::abs(line.points().front().y() - line.points().back().y()) < 1e-9);
}

// Wrong: a name could not be put on a part.
void TestMarkTool::aClickSetsWords()
{
    MarkDesk desk;
    desk.click(desk.plate(30, 10));
    const Mark &mark = *desk.marked().marks.front();
    QVERIFY(mark.lettering.has_value());
    QVERIFY((boxOf(mark).center() - Vec2(30, 10)).norm() < 0.6);
    QVERIFY(std::abs(mark.lettering->turn) < 1e-9);
}

// Wrong: a line to fold along could not go to the very edge; or words would be burnt into the air.
void TestMarkTool::besideTheSectionNothingIsLeft()
{
    MarkDesk desk;
    desk.click(desk.plate(160, 0));
    QCOMPARE(desk.hint(), hints::kMarkOutside);
    QVERIFY(desk.marked().marks.empty());
    QVERIFY(!desk.interaction.selection().empty());
    desk.drag({desk.plate(-130, 0), desk.plate(130, 0)}, Button::Left, kShift);
    QCOMPARE(desk.marked().marks.size(), std::size_t(1));
    const Camera before = desk.interaction.camera();
    desk.drag({desk.plate(0, 0), desk.plate(30, 20)}, Button::Right);
    QVERIFY(!isSameCamera(before, desk.interaction.camera()));
}

// Wrong: what lies before the section would hide what is drawn on it.
void TestMarkTool::othersStandBack()
{
    Desk desk;
    desk.addPlate();
    desk.addPlate(30.0);
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.mark");
    desk.wait(2000.0);
    QVERIFY(desk.interaction.view().isGhost(desk.sections()[1]->id));
    desk.click(desk.plate(0, 0)); // through the other one
    QCOMPARE(desk.sections()[0]->marks.size(), std::size_t(1));
    desk.interaction.layDown(desk.time);
    QVERIFY(desk.interaction.view().isolated.empty());
}

// Wrong: a line was asked for, drawn, and only selected what it was drawn on.
void TestMarkTool::theFirstDragDrawsOnWhereItBegins()
{
    Desk desk;
    desk.addPlate();
    desk.run("section.mark");
    const Camera before = desk.interaction.camera();
    desk.drag({desk.plate(-40, 0), desk.plate(0, 20), desk.plate(40, 0)});
    QCOMPARE(desk.sections().front()->marks.size(), std::size_t(1));
    const CurvePath &line = desk.sections().front()->marks.front()->paths.front();
    QVERIFY((line.points().front() - Vec2(-40, 0)).norm() < 0.5);
    QVERIFY((line.points().back() - Vec2(40, 0)).norm() < 0.5);
    QCOMPARE(desk.interaction.selection(), std::vector{desk.sections().front()->ref()});
    QVERIFY(isSameCamera(before, desk.interaction.camera()));
    QVERIFY(desk.interaction.tool());
    desk.drag({desk.plate(-40, -20), desk.plate(40, -20)});
    QCOMPARE(desk.sections().front()->marks.size(), std::size_t(2));
}

// Wrong: what is drawn on the back would lie on the front, where nobody sees it.
void TestMarkTool::fromBehindTheFirstDragTurnsTheView()
{
    Desk desk;
    desk.addPlate();
    desk.run("view.back");
    desk.wait(2000.0);
    desk.run("section.mark");
    desk.drag({desk.plate(-40, 0), desk.plate(0, 20), desk.plate(40, 0)});
    desk.wait(2000.0);
    QVERIFY(desk.sections().front()->marks.empty());
    QVERIFY(desk.interaction.camera().backward().dot(desk.sections().front()->frame.normal()) >
            0.9);
    QCOMPARE(desk.hint(), hints::kEngravesFront);
}

// Wrong: the tool would do nothing where nothing was selected before.
void TestMarkTool::withoutASectionOneIsPicked()
{
    Desk desk;
    desk.addPlate();
    desk.run("section.mark");
    QCOMPARE(desk.hint(), hints::kPickMarked);
    desk.click(desk.plate(0, 0));
    desk.wait(2000.0);
    QCOMPARE(desk.hint(), hints::kDrawMark);
    QVERIFY(desk.sections().front()->marks.empty());
    desk.click(desk.plate(0, 0));
    QCOMPARE(desk.sections().front()->marks.size(), std::size_t(1));
}

// Wrong: words that are written from behind come out mirrored from the machine.
void TestMarkTool::lookedAtFromTheFront()
{
    Desk desk;
    desk.addPlate();
    Camera behind = desk.interaction.camera();
    behind.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Vec3::UnitY()));
    desk.interaction.setCamera(behind);
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.mark");
    desk.wait(2000.0);
    const Vec3 normal = desk.sections().front()->frame.normal();
    QVERIFY(desk.interaction.camera().backward().dot(normal) > 0.999);
}

void TestMarkTool::escGoesOneStepBack()
{
    MarkDesk desk;
    desk.moveTo(desk.plate(0, 0));
    desk.press(desk.plate(0, 0));
    desk.moveTo(desk.plate(30, 0));
    QVERIFY(!desk.session.model().section(0)->marks.empty()); // shown while it is drawn
    desk.interaction.escape(desk.time);
    QVERIFY(desk.session.model().section(0)->marks.empty());
    QVERIFY(desk.interaction.tool());
    desk.release(desk.plate(30, 0));
    QVERIFY(desk.marked().marks.empty());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
}

void TestMarkTool::undoGivesTheVeryObjectBack()
{
    MarkDesk desk;
    const SectionPointer before = desk.sections().front();
    desk.click(desk.plate(0, 0));
    desk.session.history()->undo();
    QCOMPARE(desk.sections().front(), before);
}

// Wrong: words could only be deleted and set again; and each letter typed would be a step.
void TestMarkTool::wordsAreWrittenAnew()
{
    MarkDesk desk;
    desk.click(desk.plate(0, 0));
    const int steps = desk.steps();
    desk.run("mark.change", {{"mark", "0"}, {"text", "Stegosaurus"}, {"height", "8"}});
    desk.run("mark.change", {{"mark", "0"}, {"text", "Stegosaurus 2"}});
    const Lettering &lettering = *desk.marked().marks.front()->lettering;
    QCOMPARE(lettering.text, std::string("Stegosaurus 2"));
    QCOMPARE(lettering.height, 8.0);
    QCOMPARE(desk.steps(), steps + 1);
    QVERIFY((boxOf(*desk.marked().marks.front()).center() - lettering.at).norm() < 0.2);
    desk.run("mark.delete", {{"mark", "0"}});
    QVERIFY(desk.marked().marks.empty());
    QVERIFY(!desk.commands.run("mark.delete", {{"mark", "0"}}, desk.time));
}

void TestMarkTool::scoredOrEngraved()
{
    MarkDesk desk;
    desk.run("mark.score");
    desk.drag({desk.plate(-40, 0), desk.plate(40, 0)});
    QCOMPARE(desk.marked().marks.back()->kind, Mark::Kind::Scored);
    desk.run("mark.change", {{"mark", "0"}, {"as", "engraved"}});
    QCOMPARE(desk.marked().marks.back()->kind, Mark::Kind::Engraved);
    desk.run("mark.engrave");
    desk.drag({desk.plate(-40, 20), desk.plate(40, 20)});
    QCOMPARE(desk.marked().marks.back()->kind, Mark::Kind::Engraved);
}

// Wrong: a letter would be missing from a part without anybody knowing.
void TestMarkTool::unknownLettersAreNamed()
{
    MarkDesk desk;
    desk.run("mark.addText", {{"text", "Модель"}});
    QCOMPARE(desk.hint(), hints::kLetterUnknown);
    QCOMPARE(nameIn(desk.interaction.hint()), std::string("М"));
    QVERIFY(desk.marked().marks.empty());
    for (const char *text : {"", "   ", "\n"})
        QVERIFY(!letterPaths({.text = text}));
    QVERIFY(!letterPaths({.text = "A", .height = 0.0}));
    QVERIFY(!letterPaths({.text = "A\xff"})); // no UTF-8
}

// A capital is as high as was asked for, words are centred, lines stand under each other.
void TestMarkTool::lettersStandAsTheyAreWritten()
{
    const auto boxOfText = [](const std::string &text, double turn = 0.0) {
        Mark mark;
        mark.paths = *letterPaths({.text = text, .height = 12.0, .at = {5, 7}, .turn = turn});
        return boxOf(mark);
    };
    for (const char *text : {"H", "HEM", "l", "h1"})
        QVERIFY(std::abs(boxOfText(text).size().y() - 12.0) < 1e-9);
    QVERIFY((boxOfText("HÄUSER\nüber").center() - Vec2(5, 7)).norm() < 0.02);
    QVERIFY(boxOfText("HH").size().x() > 2.0 * boxOfText("H").size().x());
    QVERIFY(std::abs(boxOfText("H\nH").size().y() - 12.0 * (1.0 + kLineSpacing)) < 1e-6);
    const Vec2 flat = boxOfText("HHH").size(),
               upright = boxOfText("HHH", 0.5 * std::numbers::pi).size();
    QVERIFY((flat - Vec2(upright.y(), upright.x())).norm() < 1e-6);
    // Every letter of the alphabet is drawn within its line.
    for (char c = '!'; c <= '~'; ++c) {
        Mark mark;
        const auto paths = letterPaths({.text = std::string("H") + c, .height = 10.0});
        QVERIFY2(paths, std::string(1, c).c_str());
        mark.paths = *paths;
        QVERIFY2(boxOf(mark).size().y() < 14.0, std::string(1, c).c_str());
    }
}

void TestMarkTool::accentsStandOnTheirLetters()
{
    const auto height = [](const std::string &text) {
        Mark mark;
        mark.paths = *letterPaths({.text = text, .height = 10.0});
        return boxOf(mark).size().y();
    };
    QVERIFY(height("ä") > height("a"));
    QVERIFY(height("Ä") > height("A") + 1.0);
    QVERIFY(height("ç") > height("c"));
    for (const char *text : {"Größe", "façade", "mañana", "Łódź", "Čeština", "İstanbul", "ÅØÆ"})
        QVERIFY2(letterPaths({.text = text}), text);
}

// Wrong: what is drawn on a section would stay behind when that is scaled.
void TestMarkTool::movedAlongAndScaled()
{
    MarkDesk desk;
    desk.click(desk.plate(20, 0));
    const Box2 before = boxOf(*desk.marked().marks.front());
    const MarkPointer same = desk.marked().marks.front();
    desk.run("section.move", {{"x", "50"}});
    QCOMPARE(desk.marked().marks.front(), same); // in the section's own coordinates
    desk.run("section.scale", {{"factor", "2"}});
    const Box2 after = boxOf(*desk.marked().marks.front());
    QVERIFY((after.size() - 2.0 * before.size()).norm() < 0.1);
    QVERIFY(std::abs(desk.marked().marks.front()->lettering->height - 20.0) < 1e-9);
    desk.run("section.scale", {{"x", "2"}});
    QVERIFY(!desk.marked().marks.front()->lettering); // it is no alphabet any more
    QVERIFY(!desk.marked().marks.front()->paths.empty());
}

// Wrong: the words on the other half of a symmetric model would come out mirrored.
void TestMarkTool::mirroredWordsStayReadable()
{
    MarkDesk desk;
    desk.click(desk.plate(20, 0));
    desk.interaction.layDown(desk.time);
    desk.interaction.select({desk.marked().id});
    desk.run("edit.mirrorCopyZ");
    const Model &model = desk.session.committed();
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        QCOMPARE(model.section(i)->marks.front()->paths, desk.marked().marks.front()->paths);
}

void TestMarkTool::savedAndRead()
{
    MarkDesk desk;
    desk.click(desk.plate(20, 0));
    desk.run("mark.score");
    desk.drag({desk.plate(-40, 0), desk.plate(0, 20), desk.plate(40, -9)});
    const Document &document = desk.session.committed().document;
    const Result<io::LoadedDocument> read = io::readFff(*io::writeFff(document));
    QVERIFY(read);
    QVERIFY(read->document == document);
    // A mark without lines is no mark.
    std::string text = *io::writeFff(document);
    const std::size_t at = text.find("\"engraved\"");
    QVERIFY(at != std::string::npos);
    text.replace(at, 10, "\"painted\"");
    QVERIFY(!io::readFff(text));
}

// Wrong: what was drawn would not be on the part, or would be cut through.
void TestMarkTool::inTheCuttingFile()
{
    MarkDesk desk;
    desk.drag({desk.plate(-40, 0), desk.plate(0, 20), desk.plate(40, -9)});
    desk.run("mark.score");
    desk.drag({desk.plate(-40, -20), desk.plate(40, -20)}, Button::Left, kShift);
    const Analysis analysis = analysed(desk.session.committed());
    const Result<io::CuttingFile> file = io::makeCuttingFile(analysis);
    QVERIFY(file);
    const auto count = [&file](const std::string &colour) {
        int found = 0;
        for (std::size_t at = 0; (at = file->whole.find(colour, at)) != std::string::npos; ++at)
            ++found;
        return found;
    };
    QCOMPARE(count("stroke=\"#000000\""), 1);
    QCOMPARE(count("stroke=\"#00ff00\""), 1);
    QCOMPARE(count("stroke=\"#ff0000\""), 1);
    QVERIFY(file->whole.find("#000000") < file->whole.find("#ff0000")); // before it is cut out
}

// Wrong: a line that is drawn too far would be burnt into the rest of the sheet.
void TestMarkTool::cutAtTheEdgeOfThePart()
{
    MarkDesk desk;
    const Result<CurvePath> inside = CurvePath::fromLine({{-50, 0}, {50, 0}});
    const Result<CurvePath> beyond = CurvePath::fromLine({{-150, 10}, {150, 10}});
    const Result<CurvePath> away = CurvePath::fromLine({{-150, 90}, {150, 90}});
    const auto mark =
        std::make_shared<const Mark>(Mark{Mark::Kind::Engraved, {*inside, *beyond, *away}});
    Result<Document> document = addMark(desk.session.committed().document, desk.marked().id, mark);
    QVERIFY(document);
    desk.session.commit(QStringLiteral("Mark"), *document);
    const Analysis analysis = analysed(desk.session.committed());
    const std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    const MarkedLines lines = linesOn(parts.front(), desk.marked().marks);
    QCOMPARE(lines.engraved.size(), std::size_t(2));
    QCOMPARE(lines.engraved[0], *inside); // its own curve
    QVERIFY((lines.engraved[1].points().front() - Vec2(-100, 10)).norm() < 1e-5);
    QVERIFY((lines.engraved[1].points().back() - Vec2(100, 10)).norm() < 1e-5);
    QVERIFY(!addMark(*document, desk.marked().id, std::make_shared<const Mark>()));
}

// Wrong: a part's number would be burnt over its name.
void TestMarkTool::numbersKeepOffThem()
{
    MarkDesk desk;
    desk.click(desk.plate(0, 0));
    const Analysis analysis = analysed(desk.session.committed());
    const std::vector<Part> parts = makeParts(analysis.model, analysis.assembly, analysis.bodies);
    const Engraving engraving = engrave(parts.front(), desk.marked().marks);
    QVERIFY(engraving.hasNumber);
    for (const CurvePath &path : engraving.lines.engraved)
        for (const Vec2 &p : path.flatten(0.05))
            for (const Box2 &box : engraving.boxes)
                QVERIFY(
                    !((p.array() > box.min.array()).all() && (p.array() < box.max.array()).all()));
}

void TestMarkTool::lockedIsRefused()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.lock");
    desk.run("section.mark");
    QCOMPARE(desk.hint(), hints::kLocked);
    desk.run("mark.addText", {{"text", "A"}});
    QVERIFY(desk.sections().front()->marks.empty());
}

FFF_TEST(TestMarkTool)
#include "tst_mark_tool.moc"
