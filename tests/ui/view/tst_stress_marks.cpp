// Stresses and forces over the view: what is asked about, and what is said of it.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/stress_lines.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/scene.h"
#include "ui/view/stress_card.h"
#include "ui/view/stress_marks.h"

#include <QGuiApplication>
#include <QImage>

#include <cmath>

using namespace fff;
using namespace fff::test;
using namespace fff::ui;

namespace {

const Vec2 kSize(900.0, 700.0);

struct Loaded
{
    AnalysisPointer analysis;
    Strength strength;
    StressMarks marks;
    Camera camera;

    explicit Loaded(const char *sample, double factor = 1.0)
    {
        const auto file =
            io::readDocument(QStringLiteral(FFF_SAMPLES) + u'/' + QLatin1String(sample));
        Document document = file ? file->document : Document();
        for (Load &weight : document.loads)
            weight.mass *= factor;
        analysis = std::make_shared<const Analysis>(analysed(document));
        StrengthCaches caches;
        strength = strengthOf(*analysis, StrengthRules(), caches);
        marks = stressMarksOf(analysis, strength);
        camera = cameraFor(sceneOf(*analysis), "iso1", kSize);
    }
};

QImage painted(const StressMarks &marks, const Camera &camera)
{
    QImage image(900, 700, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const ViewStyle style;
    MarkPen pen(painter, camera, kSize, style);
    paintStress(pen, marks, ViewState(), QLocale::c());
    paintAskedLine(pen, marks, QLocale::c());
    return image;
}

} // namespace

class TestStressMarks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Wrong: a card that lies on the very place that it explains, or half beyond the edge.
    void theCardStandsBesideItsPlace()
    {
        QImage image(640, 480, QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        const ViewStyle style;
        const Vec2 view(640.0, 480.0);
        for (double x = 0.0; x <= view.x(); x += 32.0)
            for (double y = 0.0; y <= view.y(); y += 32.0) {
                MarkPen pen(painter, Camera(), view, style);
                const QPointF place(x, y);
                const QRectF all(0.0, 0.0, view.x(), view.y());
                const QRectF alone = cardPlace({300.0, 200.0}, place,
                                               QRectF(place, QSizeF()).adjusted(-9, -9, 9, 9), pen);
                QVERIFY(all.contains(alone));
                QVERIFY(!alone.adjusted(-12, -12, 12, 12).contains(place));
                // Of a section as large as the view it cannot keep off.
                const QRectF within = cardPlace({300.0, 200.0}, place, all, pen);
                QVERIFY(all.contains(within) && !within.adjusted(-12, -12, 12, 12).contains(place));
            }
        // There is room beside the section as well.
        MarkPen pen(painter, Camera(), view, style);
        const QRectF section(20.0, 100.0, 250.0, 300.0);
        QVERIFY(!cardPlace({300.0, 200.0}, {140.0, 240.0}, section, pen).intersects(section));
    }

    void theLineUnderTheCursor();
    void whatItSays();
    void feetBearTheWeight();
    void fewNumbersAreSaid();
    void forcesAtJointsAreOpposite();
    void whatIsNotKnownIsSaid();
    void allIsPaintedWhole();
    void linesWhereColoursCannotBeRead();
};

// Wrong: another line than the one that is pointed at, or one behind a section.
void TestStressMarks::theLineUnderTheCursor()
{
    const Loaded glass("glass_three_legs.fff");
    QVERIFY(glass.marks.lines.size() > 3);
    int found = 0;
    for (const StressLine &line : glass.marks.lines) {
        const Vec3 middle = 0.5 * (line.from + line.to);
        const Vec2 at = glass.camera.toScreen(middle, kSize);
        const int index =
            lineAt(QPointF(at.x(), at.y()), glass.marks, glass.camera, kSize, ViewState());
        if (index < 0)
            continue; // behind another section
        const StressLine &hit = glass.marks.lines[static_cast<std::size_t>(index)];
        QVERIFY(hit.section == line.section || hit.use > 0.0);
        ++found;
    }
    QVERIFY(found > 0);
    QCOMPARE(lineAt({1.0, 1.0}, glass.marks, glass.camera, kSize, ViewState()), -1);
    ViewState hidden;
    for (std::size_t i = 0; i < glass.analysis->model.sectionCount(); ++i)
        hidden.hidden.insert(glass.analysis->model.ref(i));
    for (const StressLine &line : glass.marks.lines) {
        const Vec2 at = glass.camera.toScreen(0.5 * (line.from + line.to), kSize);
        QCOMPARE(lineAt({at.x(), at.y()}, glass.marks, glass.camera, kSize, hidden), -1);
    }
}

// Wrong: numbers that are not those of the line.
void TestStressMarks::whatItSays()
{
    const Loaded glass("glass_three_legs.fff");
    for (const StressLine &line : glass.marks.lines) {
        const std::vector<StressRow> rows = stressRows(line, QLocale::c());
        QVERIFY(rows.size() >= 2);
        const NominalStress &stress = line.stress.stress;
        QVERIFY(rows[0].value.startsWith(QLocale::c().toString(stress.neck, 'g', 3)));
        const bool isAtCorner = stress.notch > 1.0;
        if (isAtCorner)
            QVERIFY(rows[1].value.endsWith(QLocale::c().toString(100.0 * line.use, 'f', 0) +
                                           QStringLiteral("\u202f%")));
        for (const StressRow &row : rows)
            QVERIFY(!row.what.isEmpty() && !row.value.contains(QStringLiteral("nan")));
        QVERIFY(!breaksFirst(line).isEmpty());
    }
}

// Wrong: an arrow without its force, or one that is not there.
void TestStressMarks::feetBearTheWeight()
{
    const Loaded glass("glass_four_legs.fff");
    double hanging = 0.0;
    for (const Load &weight : glass.analysis->model.document.loads)
        hanging += weight.mass;
    const double mass = glass.analysis->bodies.mass().mass + hanging;
    Vec3 sum = Vec3::Zero();
    for (const ForceMark &mark : footForces(glass.strength)) {
        QVERIFY(mark.foot >= 0);
        sum += mark.force;
    }
    // Feet that press with less than shows are left out.
    QVERIFY(std::abs(sum.y() - 9.81 * mass) < 0.05);
    const Loaded falling("cutlery_man.fff", 1e4);
    if (!areStressesKnown(falling.strength))
        QVERIFY(footForces(falling.strength).empty());
}

// Wrong: a model under numbers; three chips in a heap that say the same; a number under a badge,
// or pushed aside by it to where nothing acts.
void TestStressMarks::fewNumbersAreSaid()
{
    QImage image(900, 700, QImage::Format_ARGB32_Premultiplied);
    QPainter painter(&image);
    const ViewStyle style;
    Camera camera;
    camera.millimetresPerPixel = 1.0;
    const auto words = [&](const std::vector<ForceMark> &forces, const QRectF &covered = {}) {
        MarkPen pen(painter, camera, kSize, style);
        if (!covered.isEmpty())
            pen.keepFree(covered);
        paintForces(pen, forces, false, QLocale::c());
        return pen.paintChips();
    };
    std::vector<ForceMark> feet;
    for (int i = 0; i < 8; ++i)
        feet.push_back(
            {camera.target + Vec3(-280.0 + 80.0 * i, 0.0, 0.0), Vec3(0.0, 1.0 + i, 0.0), i});
    const std::vector<QRectF> five = words(feet);
    QCOMPARE(five.size(), std::size_t(5));
    for (const QRectF &box : five) // of the largest forces
        QVERIFY(box.center().x() > 0.5 * kSize.x() - 280.0 + 200.0);
    const std::vector<ForceMark> one{feet.front()};
    QCOMPARE(words(one).size(), std::size_t(1));
    QVERIFY(words(one, QRectF(150.0, 300.0, 60.0, 100.0)).empty());

    std::vector<ForceMark> open;
    for (int i = 0; i < 3; ++i)
        open.push_back(
            {camera.target + Vec3(20.0 * i, 10.0 * i, 0.0), Vec3::Zero(), -1, true, 1.0 + i});
    QCOMPARE(words(open).size(), std::size_t(1));
    open.back().at.x() += 200.0;
    QCOMPARE(words(open).size(), std::size_t(2));
    open.insert(open.end(), feet.begin(), feet.end());
    QCOMPARE(words(open).size(), std::size_t(5)); // of both in all
}

// Wrong: two sections that do not do the opposite to each other.
void TestStressMarks::forcesAtJointsAreOpposite()
{
    const Loaded chair("chair.fff");
    Vec3 all = Vec3::Zero();
    const int count = static_cast<int>(chair.analysis->model.sectionCount());
    std::size_t marks = 0;
    for (int section = 0; section < count; ++section)
        for (const ForceMark &mark : jointForces(*chair.analysis, chair.strength, section)) {
            all += mark.force;
            ++marks;
        }
    QVERIFY(marks > 4);
    QVERIFY(all.norm() < 1e-9);
    QCOMPARE(jointForces(*chair.analysis, chair.strength).size(), marks / 2);
}

// Wrong: that nothing is strained, of what nobody knows the strength of, or of what falls over.
void TestStressMarks::whatIsNotKnownIsSaid()
{
    const QLocale c = QLocale::c();
    QCOMPARE(withoutLines(Loaded("chair.fff").marks, c), QStringLiteral("Nothing above 20\u202f%"));
    const auto file =
        io::readDocument(QStringLiteral(FFF_SAMPLES) + QStringLiteral("/glass_three_legs.fff"));
    Document unrated = file->document;
    for (const auto &stock : file->document.stocks) {
        Stock changed = *stock;
        changed.tensileStrength.reset();
        changed.flexuralStrength.reset();
        unrated = *setStock(std::move(unrated), changed);
    }
    const auto wordsOf = [&](const Document &document) {
        const auto analysis = std::make_shared<const Analysis>(analysed(document));
        StrengthCaches caches;
        const StressMarks marks =
            stressMarksOf(analysis, strengthOf(*analysis, StrengthRules(), caches));
        return marks.lines.empty() ? withoutLines(marks, c) : QStringLiteral("lines");
    };
    QCOMPARE(wordsOf(file->document), QStringLiteral("lines"));
    QCOMPARE(wordsOf(unrated), QStringLiteral("Strength unknown"));
    // In the air.
    QCOMPARE(wordsOf(moveAll(file->document, Vec3(0, 50, 0))),
             QStringLiteral("It does not stand; no stress is shown."));
}

// Wrong: a card that runs out of the view.
void TestStressMarks::allIsPaintedWhole()
{
    Loaded glass("glass_three_legs.fff", 4.0);
    glass.marks.forces = footForces(glass.strength);
    const QImage plain = painted(glass.marks, glass.camera);
    for (int i = 0; i < static_cast<int>(glass.marks.lines.size()); i += 5) {
        glass.marks.lit = i;
        glass.marks.hasCard = false;
        const QImage ringed = painted(glass.marks, glass.camera);
        glass.marks.hasCard = true;
        const QImage carded = painted(glass.marks, glass.camera);
        QVERIFY(ringed != plain && carded != ringed);
        for (int x = 0; x < carded.width(); ++x) {
            QCOMPARE(carded.pixel(x, 0), plain.pixel(x, 0));
            QCOMPARE(carded.pixel(x, carded.height() - 1), plain.pixel(x, plain.height() - 1));
        }
    }
    glass.marks.lines.clear();
    glass.marks.lit = 3; // of what was there before
    QVERIFY(painted(glass.marks, glass.camera) != plain);
}

// Wrong: lines lie over colours that tell more, or a thin leg shows neither.
void TestStressMarks::linesWhereColoursCannotBeRead()
{
    Loaded glass("glass_three_legs.fff");
    StressMarks &marks = glass.marks;
    marks.forces.clear();
    const auto drawn = [&](double millimetresPerPixel) {
        int count = 0;
        for (const StressLine &line : marks.lines) {
            Camera camera = glass.camera;
            camera.target = 0.5 * (line.from + line.to);
            camera.millimetresPerPixel = millimetresPerPixel;
            const double side = line.normal.dot(camera.backward()) < 0.0 ? -1.0 : 1.0;
            const Vec2 at = camera.toScreen(camera.target + side * line.half * line.normal, kSize);
            count += painted(marks, camera)
                                 .pixelColor(static_cast<int>(at.x()), static_cast<int>(at.y())) !=
                             Qt::white
                         ? 1
                         : 0;
        }
        return count;
    };
    constexpr double kNear = 0.02, kFar = 8.0; // mm a pixel
    const int before = drawn(kNear);
    QVERIFY(before > 0);
    BentModel known;
    known.fields.assign(glass.analysis->bodies.size(),
                        std::make_shared<const StressField>(StressField()));
    marks.bent = std::make_shared<const BentModel>(std::move(known));
    QCOMPARE(drawn(kNear), 0);
    QVERIFY(drawn(kFar) > 0);
    marks.lit = static_cast<int>(marks.lines.size()) - 1; // what is asked about is always there
    QVERIFY(drawn(kNear) > 0);
}

FFF_TEST_WITH(TestStressMarks, fff::testing::runWithin<TestStressMarks, QGuiApplication>)
#include "tst_stress_marks.moc"
