// Every text of the program is in every language, says the same places, has letters that can be
// drawn, and a key of its own in its menu.
#include <QApplication>
#include <QTest>

#include "tests/test_program.h"
#include "tests/ui/translated_texts.h"
#include "ui/actions/action_set.h"
#include "ui/settings/languages.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QFontMetrics>
#include <QKeySequence>
#include <QLibraryInfo>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSet>
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
using namespace fff::ui;

class TestTranslations : public QObject
{
    Q_OBJECT

private:
    /// Every one but English, whose file has plural forms alone.
    static void translations()
    {
        QTest::addColumn<QString>("language");
        for (const QString &language : languagesThere())
            if (language != QStringLiteral("en"))
                QTest::newRow(qPrintable(language)) << language;
    }
    static QString fileOf(const QString &language)
    {
        return kSources + QStringLiteral("/translations/flatfitfab_%1.ts").arg(language);
    }

private Q_SLOTS:
    void everyTextOfTheSourcesIsThere_data() { translations(); }

    /// A text that was changed or added without its translation would be seen in English.
    void everyTextOfTheSourcesIsThere()
    {
        static const std::vector<TranslatedText> wanted = [] {
            QTemporaryDir folder;
            const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
            const QString failure = bringTexts(fresh);
            return failure.isEmpty() ? textsOf(fresh) : std::vector<TranslatedText>();
        }();
        QVERIFY2(wanted.size() > 500, "texts are missing: lupdate did not find the sources");
        QFETCH(QString, language);
        const auto keyOf = [](const TranslatedText &text) {
            return text.context + QStringLiteral(": ") + text.source;
        };
        QStringList there, missing;
        for (const TranslatedText &text : textsOf(fileOf(language))) {
            there += keyOf(text);
            if (text.isUnfinished || text.translation.isEmpty())
                missing += keyOf(text);
        }
        there.sort();
        QStringList sources;
        for (const TranslatedText &text : wanted) {
            sources += keyOf(text);
            if (!std::binary_search(there.cbegin(), there.cend(), keyOf(text)))
                missing += keyOf(text);
        }
        QVERIFY2(missing.isEmpty(), qPrintable(QStringLiteral("run translations/update and fill "
                                                              "in:\n") +
                                               missing.join(u'\n')));
        QCOMPARE(there.size(), sources.size()); // none is left of texts that are gone
    }

    void translationsFillInTheSamePlaces_data() { translations(); }

    /// A translation that leaves out %1 shows a sentence without its number or name.
    void translationsFillInTheSamePlaces()
    {
        QFETCH(QString, language);
        for (const TranslatedText &message : textsOf(fileOf(language))) {
            QVERIFY2(placesOf(message.translation) == placesOf(message.source),
                     qPrintable(message.source));
        }
    }

    void itsLettersAreThere_data() { translations(); }

    /// Squares in place of letters.
    void itsLettersAreThere()
    {
        QFETCH(QString, language);
        const QFontMetrics letters{QApplication::font()};
        QSet<char32_t> missing;
        for (const TranslatedText &message : textsOf(fileOf(language)))
            for (const char32_t letter : message.translation.toUcs4())
                if (QChar::isPrint(letter) && !letters.inFontUcs4(letter))
                    missing.insert(letter);
        QString all;
        for (const char32_t letter : missing)
            all += QString::fromUcs4(&letter, 1);
        QVERIFY2(all.isEmpty(), qPrintable(all));
    }

    void keysAreNamedAsOnKeyboards_data() { translations(); }

    /// Wrong: a Polish menu had "Katalog domowy", a home directory, for a key.
    void keysAreNamedAsOnKeyboards()
    {
        QFETCH(QString, language);
        QTranslator qts, ours;
        QVERIFY(ours.load(QStringLiteral(":/i18n/flatfitfab_") + language));
        if (qts.load(QStringLiteral("qtbase_") + language,
                     QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
            QCoreApplication::installTranslator(&qts);
        QCoreApplication::installTranslator(&ours);
        const QString keys =
            QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Home).toString(QKeySequence::NativeText);
        QCOMPARE(keys,
                 QStringLiteral("%1+%2+%3")
                     .arg(ours.translate("QShortcut", "Ctrl"), ours.translate("QShortcut", "Shift"),
                          ours.translate("QShortcut", "Home")));
        QCoreApplication::removeTranslator(&ours);
        QCoreApplication::removeTranslator(&qts);
    }

    void menusHaveOneKeyForEachEntry_data()
    {
        QTest::addColumn<QString>("language");
        for (const QString &language : languagesThere())
            QTest::newRow(qPrintable(language)) << language;
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
                if (action->isSeparator() || !action->isVisible())
                    continue;
                const bool isOfTable = ActionSet::isOfCommand(action) || menu == window.menuBar();
                if (mark < 0 && isOfTable)
                    clashes += QStringLiteral("none in ") + text;
                if (mark < 0)
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
