// The sentences of errors and warnings. If this fails, a person reads gaps or nothing.
#include "core/io/error_text.h"
#include "tests/test_program.h"

#include <QtTest/QtTest>
#include <set>

using namespace fff;

class TestErrorText : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sentences_data();
    void sentences();
    void everyErrorHasASentence();
    void everyWarningHasASentence();
    void argsAreNotMarkers();
};

void TestErrorText::sentences_data()
{
    QTest::addColumn<Error>("error");
    QTest::addColumn<QString>("text");
    const auto row = [](const char *name, Error error, const char *text) {
        QTest::newRow(name) << std::move(error) << QString::fromUtf8(text);
    };
    using enum ErrorCode;
    row("as in the contract", {NonFinite, "fish.txt:340", {"nan"}},
        "fish.txt:340: found \"nan\", expected a finite number");
    row("bad value", {BadValue, "a.fff:$.sections[3].name", {"7", "a text"}},
        "a.fff:$.sections[3].name: found \"7\", expected a text");
    row("missing value", {BadValue, "a.fff:$.nextId", {"", "a whole number"}},
        "a.fff:$.nextId: found nothing, expected a whole number");
    row("value without a word", {BadValue, "thickness", {}},
        "thickness: this value is not allowed here");
    row("no place", {NothingToExport, "", {}},
        "there is no section yet, so there is nothing to cut");
    row("slits leave nothing", {NothingToExport, "a.fff", {"Rib"}},
        "a.fff: slits leave nothing of any section, so there is nothing to cut");
    row("no skin", {NoSkin, "a.fff", {}},
        "a.fff: no contours cross each other at their edges, so there is no skin");
    row("no skin over what is open", {NoSkin, "a.fff", {"2"}},
        "a.fff: none of the places between its contours can be covered (2), so there is no skin");
    row("system's reason", {CannotWrite, "/a/b.fff", {"No space left on device"}},
        "/a/b.fff: could not be written: No space left on device");
    row("newer version", {NewerVersion, "a.fff:$.version", {"7", "5"}},
        "a.fff:$.version: made by a newer FlatFitFab: found format 7, expected at most 5");
    row("count", {BadCount, "a.txt:2", {"2000000000", "100000"}},
        "a.txt:2: found a count of 2000000000, expected at most 100000");
    row("count of something", {BadCount, "a.txt", {"9", "8", "bytes"}},
        "a.txt: found 9 bytes, expected at most 8 bytes");
    row("a section that is not cut out", {NotCutOut, "fish.fff", {"Rib 3"}},
        "fish.fff: \"Rib 3\" could not be cut out: what its slits leave of it could not be worked "
        "out");
    row("a key that is there twice",
        {BadSyntax, "a.fff:82", {"sections", "each key of an object only once"}},
        "a.fff:82: found \"sections\", expected each key of an object only once");
    row("no model", {NotAModel, "a.png", {}},
        "a.png: not a model, expected a .fff file or a .txt file of FlatFab");
    row("an entry of an archive", {BadArchive, "a.fff:blobs/x", {"this entry is damaged"}},
        "a.fff:blobs/x: this entry is damaged");
    row("umlauts", {UnknownCommand, "Tür", {"öffnen"}}, "Tür: there is no command \"öffnen\"");
}

void TestErrorText::sentences()
{
    QFETCH(Error, error);
    QFETCH(QString, text);
    QCOMPARE(io::errorText(error), text);
}

/// With any number of args, and different for every code.
void TestErrorText::everyErrorHasASentence()
{
    const int last = static_cast<int>(ErrorCode::BadArchive);
    for (const int count : {0, 1, 2, 3}) {
        std::set<QString> sentences;
        for (int code = 0; code <= last; ++code) {
            const Error error{static_cast<ErrorCode>(code),
                              {},
                              std::vector<std::string>(static_cast<std::size_t>(count), "word")};
            const QString sentence = io::errorSentence(error);
            QVERIFY2(!sentence.isEmpty(), qPrintable(QString::number(code)));
            QVERIFY2(!sentence.contains(QLatin1Char('%')), qPrintable(sentence));
            sentences.insert(sentence);
        }
        QVERIFY(static_cast<int>(sentences.size()) >= last - 2); // bad syntax, value, event agree
    }
}

void TestErrorText::everyWarningHasASentence()
{
    std::set<QString> sentences;
    const int last = static_cast<int>(WarningCode::LostBinding);
    for (int code = 0; code <= last; ++code) {
        for (const std::vector<std::string> &args :
             {std::vector<std::string>{}, {"Section 3"}, {"Section 3", "0.5"}}) {
            const QString text = io::warningText({static_cast<WarningCode>(code), "a.txt:3", args});
            QVERIFY2(text.size() > 20 && !text.contains(QLatin1Char('%')), qPrintable(text));
            QVERIFY(text.startsWith(QStringLiteral("a.txt:3: ")));
            sentences.insert(text);
        }
    }
    QVERIFY(static_cast<int>(sentences.size()) > last);
}

/// Text from a file may look like a place for an argument.
void TestErrorText::argsAreNotMarkers()
{
    QCOMPARE(io::errorText({ErrorCode::BadSyntax, "%1%2.txt:1", {"%2", "%1"}}),
             QStringLiteral("%1%2.txt:1: found \"%2\", expected %1"));
}

FFF_TEST(TestErrorText)
#include "tst_error_text.moc"
