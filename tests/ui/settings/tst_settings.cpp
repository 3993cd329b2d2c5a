// What a person sets is there again at the next start, and nothing in the file can do harm.
#include <QTest>

#include "tests/test_program.h"
#include "ui/settings/check_rules.h"
#include "ui/settings/settings.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>

using namespace fff;
using namespace fff::ui;

class TestSettings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void defaultsAreThoseOfTheManual();
    void whatIsSetIsThereAtTheNextStart();
    void onlyAChangeIsAnnounced();
    void nonsenseReadsAsTheDefault_data();
    void nonsenseReadsAsTheDefault();
    void numbersStayInTheirRange();
    void checksGoByTheirOwnUnits();
    void aRecentFileIsThereOnceAndFirst();
    void shortcutsAreKeptById();
    void whatThePersonSetsCountsBeforeDefaults();
    void defaultsAreNeverWritten();
    void aWorkFolderHasToBeThere();
    void safelyNothingThatWasSetCounts();

private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
};

void TestSettings::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_file = m_folder->filePath(QStringLiteral("settings.ini"));
}

void TestSettings::defaultsAreThoseOfTheManual()
{
    const Settings settings(m_file);
    QCOMPARE(settings.unit(), LengthUnit::Millimetre);
    QCOMPARE(settings.colourScheme(), ColourScheme::System);
    QCOMPARE(settings.language(), QString());
    QVERIFY(settings.showsStartPage());
    QCOMPARE(settings.turnTime(), 800);
    QCOMPARE(settings.shallowAngle(), 30);
    QCOMPARE(settings.planningTime(), 1000);
    QCOMPARE(settings.autosaveInterval(), 10);
    QVERIFY(settings.keepsBackup());
    QVERIFY(!settings.isStressColourSafe());
    QVERIFY(settings.recentFiles().isEmpty());
    QVERIFY(!settings.shortcuts(QStringLiteral("edit.undo")));
}

void TestSettings::whatIsSetIsThereAtTheNextStart()
{
    {
        Settings settings(m_file);
        settings.setUnit(LengthUnit::Inch);
        settings.setColourScheme(ColourScheme::Dark);
        settings.setLanguage(QStringLiteral("de"));
        settings.setShowsStartPage(false);
        settings.setTurnTime(250);
        settings.setMotion(Motion::Reduced);
        settings.setShallowAngle(45);
        settings.setPlanningTime(5000);
        settings.setAutosaveInterval(20);
        settings.setKeepsBackup(false);
        settings.setStressColourSafe(true);
        settings.setWindowGeometry(QByteArray("\0\1\xff,;=", 6));
        settings.setMemory(QStringLiteral("export/filter"), QStringLiteral("obj"));
    }
    const Settings next(m_file);
    QCOMPARE(next.unit(), LengthUnit::Inch);
    QCOMPARE(next.colourScheme(), ColourScheme::Dark);
    QCOMPARE(next.language(), QStringLiteral("de"));
    QVERIFY(!next.showsStartPage());
    QVERIFY(next.isStressColourSafe());
    QCOMPARE(next.shallowAngle(), 45);
    QCOMPARE(next.planningTime(), 5000);
    QCOMPARE(next.turnTime(), 250);
    QVERIFY(next.reducesMotion());
    QCOMPARE(next.animationTime(400), 0);
    QCOMPARE(next.autosaveInterval(), 20);
    QVERIFY(!next.keepsBackup());
    QCOMPARE(next.windowGeometry(), QByteArray("\0\1\xff,;=", 6));
    QCOMPARE(next.memory(QStringLiteral("export/filter")).toString(), QStringLiteral("obj"));
}

void TestSettings::onlyAChangeIsAnnounced()
{
    Settings settings(m_file);
    QSignalSpy units(&settings, &Settings::unitChanged), view(&settings, &Settings::viewChanged),
        shortcuts(&settings, &Settings::shortcutsChanged);
    settings.setUnit(LengthUnit::Millimetre);
    settings.setTurnTime(800);
    settings.setShortcuts(QStringLiteral("edit.undo"), std::nullopt);
    QCOMPARE(units.count() + view.count() + shortcuts.count(), 0);
    settings.setUnit(LengthUnit::Centimetre);
    settings.setTurnTime(0);
    settings.setMotion(Motion::Full);
    QCOMPARE(units.count(), 1);
    QCOMPARE(view.count(), 2);
}

void TestSettings::nonsenseReadsAsTheDefault_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QVariant>("value");
    const QString keys[] = {
        QStringLiteral("display/unit"),     QStringLiteral("display/theme"),
        QStringLiteral("display/language"), QStringLiteral("start/page"),
        QStringLiteral("view/turnTime"),    QStringLiteral("view/motion"),
        QStringLiteral("files/backup"),     QStringLiteral("files/autosaveInterval")};
    for (const QString &key : keys) {
        QTest::addRow("%s is a word", qPrintable(key)) << key << QVariant(QStringLiteral("fish"));
        QTest::addRow("%s is empty", qPrintable(key)) << key << QVariant(QString());
        QTest::addRow("%s is a list", qPrintable(key))
            << key << QVariant(QStringList{QStringLiteral("a"), QStringLiteral("b")});
    }
}

void TestSettings::nonsenseReadsAsTheDefault()
{
    QFETCH(QString, key);
    QFETCH(QVariant, value);
    {
        QSettings file(m_file, QSettings::IniFormat);
        file.setValue(key, value);
    }
    defaultsAreThoseOfTheManual();
}

void TestSettings::numbersStayInTheirRange()
{
    Settings settings(m_file);
    settings.setTurnTime(-5);
    QCOMPARE(settings.turnTime(), 0);
    settings.setTurnTime(100000);
    QCOMPARE(settings.turnTime(), 3000);
    settings.setAutosaveInterval(1);
    QCOMPARE(settings.autosaveInterval(), 5);
    settings.setAutosaveInterval(3600);
    QCOMPARE(settings.autosaveInterval(), 30);
    {
        QSettings file(m_file, QSettings::IniFormat);
        file.setValue(QStringLiteral("files/autosaveInterval"), 3600);
    }
    QCOMPARE(Settings(m_file).autosaveInterval(), 30);
}

// Wrong: every joint is too flat, or none is; the search for an order ends at once, or never.
void TestSettings::checksGoByTheirOwnUnits()
{
    Settings settings(m_file);
    QCOMPARE(checkRules(settings), CheckRules());
    settings.setShallowAngle(45);
    settings.setPlanningTime(2500);
    const CheckRules rules = checkRules(settings);
    QVERIFY(std::abs(std::tan(rules.shallowAngle) - 1.0) < 1e-12);
    QCOMPARE(rules.planningTime, std::chrono::milliseconds(2500));
}

void TestSettings::aRecentFileIsThereOnceAndFirst()
{
    Settings settings(m_file);
    QSignalSpy spy(&settings, &Settings::recentFilesChanged);
    for (int i = 0; i < 2 * Settings::kMaxRecentFiles; ++i)
        settings.addRecentFile(QStringLiteral("/models/m%1.fff").arg(i));
    QCOMPARE(settings.recentFiles().size(), Settings::kMaxRecentFiles);
    const QString old = settings.recentFiles().at(3);
    settings.addRecentFile(QFileInfo(old).path() + QStringLiteral("/../models/") +
                           QFileInfo(old).fileName());
    QCOMPARE(settings.recentFiles().front(), old);
    QCOMPARE(settings.recentFiles().count(old), 1);
    spy.clear();
    settings.addRecentFile(old);
    QCOMPARE(spy.count(), 0);
    settings.removeRecentFile(old);
    QVERIFY(!settings.recentFiles().contains(old));
    settings.clearRecentFiles();
    QVERIFY(Settings(m_file).recentFiles().isEmpty());
}

void TestSettings::shortcutsAreKeptById()
{
    const QString undo = QStringLiteral("edit.undo"), redo = QStringLiteral("edit.redo");
    const QList<QKeySequence> keys = {QKeySequence(QStringLiteral("Ctrl+,")),
                                      QKeySequence(QStringLiteral("Ctrl+;")),
                                      QKeySequence(QStringLiteral("Ctrl+K, Ctrl+U"))};
    {
        Settings settings(m_file);
        settings.setShortcuts(undo, keys);
        settings.setShortcuts(redo, QList<QKeySequence>());
    }
    Settings settings(m_file);
    QCOMPARE(settings.shortcuts(undo), std::optional(keys));
    QCOMPARE(settings.shortcuts(redo), std::optional(QList<QKeySequence>()));
    settings.setShortcuts(undo, std::nullopt);
    QVERIFY(!settings.shortcuts(undo));
    settings.resetShortcuts();
    QVERIFY(!settings.shortcuts(redo));
}

namespace {

QString written(const QTemporaryDir &folder, const char *name, const QByteArray &text)
{
    const QString path = folder.filePath(QLatin1String(name));
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

} // namespace

void TestSettings::whatThePersonSetsCountsBeforeDefaults()
{
    const QString first = written(*m_folder, "first.ini", "[display]\nunit=in\n");
    const QString second = written(*m_folder, "second.ini",
                                   "[display]\nunit=cm\ntheme=dark\n[start]\npage=nonsense\n"
                                   "[shortcuts]\nedit.undo=Ctrl+U\n");
    const QStringList defaults{first, m_folder->filePath(QStringLiteral("none.ini")), second};
    Settings settings(m_file, defaults);
    QCOMPARE(settings.unit(), LengthUnit::Inch); // the first that has it
    QCOMPARE(settings.colourScheme(), ColourScheme::Dark);
    QVERIFY(settings.showsStartPage());
    QCOMPARE(settings.shortcuts(QStringLiteral("edit.undo"))->size(), 1);
    QSignalSpy told(&settings, &Settings::unitChanged);
    settings.setUnit(LengthUnit::Inch);
    QCOMPARE(told.size(), 0);
    settings.setUnit(LengthUnit::Millimetre);
    QCOMPARE(told.size(), 1);
    settings.setColourScheme(ColourScheme::System); // what the program has without defaults
    const Settings again(m_file, defaults);
    QCOMPARE(again.unit(), LengthUnit::Millimetre);
    QCOMPARE(again.colourScheme(), ColourScheme::System);
}

void TestSettings::defaultsAreNeverWritten()
{
    const QByteArray text = "[display]\nunit=in\n[shortcuts]\nedit.undo=Ctrl+U\n";
    const QString path = written(*m_folder, "defaults.ini", text);
    {
        Settings settings(m_file, {path});
        settings.setUnit(LengthUnit::Centimetre);
        settings.resetShortcuts();
        settings.setLanguage(QStringLiteral("de"));
    }
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), text);
}

void TestSettings::aWorkFolderHasToBeThere()
{
    const QString path =
        written(*m_folder, "defaults.ini", "[files]\nfolder=~\nnewModel=~/new.fff\n");
    const Settings settings(m_file, {path});
    QCOMPARE(settings.workFolder(), QDir::homePath());
    QCOMPARE(settings.newModelFile(), QDir::homePath() + QStringLiteral("/new.fff"));
    const QString gone = written(*m_folder, "gone.ini", "[files]\nfolder=/no/such/folder\n");
    QCOMPARE(Settings(m_file, {gone}).workFolder(), QString());
    QCOMPARE(Settings(m_file).newModelFile(), QString());
}

void TestSettings::safelyNothingThatWasSetCounts()
{
    Settings::setFile(m_file);
    settings().setUnit(LengthUnit::Inch);
    Settings::startSafely();
    QCOMPARE(settings().unit(), LengthUnit::Millimetre);
    settings().setUnit(LengthUnit::Centimetre);
    Settings::setFile(m_file);
    QCOMPARE(settings().unit(), LengthUnit::Inch);
}

FFF_TEST(TestSettings)
#include "tst_settings.moc"
