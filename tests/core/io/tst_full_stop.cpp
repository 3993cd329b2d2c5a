// Where sentences end, whatever they are written in.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/io/full_stop.h"
#include "tests/test_program.h"

using namespace fff;

class TestFullStop : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void firstSentences_data();
    void firstSentences();
    void itIsTakenOff();
};

void TestFullStop::firstSentences_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("rest");
    const auto row = [](const char *name, const char16_t *text, const char16_t *first,
                        const char16_t *rest) {
        QTest::newRow(name) << QString::fromUtf16(text) << QString::fromUtf16(first)
                            << QString::fromUtf16(rest);
    };
    row("two", u"Falls over. Put a foot there.", u"Falls over", u"Put a foot there.");
    row("numbers", u"Tips past 3.5 mm. Margin 2 mm.", u"Tips past 3.5 mm", u"Margin 2 mm.");
    row("one", u"Stands.", u"Stands.", u"");
    row("none", u"", u"", u"");
    // Wrong: the verdict stood there twice.
    row("Japanese", u"倒れます。足を付けてください。", u"倒れます", u"足を付けてください。");
    row("Japanese, one", u"倒れます。", u"倒れます。", u"");
}

void TestFullStop::firstSentences()
{
    QFETCH(QString, text);
    const FirstSentence split = firstSentence(text);
    QTEST(split.first, "first");
    QTEST(split.rest, "rest");
}

void TestFullStop::itIsTakenOff()
{
    QCOMPARE(withoutFullStop(QStringLiteral("Stands.")), QStringLiteral("Stands"));
    QCOMPARE(withoutFullStop(QStringLiteral("立つ。")), QStringLiteral("立つ"));
    QCOMPARE(withoutFullStop(QString()), QString());
    QCOMPARE(withFullStop(QStringLiteral("Stands")), QStringLiteral("Stands."));
}

FFF_TEST(TestFullStop)
#include "tst_full_stop.moc"
