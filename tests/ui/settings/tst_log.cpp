// What a person can send when something went wrong.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/test_program.h"
#include "ui/settings/log.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fff::ui;

class TestLog : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyMessageIsALine();
    void aLongOneIsPutAside();
    void noFolderIsNoMisfortune();
};

void TestLog::everyMessageIsALine()
{
    const QTemporaryDir folder;
    keepLog(folder.filePath(QStringLiteral("new/data")));
    noteInLog(QStringLiteral("started"));
    QTest::ignoreMessage(QtWarningMsg, "one\nof two lines");
    qWarning("one\nof two lines");
    const QStringList lines = endOfLog(10).split(u'\n');
    QCOMPARE(lines.size(), 2);
    QVERIFY(lines[0].endsWith(QStringLiteral(" started")));
    QVERIFY2(lines[1].endsWith(QStringLiteral(" warning: one of two lines")), qPrintable(lines[1]));
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("new/data/log.txt"))));
    QCOMPARE(endOfLog(1), lines[1]);
}

void TestLog::aLongOneIsPutAside()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("log.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(static_cast<int>(kLongLog) + 1, 'x'));
    file.close();
    keepLog(folder.path());
    noteInLog(QStringLiteral("new"));
    QVERIFY(QFile(folder.filePath(QStringLiteral("log-before.txt"))).size() > kLongLog);
    QVERIFY(QFile(folder.filePath(QStringLiteral("log.txt"))).size() < 100);
}

void TestLog::noFolderIsNoMisfortune()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("taken")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    keepLog(folder.filePath(QStringLiteral("taken/below")));
    noteInLog(QStringLiteral("lost"));
    QCOMPARE(endOfLog(10), QString());
}

FFF_TEST(TestLog)
#include "tst_log.moc"
