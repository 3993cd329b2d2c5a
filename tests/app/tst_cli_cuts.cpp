// Tabs, leads, shared cuts and the fit coupon, as people ask for them.
#include <QTest> // first: moc stumbles over some standard headers

#include "tests/app/cli_run.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliCuts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tabsOpenTheCuts();
    void leadsWithoutRoom();
    void aCoupon();
    void aCouponOfFewSlits_data();
    void aCouponOfFewSlits();
    void wrongUse_data();
    void wrongUse();

private:
    QByteArray written(const QString &name) const
    {
        QFile file(m_folder.filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    Run runExport(const QString &name, const QStringList &more) const
    {
        return run(QStringList{u"export"_s, QStringLiteral(FFF_SAMPLES "/gears.fff"), u"-o"_s,
                               m_folder.filePath(name)} +
                   more);
    }

    QTemporaryDir m_folder;
};

void TestCliCuts::tabsOpenTheCuts()
{
    QCOMPARE(runExport(u"plain.svg"_s, {}).status, 0);
    QCOMPARE(runExport(u"tabs.svg"_s, {u"--tabs"_s, u"3:0.4"_s, u"--lead"_s, u"1"_s}).status, 0);
    QCOMPARE(runExport(u"none.svg"_s, {u"--tabs"_s, u"0"_s}).status, 0);
    const auto paths = [this](const QString &name) { return written(name).count("<path"); };
    QVERIFY(paths(u"plain.svg"_s) > 0);
    QVERIFY(paths(u"tabs.svg"_s) > paths(u"plain.svg"_s));
    QCOMPARE(written(u"none.svg"_s), written(u"plain.svg"_s));
}

/// Holes, or parts close together, that are too small for a lead got none, and nothing was said.
void TestCliCuts::leadsWithoutRoom()
{
    QVERIFY(!runExport(u"plain.svg"_s, {}).err.contains("No room for the leads"));
    const Run none = runExport(u"lead.svg"_s, {u"--lead"_s, u"40"_s});
    QCOMPARE(none.status, 0);
    QVERIFY2(none.err.contains("No room for the leads of all cuts"), none.err.constData());
}

void TestCliCuts::aCoupon()
{
    for (const auto &suffix : {u"svg"_s, u"dxf"_s, u"pdf"_s, u"lbrn2"_s, u"gcode"_s}) {
        const Run made =
            runExport(u"coupon."_s + suffix, {u"--coupon"_s, u"--machine"_s, u"k40"_s});
        QVERIFY2(made.status == 0, made.err.constData());
        QVERIFY(made.err.contains("Slits 1 to 13"));
        QVERIFY(written(u"coupon."_s + suffix).size() > 1000);
    }
    QVERIFY(written(u"coupon.svg"_s).contains("Slits to try"));
}

/// All 13 were promised where the kerf closes some, or the sheet is too short for them.
void TestCliCuts::aCouponOfFewSlits_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char *name, const QStringList &options, const char *says) {
        QTest::newRow(name) << options << QByteArray(says);
    };
    row("all of them", {}, "Slits 1 to 13 have clearances from -0.30 to 0.30 mm");
    row("thin", {u"--thickness"_s, u"0.25"_s, u"--kerf"_s, u"0.15"_s},
        "Slits 6 to 13 have clearances from -0.05 to 0.30 mm");
    row("a short sheet", {u"--thickness"_s, u"10"_s, u"--sheet"_s, u"200x150"_s},
        "Slits 3 to 10 have clearances from -0.20 to 0.15 mm");
}

void TestCliCuts::aCouponOfFewSlits()
{
    QFETCH(QStringList, options);
    QFETCH(QByteArray, says);
    const Run made = runExport(u"coupon.svg"_s, QStringList{u"--coupon"_s} + options);
    QVERIFY2(made.status == 0, made.err.constData());
    QVERIFY2(made.err.contains(says), made.err.constData());
}

void TestCliCuts::wrongUse_data()
{
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("says");
    const auto row = [](const char *name, const QStringList &options, const char *says) {
        QTest::newRow(name) << options << QByteArray(says);
    };
    row("words for tabs", {u"--tabs"_s, u"many"_s}, "--tabs: found \"many\"");
    row("too many tabs", {u"--tabs"_s, u"101"_s}, "--tabs: found \"101\"");
    row("no width", {u"--tabs"_s, u"3:"_s}, "--tabs: found \"3:\"");
    row("a width of nothing", {u"--tabs"_s, u"3:0"_s}, "--tabs: found \"3:0\"");
    row("three numbers", {u"--tabs"_s, u"3:1:1"_s}, "--tabs: found \"3:1:1\"");
    row("joints' colours in layers", {u"--joint-colours"_s, u"--format"_s, u"dxf"_s},
        "--joint-colours: this kind of file cannot hold them; expected .svg");
    row("a lead backwards", {u"--lead"_s, u"-1"_s}, "--lead: found \"-1\"");
    row("an endless lead", {u"--lead"_s, u"inf"_s}, "--lead: found \"inf\"");
    row("a coupon that is a solid", {u"--coupon"_s, u"--format"_s, u"obj"_s}, "--coupon: ");
    row("a closed coupon", {u"--coupon"_s, u"--kerf"_s, u"8"_s}, "which a kerf of 8.00 mm would");
}

void TestCliCuts::wrongUse()
{
    QFETCH(QStringList, options);
    QFETCH(QByteArray, says);
    const Run made = runExport(u"wrong.svg"_s, options);
    QVERIFY(made.status == 1 || made.status == 2);
    QVERIFY2(made.err.contains(says), made.err.constData());
    QVERIFY(!QFile::exists(m_folder.filePath(u"wrong.svg"_s)));
}

FFF_TEST(TestCliCuts)
#include "tst_cli_cuts.moc"
