// Lengths: measured, kept, and said as the size of the whole model.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/interaction/measure_tool.h"
#include "core/interaction/measure_words.h"
#include "core/io/document_file.h"
#include "core/io/fff_format.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/model/named_numbers.h"
#include "core/model/point_edits.h"
#include "core/operations/scaled_model.h"
#include "tests/core/interaction/desk.h"
#include "tests/test_program.h"

#include <QDir>
#include <QUndoStack>

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

/// A plate of 200 x 120 mm and the tool that measures it.
struct MeasureDesk : Desk
{
    explicit MeasureDesk(const char *tool = "measure.ruler")
    {
        addPlate();
        run(tool);
    }
    double measured() const
    {
        const auto *measure = interaction.overlay().find<sign::Line>();
        return measure ? (measure->points.back() - measure->points.front()).norm() : 0.0;
    }
    const std::vector<Dimension> &dimensions() const
    {
        return session.committed().document.dimensions;
    }
};

double lengthOf(const Model &model, const Dimension &dimension)
{
    return (*placeOf(model, dimension.to) - *placeOf(model, dimension.from)).norm();
}

} // namespace

class TestMeasureTool : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fromCornerToCorner();
    void clickAndClick();
    void ctrlSnapsToNothing();
    void alongAContour();
    void onTheGround();
    void besideTheModelFromInFront();
    void keptAsADimension();
    void aDimensionFollowsItsPoint();
    void aDimensionGoesWithItsSection();
    void typingALengthScalesTheModel();
    void theCursorMayPassByWhileTyped();
    void escDropsWhatIsTyped();
    void aKeptOneIsPickedUp();
    void scalingBackIsTheIdentity_data();
    void scalingBackIsTheIdentity();
    void scalingLeavesStocksAndMasses();
    void scalingBeyondBoundsIsRefused();
    void numbersHaveNames();
    void savedAndRead();
};

// Wrong: the plate would be said to be another size than it is.
void TestMeasureTool::fromCornerToCorner()
{
    MeasureDesk desk;
    // A few pixels off: it is the corner that is meant.
    desk.drag({desk.plate(-100, -60) + Vec2(4, 3), desk.plate(100, 60) + Vec2(-3, 5)});
    QVERIFY(std::abs(desk.measured() - std::hypot(200.0, 120.0)) < 1e-9);
    QCOMPARE(desk.hint(), hints::kMeasured);
    QCOMPARE(desk.steps(), 1); // nothing changed
    desk.interaction.escape(desk.time);
    QCOMPARE(desk.measured(), 0.0);
    QVERIFY(desk.interaction.tool());
    desk.interaction.escape(desk.time);
    QVERIFY(!desk.interaction.tool());
}

void TestMeasureTool::clickAndClick()
{
    MeasureDesk desk;
    desk.click(desk.plate(-100, -60));
    QCOMPARE(desk.hint(), hints::kSecondPlace);
    desk.click(desk.plate(100, -60));
    QVERIFY(std::abs(desk.measured() - 200.0) < 1e-9);
}

void TestMeasureTool::ctrlSnapsToNothing()
{
    MeasureDesk desk;
    desk.drag({desk.plate(-95, 0), desk.plate(95, 0)}, Button::Left, kControl);
    QVERIFY(std::abs(desk.measured() - 190.0) < 1e-6);
}

void TestMeasureTool::alongAContour()
{
    MeasureDesk desk;
    desk.drag({desk.plate(-101, 7), desk.plate(101, 7)});
    QVERIFY(std::abs(desk.measured() - 200.0) < 1e-6);
}

// Wrong: the height of something over the ground could not be measured.
void TestMeasureTool::onTheGround()
{
    MeasureDesk desk;
    Camera above = desk.interaction.camera();
    orientationOfView("iso1", above.orientation);
    desk.interaction.setCamera(above);
    const Vec3 corner(-100, kFirstPlaneHeight - 60, 0), below(-100, 0, 0);
    desk.drag({desk.screen(corner), desk.screen(below)});
    QVERIFY(std::abs(desk.measured() - (kFirstPlaneHeight - 60)) < 1e-6);
}

// Wrong: from in front, where the ground is a line, a drag beside the model would turn the view
// away, and on the ground it would not.
void TestMeasureTool::besideTheModelFromInFront()
{
    MeasureDesk desk;
    const Camera before = desk.interaction.camera();
    desk.drag({desk.plate(130, 10), desk.plate(130, 50)});
    QVERIFY(std::abs(desk.measured() - 40.0) < 1e-6);
    QVERIFY(isSameCamera(before, desk.interaction.camera()));
}

// Wrong: what was measured would have to be measured again and again.
void TestMeasureTool::keptAsADimension()
{
    MeasureDesk desk;
    QVERIFY(!desk.commands.isEnabled("measure.keep"));
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.run("measure.keep");
    QCOMPARE(desk.dimensions().size(), std::size_t(1));
    QCOMPARE(desk.lastStep(), QStringLiteral("Keep dimension"));
    QVERIFY(std::abs(lengthOf(desk.session.committed(), desk.dimensions()[0]) - 200.0) < 1e-9);
    desk.run("measure.remove", {{"dimension", "0"}});
    QVERIFY(desk.dimensions().empty());
    desk.session.history()->undo();
    QCOMPARE(desk.dimensions().size(), std::size_t(1));
}

// Wrong: a dimension would say what was, not what is.
void TestMeasureTool::aDimensionFollowsItsPoint()
{
    MeasureDesk desk;
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.run("measure.keep");
    const Section &plate = *desk.sections().front();
    const std::vector<Vec2> &points = plate.shape->contour().points();
    std::size_t corner = 0;
    while ((points[corner] - Vec2(100, -60)).norm() > 1e-9)
        corner += 3;
    std::vector<Vec2> moved = points;
    moved[corner] = {130, -60};
    const Result<ShapePointer> shape = Shape::make(*Contour::fromPoints(moved));
    QVERIFY(shape);
    const Result<Document> next = setShape(desk.session.committed().document, plate.id, *shape);
    desk.session.commit(QStringLiteral("Move"), *next);
    QVERIFY(std::abs(lengthOf(desk.session.committed(), desk.dimensions()[0]) - 230.0) < 1e-9);
}

void TestMeasureTool::aDimensionGoesWithItsSection()
{
    MeasureDesk desk;
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.run("measure.keep");
    desk.interaction.layDown(desk.time);
    desk.interaction.select({desk.sections().front()->id});
    desk.run("section.move", {{"x", "500"}, {"z", "30"}});
    QVERIFY(std::abs(lengthOf(desk.session.committed(), desk.dimensions()[0]) - 200.0) < 1e-9);
    desk.run("section.scale", {{"factor", "0.5"}});
    QVERIFY(std::abs(lengthOf(desk.session.committed(), desk.dimensions()[0]) - 100.0) < 1e-9);
    desk.run("edit.delete");
    QVERIFY(desk.dimensions().empty());
}

// Wrong: a model that was drawn freely could not be made to hold what it is for.
void TestMeasureTool::typingALengthScalesTheModel()
{
    MeasureDesk desk("measure.dimension");
    desk.addPlate(40.0);
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    QCOMPARE(desk.hint(), hints::kDimensionType);
    QCOMPARE(desk.interaction.numbers().front().kind, ToolNumber::Kind::Wanted);
    const Document before = desk.session.committed().document;
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 300.0}}, desk.time);
    // It is shown before it is done.
    QVERIFY(std::abs(desk.session.model().section(0)->shape->bounds().size().x() - 300.0) < 1e-9);
    QVERIFY(desk.session.committed().document.isSame(before));
    QVERIFY(desk.interaction.key(ToolKey::Enter, desk.time));
    QVERIFY(std::abs(desk.sections()[1]->shape->bounds().size().y() - 180.0) < 1e-9);
    QVERIFY(std::abs(desk.sections()[1]->frame.origin.z() - 60.0) < 1e-9);
    QCOMPARE(desk.lastStep(), QStringLiteral("Scale the model to 150\u202F%"));
    QVERIFY(std::abs(desk.measured() - 300.0) < 1e-9); // still in the hand
    desk.session.history()->undo();
    QVERIFY(desk.session.committed().document.isSame(before));
}

// Wrong: with every move of the mouse the whole model would be scaled, cut and checked anew.
void TestMeasureTool::theCursorMayPassByWhileTyped()
{
    MeasureDesk desk("measure.dimension");
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 50.0}}, desk.time);
    QVERIFY(desk.session.hasPreview());
    const Document shown = desk.session.model().document;
    desk.moveTo(desk.plate(10, 10));
    desk.moveTo(desk.plate(30, 20));
    QVERIFY(desk.session.model().document.isSame(shown));
    desk.interaction.key(ToolKey::Enter, desk.time);
    QVERIFY(desk.session.committed().document.isSame(shown));
}

void TestMeasureTool::escDropsWhatIsTyped()
{
    MeasureDesk desk("measure.dimension");
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 300.0}}, desk.time);
    desk.interaction.escape(desk.time);
    QVERIFY(std::abs(desk.session.model().section(0)->shape->bounds().size().x() - 200.0) < 1e-9);
    QVERIFY(std::abs(desk.measured() - 200.0) < 1e-9);
    // Nothing, and less than nothing, is no length.
    for (const double wanted : {0.0, -5.0, std::nan("")})
        desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, wanted}}, desk.time);
    QVERIFY(!desk.interaction.wants(ToolKey::Enter));
}

void TestMeasureTool::aKeptOneIsPickedUp()
{
    MeasureDesk desk("measure.dimension");
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.run("measure.keep");
    desk.interaction.escape(desk.time);
    desk.click(desk.plate(10, -60));
    QVERIFY(std::abs(desk.measured() - 200.0) < 1e-9);
    desk.interaction.setNumbers({{ToolNumber::Kind::Wanted, 100.0}}, desk.time);
    desk.interaction.key(ToolKey::Enter, desk.time);
    QVERIFY(std::abs(lengthOf(desk.session.committed(), desk.dimensions()[0]) - 100.0) < 1e-9);
    desk.run("measure.remove");
    QVERIFY(desk.dimensions().empty());
}

void TestMeasureTool::scalingBackIsTheIdentity_data()
{
    QTest::addColumn<QString>("path");
    const QDir folder(QStringLiteral(FFF_TEST_DATA "/../../resources/samples"));
    for (const QString &name : folder.entryList({QStringLiteral("*.fff")}))
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

// Scaled by f and by 1/f every sample is what it was, but for floating rounding: points, places,
// weights, marks, figures, and all that operations make of it.
void TestMeasureTool::scalingBackIsTheIdentity()
{
    QFETCH(QString, path);
    const Result<io::LoadedDocument> read = io::readDocument(path);
    QVERIFY(read);
    const Document &document = read->document;
    for (const double factor : {0.7, 1.25}) {
        const Result<Document> there = scaledModel(document, factor);
        if (!there) // a length of an operation leaves its bounds, which is said
            QCOMPARE(there.error().code, ErrorCode::BadValue);
        if (!there)
            continue;
        const Result<Document> back = scaledModel(*there, 1.0 / factor);
        QVERIFY(back);
        QCOMPARE(back->sections.size(), document.sections.size());
        for (std::size_t i = 0; i < document.sections.size(); ++i) {
            const Section &was = *document.sections[i], &is = *back->sections[i];
            QVERIFY((was.frame.origin - is.frame.origin).norm() < 1e-9);
            QCOMPARE(is.frame.x, was.frame.x);
            QCOMPARE(is.stock, was.stock);
            QCOMPARE(is.figures.size(), was.figures.size());
            const auto &a = was.shape->contour().points(), &b = is.shape->contour().points();
            QCOMPARE(b.size(), a.size());
            for (std::size_t k = 0; k < a.size(); ++k)
                QVERIFY((a[k] - b[k]).norm() < 1e-9);
        }
        for (std::size_t i = 0; i < document.loads.size(); ++i) {
            QVERIFY((document.loads[i].position - back->loads[i].position).norm() < 1e-9);
            QCOMPARE(back->loads[i].mass, document.loads[i].mass);
        }
        // What operations make of it is larger by the same factor.
        const Model before = evaluate(document), after = evaluate(*there);
        QCOMPARE(after.sectionCount(), before.sectionCount());
        const Box3 a = before.bounds(), b = after.bounds();
        QVERIFY((b.size() - factor * a.size()).norm() < 1e-3 * a.size().norm());
    }
}

void TestMeasureTool::scalingLeavesStocksAndMasses()
{
    MeasureDesk desk;
    Document document = desk.session.committed().document;
    document = *addLoad(document, {{}, desk.sections().front()->id, Vec2(10, 20), 0.5});
    const Result<Document> scaled = scaledModel(document, 3.0);
    QVERIFY(scaled);
    QCOMPARE(scaled->stocks, document.stocks);
    QCOMPARE(scaled->loads.front().mass, 0.5);
    QCOMPARE(scaled->loads.front().position, Vec2(30, 60));
    QVERIFY(scaledModel(document, 1.0)->isSame(document));
}

void TestMeasureTool::scalingBeyondBoundsIsRefused()
{
    MeasureDesk desk;
    for (const char *factor : {"0", "-1"})
        QVERIFY(!desk.commands.run("measure.scale", {{"factor", factor}}, desk.time));
    desk.run("measure.scale", {{"factor", "1e6"}});
    QCOMPARE(desk.hint(), hints::kNotScaledSoFar);
    desk.run("measure.scale", {{"factor", "1e-6"}});
    QCOMPARE(desk.hint(), hints::kNotScaledSoFar);
    QCOMPARE(desk.steps(), 1);
}

void TestMeasureTool::numbersHaveNames()
{
    Desk desk;
    desk.run("numbers.set", {{"name", "gap"}, {"value", "12"}, {"expression", "12 mm"}});
    const auto numbers = [&desk] { return desk.session.committed().document.numbers; };
    QCOMPARE(numbers().size(), std::size_t(1));
    QCOMPARE(findNumber(desk.session.committed().document, "GAP")->value, 12.0);
    desk.run("numbers.rename", {{"name", "gap"}, {"to", "space"}});
    QCOMPARE(numbers().front().name, std::string("space"));
    for (const char *name : {"t", "mm", "IN", "2x", "", "a b", "größe"})
        QVERIFY2(!desk.commands.run("numbers.set", {{"name", name}, {"value", "1"}}, 0.0), name);
    desk.run("numbers.remove", {{"name", "space"}});
    QVERIFY(numbers().empty());
    desk.session.history()->undo();
    QCOMPARE(desk.session.committed().document.numbers.size(), std::size_t(1));
}

void TestMeasureTool::savedAndRead()
{
    MeasureDesk desk;
    desk.drag({desk.plate(-100, -60), desk.plate(100, -60)});
    desk.run("measure.keep");
    desk.run("numbers.set", {{"name", "gap"}, {"value", "12"}, {"expression", "12 mm"}});
    const Document &document = desk.session.committed().document;
    const Result<io::LoadedDocument> read = io::readFff(*io::writeFff(document));
    QVERIFY(read);
    QVERIFY(read->document == document);
}

FFF_TEST(TestMeasureTool)
#include "tst_measure_tool.moc"
