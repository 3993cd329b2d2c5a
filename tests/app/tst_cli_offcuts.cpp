// --offcut: of which stock it is. If this fails, parts lie on a sheet that is of another material.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "tests/app/cli_run.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

class TestCliOffcuts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void theOnlyStocks();
    void theNamedStocks();
    void wrongUse_data();
    void wrongUse();

private:
    QString path(const QString &name) const { return m_folder.filePath(name); }
    Run nested(const QString &file, const QStringList &offcuts) const
    {
        QStringList arguments{u"nest"_s, path(file), u"--json"_s, u"--seconds"_s, u"0"_s};
        for (const QString &offcut : offcuts)
            arguments += {u"--offcut"_s, offcut};
        return run(arguments);
    }
    /// Stocks of the offcuts that parts lie on.
    static QStringList stocksOf(const Run &told)
    {
        QStringList stocks;
        for (const QJsonValue &sheet : object(told.out)[u"sheets"_s].toArray())
            if (sheet[u"offcut"_s].isDouble())
                stocks += sheet[u"stock"_s].toString();
        return stocks;
    }

    QTemporaryDir m_folder;
};

void TestCliOffcuts::initTestCase()
{
    Document document = withSection(newDocument(), plateOf(0, 0, 100, 50), front());
    QVERIFY(io::writeDocument(path(u"one.fff"_s), document));
    Stock card = flatfabAcrylic();
    card.name = "Card = 2 mm";
    document = *addStock(std::move(document), card);
    QVERIFY(io::writeDocument(path(u"unused.fff"_s), document));
    document = withSection(std::move(document), plateOf(0, 0, 100, 50), front(50.0));
    QCOMPARE(document.sections.back()->stock, document.currentStock);
    QVERIFY(io::writeDocument(path(u"two.fff"_s), document));
    QFile drawing(path(u"a=b.svg"_s));
    QVERIFY(drawing.open(QIODevice::WriteOnly));
    drawing.write(R"(<svg xmlns="http://www.w3.org/2000/svg" width="160mm" height="90mm"
        viewBox="0 0 160 90"><rect width="160" height="90"/></svg>)");
}

void TestCliOffcuts::theOnlyStocks()
{
    for (const auto &file : {u"one.fff"_s, u"unused.fff"_s}) {
        const Run told = nested(file, {u"150x80"_s});
        QVERIFY2(told.status == 0, told.err);
        QCOMPARE(stocksOf(told), QStringList(u"Birch plywood"_s));
    }
}

void TestCliOffcuts::theNamedStocks()
{
    const Run birch = nested(u"two.fff"_s, {u"birch plywood=150x80:2"_s});
    QVERIFY2(birch.status == 0, birch.err);
    QCOMPARE(stocksOf(birch), QStringList(u"Birch plywood"_s));
    for (const QString &what : {u"150x80"_s, path(u"a=b.svg"_s), path(u"a=b.svg"_s) + u":3"_s}) {
        const Run card = nested(u"two.fff"_s, {u"Card = 2 mm="_s + what});
        QVERIFY2(card.status == 0, card.err);
        QCOMPARE(stocksOf(card), QStringList(u"Card = 2 mm"_s));
    }
    const Run both =
        nested(u"two.fff"_s, {u"Card = 2 mm=150x80"_s, u"Birch plywood="_s + path(u"a=b.svg"_s)});
    QVERIFY2(both.status == 0, both.err);
    QCOMPARE(stocksOf(both).size(), 2);
}

void TestCliOffcuts::wrongUse_data()
{
    QTest::addColumn<QString>("offcut");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("of which stock")
        << u"150x80"_s
        << QByteArray("--offcut 150x80: the model is cut from Birch plywood and Card = 2 mm. Say "
                      "of which this one is, as in \"Birch plywood=150x80\".\n");
    QTest::newRow("no such stock")
        << u"Glass=150x80"_s
        << QByteArray("--offcut Glass=150x80: the model has no stock \"Glass\"; it is cut from "
                      "Birch plywood and Card = 2 mm.\n");
    QTest::newRow("no size behind the name")
        << u"Birch plywood="_s << QByteArray("--offcut: found \"Birch plywood=\", expected");
    QTest::newRow("none of them") << u"Birch plywood=150x80:0"_s
                                  << QByteArray("--offcut: found \"Birch plywood=150x80:0\"");
}

void TestCliOffcuts::wrongUse()
{
    QFETCH(QString, offcut);
    QFETCH(QByteArray, says);
    const Run told = nested(u"two.fff"_s, {offcut});
    QCOMPARE(told.status, 1);
    QVERIFY2(told.err.contains(says), told.err);
}

FFF_TEST(TestCliOffcuts)
#include "tst_cli_offcuts.moc"
