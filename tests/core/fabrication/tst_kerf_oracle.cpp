#include "core/fabrication/kerf.h"
#include "core/io/cutting_file.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/core/fabrication/spiky_outlines.h"
#include "tests/core/fabrication/swept_disc_oracle.h"
#include "tests/test_program.h"

#include <QDir>
#include <QTest>

using namespace fff;
using namespace fff::test;

namespace {

constexpr double kKerfs[] = {0.05, 0.1, 0.2, 0.5, 3.0};
constexpr double kClearances[] = {-0.1, 0.0, 0.1};
constexpr unsigned kOutlines = 300;

double areaOf(const CurvedRegion &region)
{
    double sum = region.outer.signedArea();
    for (const Contour &hole : region.holes)
        sum += hole.signedArea();
    return sum;
}

/// The model with this clearance and kerf in all its stocks.
Analysis analysed(Document document, double clearance, double kerf)
{
    for (auto &stock : document.stocks) {
        Stock changed = *stock;
        changed.clearance = clearance;
        changed.kerf = kerf;
        stock = std::make_shared<const Stock>(changed);
    }
    AnalysisCaches caches;
    return analyse(evaluate(std::move(document)), caches);
}

} // namespace

class TestKerfOracle : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void spikyOutlines_data();
    void spikyOutlines();
    void models_data();
    void models();
};

void TestKerfOracle::spikyOutlines_data()
{
    QTest::addColumn<unsigned>("first");
    for (unsigned first = 0; first < kOutlines; first += 50)
        QTest::addRow("seeds %u to %u", first, first + 49) << first;
}

// Wrong: somewhere the tool would enter a part, or leave what it can take away, or the path would
// cross itself, and the file would say that the kerf is applied.
void TestKerfOracle::spikyOutlines()
{
    QFETCH(unsigned, first);
    int judged = 0, refused = 0;
    for (unsigned seed = first; seed < first + 50; ++seed) {
        for (const double clearance : kClearances) {
            const auto outline = SpikyOutlines(seed).next(clearance);
            if (!outline)
                continue;
            double before = areaOf(outline->region);
            for (const double kerf : kKerfs) {
                const QByteArray row =
                    QStringLiteral("%1, seed %2, clearance %3, kerf %4")
                        .arg(QString::fromStdString(outline->name), QString::number(seed),
                             QString::number(clearance), QString::number(kerf))
                        .toUtf8();
                const auto path = compensateKerf(outline->region, kerf);
                if (!path) {
                    QCOMPARE(path.error().code, ErrorCode::CannotOffset);
                    qInfo("refused: %s", row.constData());
                    ++refused;
                    continue;
                }
                ++judged;
                const QString fault = SweptDiscOracle(outline->region, *path, 0.5 * kerf).verdict();
                QVERIFY2(fault.isEmpty(),
                         qPrintable(QString::fromUtf8(row) + QStringLiteral(": ") + fault));
                QVERIFY2(areaOf(*path) > before, row.constData());
                before = areaOf(*path);
            }
        }
    }
    qInfo("%d judged, %d refused", judged, refused);
    QVERIFY(refused * 50 <= judged); // contours that cross themselves finer than they are resolved
}

void TestKerfOracle::models_data()
{
    QTest::addColumn<QString>("path");
    for (const char *folder : {FFF_SHARED_MODELS, FFF_TEST_DATA "/../../resources/samples"}) {
        const QDir models(QString::fromUtf8(folder));
        for (const QFileInfo &file :
             models.entryInfoList({QStringLiteral("*.txt"), QStringLiteral("*.fff")}))
            QTest::newRow(qPrintable(file.fileName())) << file.filePath();
    }
}

// Wrong: the same, of what people cut; and a section that is refused without its name.
void TestKerfOracle::models()
{
    QFETCH(QString, path);
    const auto read = io::readDocument(path);
    QVERIFY(read);
    int judged = 0, refused = 0;
    for (const double clearance : kClearances) {
        const Analysis analysis = analysed(read->document, clearance, 0.2);
        for (std::size_t i = 0; i < analysis.cuts.size(); ++i) {
            const std::string &name = analysis.model.section(i)->name;
            const std::vector<CurvedRegion> &parts = analysis.cuts[i]->parts();
            std::vector<double> before;
            for (const CurvedRegion &part : parts)
                before.push_back(areaOf(part));
            for (const double kerf : kKerfs) {
                const auto paths = analysis.cuts[i]->compensated(kerf);
                if (!paths) {
                    qInfo("refused: %s, clearance %g, kerf %g", name.c_str(), clearance, kerf);
                    ++refused;
                    QVERIFY(kerf > 0.5); // a laser's is for every model
                    continue;
                }
                for (std::size_t k = 0; k < parts.size(); ++k) {
                    ++judged;
                    const CurvedRegion &outline = (**paths)[k];
                    const QString fault = SweptDiscOracle(parts[k], outline, 0.5 * kerf).verdict();
                    const QString row = QStringLiteral("%1, clearance %2, kerf %3: %4")
                                            .arg(QString::fromStdString(name))
                                            .arg(clearance)
                                            .arg(kerf)
                                            .arg(fault);
                    QVERIFY2(fault.isEmpty(), qPrintable(row));
                    QVERIFY2(areaOf(outline) > before[k], qPrintable(row));
                    before[k] = areaOf(outline);
                }
            }
        }
    }
    qInfo("%d judged, %d refused", judged, refused);
    // A kerf that is wider than the slits is refused by name.
    const Analysis wide = analysed(read->document, 0.0, 100.0);
    const auto file = io::makeCuttingFile(wide);
    const bool hasSlit = std::any_of(wide.assembly.slits.begin(), wide.assembly.slits.end(),
                                     [](const auto &slits) { return !slits.empty(); });
    QCOMPARE(!file, hasSlit);
    QVERIFY(file || (!file.error().args.empty() && !file.error().args[0].empty()));
}

FFF_TEST(TestKerfOracle)
#include "tst_kerf_oracle.moc"
