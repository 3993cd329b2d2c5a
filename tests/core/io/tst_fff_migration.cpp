// Files of older versions. If this fails, somebody's model of last year opens wrongly, or not at
// all.
#include <QTest>

#include "core/io/document_file.h"
#include "core/io/error_text.h"
#include "core/io/fff_format.h"
#include "core/io/fff_migration.h"
#include "tests/core/io/io_samples.h"
#include "tests/test_program.h"

#include <QtCore/QFile>

using namespace fff;

class TestFffMigration : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyVersionOpens_data();
    void everyVersionOpens();
    void everyStepIsThere();
    void stepsFollowEachOther_data();
    void stepsFollowEachOther();
    void aNewerVersionIsNamed();
};

namespace {

QJsonObject renamed(QJsonObject document, const char *from, const char *to)
{
    document[QLatin1String(to)] = document.take(QLatin1String(from));
    return document;
}

/// "a" became "b" in version 2 and "c" in version 3.
const io::Migration kSteps[] = {
    {1, [](QJsonObject document) { return renamed(std::move(document), "a", "b"); }},
    {2, [](QJsonObject document) { return renamed(std::move(document), "b", "c"); }},
};

} // namespace

void TestFffMigration::everyVersionOpens_data()
{
    QTest::addColumn<int>("version");
    for (int version = 1; version <= io::kFffVersion; ++version)
        QTest::addRow("version %d", version) << version;
}

void TestFffMigration::everyVersionOpens()
{
    QFETCH(int, version);
    const QString file = QStringLiteral(FFF_TEST_DATA "/migration/version_%1.fff").arg(version);
    const auto loaded = io::readDocument(file);
    QVERIFY2(loaded, qPrintable(loaded ? QString() : io::errorText(loaded.error())));
    QVERIFY(loaded->document == test::twoSections());
    QVERIFY(loaded->warnings.empty());
    QFile bytes(file);
    QVERIFY(bytes.open(QIODevice::ReadOnly));
    QVERIFY2(bytes.readAll().contains("\"version\": " + QByteArray::number(version)),
             "the file is of the version that it stands for");
}

void TestFffMigration::everyStepIsThere()
{
    QCOMPARE(io::fffMigrations().size(), static_cast<std::size_t>(io::kFffVersion - 1));
    std::int64_t version = 1;
    for (const io::Migration &step : io::fffMigrations())
        QCOMPARE(step.from, version++);
}

void TestFffMigration::stepsFollowEachOther_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<int>("version");
    QTest::newRow("the oldest takes all steps") << QStringLiteral("a") << 1;
    QTest::newRow("the one in the middle takes the last") << QStringLiteral("b") << 2;
    QTest::newRow("the newest takes none") << QStringLiteral("c") << 3;
}

void TestFffMigration::stepsFollowEachOther()
{
    QFETCH(QString, key);
    QFETCH(int, version);
    const QJsonObject old{{QStringLiteral("version"), version},
                          {key, QStringLiteral("kept")},
                          {QStringLiteral("other"), 7}};
    const QJsonObject wanted{{QStringLiteral("version"), 3},
                             {QStringLiteral("c"), QStringLiteral("kept")},
                             {QStringLiteral("other"), 7}};
    QCOMPARE(io::migrated(old, version, kSteps), wanted);
}

void TestFffMigration::aNewerVersionIsNamed()
{
    const std::string text =
        test::replacedOnce(io::writeFff(test::twoSections()).value(),
                           "\"version\": " + std::to_string(io::kFffVersion), "\"version\": 70");
    const auto loaded = io::readFff(text, "a.fff");
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, ErrorCode::NewerVersion);
    const QString sentence = io::errorText(loaded.error());
    QVERIFY2(sentence.contains(QStringLiteral("70")), qPrintable(sentence));
    QVERIFY2(sentence.contains(QString::number(io::kFffVersion)), qPrintable(sentence));
}

FFF_TEST(TestFffMigration)
#include "tst_fff_migration.moc"
