#include "core/assembly/assembly.h"
#include "core/io/fff_format.h"
#include "tests/core/operations/operation_models.h"
#include "tests/test_program.h"

#include <QTest>

#include <random>

using namespace fff;
using namespace fff::test;

class TestEvaluate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unrelatedEditsKeepTheObjects();
    void movedInputsKeepTheShape();
    void ribsBeforeAMovedPointStayTheVeryOnes_data();
    void ribsBeforeAMovedPointStayTheVeryOnes();
    void laterOperationsFollowEarlierOnes();
    void missingInputsAreNamedAndComeBack();
    void offMakesNothing();
    void orderIsOneOfWork();
    void exceptionsSurvive();
    void savedOperationsStayAlive();
    void valuesOutOfRangeAreBroughtIn();
    void assemblyFollowsByWhatItTouches();
};

namespace {

Document withRibs()
{
    FishBones bones;
    add(bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                                  {{"side", std::string("both")}}));
    return bones.document;
}

Document moved(Document document, SectionId id, const Vec3 &way)
{
    Frame frame = document.find(id)->frame;
    frame.origin += way;
    return moveSection(std::move(document), id, frame).value();
}

} // namespace

// Wrong: every edit anywhere would cut all ribs anew.
void TestEvaluate::unrelatedEditsKeepTheObjects()
{
    Document document = withRibs();
    const Model before = evaluate(document);
    add(document, "Stand", shapeOf(circle({0, 0}, 30)), frontFrame({0, 0, 70}));
    const Model after = evaluate(document, before);
    QCOMPARE(after.evaluation.results[0], before.evaluation.results[0]);
    for (std::size_t i = 3; i < after.sectionCount(); ++i)
        QCOMPARE(after.section(i), before.section(i - 1));
    // Renaming the operation makes it work again, with the same outcome.
    Operation renamed = *document.operations[0];
    renamed.name = "Ribs";
    const Model named = evaluate(setOperation(document, renamed).value(), after);
    for (std::size_t i = 0; i < after.sectionCount(); ++i)
        QCOMPARE(named.section(i), after.section(i));
    QCOMPARE(named.evaluation.listing, after.evaluation.listing);
}

// Wrong: dragging a rib would make fifty shapes a move.
void TestEvaluate::movedInputsKeepTheShape()
{
    const Document document = withRibs();
    const Model before = evaluate(document);
    const Model after = evaluate(moved(document, SectionId{3}, {1.5, 0, 0}), before);
    QCOMPARE(after.sectionCount(), before.sectionCount());
    for (std::size_t i = 1; i < after.sectionCount(); ++i)
        QCOMPARE(after.section(i)->shape, before.section(1)->shape);
}

void TestEvaluate::ribsBeforeAMovedPointStayTheVeryOnes_data()
{
    QTest::addColumn<QByteArray>("kind");
    QTest::addColumn<QByteArray>("scale");
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<int>("moved"); // of the spine's points, one that the row does not come to
    for (const char *scale : {"no", "thickness"}) {
        QTest::addRow("linear %s", scale)
            << QByteArray("linear") << QByteArray(scale) << 0.4 << 1.0 << 6;
        QTest::addRow("revolve %s", scale)
            << QByteArray("revolve") << QByteArray(scale) << 0.0 << 0.15 << 7;
    }
    QTest::newRow("revolve back") << QByteArray("revolve") << QByteArray("no") << 0.8 << 0.2 << 7;
}

// Wrong: the far end of a spine could not be dragged without making, cutting and drawing all ribs
// anew.
void TestEvaluate::ribsBeforeAMovedPointStayTheVeryOnes()
{
    QFETCH(QByteArray, kind);
    QFETCH(QByteArray, scale);
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(int, moved);
    FishBones bones;
    add(bones.document,
        operation(kind.constData(), {{"section", {bones.rib}}, {"along", {bones.spine}}},
                  {{"side", std::string(kind == QByteArray("linear") ? "both" : "outside")},
                   {"repeatBy", std::string("spacing")},
                   {"spacing", 7.0},
                   {"scale", std::string(scale.constData())},
                   {"from", from},
                   {"to", to}}));
    const Model before = evaluate(bones.document);
    const ShapePointer shape = bones.document.find(bones.spine)->shape;
    std::vector<Vec2> points = shape->contour().points();
    points[static_cast<std::size_t>(moved)].x() += 3.0;
    const ShapePointer other = shapeOf(Contour::fromPoints(points).value());
    const Model after = evaluate(setShape(bones.document, bones.spine, other).value(), before);
    int made = 0, kept = 0;
    for (const SectionPointer &section : before.sections()) {
        made += section->made.operation.isValid() ? 1 : 0;
        const Section *now = after.find(section->ref());
        kept += section->made.operation.isValid() && now == section.get() ? 1 : 0;
    }
    QVERIFY2(made > 4 && kept > made / 2, qPrintable(QStringLiteral("%1 %2").arg(made).arg(kept)));
}

// Wrong: what stands on a rib would stay in the air when the ribs are moved.
void TestEvaluate::laterOperationsFollowEarlierOnes()
{
    FishBones bones;
    const OperationId rows = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}},
                                  {{"count", 4.0}, {"side", std::string("back")}}));
    const SectionId slat =
        add(bones.document, "Slat", shapeOf(polygonContour(rectangleAt(50, -8, 80, 16))),
            {{0, 30, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    const OperationId slats =
        add(bones.document,
            operation("linear", {{"section", {slat}}, {"along", {SectionRef(rows, "-1")}}},
                      {{"count", 3.0}, {"equalDepth", false}, {"side", std::string("both")}}));
    const Model before = evaluate(bones.document);
    QCOMPARE(before.evaluation.results[1]->sections.size(), 2U);
    Operation fewer = *bones.document.operations[0];
    fewer.parameters["count"] = 3.0;
    const Model after = evaluate(setOperation(bones.document, fewer).value(), before);
    QCOMPARE(after.evaluation.results[1]->sections.size(), 2U);
    QVERIFY(after.find({rows, "-1"}) && !after.find({rows, "-3"}));
    QVERIFY(after.evaluation.results[1] != before.evaluation.results[1]);
    QVERIFY(after.find({slats, "1"}) || after.find({slats, "-1"}));
}

// Wrong: deleting a rib would take all of the work along, and undo would not bring it back.
void TestEvaluate::missingInputsAreNamedAndComeBack()
{
    Document document = withRibs();
    const Model before = evaluate(document);
    const std::vector<SectionId> rib{SectionId{3}};
    const Model without = evaluate(removeSections(document, rib).value(), before);
    QCOMPARE(without.sectionCount(), 1U);
    const OperationNotice notice = without.evaluation.results[0]->notices.front();
    QCOMPARE(notice.kind, OperationNotice::Kind::InputMissing);
    QCOMPARE(notice.name, std::string("Rib"));
    QVERIFY(without.document.operations.size() == 1);
    const Model again = evaluate(document, without);
    QCOMPARE(again.sectionCount(), before.sectionCount());
}

// Wrong: switched off, sections would still be cut.
void TestEvaluate::offMakesNothing()
{
    Document document = withRibs();
    Operation off = *document.operations[0];
    off.isOn = false;
    const Model model = evaluate(setOperation(document, off).value(), evaluate(document));
    QCOMPARE(model.sectionCount(), 2U);
    QVERIFY(!model.evaluation.listing);
    QVERIFY(!model.resultOf(off.id));
}

// Wrong: an operation could read what one below it makes, and so itself.
void TestEvaluate::orderIsOneOfWork()
{
    FishBones bones;
    const OperationId first = add(
        bones.document, operation("linear", {{"section", {bones.rib}}, {"along", {bones.spine}}}));
    const OperationId second =
        add(bones.document,
            operation("linear", {{"section", {SectionRef(first, "1")}}, {"along", {bones.spine}}}));
    QCOMPARE(evaluate(bones.document).evaluation.results[1]->notices.size(), 0U);
    const Model turned = evaluate(moveOperation(bones.document, second, 0).value());
    QCOMPARE(turned.evaluation.results[0]->operation->id, second);
    QCOMPARE(turned.evaluation.results[0]->notices.front().kind,
             OperationNotice::Kind::InputMissing);
    QCOMPARE(turned.evaluation.results[1]->sections.size(), 7U);
}

// Wrong: a hidden rib would come back, or another one go, with another count.
void TestEvaluate::exceptionsSurvive()
{
    Document document = withRibs();
    const OperationId id = document.operations[0]->id;
    const SectionRef hidden(id, "-2");
    document = setException(document, hidden, {Exception::State::Hidden}).value();
    Model model = evaluate(document);
    QCOMPARE(model.sectionCount(), 2U + 6U);
    QCOMPARE(model.indexOf(hidden), -1);
    for (const double count : {3.0, 20.0}) {
        Operation other = *document.operations[0];
        other.parameters["count"] = count;
        model = evaluate(setOperation(document, other).value(), model);
        QCOMPARE(model.indexOf(hidden), -1);
    }
    document = setException(document, hidden, {}).value();
    QVERIFY(document.operations[0]->exceptions.empty());
    QVERIFY(evaluate(document).indexOf(hidden) >= 0);
}

// Wrong: a file would open as what it was when it was saved, and never follow again.
void TestEvaluate::savedOperationsStayAlive()
{
    Document document = withRibs();
    document = setException(document, {document.operations[0]->id, "1"}, {Exception::State::Hidden})
                   .value();
    const Document loaded = io::readFff(io::writeFff(document).value()).value().document;
    QVERIFY(loaded == document);
    const Model model = evaluate(document), again = evaluate(loaded);
    QCOMPARE(again.sectionCount(), model.sectionCount());
    for (std::size_t i = 0; i < model.sectionCount(); ++i)
        QVERIFY(*again.section(i) == *model.section(i));
}

// Wrong: a number from another program would hang the window or crash.
void TestEvaluate::valuesOutOfRangeAreBroughtIn()
{
    std::mt19937 random(7);
    const double odd[] = {-1e300, -1.0, 0.0, 0.3, 1e9, 1e300, std::nan(""), HUGE_VAL};
    for (const OperationKind *kind : operationKinds()) {
        for (int round = 0; round < 60; ++round) {
            FishBones bones;
            Operation wild =
                operation(kind->key, {{"section", {bones.rib}}, {"along", {bones.spine}}});
            for (const ParameterSpec &spec : kind->parameters) {
                if (random() % 3 == 0)
                    wild.parameters[spec.key] = odd[random() % std::size(odd)];
                else if (random() % 5 == 0)
                    wild.parameters[spec.key] = std::string("nonsense");
            }
            add(bones.document, wild);
            const Model model = evaluate(bones.document);
            QVERIFY(model.sectionCount() >= 1);
            for (std::size_t i = 0; i < model.sectionCount(); ++i)
                QVERIFY(model.section(i)->frame.origin.allFinite());
        }
    }
}

// Wrong: joints and slits would be those of other sections after an edit before them.
void TestEvaluate::assemblyFollowsByWhatItTouches()
{
    Document document = withRibs();
    Model model = evaluate(document);
    Assembly assembly = assemble(model);
    const auto step = [&](Document next) {
        document = std::move(next);
        Model after = evaluate(document, model);
        const Assembly followed = assemble(after, model, assembly), anew = assemble(after);
        QCOMPARE(followed.joints.size(), anew.joints.size());
        for (std::size_t i = 0; i < anew.joints.size(); ++i) {
            QCOMPARE(followed.joints[i].id, anew.joints[i].id);
            QCOMPARE(followed.joints[i].a, anew.joints[i].a);
            QCOMPARE(followed.joints[i].b, anew.joints[i].b);
            QCOMPARE(followed.joints[i].kind, anew.joints[i].kind);
        }
        QVERIFY(followed.slits == anew.slits);
        model = std::move(after);
        assembly = followed;
    };
    const auto withCount = [&](double count) {
        Operation other = *document.operations[0];
        other.parameters["count"] = count;
        return setOperation(document, other).value();
    };
    Document next = document;
    add(next, "Bar", shapeOf(polygonContour(rectangleAt(20, -5, 150, 10))),
        {{0, 50, 0}, Vec3::UnitX(), -Vec3::UnitZ()});
    step(next); // a drawn one before the generated ones
    step(moved(document, SectionId{3}, {3, 0, 0}));
    step(withCount(15.0));
    step(withCount(6.0));
    step(setException(document, {document.operations[0]->id, "-1"}, {Exception::State::Hidden})
             .value());
    const std::vector<SectionId> bar{document.sections.back()->id};
    step(removeSections(document, bar).value());
    Document two = document;
    add(two, operation("revolve", {{"section", {SectionId{3}}}, {"along", {SectionId{2}}}},
                       {{"count", 5.0}}));
    step(two);
    step(moveOperation(document, document.operations[1]->id, 0).value());
    step(removeOperation(document, document.operations[0]->id).value());
}

FFF_TEST(TestEvaluate)
#include "tst_evaluate.moc"
