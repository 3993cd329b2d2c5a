// Keys of menus in languages whose texts mark none.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "ui/actions/menu_keys.h"

#include <QRandomGenerator>
#include <QSet>

using namespace fff::ui;

namespace {

QStringList list(const char16_t *texts)
{
    return QString::fromUtf16(texts).split(u'|', Qt::SkipEmptyParts);
}

} // namespace

class TestMenuKeys : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreChosen_data();
    void theyAreChosen();
    void noTwoAreTheSame();
};

void TestMenuKeys::theyAreChosen_data()
{
    QTest::addColumn<QStringList>("texts");
    QTest::addColumn<QStringList>("sources");
    QTest::addColumn<QStringList>("marked");
    QTest::newRow("as in English")
        << list(u"Copier|Coller") << list(u"&Copy|&Paste") << list(u"&Copier|C&oller");
    QTest::newRow("the translator's own")
        << list(u"Ouvrir|O&ter") << list(u"&Open|&Take") << list(u"&Ouvrir|O&ter");
    QTest::newRow("a word's first")
        << list(u"Tout voir|Voir") << list(u"&Fit|Look") << list(u"&Tout voir|&Voir");
    QTest::newRow("Japanese") << list(u"ファイル|開く…|SVGを書く")
                              << list(u"&File|&Open…|&Write SVG")
                              << list(u"ファイル(&F)|開く(&O)…|SVGを書く(&W)");
    QTest::newRow("who has no other choice")
        << list(u"Esc|Se|E") << list(u"&X|&Y|&Z") << list(u"Es&c|&Se|&E");
    QTest::newRow("no letter is left") << list(u"a|A") << list(u"x|y") << list(u"&a|A");
    QTest::newRow("a real ampersand")
        << list(u"Schnitt && Co") << list(u"&Cut && Co") << list(u"Schnitt && &Co");
    QTest::newRow("empty") << list(u"") << list(u"") << list(u"");
}

void TestMenuKeys::theyAreChosen()
{
    QFETCH(QStringList, texts);
    QFETCH(QStringList, sources);
    QFETCH(QStringList, marked);
    QCOMPARE(withMenuKeys(texts, sources), marked);
}

// Wrong: a key that opens neither of two entries.
void TestMenuKeys::noTwoAreTheSame()
{
    QRandomGenerator random(7);
    const QString letters = QStringLiteral("abcdeé łAB 開…&");
    for (int round = 0; round < 2000; ++round) {
        QStringList texts, sources;
        for (int i = random.bounded(14); i >= 0; --i) {
            QString text, source = QStringLiteral("&x");
            for (int k = random.bounded(1, 9); k > 0; --k)
                text += letters[random.bounded(letters.size() - 1)];
            source[1] = QChar(u'a' + random.bounded(26));
            texts += text;
            sources += source;
        }
        const QStringList marked = withMenuKeys(texts, sources);
        QCOMPARE(marked.size(), texts.size());
        QSet<QChar> keys;
        for (qsizetype i = 0; i < marked.size(); ++i) {
            const qsizetype at = marked[i].indexOf(u'&');
            if (at >= 0) {
                const QChar key = marked[i][at + 1].toLower();
                QVERIFY2(!keys.contains(key), qPrintable(marked.join(u'|')));
                keys.insert(key);
            }
            QString plain = marked[i];
            plain.remove(u'&');
            QVERIFY(plain.startsWith(texts[i].section(u'…', 0, 0)));
        }
    }
}

FFF_TEST(TestMenuKeys)
#include "tst_menu_keys.moc"
