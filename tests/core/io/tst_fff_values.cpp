// Values with names, and what was typed for numbers, in files.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/fff_format.h"
#include "core/values/presets.h"
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
    void presets();
    void whatOpensForAdjusting();
    void whatIsLostIsSaid();
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

void TestFffValues::presets()
{
    Document document = withValue(withValue(shelf(), "w", "3 mm"), "n", "3", ValueKind::Count);
    for (const char *name : {"w", "n"}) {
        Value value = *document.values.find(std::string_view(name));
        value.isShown = true;
        value.group = "Size, and \"more\"";
        value.reading.commas = Commas::Decimals;
        document = changeValue(std::move(document), value).value();
    }
    document.values = withPreset(document.values, takenPreset(document.values, "A5"));
    document.values = withPreset(document.values, takenPreset(document.values, "four \"shelves\""));
    const std::string text = io::writeFff(document).value();
    const auto read = io::readFff(text);
    QVERIFY(read && read->document == document);
    QCOMPARE(io::writeFff(read->document).value(), text);
    const std::string w = std::to_string(idOf(document, "w").value);
    const std::string n = std::to_string(idOf(document, "n").value);
    for (const auto &[from, to] : {std::pair<std::string, std::string>{"\"A5\"", "\"a=5\""},
                                   {"\"A5\"", "\"FOUR \\\"shelves\\\"\""},
                                   {"{\"value\": " + n, "{\"value\": " + w},
                                   {"{\"value\": " + n, "{\"value\": 0"},
                                   {"\"settings\"", "\"set\""}}) {
        std::string wrong = text;
        QVERIFY2(wrong.find(from) != wrong.npos, from.c_str());
        wrong.replace(wrong.find(from), from.size(), to);
        const auto failed = io::readFff(wrong);
        QVERIFY2(!failed && failed.error().place.find("presets") != std::string::npos, to.c_str());
    }
    // Of a value that is none here, a setting is nothing.
    std::string other = text;
    for (std::size_t at; (at = other.find("{\"value\": " + w)) != other.npos;)
        other.replace(at, 10 + w.size(),
                      "{\"value\": " + std::to_string(document.sections[0]->id.value));
    const auto lacking = io::readFff(other);
    QVERIFY(lacking && lacking->document.values.presets[0]->settings.size() == 1);
}

// Wrong: what was handed on opens as what it was made in.
// Wrong: half of a model followed its values no more, and nobody heard of it.
void TestFffValues::whatIsLostIsSaid()
{
    Document document = withValue(shelf(), "w", "200 mm");
    const std::string place = key("section", document.sections[0]->id.value, "width");
    document = madeOf(document, place, "w");
    const std::string text = io::writeFff(document).value();
    QVERIFY(io::readFff(text)->warnings.empty());
    const auto changed = [&text](const std::string &from, const std::string &to) {
        std::string wrong = text;
        const std::size_t at = wrong.find(from, wrong.find("\"bindings\""));
        if (at != wrong.npos)
            wrong.replace(at, from.size(), to);
        return io::readFff(wrong);
    };
    for (const auto &[from, to] :
         {std::pair("\"width\"", "\"widht\""), std::pair("\"section\"", "\"sextion\""),
          std::pair("\"result\": 200", "\"result\": 77")}) {
        const auto loaded = changed(from, to);
        QVERIFY2(loaded, from);
        QCOMPARE(loaded->warnings.size(), std::size_t(1));
        QCOMPARE(loaded->warnings.front().code, WarningCode::LostBinding);
        QCOMPARE(loaded->warnings.front().args.front(), std::string("w"));
    }
}

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
