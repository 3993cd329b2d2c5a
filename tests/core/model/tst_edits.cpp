#include "core/geometry/contour.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

ShapePointer disc(double radius = 20.0)
{
    return Shape::make(circle({0, 0}, radius)).value();
}

/// Three sections, the third drawn on the first; a weight on each.
Document sample()
{
    Document document = newDocument();
    for (int i = 0; i < 3; ++i) {
        NewSection section;
        section.shape = disc();
        if (i == 2)
            section.parent = Parent{document.sections[0]->id, {0, 0}, {0, 20}};
        document = addSection(document, section).value();
        Load weight;
        weight.section = document.sections.back()->id;
        document = addLoad(document, weight).value();
    }
    return document;
}

bool isUnknown(const Result<Document> &result)
{
    return !result && result.error().code == ErrorCode::UnknownReference;
}

} // namespace

class TestEdits : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void idsAreNeverReused();
    void freshSectionsGetAName();
    void othersKeepTheirObjects();
    void editsThatChangeNothingReturnTheSame();
    void unknownReferencesAreRefused();
    void failedEditLeavesTheDocument();
    void removingASectionTakesItsWeights();
    void childrenOfARemovedSectionStay();
    void stocksAreChecked_data();
    void stocksAreChecked();
    void removedStocksAreReplaced();
    void weightsAreChecked();
};

// Wrong: a reference to a deleted section would come to life on another one.
void TestEdits::idsAreNeverReused()
{
    Document document = sample();
    const SectionId last = document.sections.back()->id;
    document = removeSections(document, std::vector{last}).value();
    NewSection section;
    section.shape = disc();
    document = addSection(document, section).value();
    QVERIFY(document.sections.back()->id > last);
    QVERIFY(document.nextId > document.sections.back()->id.value);
}

// Wrong: two sections of one name, which nobody can tell apart in a list.
void TestEdits::freshSectionsGetAName()
{
    Document document = sample();
    document = removeSections(document, std::vector{document.sections[1]->id}).value();
    for (int i = 0; i < 3; ++i) {
        NewSection section;
        section.shape = disc();
        document = addSection(document, section).value();
    }
    std::vector<std::string> names;
    for (const SectionPointer &s : document.sections) {
        QVERIFY(std::find(names.begin(), names.end(), s->name) == names.end());
        names.push_back(s->name);
    }
}

// Wrong: everything would be computed and drawn again at every edit.
void TestEdits::othersKeepTheirObjects()
{
    const Document before = sample();
    const SectionId id = before.sections[1]->id;
    const Frame moved = *makeFrame({1, 2, 3}, {0, 1, 0}, {0, 0, 1});
    const Document after = moveSection(before, id, moved).value();
    QCOMPARE(after.sections[0].get(), before.sections[0].get());
    QCOMPARE(after.sections[2].get(), before.sections[2].get());
    QVERIFY(after.sections[1] != before.sections[1]);
    QCOMPARE(after.sections[1]->shape.get(), before.sections[1]->shape.get());
    QVERIFY(after.find(id)->frame == moved);
    QVERIFY(!(before.find(id)->frame == moved));
}

// Wrong: undo would get steps that do nothing.
void TestEdits::editsThatChangeNothingReturnTheSame()
{
    const Document d = sample();
    const Section &s = *d.sections[0];
    QVERIFY(moveSection(d, s.id, s.frame)->isSame(d));
    QVERIFY(setShape(d, s.id, s.shape)->isSame(d));
    QVERIFY(renameSection(d, s.id, s.name)->isSame(d));
    QVERIFY(setSectionStock(d, s.id, s.stock)->isSame(d));
    QVERIFY(setStock(d, *d.stocks[0])->isSame(d));
    QVERIFY(setCurrentStock(d, d.currentStock)->isSame(d));
    QVERIFY(removeSections(d, {})->isSame(d));
}

// Wrong: a stale selection would crash the program.
void TestEdits::unknownReferencesAreRefused()
{
    const Document d = sample();
    const SectionId none{999};
    QVERIFY(isUnknown(moveSection(d, none, {})));
    QVERIFY(isUnknown(setShape(d, none, disc())));
    QVERIFY(isUnknown(renameSection(d, none, "x")));
    QVERIFY(isUnknown(setSectionStock(d, none, d.currentStock)));
    QVERIFY(isUnknown(setSectionStock(d, d.sections[0]->id, StockId{999})));
    QVERIFY(isUnknown(setCurrentStock(d, StockId{999})));
    QVERIFY(isUnknown(removeSections(d, std::vector{none})));
    QVERIFY(isUnknown(removeLoad(d, LoadId{999})));
    NewSection section;
    section.shape = disc();
    section.stock = StockId{999};
    QVERIFY(isUnknown(addSection(d, section)));
}

// Wrong: half an edit would stay.
void TestEdits::failedEditLeavesTheDocument()
{
    const Document d = sample(), copy = d;
    QVERIFY(!removeSections(d, std::vector{d.sections[0]->id, SectionId{999}}));
    QVERIFY(!addSection(d, NewSection{}));
    QVERIFY(d.isSame(copy));
}

// Wrong: a weight would hang in the air, without a section.
void TestEdits::removingASectionTakesItsWeights()
{
    const Document d = sample();
    const Document after = removeSections(d, std::vector{d.sections[1]->id}).value();
    QCOMPARE(after.sections.size(), 2U);
    QCOMPARE(after.loads.size(), 2U);
    for (const Load &w : after.loads)
        QVERIFY(after.find(w.section.drawn));
    QCOMPARE(removeLoad(after, after.loads[0].id)->loads.size(), 1U);
}

// Wrong: deleting one section would delete what was drawn on it, or leave it with a dead parent.
void TestEdits::childrenOfARemovedSectionStay()
{
    const Document d = sample();
    QVERIFY(d.sections[2]->parent);
    const Document after = removeSections(d, std::vector{d.sections[0]->id}).value();
    QCOMPARE(after.sections.size(), 2U);
    QVERIFY(!after.sections[1]->parent);
    QCOMPARE(after.sections[0].get(), d.sections[1].get());
}

void TestEdits::stocksAreChecked_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("good");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QTest::newRow("no thickness") << "thickness" << 0.0 << false;
    QTest::newRow("thickness not a number") << "thickness" << nan << false;
    QTest::newRow("thick") << "thickness" << 18.0 << true;
    QTest::newRow("negative density") << "density" << -1.0 << false;
    QTest::newRow("negative kerf") << "kerf" << -0.1 << false;
    QTest::newRow("scissors have no kerf") << "kerf" << 0.0 << true;
    QTest::newRow("a press fit") << "clearance" << -0.05 << true;
    QTest::newRow("no strength") << "tensileStrength" << 0.0 << false;
}

// Wrong: slits of width 0 or nan.
void TestEdits::stocksAreChecked()
{
    QFETCH(QString, field);
    QFETCH(double, value);
    QFETCH(bool, good);
    const Document d = sample();
    Stock stock = *d.stocks[0];
    if (field == QStringLiteral("thickness"))
        stock.thickness = value;
    else if (field == QStringLiteral("density"))
        stock.density = value;
    else if (field == QStringLiteral("kerf"))
        stock.kerf = value;
    else if (field == QStringLiteral("clearance"))
        stock.clearance = value;
    else
        stock.tensileStrength = value;
    const auto changed = setStock(d, stock), added = addStock(d, stock);
    QCOMPARE(changed.has_value(), good);
    QCOMPARE(added.has_value(), good);
    if (good) {
        QVERIFY(*changed->stocks[0] == stock);
        QVERIFY(added->currentStock == added->stocks[1]->id);
        QVERIFY(added->stocks[1]->id != stock.id);
    } else {
        QCOMPARE(QString::fromStdString(changed.error().place), field);
    }
}

// Wrong: a section whose stock is not there any more.
void TestEdits::removedStocksAreReplaced()
{
    Document document = sample();
    const StockId first = document.currentStock;
    Stock other = *document.stocks[0];
    other.name = "MDF";
    document = addStock(document, other).value();
    const StockId second = document.currentStock;
    document = setSectionStock(document, document.sections[1]->id, second).value();

    const Document after = removeStock(document, second, first).value();
    QCOMPARE(after.stocks.size(), std::size_t(1));
    QVERIFY(after.currentStock == first);
    QVERIFY(after.sections[1]->stock == first);
    QVERIFY(after.sections[0] == document.sections[0]); // was of the other stock
    QVERIFY(!removeStock(document, second, second));
    QVERIFY(isUnknown(removeStock(document, second, StockId{999})));
    QVERIFY(isUnknown(removeStock(document, StockId{999}, first)));
}

// Wrong: a weight of nothing, or on nothing.
void TestEdits::weightsAreChecked()
{
    const Document d = sample();
    Load weight = d.loads[0];
    weight.mass = 0.0;
    QVERIFY(!addLoad(d, weight));
    weight.mass = 0.1;
    weight.section = SectionId{999};
    QVERIFY(isUnknown(addLoad(d, weight)));
    // On a section that an operation makes, which may not be there just now.
    weight.section = SectionRef(OperationId{5}, "3");
    QVERIFY(addLoad(d, weight));
}

FFF_TEST(TestEdits)
#include "tst_edits.moc"
