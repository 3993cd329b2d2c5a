#include <QTest>

#include "core/io/document_file.h"
#include "core/io/file_set.h"
#include "tests/test_program.h"

#include <QDir>
#include <QTemporaryDir>

using namespace fff;

class TestFileSet : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allAreWritten();
    void noneIsWrittenWhenOneCannotBe_data();
    void noneIsWrittenWhenOneCannotBe();
    void whatAnEarlierSetLeft();
};

void TestFileSet::allAreWritten()
{
    const QTemporaryDir folder;
    const QString a = folder.filePath(QStringLiteral("a")),
                  b = folder.filePath(QStringLiteral("b"));
    QVERIFY(io::writeFile(b, "old"));
    QVERIFY(io::writeFiles({{a, "one"}, {b, std::string("t\0wo", 4)}}));
    QCOMPARE(*io::readFile(a), std::string("one"));
    QCOMPARE(*io::readFile(b), std::string("t\0wo", 4));
    QVERIFY(io::writeFiles({}));
}

void TestFileSet::noneIsWrittenWhenOneCannotBe_data()
{
    QTest::addColumn<QString>("bad");
    QTest::newRow("a folder that is not there") << QStringLiteral("absent/c");
    QTest::newRow("a folder in its place") << QStringLiteral("folder");
}

// Half a set of sheets beside half of an older one looks like a whole one.
void TestFileSet::noneIsWrittenWhenOneCannotBe()
{
    QFETCH(QString, bad);
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("folder")));
    const QString old = folder.filePath(QStringLiteral("a")),
                  fresh = folder.filePath(QStringLiteral("b")), impossible = folder.filePath(bad);
    QVERIFY(io::writeFile(old, "old"));
    const Result<void> written =
        io::writeFiles({{old, "new"}, {fresh, "new"}, {impossible, "new"}});
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::CannotWrite);
    QCOMPARE(written.error().place, impossible.toStdString());
    QCOMPARE(*io::readFile(old), std::string("old"));
    QVERIFY(!QFile::exists(fresh));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
}

void TestFileSet::whatAnEarlierSetLeft()
{
    const QTemporaryDir folder;
    const auto file = [&](const char *name) { return folder.filePath(QLatin1String(name)); };
    const QString plan = file("plan.svg");
    for (const io::NamedBytes &one :
         io::numberedFiles(plan, std::vector<std::string>(12, "old"), QStringLiteral("svg")))
        QVERIFY(io::writeFile(one.path, one.bytes));
    for (const char *name : {"plan-013.svg", "plan-2024.svg", "plan-14.obj", "plan-x.svg",
                             "a plan-14.svg", "plan-14.svg.bak"})
        QVERIFY(io::writeFile(file(name), "mine"));
    const std::vector<QString> older{file("plan-10.svg"), file("plan-11.svg"), file("plan-12.svg")};
    QVERIFY(io::olderFiles(plan, 9, QStringLiteral("svg")) == older);
    QVERIFY(io::olderFiles(file("plan"), 9, QStringLiteral("svg")) == older);
    QVERIFY(io::olderFiles(plan, 12, QStringLiteral("svg")).empty());
}

FFF_TEST(TestFileSet)
#include "tst_file_set.moc"
