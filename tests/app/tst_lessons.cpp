// The models of the lessons are what resources/help/lessons.md promises: a class that starts from
// one finds the problem that is told of, and the finished one has none.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/cli_run.h"
#include "tests/test_program.h"

#include <QDir>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;

namespace {

constexpr int kFails = 3; // the status of `check` with errors

QString fileOf(const QString &name)
{
    return QStringLiteral(FFF_RESOURCES "/lessons/%1.fff").arg(name);
}

} // namespace

class TestLessons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachIsAsThePageSays_data();
    void eachIsAsThePageSays();
    void allAreInThePage();
    void theLampStartsFromItsMesh();
};

void TestLessons::eachIsAsThePageSays_data()
{
    QTest::addColumn<int>("status");
    QTest::addColumn<QStringList>("says");
    const QStringList isFine{QStringLiteral("Connected."), QStringLiteral("Stands."),
                             QStringLiteral("Can be assembled."),
                             QStringLiteral("Fits the sheet. 1 sheet of")};
    QTest::newRow("1_toy_animal_start")
        << kFails << QStringList{QStringLiteral("error: Not on the ground.")};
    QTest::newRow("1_toy_animal_finished")
        << 0 << isFine + QStringList{QStringLiteral("of 297 × 210")};
    QTest::newRow("2_shelf_start")
        << kFails << QStringList{QStringLiteral("error: Too weak for 1000")};
    QTest::newRow("2_shelf_finished") << 0 << isFine + QStringList{QStringLiteral("Holds 1000")};
    QTest::newRow("3_lamp_start") << 0
                                  << QStringList{QStringLiteral(
                                         "Nothing to check: the model has no sections.")};
    QTest::newRow("3_lamp_finished") << 0 << isFine + QStringList{QStringLiteral("Strong enough.")};
}

void TestLessons::eachIsAsThePageSays()
{
    QFETCH(int, status);
    QFETCH(QStringList, says);
    const QString name = QString::fromUtf8(QTest::currentDataTag());
    const Result<io::LoadedDocument> loaded = io::readDocument(fileOf(name));
    QVERIFY(loaded);
    QVERIFY(loaded->warnings.empty());
    const Run checked = run({QStringLiteral("check"), fileOf(name)}, false);
    const QString said = QString::fromUtf8(checked.out + checked.err);
    QCOMPARE(checked.status, status);
    for (const QString &text : says)
        QVERIFY2(said.contains(text), qPrintable(said));
    if (!name.endsWith(QStringLiteral("finished")))
        return;
    for (const QString &line : said.split(u'\n'))
        QVERIFY2(!line.startsWith(QStringLiteral("error:")) &&
                     !line.startsWith(QStringLiteral("warning:")),
                 qPrintable(line));
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("parts.svg"));
    QCOMPARE(
        run({QStringLiteral("export"), fileOf(name), QStringLiteral("-o"), file}, false).status, 0);
    QVERIFY(QFile::exists(file));
}

// Wrong: a file that no link leads to, or a link without a file.
void TestLessons::allAreInThePage()
{
    QFile page(QStringLiteral(FFF_RESOURCES "/help/lessons.md"));
    QVERIFY(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    const QStringList files =
        QDir(QStringLiteral(FFF_RESOURCES "/lessons")).entryList({QStringLiteral("*.fff")});
    QCOMPARE(files.size(), 6);
    for (const QString &file : files)
        QVERIFY2(text.contains(QStringLiteral("(lesson:%1)").arg(QFileInfo(file).baseName())),
                 qPrintable(file));
    QCOMPARE(text.count(QStringLiteral("(lesson:")), files.size());
}

void TestLessons::theLampStartsFromItsMesh()
{
    const auto started = io::readDocument(fileOf(QStringLiteral("3_lamp_start")));
    QVERIFY(started && started->document.sections.empty());
    QCOMPARE(started->document.templates.size(), std::size_t(1));
    QVERIFY(started->document.templates.front()->mesh);
}

FFF_TEST(TestLessons)
#include "tst_lessons.moc"
