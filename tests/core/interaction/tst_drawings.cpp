// Drawings of other programs as sections, contours, holes and marks.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/drawing_words.h"
#include "core/interaction/section_editing.h"
#include "core/io/cutting_file.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QUndoStack>

#include <set>

using namespace fff;
using namespace fff::test;

namespace {

std::string drawing(const char *name)
{
    return (QStringLiteral(FFF_TEST_DATA "/drawings/") + QLatin1String(name) +
            QStringLiteral(".svg"))
        .toStdString();
}

} // namespace

class TestDrawings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aSectionForEveryOutline();
    void besideWhatIsThere();
    void theLargestOutlineAsContour();
    void aHoleForEveryOutline();
    void linesAsMarks();
    void whatWasSkippedIsSaid();
    void openLinesAreRefused();
    void brokenFilesChangeNothing();
    void manySectionsAreOneStep();
    void tangledLinesAreRefusedButEngraved();
    void uprightOnATurnedSection();
    void ourOwnFileComesBack();
};

// Wrong: what was drawn elsewhere had to be drawn again.
void TestDrawings::aSectionForEveryOutline()
{
    Desk desk;
    desk.run("section.importSections", {{"path", drawing("path-island-in-hole")}});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QCOMPARE(desk.sections()[0]->shape->holes().size(), std::size_t(1));
    QVERIFY(std::abs(desk.sections()[0]->shape->area() - (3600.0 - 1600.0)) < 1e-6);
    QVERIFY(std::abs(desk.session.committed().bounds().min.y()) < 0.01); // on the ground
    QCOMPARE(desk.interaction.selection().size(), std::size_t(2));
    QCOMPARE(desk.lastStep(), QStringLiteral("Import path-island-in-hole.svg"));
    desk.session.history()->undo();
    QVERIFY(desk.sections().empty());
}

void TestDrawings::besideWhatIsThere()
{
    Desk desk;
    desk.addPlate();
    desk.run("section.importSections", {{"path", drawing("circle")}});
    const Section &circle = *desk.sections()[1];
    QVERIFY(worldBounds(*circle.shape, circle.frame).min.x() > 119.0);
}

void TestDrawings::theLargestOutlineAsContour()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    const Vec3 before = positionOf(*desk.sections().front());
    desk.run("section.importContour", {{"path", drawing("path-two-subpaths")}});
    const Section &section = *desk.sections().front();
    QVERIFY(std::abs(section.shape->area() - 1500.0) < 1e-6);
    QVERIFY((positionOf(section) - before).norm() < 1e-6);
    desk.run("section.importContour", {{"path", drawing("path-island-in-hole")}});
    QCOMPARE(desk.hint(), hints::kDrawingLeft);
    QCOMPARE(desk.interaction.hint().words.count, std::optional(1));
}

void TestDrawings::aHoleForEveryOutline()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.importHoles", {{"path", drawing("use-and-defs")}});
    QCOMPARE(desk.sections().front()->shape->holes().size(), std::size_t(3));
    desk.run("section.importHoles", {{"path", drawing("units-inch")}});
    QVERIFY(desk.sections().front()->shape->isPlain());
}

void TestDrawings::linesAsMarks()
{
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    desk.run("mark.score");
    desk.run("section.importMarks", {{"path", drawing("cad-loose-edges")}});
    const Mark &mark = *desk.sections().front()->marks.front();
    QCOMPARE(mark.paths.size(), std::size_t(4));
    QCOMPARE(mark.kind, Mark::Kind::Scored);
}

// Wrong: texts would be missing and nobody would know why.
void TestDrawings::whatWasSkippedIsSaid()
{
    Desk desk;
    desk.run("section.importSections", {{"path", drawing("text-and-picture")}});
    QCOMPARE(desk.hint(), hints::kDrawingReadOfBoth);
    const std::vector<Argument> &said = desk.interaction.hint().words.arguments;
    QVERIFY(said[1] == Argument(Message{hints::kSkippedTexts, {}, 3}));
    QVERIFY(said[2] == Argument(Message{hints::kSkippedPictures, {}, 1}));
    QVERIFY(said[3] == Argument(Message{hints::kLinesRead, {}, 1}));
    QCOMPARE(desk.sections().size(), std::size_t(1));
}

void TestDrawings::openLinesAreRefused()
{
    Desk desk;
    desk.run("section.importSections", {{"path", drawing("polyline-open")}});
    QCOMPARE(desk.hint(), hints::kDrawingOpen);
    desk.run("section.importSections", {{"path", drawing("cad-loose-edges")}});
    QCOMPARE(desk.sections().size(), std::size_t(1)); // its edges meet
}

void TestDrawings::brokenFilesChangeNothing()
{
    Desk desk;
    for (const char *name : {"broken-path", "use-bomb", "not-xml", "only-text", "there-is-none"})
        QVERIFY(!desk.commands.run("section.importSections", {{"path", drawing(name)}}, 0.0));
    QCOMPARE(desk.steps(), 0);
    QVERIFY(!desk.commands.run("section.importSections", {}, 0.0));
}

// Wrong: names would be given twice, or the sections would come in steps of their own.
void TestDrawings::manySectionsAreOneStep()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("many.svg")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QByteArray text = "<svg width=\"400mm\" height=\"400mm\" viewBox=\"0 0 400 400\">";
    for (int i = 0; i < 900; ++i)
        text += QStringLiteral("<rect x=\"%1\" y=\"%2\" width=\"8\" height=\"8\"/>")
                    .arg(i % 30 * 10)
                    .arg(i / 30 * 10)
                    .toLatin1();
    file.write(text + "</svg>");
    file.close();
    Desk desk;
    desk.addPlate(); // has the first name
    const int before = desk.steps();
    desk.run("section.importSections", {{"path", file.fileName().toStdString()}});
    QCOMPARE(desk.steps(), before + 1);
    QCOMPARE(desk.sections().size(), std::size_t(901));
    QCOMPARE(desk.interaction.selection().size(), std::size_t(900));
    std::set<std::string> names;
    for (const SectionPointer &section : desk.sections())
        names.insert(section->name);
    QCOMPARE(names.size(), std::size_t(901));
    QVERIFY(names.contains("Section 901"));
}

// Wrong: it would be busy for hours with what nobody can cut out, or refuse what can be engraved.
void TestDrawings::tangledLinesAreRefusedButEngraved()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("tangle.svg")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QByteArray text =
        "<svg width=\"999mm\" height=\"999mm\" viewBox=\"0 0 999 999\"><path d=\"M0 0";
    unsigned place = 1;
    for (int i = 0; i < 30'000; ++i) {
        place = place * 1'664'525u + 1'013'904'223u;
        text += QStringLiteral("L%1 %2").arg(place / 65'536 % 997).arg(0.03 * i).toLatin1();
        place = place * 1'664'525u + 1'013'904'223u;
        text +=
            QStringLiteral("L%1 %2").arg(place / 65'536 % 991).arg(place / 4'096 % 983).toLatin1();
    }
    file.write(text + "Z\"/></svg>");
    file.close();
    Desk desk;
    desk.addPlate();
    desk.interaction.select({desk.sections().front()->id});
    const CommandParameters path{{"path", file.fileName().toStdString()}};
    const int before = desk.steps();
    const Result<void> run = desk.commands.run("section.importSections", path, 0.0);
    QVERIFY(!run);
    QCOMPARE(run.error().code, ErrorCode::BadCount);
    QCOMPARE(run.error().place, std::string("tangle.svg"));
    QVERIFY(!desk.commands.run("section.importHoles", path, 0.0));
    QCOMPARE(desk.steps(), before);
    QVERIFY(desk.commands.run("section.importMarks", path, 0.0));
    QCOMPARE(desk.steps(), before + 1);
}

// Wrong: on a section whose frame lies otherwise, the drawing would lie on its side.
void TestDrawings::uprightOnATurnedSection()
{
    Desk desk;
    Frame frame{Vec3(0, 100, 0), Vec3::UnitY(), -Vec3::UnitX()}; // a quarter turn
    desk.session.commit(QStringLiteral("Draw"),
                        withSection(desk.session.committed().document,
                                    polygonShape(rectangle(-60, -60, 60, 60)), frame));
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.importContour", {{"path", drawing("units-cm")}}); // 100 x 50
    const Box3 box = worldBounds(*desk.sections().front()->shape, desk.sections().front()->frame);
    QVERIFY(std::abs(box.size().x() - 100.0) < 1e-6);
    QVERIFY(std::abs(box.size().y() - 50.0) < 1e-6);
}

// Wrong: from our own cutting file the 100 mm bar would come as a part, and numbers as holes.
void TestDrawings::ourOwnFileComesBack()
{
    Desk desk;
    desk.addPlate();
    io::CuttingFileOptions options;
    options.compensatesKerf = false;
    AnalysisCaches caches;
    const Result<io::CuttingFile> file =
        io::makeCuttingFile(analyse(desk.session.committed(), caches), options);
    QVERIFY(file);
    QTemporaryDir folder;
    QFile svg(folder.filePath(QStringLiteral("plate.svg")));
    QVERIFY(svg.open(QIODevice::WriteOnly));
    svg.write(QByteArray::fromStdString(file->whole));
    svg.close();
    desk.run("section.importSections", {{"path", svg.fileName().toStdString()}});
    QCOMPARE(desk.sections().size(), std::size_t(2));
    QVERIFY(desk.sections()[1]->shape->holes().empty());
    QVERIFY(std::abs(desk.sections()[1]->shape->area() - 24000.0) < 1e-3);
}

FFF_TEST(TestDrawings)
#include "tst_drawings.moc"
