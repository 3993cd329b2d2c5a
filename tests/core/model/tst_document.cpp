#include "core/geometry/contour.h"
#include "core/model/edits.h"
#include "core/model/model.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

Document withDisc(Document document, double radius = 20.0)
{
    NewSection section;
    section.shape = Shape::make(circle({0, 0}, radius)).value();
    return addSection(std::move(document), section).value();
}

} // namespace

class TestDocument : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void newDocumentHasAStock();
    void copiesAreTheSame();
    void equalValuesAreNotTheSameObjects();
    void findByNameOfNothing();
    void sectionsAreFoundInAnyOrder_data();
    void sectionsAreFoundInAnyOrder();
    void modelListsDrawnThenGenerated();
    void referencesAreOrderedAndTold();
    void emptyModelHasNoBounds();
};

void TestDocument::sectionsAreFoundInAnyOrder_data()
{
    QTest::addColumn<QList<qint64>>("ids");
    QTest::newRow("none") << QList<qint64>{};
    QTest::newRow("as drawn") << QList<qint64>{2, 3, 4, 7, 9, 10, 12};
    QTest::newRow("backwards") << QList<qint64>{12, 10, 9, 7, 4, 3, 2};
    QTest::newRow("mixed, as a file may have them") << QList<qint64>{7, 12, 2, 10, 3, 9, 4};
}

// Wrong: a section of a file whose ids do not rise could not be selected, moved or deleted.
void TestDocument::sectionsAreFoundInAnyOrder()
{
    QFETCH(QList<qint64>, ids);
    Model model{newDocument(), {}};
    const SectionPointer disc = withDisc(newDocument()).sections.front();
    for (const qint64 id : ids) {
        Section section = *disc;
        section.id = SectionId{id};
        model.document.sections.push_back(std::make_shared<const Section>(section));
    }
    for (qint64 id = -1; id < 14; ++id) {
        const int index = static_cast<int>(ids.indexOf(id));
        QCOMPARE(model.document.indexOf(SectionId{id}), index);
        QCOMPARE(model.indexOf(SectionRef(SectionId{id})), index);
        QCOMPARE(model.document.find(SectionId{id}) != nullptr, index >= 0);
    }
}

// Wrong: the first stroke would be of no material.
void TestDocument::newDocumentHasAStock()
{
    const Document d = newDocument();
    QCOMPARE(d.stocks.size(), 1U);
    QVERIFY(d.find(d.currentStock));
    QVERIFY(d.nextId > d.currentStock.value);
}

// Wrong: undo would see a change where there was none.
void TestDocument::copiesAreTheSame()
{
    const Document d = withDisc(newDocument());
    const Document copy = d;
    QVERIFY(copy.isSame(d) && copy == d);
    QVERIFY(!withDisc(d).isSame(d));
}

// Wrong: saved-and-read could not be compared with what was saved.
void TestDocument::equalValuesAreNotTheSameObjects()
{
    const Document a = withDisc(newDocument()), b = withDisc(newDocument());
    QVERIFY(a == b);
    QVERIFY(!a.isSame(b));
    QVERIFY(!(a == withDisc(newDocument(), 21.0)));
}

// Wrong: dangling ids would name some section.
void TestDocument::findByNameOfNothing()
{
    const Document d = withDisc(newDocument());
    QVERIFY(!d.find(SectionId{}));
    QVERIFY(!d.find(SectionId{d.nextId}));
    QVERIFY(!d.find(StockId{d.sections[0]->id.value}));
    QCOMPARE(&d.stockOf(*d.sections[0]), d.stocks[0].get());
}

// Wrong: indices of joints and parts would name other sections.
void TestDocument::modelListsDrawnThenGenerated()
{
    Model model{withDisc(withDisc(newDocument())), {}};
    Section made = *model.document.sections[0];
    made.id = {};
    made.made = SectionRef(OperationId{7}, "1");
    const auto replica = std::make_shared<const Section>(made);
    auto listing = std::make_shared<Listing>();
    listing->sections = model.document.sections;
    listing->drawn = 2;
    listing->sections.push_back(replica);
    listing->blocks = {{OperationId{7}, 2, 3}};
    model.evaluation.listing = listing;
    QCOMPARE(model.sectionCount(), 3U);
    QCOMPARE(model.section(2).get(), replica.get());
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(model.indexOf(model.ref(i)), static_cast<int>(i));
    QCOMPARE(model.indexOf(SectionRef(OperationId{7}, "2")), -1);
    QCOMPARE(model.indexOf(SectionId{99}), -1);
}

// Wrong: overrides of generated sections would be lost or mixed up.
void TestDocument::referencesAreOrderedAndTold()
{
    const SectionRef drawn(SectionId{3});
    const SectionRef first(OperationId{3}, "1"), second(OperationId{3}, "2");
    QVERIFY(drawn != first);
    QVERIFY(first < second);
    QVERIFY(first == SectionRef(OperationId{3}, "1"));
}

// Wrong: the camera would fly to nowhere.
void TestDocument::emptyModelHasNoBounds()
{
    const Model empty{newDocument(), {}};
    QVERIFY(empty.bounds().isEmpty());
    const Box3 box = Model{withDisc(newDocument()), {}}.bounds();
    QVERIFY(!box.isEmpty());
    QVERIFY(box.size().z() < 1e-9);
}

FFF_TEST(TestDocument)
#include "tst_document.moc"
