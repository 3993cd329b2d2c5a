// Every text of the program is in German, says the same places and has a key of its own in its
// menu.
#include <QApplication>
#include <QTest>

#include "tests/test_program.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QMenu>
#include <QMenuBar>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTranslator>
#include <QXmlStreamReader>

#include <algorithm>

namespace {

const QString kSources = QStringLiteral(FFF_SOURCES);

struct Message
{
    QString context, source;
    QStringList translations;
    bool isUnfinished = false;
};

std::vector<Message> messagesOf(const QString &path)
{
    std::vector<Message> messages;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return messages;
    QXmlStreamReader xml(&file);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        const auto name = xml.name();
        if (name == u"name") {
            context = xml.readElementText();
        } else if (name == u"message") {
            messages.push_back({context, {}, {}, false});
        } else if (name == u"source") {
            messages.back().source = xml.readElementText();
        } else if (name == u"translation") {
            messages.back().isUnfinished = xml.attributes().hasAttribute(QStringLiteral("type"));
            const QString text =
                xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
            messages.back().translations = {text};
        }
    }
    return messages;
}

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
        QProcess lupdate;
        lupdate.setWorkingDirectory(kSources);
        lupdate.start(QStringLiteral(FFF_LUPDATE),
                      {QStringLiteral("-I"), QStringLiteral("."), QStringLiteral("ui"),
                       QStringLiteral("app"), QStringLiteral("core"), QStringLiteral("-locations"),
                       QStringLiteral("none"), QStringLiteral("-no-obsolete"),
                       QStringLiteral("-silent"), QStringLiteral("-ts"), fresh});
        QVERIFY2(lupdate.waitForFinished(-1), qPrintable(lupdate.errorString()));
        QCOMPARE(lupdate.exitCode(), 0);

        const std::vector<Message> messages = messagesOf(fresh);
        QVERIFY2(messages.size() > 500, "texts are missing: lupdate did not find the sources");
        QStringList missing;
        for (const Message &message : messages) {
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
        const std::vector<Message> messages =
            messagesOf(kSources + QStringLiteral("/translations/flatfitfab_de.ts"));
        for (const Message &message : messages) {
            for (const QString &translation : message.translations) {
                QVERIFY2(placesOf(translation) == placesOf(message.source),
                         qPrintable(message.source));
            }
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
