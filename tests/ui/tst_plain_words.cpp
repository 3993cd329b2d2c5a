// What the program says, it says as a maker would, and with one word for a thing. If this fails,
// words come back that people did not understand.
#include <QCoreApplication>
#include <QTest>

#include "tests/test_program.h"
#include "tests/ui/translated_texts.h"

#include <QDir>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>

using namespace fff::test;

namespace {

QString withoutMarkup(QString text)
{
    static const QRegularExpression tag(QStringLiteral("</?[a-z]+>"));
    static const QRegularExpression key(QStringLiteral("&(?=\\w)"));
    return text.remove(tag).remove(key);
}

} // namespace

class TestPlainWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void oldWordsAreGone_data();
    void oldWordsAreGone();
    void helpUsesTheSameWords();
    void textsAreTypeset_data();
    void textsAreTypeset();
    void labelsAreInSentenceCase();

private:
    std::vector<TranslatedText> m_texts;
};

void TestPlainWords::initTestCase()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("texts.ts"));
    const QString failure = bringTexts(path);
    QVERIFY2(failure.isEmpty(), qPrintable(failure));
    m_texts = textsOf(path);
    QVERIFY2(m_texts.size() > 1500, "texts are missing: lupdate did not find the sources");
}

void TestPlainWords::oldWordsAreGone_data()
{
    QTest::addColumn<QString>("pattern");
    const auto row = [](const char *pattern) {
        QTest::newRow(pattern) << QString::fromUtf8(pattern);
    };
    // What somebody read and did not understand.
    row("\\bstays? between\\b");
    row("^Thin web");
    row("^Shallow angle");
    row("\\btouch(es)? nothing\\b");
    row("[Cc]ut into each other|^In each other");
    row("slide in different directions\\.");
    row("but not firmly");
    row("beside (its|the) feet");
    row("[Tt]urn(ed)? (its |the )?(slits )?round$|turned round\\b");
    row("^First section too");
    row("^Flat at ground");
    row("^Turn (to|time)$");
    row("^In space$|^With (what|all) (is )?on it$");
    row("^Numbers$");
    row("^Apart$");
    row("^Mouse as in");
    row("^Warn of ");
    row("^Lengths in$");
    row("[Dd]rag again");
    row("[Tt]here is only one (section|part)");
    row("\\bset words\\b");
    row("next start on");
    row("\\blays? (the|it) ");
    row("axes of .* (right angles|length 1)");
    row("\\bshall\\b");
    row("\\banew\\b");
    row("looks from there");
    row("\\bmend(s|ed)?\\b");
    row("gives? up\\b");
    row("\\bhangs? on\\b|hang together");
    row("keep to points");
    row("[Tt]ake this dimension away");
    row("was drawn on\\b.*[Tt]ake|^Take it off");
    row("the image of the other");
    row("only %\\d stays?\\b");
    row("comes? off in a straight");
    row("back to itself");
    row("[Tt]hrow away|wastebasket");
    row("^Nothing is called");
    row("^(Linear|Grid|Radial|Revolve|Blend|Branch|Array) %1$");
    // One word for a thing.
    row("\\b(bears?|borne)\\b"); // holds, carries
    row("\\bcollides?\\b");      // overlaps
    row("\\bactions?\\b");       // commands
}

void TestPlainWords::oldWordsAreGone()
{
    QFETCH(QString, pattern);
    const QRegularExpression old(pattern);
    QVERIFY2(old.isValid(), qPrintable(old.errorString()));
    QStringList found;
    for (const TranslatedText &text : m_texts)
        if (old.match(withoutMarkup(text.source)).hasMatch())
            found += text.context + QStringLiteral(": ") + text.source;
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

/// What a page tells to click is called so in the window.
void TestPlainWords::helpUsesTheSameWords()
{
    QSet<QString> known;
    for (const TranslatedText &text : m_texts)
        known += withoutMarkup(text.source);
    const QDir folder(kSources + QStringLiteral("/resources/help"));
    int count = 0;
    for (const QString &name : folder.entryList({QStringLiteral("*.md")})) {
        QFile page(folder.filePath(name));
        QVERIFY(page.open(QIODevice::ReadOnly));
        static const QRegularExpression code(QStringLiteral("`[^`]*`"));
        const QString text = QString::fromUtf8(page.readAll()).simplified().remove(code);
        static const QRegularExpression named(QStringLiteral("(?<!\\*)\\*([^*]+)\\*(?!\\*)"));
        for (auto it = named.globalMatch(text); it.hasNext();) {
            const QString path = it.next().captured(1);
            for (const QString &word : path.split(QStringLiteral(" › "))) {
                QVERIFY2(known.contains(word), qPrintable(name + QStringLiteral(": ") + word));
                ++count;
            }
        }
    }
    QVERIFY(count > 20);
}

void TestPlainWords::textsAreTypeset_data()
{
    QTest::addColumn<QString>("pattern");
    QTest::newRow("three dots for an ellipsis") << QStringLiteral("\\.\\.\\.");
    QTest::newRow("a comma before too") << QStringLiteral(", too\\b");
    QTest::newRow("a blank before a full stop") << QStringLiteral("\\w [.,;:!?](\\s|$)");
    QTest::newRow("a blank at an end") << QStringLiteral("^\\s\\w|\\w\\s$");
    QTest::newRow("an article before a name") << QStringLiteral("\\b[Tt]he %1 (is|has|meets)\\b");
}

void TestPlainWords::textsAreTypeset()
{
    QFETCH(QString, pattern);
    const QRegularExpression bad(pattern);
    QStringList found;
    for (const TranslatedText &text : m_texts)
        if (bad.match(text.source).hasMatch())
            found += text.context + QStringLiteral(": ") + text.source;
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

/// "Move to trash", not "Move To Trash".
void TestPlainWords::labelsAreInSentenceCase()
{
    static const QRegularExpression label(QStringLiteral("^([A-Z][a-z]+ )([A-Z][a-z]+)$"));
    QStringList found;
    for (const TranslatedText &text : m_texts)
        if (const auto match = label.match(withoutMarkup(text.source)); match.hasMatch())
            found += text.context + QStringLiteral(": ") + text.source;
    QVERIFY2(found.isEmpty(), qPrintable(found.join(u'\n')));
}

FFF_TEST(TestPlainWords)
#include "tst_plain_words.moc"
