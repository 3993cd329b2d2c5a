// Numbers with names: what they are worth, and what is made of them.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/model/named_numbers.h"
#include "tests/test_program.h"

using namespace fff;

class TestNamedNumbers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thoseMadeOfAnotherOneFollow();
    void whatCannotBeReadChangesNothing();
    void onlyThoseBeforeAreKnown();
    void aNameThatIsKnownKeepsItsLetters();

private:
    static Document with(Document document, const char *name, const char *expression)
    {
        auto next = setExpression(std::move(document), name, expression, Commas::Groups);
        return next ? *std::move(next) : Document();
    }
};

void TestNamedNumbers::thoseMadeOfAnotherOneFollow()
{
    Document document = with({}, "gap", "12 mm");
    document = with(std::move(document), "ribs", "5");
    document = with(std::move(document), "length", "ribs*gap");
    QCOMPARE(document.numbers.size(), std::size_t(3));
    QCOMPARE(document.numbers[2].value, 60.0);
    document = with(std::move(document), "gap", "2 cm");
    QCOMPARE(document.numbers[0].value, 20.0);
    QCOMPARE(document.numbers[0].expression, std::string("2 cm"));
    QCOMPARE(document.numbers[2].value, 100.0);
    QVERIFY(namesBefore(document, 3)("LENGTH")->isLength);
    QVERIFY(!namesBefore(document, 3)("ribs")->isLength);
}

void TestNamedNumbers::whatCannotBeReadChangesNothing()
{
    const Document document = with({}, "gap", "12 mm");
    const auto refused = setExpression(document, "gap", "12 kg", Commas::Groups);
    QVERIFY(!refused);
    QVERIFY(refused.error().fault == Expression::Fault::Unreadable);
    QCOMPARE(refused.error().piece, std::string("kg"));
}

// Wrong: a number that is made of itself, or of one that is made of it.
void TestNamedNumbers::onlyThoseBeforeAreKnown()
{
    const Document document = with(with({}, "a", "1"), "b", "2*a");
    for (const char *expression : {"b", "a + 1"}) {
        const auto refused = setExpression(document, "a", expression, Commas::Groups);
        QVERIFY(!refused);
        QVERIFY(refused.error().fault == Expression::Fault::UnknownName);
    }
    QVERIFY(namesBefore(document, 1)("a") && !namesBefore(document, 1)("b"));
}

void TestNamedNumbers::aNameThatIsKnownKeepsItsLetters()
{
    const Document document = with(with({}, "Gap", "1"), "gAP", "3");
    QCOMPARE(document.numbers.size(), std::size_t(1));
    QCOMPARE(document.numbers[0].name, std::string("Gap"));
    QCOMPARE(document.numbers[0].value, 3.0);
}

FFF_TEST(TestNamedNumbers)
#include "tst_named_numbers.moc"
