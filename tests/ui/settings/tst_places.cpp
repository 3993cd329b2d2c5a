// Where a person's things are kept, with and without portable.txt beside the program.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "ui/settings/places.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <memory>

using namespace fff::ui;

class TestPlaces : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void init();
    void withoutTheFileTheyAreTheSystems();
    void anEmptyFileKeepsNothing_data();
    void anEmptyFileKeepsNothing();
    void aNamedFolderHasAll();
    void aFolderThatCannotBeWrittenKeepsNothing();

private:
    void write(const QByteArray &text);

    std::unique_ptr<QTemporaryDir> m_folder;
};

namespace {

QStringList allOf(const Places &places)
{
    return {places.settings, places.data, places.cache};
}

} // namespace

void TestPlaces::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
}

void TestPlaces::write(const QByteArray &text)
{
    QFile file(m_folder->filePath(QStringLiteral("portable.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

void TestPlaces::withoutTheFileTheyAreTheSystems()
{
    const Places places = placesFor(m_folder->path());
    QCOMPARE(places.settings,
             QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
                 QStringLiteral("/flatfitfab/settings.ini"));
    for (const QString &path : allOf(places))
        QVERIFY2(!path.startsWith(m_folder->path()), qPrintable(path));
}

void TestPlaces::anEmptyFileKeepsNothing_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("a comment") << QByteArray("# for the stick\r\n\r\n");
    QTest::newRow("spaces") << QByteArray("  \n\t\n");
}

void TestPlaces::anEmptyFileKeepsNothing()
{
    QFETCH(const QByteArray, text);
    write(text);
    const QStringList before =
        QDir(m_folder->path()).entryList(QDir::NoDotAndDotDot | QDir::AllEntries);
    const Places places = placesFor(m_folder->path()), system = [] {
        const QTemporaryDir other;
        return placesFor(other.path());
    }();
    for (const QString &path : allOf(places)) {
        QVERIFY2(!allOf(system).contains(path), qPrintable(path));
        QVERIFY2(!path.startsWith(m_folder->path()), qPrintable(path));
    }
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::NoDotAndDotDot | QDir::AllEntries), before);
}

void TestPlaces::aNamedFolderHasAll()
{
    write("# kept here\n  my settings \n");
    const QString folder = m_folder->filePath(QStringLiteral("my settings"));
    const Places places = placesFor(m_folder->path());
    QCOMPARE(places.settings, folder + QStringLiteral("/settings.ini"));
    QCOMPARE(places.data, folder);
    QVERIFY(places.cache.startsWith(folder + u'/'));
    QVERIFY(QDir(folder).isEmpty()); // that it was tried leaves nothing
}

void TestPlaces::aFolderThatCannotBeWrittenKeepsNothing()
{
    write("taken\n");
    QFile file(m_folder->filePath(QStringLiteral("taken")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    for (const QString &path : allOf(placesFor(m_folder->path())))
        QVERIFY2(!path.startsWith(m_folder->path()), qPrintable(path));
}

FFF_TEST(TestPlaces)
#include "tst_places.moc"
