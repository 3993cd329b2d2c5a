// Values with names, and what was typed for numbers, in files.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/fff_format.h"
#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <string>
#include <utility>

using namespace fff;
using namespace fff::test;

class TestFffValues : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void files();
    void whatOpensForAdjusting();
};

void TestFffValues::files()
{
    Document document = withValue(withValue(shelf(), "w", "3 mm"), "n", "3", ValueKind::Count);
    Value choice;
    choice.name = "wood";
    choice.kind = ValueKind::Choice;
    choice.typed = "beech";
    choice.choices = {"beech", "birch"};
    choice.range = {1.0, 2.0, 0.5};
    choice.note = "of what it is";
    choice.isShown = true;
    choice.reading.commas = Commas::Decimals;
    choice.reading.lengthUnit = 25.4;
    document = addValue(std::move(document), choice).value();
    const std::int64_t board = document.sections[0]->id.value;
    document = madeOf(document, stockKey(document, "thickness"), "2*w");
    document = madeOf(document, "lettering/" + std::to_string(board) + "/0/text", "{n} \"x\"");
    document = madeOf(document, "figure/" + std::to_string(board) + "/1/diameter", "3*w");
    QCOMPARE(document.bindings.size(), std::size_t(3));
    const std::string text = io::writeFff(document).value();
    const auto read = io::readFff(text);
    QVERIFY(read);
    QVERIFY(read->document == document);
    QCOMPARE(io::writeFff(read->document).value(), text);
    QVERIFY(driven(read->document).document.isSame(read->document));
    // By hand, another number: it is one by itself.
    std::string edited = text;
    const std::size_t at = edited.find("\"thickness\": 6");
    QVERIFY(at != edited.npos);
    edited.replace(at, 14, "\"thickness\": 7");
    const Document other = evaluate(io::readFff(edited).value().document).document;
    QCOMPARE(other.stocks[0]->thickness, 7.0);
    QCOMPARE(other.bindings.size(), std::size_t(2));
    // What is wrong is named.
    for (const auto &[from, to] : {std::pair{"\"name\": \"n\"", "\"name\": \"W\""},
                                   std::pair{"\"kind\": \"count\"", "\"kind\": \"colour\""},
                                   std::pair{"\"commas\": \"decimals\"", "\"commas\": \"none\""}}) {
        std::string wrong = text;
        wrong.replace(wrong.find(from), std::string(from).size(), to);
        const auto failed = io::readFff(wrong);
        QVERIFY2(!failed && failed.error().place.find("values") != std::string::npos, to);
    }
}

// Wrong: what was handed on opens as what it was made in.
void TestFffValues::whatOpensForAdjusting()
{
    Document document = withValue(shelf(), "w", "3 mm");
    QVERIFY(io::writeFff(document).value().find("opensForAdjusting") == std::string::npos);
    const Document before = document;
    document.opensForAdjusting = true;
    QVERIFY(!(document == before));
    QVERIFY(!document.isSame(before));
    QVERIFY(evaluate(document).document.opensForAdjusting);
    const std::string text = io::writeFff(document).value();
    const auto read = io::readFff(text);
    QVERIFY(read && read->document == document);
    std::string wrong = text;
    const std::string member = "\"opensForAdjusting\": true";
    QVERIFY(wrong.find(member) != wrong.npos);
    wrong.replace(wrong.find(member), member.size(), "\"opensForAdjusting\": 3");
    const auto failed = io::readFff(wrong);
    QVERIFY(!failed && failed.error().place.find("opensForAdjusting") != std::string::npos);
}

FFF_TEST(TestFffValues)
#include "tst_fff_values.moc"
