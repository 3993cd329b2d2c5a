// Which languages there are, and which of them somebody gets.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "tests/test_program.h"
#include "ui/settings/languages.h"

#include <QLocale>

using namespace fff::ui;

class TestLanguages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreFound();
    void eachSuitsItsReaders_data();
    void eachSuitsItsReaders();
};

void TestLanguages::theyAreFound()
{
    const QStringList expected = QStringLiteral("de en es fr it nl pl pt_BR ja zh_CN").split(u' ');
    QCOMPARE(languagesThere(), expected);
    QStringList names;
    for (const QString &code : languagesThere())
        names += nameOfLanguage(code);
    const QStringList inThemselves =
        QStringLiteral("Deutsch|English|Español|Français|Italiano|Nederlands|Polski|"
                       "Português (Brasil)|日本語|简体中文")
            .split(u'|');
    QCOMPARE(names, inThemselves);
}

void TestLanguages::eachSuitsItsReaders_data()
{
    QTest::addColumn<QString>("wanted");
    QTest::addColumn<QString>("gets");
    for (const auto &[wanted, gets] :
         {std::pair("de", "de"), std::pair("de_AT", "de"), std::pair("en_GB", "en"),
          std::pair("en_US", "en"), std::pair("fr_CA", "fr"), std::pair("es_MX", "es"),
          std::pair("pt_BR", "pt_BR"), std::pair("pt_PT", "pt_BR"), std::pair("zh_CN", "zh_CN"),
          std::pair("zh_SG", "zh_CN"), std::pair("zh_TW", ""), std::pair("ja_JP", "ja"),
          std::pair("nl_BE", "nl"), std::pair("sv_SE", "")})
        QTest::newRow(wanted) << QString::fromLatin1(wanted) << QString::fromLatin1(gets);
}

void TestLanguages::eachSuitsItsReaders()
{
    QFETCH(QString, wanted);
    QFETCH(QString, gets);
    QCOMPARE(languageFor(QLocale(wanted)), gets);
}

FFF_TEST(TestLanguages)
#include "tst_languages.moc"
