// A stock as a file: what one person measured is what another one cuts with.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/io/document_file.h"
#include "core/io/stock_file.h"
#include "core/model/edits.h"
#include "core/model/materials.h"
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

void TestStockFile::comesBackAsItWas()
{
    std::vector<Stock> stocks{birchPlywood(), flatfabAcrylic()};
    for (const Material &material : materials())
        stocks.push_back(material.stock);
    for (Stock stock : stocks) {
        stock.thickness *= 0.97; // as measured
        stock.clearance = -0.05;
        stock.kerf = 0.17;
        stock.slitEnd = SlitEnd::Dogbone;
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
