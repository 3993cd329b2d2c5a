// What is written on the paper of the steps, beside its pictures.
#include <QGuiApplication>
#include <QTest>

#include "core/analysis/cutting.h"
#include "core/model/edits.h"
#include "core/model/stock.h"
#include "core/operations/evaluate.h"
#include "core/session/assembly_steps.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"
#include "ui/view/steps_paper.h"

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

class TestStepsPaper : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedKingdom)); }

    void lengthsAreInTheUnit_data();
    void lengthsAreInTheUnit();
    void stocksAreNamedAsTheReaderKnowsThem();
    void sheetsAreThoseThatAreCut();
};

void TestStepsPaper::lengthsAreInTheUnit_data()
{
    QTest::addColumn<LengthUnit>("unit");
    QTest::addColumn<QString>("stock");
    QTest::addColumn<QString>("size");
    QTest::newRow("millimetres") << LengthUnit::Millimetre << QStringLiteral("Ply, 3.175\u202fmm")
                                 << QStringLiteral("84 × 127\u202fmm");
    QTest::newRow("centimetres") << LengthUnit::Centimetre << QStringLiteral("Ply, 0.3175\u202fcm")
                                 << QStringLiteral("8.4 × 12.7\u202fcm");
    QTest::newRow("inches") << LengthUnit::Inch << QStringLiteral("Ply, 0.125\u202fin")
                            << QStringLiteral("3.3 × 5.0\u202fin");
}

// Wrong: whoever works in inches finds millimetres on the paper.
void TestStepsPaper::lengthsAreInTheUnit()
{
    QFETCH(LengthUnit, unit);
    Stock stock;
    stock.name = "Ply";
    stock.thickness = 3.175;
    StepsPaper::Options options;
    options.unit = unit;
    QTEST(StepsPaper::stockText(stock, options), "stock");
    QTEST(StepsPaper::sizeText({83.6, 127.0}, unit), "size");
}

// Wrong: the paper says one sheet, and the cutting files that lie beside it are of two.
void TestStepsPaper::sheetsAreThoseThatAreCut()
{
    Document document = combModel(8);
    Stock stock = *document.find(document.currentStock);
    stock.spares = {*rectangularSheet({150.0, 100.0})};
    document = *setStock(std::move(document), stock);
    AnalysisCaches caches;
    const AnalysisPointer analysis = analyseNext(evaluate(std::move(document)), caches);
    const AssemblyStepsPointer steps = assemblySteps(analysis, planOf(*analysis, {}));
    QVERIFY(steps);
    const std::shared_ptr<const Layout> layout = layoutFor(*analysis, {});
    QVERIFY(layout);
    QCOMPARE(layout->sheets.size(), std::size_t(2)); // the offcut, and a whole one
    QVERIFY(StepsPaper::factsText(*steps, {}).contains(QStringLiteral("from 2 sheet")));
    StepsPaper::Options options;
    Layout one = *layout;
    one.sheets.resize(1);
    options.layout = std::make_shared<const Layout>(std::move(one));
    QVERIFY(StepsPaper::factsText(*steps, options).contains(QStringLiteral("from 1 sheet")));
}

void TestStepsPaper::stocksAreNamedAsTheReaderKnowsThem()
{
    Stock stock;
    stock.name = "Birch";
    stock.thickness = 3.0;
    StepsPaper::Options options;
    QCOMPARE(StepsPaper::stockText(stock, options), QStringLiteral("Birch, 3.00\u202fmm"));
    options.stockName = [](const Stock &) { return QStringLiteral("Birke"); };
    QCOMPARE(StepsPaper::stockText(stock, options), QStringLiteral("Birke, 3.00\u202fmm"));
}

FFF_TEST_WITH(TestStepsPaper, fff::testing::runWithin<TestStepsPaper, QGuiApplication>)
#include "tst_steps_paper.moc"
