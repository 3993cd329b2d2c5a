// Layouts of real models' real outlines, held against Clipper; skipped where the models are not.
#include <QTest>

#include "core/analysis/analysis.h"
#include "core/fabrication/kerf.h"
#include "core/fabrication/layout.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "tests/test_program.h"

#include <QDir>

#include <numbers>
#include <polyclipping/clipper.hpp>

using namespace fff;

namespace {

const QString kFolder = QStringLiteral(FFF_SHARED_MODELS);
constexpr double kFineChord = 0.001; // mm: a tenth of what layouts go by
constexpr double kArc = 0.01;        // mm: chords of the round corners that growing makes
constexpr double kGrid = 1e5;        // Clipper's steps a mm

double areaOf(const ClipperLib::Paths &paths)
{
    double sum = 0.0;
    for (const ClipperLib::Path &path : paths)
        sum += ClipperLib::Area(path);
    return sum / (kGrid * kGrid);
}

/// The part's outline where it lies, grown by half the spacing.
ClipperLib::Paths grownOutline(const Part &part, const Placement &placement, double distance)
{
    ClipperLib::Path path;
    for (const Vec2 &p : part.outline.outer.flatten(kFineChord).points) {
        const Vec2 q = kGrid * placement.apply(p);
        path.emplace_back(std::llround(q.x()), std::llround(q.y()));
    }
    ClipperLib::ClipperOffset offset(2.0, kArc * kGrid);
    offset.AddPath(path, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    ClipperLib::Paths grown;
    offset.Execute(grown, distance * kGrid);
    return grown;
}

std::vector<Part> partsOf(const QString &file)
{
    Result<io::LoadedDocument> read = io::readDocument(kFolder + u'/' + file);
    AnalysisCaches caches;
    const Analysis analysis = analyse(evaluate(std::move(read->document)), caches);
    return *compensateKerf(makeParts(analysis.model, analysis.assembly, analysis.bodies),
                           analysis.model, analysis.bodies);
}

} // namespace

class TestLayoutModels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void noTwoPartsMeet_data();
    void noTwoPartsMeet();
    void turningSavesSheets();
};

void TestLayoutModels::noTwoPartsMeet_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<Vec2>("sheet");
    QTest::addColumn<double>("spacing");
    QTest::addColumn<bool>("turnsFreely");
    const QStringList files =
        QDir(kFolder).entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Name);
    for (const QString &file : files) {
        const QByteArray name = file.toUtf8();
        QTest::addRow("%s on its sheets", name.data()) << file << Vec2(600, 400) << 2.0 << true;
        QTest::addRow("%s on A4", name.data()) << file << Vec2(210, 297) << 5.0 << true;
        QTest::addRow("%s by quarter turns", name.data()) << file << Vec2(300, 300) << 1.0 << false;
    }
    if (files.empty())
        QTest::newRow("none") << QString() << Vec2(1, 1) << 0.0 << false;
}

// Outlines grown by half the spacing cover as much together as one by one, or some overlap; and
// none may leave the sheet's margin.
void TestLayoutModels::noTwoPartsMeet()
{
    QFETCH(QString, file);
    QFETCH(Vec2, sheet);
    QFETCH(double, spacing);
    QFETCH(bool, turnsFreely);
    if (file.isEmpty())
        FFF_WITHOUT_SHARED();
    const std::vector<Part> parts = partsOf(file);
    LayoutOptions options;
    options.sheet = sheet;
    options.spacing = spacing;
    options.turnsFreely = turnsFreely;
    Result<io::LoadedDocument> read = io::readDocument(kFolder + u'/' + file);
    const Layout layout = layOut(parts, evaluate(std::move(read->document)), options);
    std::vector<int> seen(parts.size(), 0);
    for (const Sheet &s : layout.sheets) {
        double sum = 0.0;
        ClipperLib::Clipper together;
        for (const Placement &placement : s.placements) {
            const Part &part = parts[static_cast<std::size_t>(placement.part)];
            ++seen[static_cast<std::size_t>(placement.part)];
            const ClipperLib::Paths grown = grownOutline(part, placement, 0.5 * spacing - kArc);
            sum += areaOf(grown);
            together.AddPaths(grown, ClipperLib::ptSubject, true);
            Box2 box;
            for (const ClipperLib::Path &path : grown)
                for (const ClipperLib::IntPoint &p : path)
                    box.extend(Vec2(static_cast<double>(p.X), static_cast<double>(p.Y)) / kGrid);
            const double room = options.margin - 0.5 * spacing - 1e-3;
            QVERIFY(box.min.minCoeff() > room && (s.size - box.max).minCoeff() > room);
        }
        ClipperLib::Paths all;
        QVERIFY(together.Execute(ClipperLib::ctUnion, all, ClipperLib::pftNonZero));
        QVERIFY2(std::abs(areaOf(all) - sum) < 1e-3,
                 qPrintable(QStringLiteral("%1 mm² overlap").arg(sum - areaOf(all))));
    }
    QVERIFY(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
}

// Wrong: turning would be a step back for somebody's model.
void TestLayoutModels::turningSavesSheets()
{
    const QStringList files =
        QDir(kFolder).entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Name);
    if (files.empty())
        FFF_WITHOUT_SHARED();
    std::size_t turned = 0, straight = 0;
    for (const QString &file : files) {
        const std::vector<Part> parts = partsOf(file);
        Result<io::LoadedDocument> read = io::readDocument(kFolder + u'/' + file);
        const Model model = evaluate(std::move(read->document));
        LayoutOptions options;
        const std::size_t free = layOut(parts, model, options).sheets.size();
        options.turnsFreely = false;
        const std::size_t quarter = layOut(parts, model, options).sheets.size();
        QVERIFY2(free <= quarter, qPrintable(file));
        turned += free;
        straight += quarter;
    }
    QVERIFY(turned < straight);
}

FFF_TEST(TestLayoutModels)
#include "tst_layout_models.moc"
