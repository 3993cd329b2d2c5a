// Which sections a value moves, against what another value of it changes.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/operation_edits.h"
#include "core/operations/value_dependents.h"
#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <algorithm>

using namespace fff;
using namespace fff::test;

namespace {

std::vector<SectionRef> dependentsOf(const Document &document, const char *name)
{
    return dependents(evaluate(document), idOf(document, name));
}

/// Sections that are other ones, or gone, or new.
std::vector<SectionRef> changedBy(const Document &document, const char *name, const char *text)
{
    const Model before = evaluate(document), after = evaluate(typed(document, name, text));
    std::vector<SectionRef> changed;
    for (const SectionPointer &section : before.sections()) {
        const Section *now = after.find(section->ref());
        if (!now || !(now->frame == section->frame) || !(*now->shape == *section->shape) ||
            after.document.stockOf(*now).thickness != before.document.stockOf(*section).thickness)
            changed.push_back(section->ref());
    }
    return changed;
}

} // namespace

class TestValueDependents : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatChangesIsAmongThem_data();
    void whatChangesIsAmongThem();
    void ofOneThatNothingIsMadeOfThereAreNone();
    void alsoThroughOtherValues();
    void eachOnce();
};

void TestValueDependents::whatChangesIsAmongThem_data()
{
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("expression");
    const Document document = shelf();
    const std::int64_t board = document.sections[0]->id.value, rib = document.sections[1]->id.value;
    QTest::newRow("stock") << QString::fromStdString(stockKey(document, "thickness"))
                           << QStringLiteral("v/10");
    QTest::newRow("size") << QString::fromStdString(key("section", board, "width"))
                          << QStringLiteral("6*v");
    QTest::newRow("place") << QString::fromStdString(key("section", rib, "y"))
                           << QStringLiteral("v - 28 mm");
    QTest::newRow("hole") << QStringLiteral("figure/%1/1/diameter").arg(board)
                          << QStringLiteral("v/2");
}

// Wrong: what moves while a slider does is not lit.
void TestValueDependents::whatChangesIsAmongThem()
{
    QFETCH(QString, place);
    QFETCH(QString, expression);
    const Document plain = withValue(shelf(), "v", "30 mm");
    const auto document = bound(plain, at(plain, place.toStdString()), expression.toStdString());
    QVERIFY2(document, qPrintable(place));
    const std::vector<SectionRef> lit = dependentsOf(*document, "v");
    const std::vector<SectionRef> changed = changedBy(*document, "v", "31 mm");
    QVERIFY(!changed.empty());
    QVERIFY(std::is_sorted(lit.begin(), lit.end()));
    QVERIFY(std::includes(lit.begin(), lit.end(), changed.begin(), changed.end()));
}

void TestValueDependents::ofOneThatNothingIsMadeOfThereAreNone()
{
    Document document = withValue(withValue(shelf(), "v", "30 mm"), "w", "2*v");
    document = madeOf(document, stockKey(document, "thickness"), "v/10");
    QVERIFY(dependentsOf(document, "w").empty());
    QVERIFY(dependents(evaluate(document), ValueId{1000000}).empty());
}

void TestValueDependents::alsoThroughOtherValues()
{
    Document document = withValue(withValue(shelf(), "v", "30 mm"), "w", "v/10");
    document = madeOf(document, stockKey(document, "thickness"), "w");
    QCOMPARE(dependentsOf(document, "v").size(), document.sections.size());
}

void TestValueDependents::eachOnce()
{
    Document document = withValue(shelf(), "v", "30 mm");
    document = madeOf(document, stockKey(document, "thickness"), "v/10");
    document = madeOf(document, key("section", document.sections[0]->id.value, "width"), "6*v");
    const std::vector<SectionRef> lit = dependentsOf(document, "v");
    QVERIFY(std::adjacent_find(lit.begin(), lit.end()) == lit.end());
}

FFF_TEST(TestValueDependents)
#include "tst_value_dependents.moc"
