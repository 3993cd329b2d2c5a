// Every text of the program is in German, says the same places and has a key of its own in its
// menu.
#include <QApplication>
#include <QTest>

#include "tests/test_program.h"
#include "tests/ui/translated_texts.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>

#include <algorithm>

namespace {

QStringList placesOf(const QString &text)
{
    static const QRegularExpression place(QStringLiteral("%(\\d|n|L\\d)"));
    QStringList places;
    for (auto found = place.globalMatch(text); found.hasNext();)
        places += found.next().captured();
    places.removeDuplicates();
    places.sort();
    return places;
}

} // namespace

using namespace fff::test;

class TestTranslations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A text that was changed or added without its translation would be seen in English.
    void germanHasEveryTextOfTheSources()
    {
        QTemporaryDir folder;
        const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
        QVERIFY(QFile::copy(kSources + QStringLiteral("/translations/flatfitfab_de.ts"), fresh));
        QVERIFY(QFile::setPermissions(fresh, QFile::ReadOwner | QFile::WriteOwner));
        const QString failure = bringTexts(fresh);
        QVERIFY2(failure.isEmpty(), qPrintable(failure));

        const std::vector<TranslatedText> messages = textsOf(fresh);
        QVERIFY2(messages.size() > 500, "texts are missing: lupdate did not find the sources");
        QStringList missing;
        for (const TranslatedText &message : messages) {
            if (message.isUnfinished)
                missing += message.context + QStringLiteral(": ") + message.source;
        }
        QVERIFY2(missing.isEmpty(), qPrintable(QStringLiteral("run translations/update and fill "
                                                              "in:\n") +
                                               missing.join(u'\n')));
    }

    /// A translation that leaves out %1 shows a sentence without its number or name.
    void translationsFillInTheSamePlaces()
    {
        const std::vector<TranslatedText> messages =
            textsOf(kSources + QStringLiteral("/translations/flatfitfab_de.ts"));
        for (const TranslatedText &message : messages) {
            QVERIFY2(placesOf(message.translation) == placesOf(message.source),
                     qPrintable(message.source));
        }
    }

    void menusHaveOneKeyForEachEntry_data()
    {
        QTest::addColumn<QString>("language");
        QTest::newRow("English") << QStringLiteral("en");
        QTest::newRow("German") << QStringLiteral("de");
    }

    /// Two entries with the same underlined letter: the key opens neither at once.
    void menusHaveOneKeyForEachEntry()
    {
        QFETCH(QString, language);
        QTranslator translator;
        QVERIFY(translator.load(QStringLiteral(":/i18n/flatfitfab_") + language));
        QCoreApplication::installTranslator(&translator);
        const fff::ui::MainWindow window;
        QCoreApplication::removeTranslator(&translator);

        QList<const QWidget *> menus{window.menuBar()};
        for (const QMenu *menu : window.menuBar()->findChildren<QMenu *>()) // and beside them
            if (menu->menuAction()->isVisible())
                menus += menu;
        QVERIFY(menus.size() > 5);
        QStringList clashes;
        for (const QWidget *menu : std::as_const(menus)) {
            QMap<QChar, QString> taken;
            for (const QAction *action : menu->actions()) {
                const QString text = action->text();
                const qsizetype mark = text.indexOf(u'&');
                if (action->isSeparator() || !action->isVisible() || mark < 0)
                    continue;
                const QChar key = text.at(mark + 1).toLower();
                if (taken.contains(key))
                    clashes += taken.value(key) + QStringLiteral(" and ") + text;
                taken.insert(key, text);
            }
        }
        QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(u'\n')));
    }
};

FFF_TEST_WITH(TestTranslations, fff::testing::runWithin<TestTranslations, QApplication>)
#include "tst_translations.moc"
