// Materials from JSON. If this fails, a stock is not what its sheet is sold as.
#include "core/io/error_text.h"
#include "core/io/material_library.h"
#include "core/io/own_libraries.h"
#include "core/model/edits.h"
#include "core/model/machine_kerfs.h"
#include "tests/test_program.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <set>

using namespace fff;
using namespace Qt::Literals::StringLiterals;

class TestMaterialLibrary : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theLibraryIsInOrder();
    void whatHasNoSourceIsNotRated();
    void soldAndReal();
    void whatIsWrongIsSaidWithItsPlace_data();
    void whatIsWrongIsSaidWithItsPlace();
    void kerfsOfMachines();
    void onesOwnComeFirst(); // last: they stay
};

namespace {

void write(const QString &path, const QByteArray &text)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

const Material *named(std::string_view name)
{
    for (const Material &material : io::materialLibrary())
        if (material.name() == name)
            return &material;
    return nullptr;
}

} // namespace

/// Every stock of it can be added to a document, and each is there once.
void TestMaterialLibrary::theLibraryIsInOrder()
{
    std::set<std::pair<std::string, double>> seen;
    QVERIFY(io::materialLibrary().size() > 10);
    for (const Material &material : io::materialLibrary())
        for (const Stock &stock : material.stocks) {
            QVERIFY2(addStock(newDocument(), stock), material.name().c_str());
            QCOMPARE(stock.name, material.name());
            QVERIFY(!stock.isMeasured);
            QVERIFY2(seen.emplace(stock.name, stock.thickness).second, stock.name.c_str());
        }
}

void TestMaterialLibrary::whatHasNoSourceIsNotRated()
{
    for (const char *name :
         {"Corrugated board B", "Corrugated board C", "Corrugated board E", "Card"}) {
        const Stock &stock = named(name)->stocks.front();
        QVERIFY2(!stock.tensileStrength && !stock.flexuralStrength && !stock.modulus, name);
    }
    QVERIFY(!named("MDF")->stocks.front().tensileStrength);
    QVERIFY(!named("Aluminium 6061")->stocks.front().flexuralStrength);
}

void TestMaterialLibrary::soldAndReal()
{
    const Stock &ply = named("Birch plywood 4 mm")->stocks.front();
    QCOMPARE(ply.thickness, 3.8);
    QCOMPARE(ply.nominalThickness, std::optional(4.0));
    const std::vector<Stock> &mdf = named("MDF")->stocks;
    QCOMPARE(mdf.size(), std::size_t(2));
    QCOMPARE(mdf[1].thickness, 6.0);
    QVERIFY(!mdf[1].nominalThickness); // it is as thick as it is sold
    QVERIFY(mdf[0].kerf < mdf[1].kerf);
}

void TestMaterialLibrary::whatIsWrongIsSaidWithItsPlace_data()
{
    QTest::addColumn<QByteArray>("json");
    QTest::addColumn<QString>("place");
    const auto row = [](const char *name, const char *material, const char *place) {
        QTest::newRow(name) << QByteArray(R"({"materials": [)") + material + "]}"
                            << QString::fromLatin1(place);
    };
    row("no thickness at all",
        R"({"name": "A", "density": 700, "sheet": [600, 400], "thicknesses": []})",
        "own.json:$.materials[0]");
    row("a thickness below 0",
        R"({"name": "A", "density": 700, "sheet": [600, 400], "thicknesses": [{"sold": -3, "kerf": 0}]})",
        "own.json:$.materials[0].thicknesses[0].sold");
    row("no kerf",
        R"({"name": "A", "density": 700, "sheet": [600, 400], "thicknesses": [{"sold": 3}]})",
        "own.json:$.materials[0].thicknesses[0].kerf");
    row("a sheet without width",
        R"({"name": "A", "density": 700, "sheet": [0, 400], "thicknesses": [{"sold": 3, "kerf": 0}]})",
        "own.json:$.materials[0].thicknesses[0]");
    row("a name twice",
        R"({"name": "A", "density": 700, "sheet": [6, 4], "thicknesses": [{"sold": 3, "kerf": 0}]},
           {"name": "A", "density": 700, "sheet": [6, 4], "thicknesses": [{"sold": 3, "kerf": 0}]})",
        "own.json:$.materials[1]");
}

void TestMaterialLibrary::whatIsWrongIsSaidWithItsPlace()
{
    QFETCH(QByteArray, json);
    QFETCH(QString, place);
    const auto read = io::readMaterials(json.toStdString(), "own.json");
    QVERIFY(!read);
    QCOMPARE(QString::fromStdString(read.error().place), place);
    QVERIFY(!io::errorText(read.error()).isEmpty());
}

/// What is set for one machine is what is cut for it, and for no other.
void TestMaterialLibrary::kerfsOfMachines()
{
    Stock stock = birchPlywood();
    const double before = stock.kerf;
    setKerf(stock, "trotec", 0.12);
    setKerf(stock, "k40", 0.2);
    setKerf(stock, "", 0.3);
    QCOMPARE(stock.kerf, 0.3);
    QCOMPARE(kerfOn(stock, "trotec"), std::optional(0.12));
    QCOMPARE(kerfOn(stock, "k40"), std::optional(0.2));
    QVERIFY(!kerfOn(stock, "lightburn") && !kerfOn(stock, ""));
    setKerf(stock, "k40", 0.25);
    QCOMPARE(stock.kerfs.size(), std::size_t(2));
    Document document = newDocument();
    stock.id = document.currentStock;
    stock.kerf = before;
    const Result<Document> known = setStock(document, stock);
    QVERIFY(known);
    QCOMPARE(cutOn(*known, "k40").stocks.front()->kerf, 0.25);
    QCOMPARE(cutOn(*known, "nobody's").stocks.front()->kerf, before);
    QVERIFY(cutOn(*known, "nobody's").isSame(*known));
}

void TestMaterialLibrary::onesOwnComeFirst()
{
    const QTemporaryDir folder;
    QVERIFY(io::addOwnLibraries(folder.path()).empty()); // where there are none
    write(folder.filePath(u"machines.json"_s), R"({"machines": []})");
    write(folder.filePath(u"materials.json"_s),
          R"({"materials": [{"name": "MDF", "density": 750, "sheet": [800, 600], "price": 9.5,
                             "thicknesses": [{"sold": 3, "real": 2.9, "kerf": 0.2,
                                              "kerfs": {"k40": 0.22, "generic": 0.2}}]}]})");
    const std::vector<Error> wrong = io::addOwnLibraries(folder.path());
    QCOMPARE(wrong.size(), std::size_t(1)); // of the machines, of which none is there
    QCOMPARE(io::materialLibrary().front().name(), std::string("MDF"));
    const Stock &own = named("MDF")->stocks.front();
    QCOMPARE(own.thickness, 2.9);
    QCOMPARE(own.price, std::optional(9.5));
    QCOMPARE(own.kerf, 0.2);
    QCOMPARE(kerfOn(own, "k40"), std::optional(0.22));
    QCOMPARE(named("MDF")->stocks.size(), std::size_t(1)); // in place of that which came along
}

FFF_TEST(TestMaterialLibrary)
#include "tst_material_library.moc"
