// A stock as a file: what one person measured is what another one cuts with.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/io/material_library.h"
#include "core/io/stock_file.h"
#include "core/model/edits.h"
#include "tests/test_program.h"

#include <QFile>
#include <QTemporaryDir>

using namespace fff;
using namespace Qt::Literals::StringLiterals;

class TestStockFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comesBackAsItWas();
    void isAModelWithoutSections();
    void ofAModelTheNextSections();
    void whatIsNoStock();

private:
    QTemporaryDir m_folder;
};

namespace {

/// An offcut with a curved bay, and a hole.
SpareSheet bay()
{
    const auto ring = [](std::vector<Vec2> points) {
        return *Contour::fromPoints(std::move(points));
    };
    const Contour hole = *Contour::fromPolygon({{20, 20}, {20, 40}, {40, 40}, {40, 20}});
    return *spareSheet({ring({{0, 0},
                              {30, 0},
                              {60, 0}, // the lower edge
                              {90, 0},
                              {70, 40},
                              {90, 80}, // the bay
                              {90, 80},
                              {45, 80},
                              {0, 80}, // and back
                              {0, 80},
                              {0, 40},
                              {0, 10}}),
                        {hole},
                        false});
}

} // namespace

void TestStockFile::comesBackAsItWas()
{
    std::vector<Stock> stocks{birchPlywood(), flatfabAcrylic()};
    for (const Material &material : io::materialLibrary())
        stocks.insert(stocks.end(), material.stocks.begin(), material.stocks.end());
    for (Stock stock : stocks) {
        stock.thickness *= 0.97; // as measured
        stock.clearance = -0.05;
        stock.kerf = 0.17;
        stock.slitEnd = SlitEnd::Dogbone;
        stock.isMeasured = true;
        stock.kerfs = {{"k40", 0.17}, {"trotec", 0.125}};
        stock.sheetCount = 3;
        stock.spares = {*rectangularSheet({300.0, 200.0}, 2), bay()};
        const QString path = m_folder.filePath(u"one.fff"_s);
        QVERIFY(io::writeStock(path, stock));
        const auto read = io::readStock(path);
        QVERIFY(read);
        stock.id = {};
        QVERIFY(*read == stock);
    }
}

void TestStockFile::isAModelWithoutSections()
{
    const QString path = m_folder.filePath(u"ply.fff"_s);
    Stock stock = birchPlywood();
    stock.name = "Ply of room 7";
    QVERIFY(io::writeStock(path, stock));
    const auto read = io::readDocument(path);
    QVERIFY(read && read->document.sections.empty());
    QCOMPARE(read->document.stocks.size(), std::size_t(1));
    QCOMPARE(read->document.stocks.front()->name, stock.name);
}

void TestStockFile::ofAModelTheNextSections()
{
    Document document = newDocument();
    Stock acrylic = flatfabAcrylic();
    acrylic.name = "Ours";
    document = *addStock(document, acrylic);
    document = *addStock(document, birchPlywood());
    document = *setCurrentStock(document, document.stocks[1]->id);
    const QString path = m_folder.filePath(u"model.fff"_s);
    QVERIFY(io::writeDocument(path, document));
    const auto read = io::readStock(path);
    QVERIFY(read);
    QCOMPARE(read->name, std::string("Ours"));
}

void TestStockFile::whatIsNoStock()
{
    const auto missing = io::readStock(m_folder.filePath(u"none.fff"_s));
    QVERIFY(!missing && missing.error().code == ErrorCode::CannotOpen);
    QFile file(m_folder.filePath(u"bad.fff"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("plywood");
    file.close();
    QVERIFY(!io::readStock(file.fileName()));
    QVERIFY(!io::writeStock(m_folder.filePath(u"no/such/folder.fff"_s), birchPlywood()));
}

FFF_TEST(TestStockFile)
#include "tst_stock_file.moc"
