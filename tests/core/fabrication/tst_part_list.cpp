#include "core/fabrication/part_list.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/fabrication/parts_of.h"
#include "tests/test_program.h"

#include "core/analysis/cutting.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

class TestPartList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPartIsListedOnce();
    void copiesAreOne();
    void anotherStockIsAnotherPart();
    void sizesAreThoseThatWereDrawn();
    void cutsAreAsLongAsTheyAre();
    void anEmptyModelHasNone();
};

namespace {

Document plates(int count)
{
    Document document = newDocument();
    for (int i = 0; i < count; ++i)
        document = withSection(document, plateOf(0, 0, 40, 30), front(50.0 * i));
    return document;
}

} // namespace

// Wrong: a part that somebody looks for in vain.
void TestPartList::everyPartIsListedOnce()
{
    Document document = plates(3);
    document = withSection(document, plateOf(0, 0, 40, 31), front(-50.0));
    document = withSection(document, plateOf(0, 0, 40, 30), front(-90.0));
    const Model model = evaluate(document);
    const std::vector<Part> parts = partsOf(model);
    std::vector<int> numbers;
    for (const ListedPart &part : partList(parts, model)) {
        QVERIFY(std::is_sorted(part.numbers.begin(), part.numbers.end()));
        numbers.insert(numbers.end(), part.numbers.begin(), part.numbers.end());
    }
    std::sort(numbers.begin(), numbers.end());
    QCOMPARE(numbers.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        QCOMPARE(numbers[i], parts[i].number);
}

void TestPartList::copiesAreOne()
{
    const Model model = evaluate(plates(3));
    const std::vector<ListedPart> list = partList(partsOf(model), model);
    QCOMPARE(list.size(), std::size_t(1));
    QCOMPARE(list.front().numbers, (std::vector{1, 2, 3}));
    QCOMPARE(list.front().name, model.section(0)->name);
}

void TestPartList::anotherStockIsAnotherPart()
{
    Document document = *addStock(plates(1), flatfabAcrylic());
    document = withSection(document, document.sections.front()->shape, front(50.0));
    const Model model = evaluate(document);
    QCOMPARE(partList(partsOf(model), model).size(), std::size_t(2));
}

// Wrong: a list that has the path of the laser in place of the part.
void TestPartList::sizesAreThoseThatWereDrawn()
{
    const Document document = withSection(
        newDocument(), polygonShape(rectangle(0, 0, 40, 30), {rectangle(10, 10, 20, 15)}), front());
    const Result<Cutting> cutting = makeCutting(analysed(document));
    QVERIFY(cutting);
    QVERIFY(document.stocks.front()->kerf > 0.0);
    QCOMPARE(cutting->drawing.list.size(), std::size_t(1));
    QVERIFY((cutting->drawing.list.front().size - Vec2(40.0, 30.0)).norm() < 1e-6);
    QVERIFY(std::abs(cutting->drawing.list.front().area - (1200.0 - 50.0)) < 1e-6);
}

// A rectangle's corners are cut round by half a kerf: 2 (w + h) + 2 pi r; its hole's stay sharp and
// are smaller by a kerf on each side.
void TestPartList::cutsAreAsLongAsTheyAre()
{
    Document document = withSection(
        newDocument(), polygonShape(rectangle(0, 0, 40, 30), {rectangle(10, 10, 20, 15)}), front());
    for (const double kerf : {0.0, 0.2}) {
        Stock stock = *document.stocks.front();
        stock.kerf = kerf;
        document = *setStock(document, stock);
        const Result<Cutting> cutting = makeCutting(analysed(document));
        QVERIFY(cutting);
        const double outside = 140.0 + M_PI * kerf, mitred = 140.0 + 4.0 * kerf;
        const double hole = 30.0 - 4.0 * kerf;
        const double length = cutLength(cutting->drawing);
        QVERIFY2(length > outside + hole - 0.01 && length < mitred + hole + 0.01,
                 qPrintable(QString::number(length)));
    }
}

void TestPartList::anEmptyModelHasNone()
{
    QVERIFY(partList({}, evaluate(newDocument())).empty());
    QCOMPARE(cutLength({}), 0.0);
}

FFF_TEST(TestPartList)
#include "tst_part_list.moc"
