#include <QTest>

#include "core/model/changes.h"
#include "core/model/edits.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <functional>

using namespace fff;
using namespace fff::test;

namespace {

/// Sections 1, 2 and 3 of one stock, 4 of another.
Document sample()
{
    Document document = newDocument();
    const StockId first = document.currentStock;
    NewSection section;
    section.shape = Shape::make(circle({0, 0}, 20.0)).value();
    for (int i = 0; i < 3; ++i)
        document = addSection(document, section).value();
    document = addStock(document, flatfabAcrylic()).value();
    document = addSection(document, section).value();
    return setCurrentStock(document, first).value();
}

using Edit = std::function<Document(const Document &)>;

} // namespace

class TestChanges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyWhatAnEditTouchedIsNamed_data()
    {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<QList<int>>("touched"); // places in the document after the edit
        const auto id = [](const Document &d, std::size_t i) { return d.sections[i]->id; };
        QTest::newRow("nothing") << Edit([](const Document &d) { return d; }) << QList<int>{};
        QTest::newRow("one is added") << Edit([](const Document &d) {
            NewSection section;
            section.shape = d.sections[0]->shape;
            return addSection(d, section).value();
        }) << QList<int>{4};
        QTest::newRow("one is moved") << Edit([id](const Document &d) {
            Frame frame;
            frame.origin = {0, 0, 30};
            return moveSection(d, id(d, 1), frame).value();
        }) << QList<int>{1};
        QTest::newRow("one is removed: the rest is as it was") << Edit([id](const Document &d) {
            return removeSections(d, std::vector{id(d, 1)}).value();
        }) << QList<int>{};
        QTest::newRow("one goes, another changes") << Edit([id](const Document &d) {
            const Document less = removeSections(d, std::vector{id(d, 0)}).value();
            return renameSection(less, less.sections[2]->id, "Fin").value();
        }) << QList<int>{2};
        QTest::newRow("a stock gets thicker: all of it") << Edit([](const Document &d) {
            Stock stock = *d.stocks.front();
            stock.thickness = 6.0;
            return setStock(d, stock).value();
        }) << QList<int>{0, 1, 2};
        QTest::newRow("the stock of one") << Edit([id](const Document &d) {
            return setSectionStock(d, id(d, 0), d.stocks.back()->id).value();
        }) << QList<int>{0};
    }

    /// Hovering a step would outline sections that it left alone, or miss those it changed.
    void onlyWhatAnEditTouchedIsNamed()
    {
        QFETCH(Edit, edit);
        QFETCH(QList<int>, touched);
        const Document before = sample(), after = edit(before);
        std::vector<SectionRef> expected;
        for (int i : touched)
            expected.push_back(after.sections[static_cast<std::size_t>(i)]->id);
        const std::vector<SectionRef> found = changedSections({before, {}}, {after, {}});
        QVERIFY2(found == expected, qPrintable(QString::number(found.size())));
    }

    /// What an operation made anew would not be seen.
    void generatedSectionsAreNamedByTheirOperation()
    {
        const Document document = sample();
        const SectionRef made(OperationId{7}, "1");
        const auto generated = [&](const char *key, std::size_t like) {
            Section section = *document.sections[like];
            section.id = {};
            section.made = SectionRef(OperationId{7}, key);
            return std::make_shared<const Section>(section);
        };
        auto listing = std::make_shared<Listing>();
        listing->sections = document.sections;
        listing->drawn = listing->sections.size();
        listing->sections.push_back(generated("0", 0));
        const auto withListing = [&](const std::shared_ptr<Listing> &of) {
            Evaluation evaluation;
            evaluation.listing = of;
            return Model{document, evaluation};
        };
        const Model before = withListing(listing);
        listing = std::make_shared<Listing>(*listing);
        listing->sections.push_back(generated("1", 1));
        const Model after = withListing(listing);
        QVERIFY(changedSections(before, after) == std::vector{made});
        QVERIFY(changedSections(after, before).empty());
    }
};

FFF_TEST(TestChanges)
#include "tst_changes.moc"
