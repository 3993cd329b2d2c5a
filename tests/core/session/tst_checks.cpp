#include <QTest>

#include "core/analysis/checks.h"
#include "core/analysis/footing.h"
#include "core/assembly/settling.h"
#include "core/base/units.h"
#include "core/io/document_file.h"
#include "core/operations/evaluate.h"
#include "core/session/finding_text.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/assembly/settle_oracle.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

Document named(Document document, const char *name)
{
    Section section = *document.sections.back();
    section.name = name;
    document.sections.back() = std::make_shared<const Section>(section);
    return document;
}

/// Two crossed plates on the ground, 100 x 60.
Document cross()
{
    const ShapePointer plate = polygonShape(rectangle(-50, 0, 50, 60));
    return named(
        withSection(named(withSection(newDocument(), plate, front()), "Body"), plate, side()),
        "Rib");
}

/// The first of the kind, of this model.
Footing footingOf(const std::vector<Finding> &all, const FindingKind &kind)
{
    return *find(all, kind)->details<Footing>();
}

QString textOf(const Analysis &analysis, const FindingKind &kind)
{
    const std::vector<Finding> all = checks(analysis);
    const Finding *finding = find(all, kind);
    return finding ? findingText(*finding, analysis.model).replace(QChar(0x202f), u' ') : QString();
}

} // namespace

class TestChecks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void goodModelHasGoodChecksOnly();
    void emptyModelHasNone();
    void wordsOfFallingOver_data();
    void wordsOfFallingOver();
    void looseSectionIsFarFromTheRest();
    void looseGroupStandsByItself();
    void plateOnEdgeIsNotFirm();
    void weightsTip();
    void heightsInWords();
    void tooLargeParts();
    void jointsThatCannotSlide();
    void slitsThatDivide();
    void whatAnEditLeavesIsKept();
    void turnedModelsHaveTurnedAnswers();
    void mechanicsCases();
    void sharedModels_data();
    void sharedModels();
};

void TestChecks::initTestCase()
{
    QLocale::setDefault(QLocale::c());
}

// A badge that is red over a sound model is soon looked at by no one.
void TestChecks::goodModelHasGoodChecksOnly()
{
    const Analysis analysis = analysed(cross());
    const std::vector<Finding> all = checks(analysis);
    for (const Finding &finding : all) {
        QCOMPARE(finding.severity, Severity::Good);
        QVERIFY(finding.sections.empty());
        QVERIFY(!messageText(finding.kind->title).isEmpty());
    }
    for (const Subject subject :
         {Subject::Connection, Subject::Stability, Subject::Size, Subject::Mass})
        QCOMPARE(worst(all, subject).value(), Severity::Good);
    QVERIFY(!worst(all, Subject::Joints));
    QCOMPARE(textOf(analysis, kConnected), QStringLiteral("Connected. Both sections, by 1 joint."));
    QCOMPARE(textOf(analysis, kStands),
             QStringLiteral("Stands. Tips only past 50°. Margin 36.4 mm."));
    QCOMPARE(textOf(analysis, kFitsSheet),
             QStringLiteral("Fits the sheet. 1 sheet of 600 × 400 mm."));
    QCOMPARE(textOf(analysis, kMass),
             QStringLiteral("Mass 23.4 g. The centre of mass lies 30 mm above the ground."));
}

void TestChecks::emptyModelHasNone()
{
    QVERIFY(checks(analysed(newDocument())).empty());
}

void TestChecks::wordsOfFallingOver_data()
{
    QTest::addColumn<double>("turn"); // of a model that leans to the right
    QTest::addColumn<QString>("words");
    QTest::newRow("right") << 0.0 << QStringLiteral("to its right.");
    QTest::newRow("back") << 90.0 << QStringLiteral("backwards.");
    QTest::newRow("left") << 180.0 << QStringLiteral("to its left.");
    QTest::newRow("front") << 270.0 << QStringLiteral("forwards.");
}

// Who mends the model must be told on the right side of it.
void TestChecks::wordsOfFallingOver()
{
    QFETCH(double, turn);
    QFETCH(QString, words);
    // A foot from 0 to 30, all the weight in a bar from 30 to 90 high above: and one across.
    const ShapePointer leaning = polygonShape(
        {{-5, 0}, {6, 0}, {6, 2}, {1, 2}, {1, 40}, {60, 40}, {60, 60}, {0, 60}, {0, 2}, {-5, 2}});
    const ShapePointer foot = polygonShape(rectangle(-20, 0, 20, 2));
    const Frame along = turned(radians(turn));
    Frame across = along;
    across.x = along.normal();
    across.origin = along.toWorld({0.5, 0});
    const Analysis analysis =
        analysed(withSection(withSection(newDocument(), leaning, along), foot, across));
    const std::vector<Finding> all = checks(analysis);
    const Finding *finding = find(all, kTopples);
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Error);
    // By hand: bar 59 x 20 at 30.5, post 1 x 60 at 0.5, less what the slits take; the foot reaches
    // to half a thickness beside the post's middle.
    const Footing &footing = *finding->details<Footing>();
    const double expected = std::hypot(footing.mass.centre.x(), footing.mass.centre.z()) - 6.0;
    QVERIFY2(std::abs(-footing.margin - expected) < 0.2,
             qPrintable(QString::number(footing.margin)));
    const QString text = textOf(analysis, kTopples);
    QVERIFY2(text.startsWith(QStringLiteral("Falls over ") + words), qPrintable(text));
}

// "Not connected" alone leaves one looking for which, and how far.
void TestChecks::looseSectionIsFarFromTheRest()
{
    const Document document =
        named(withSection(cross(), polygonShape(rectangle(-10, 100, 10, 120)), front(30)), "Spike");
    const Analysis analysis = analysed(document);
    const std::vector<Finding> all = checks(analysis);
    QVERIFY(all.front().is(kNotConnected)); // said first
    const Finding &finding = all.front();
    QCOMPARE(finding.sections, std::vector<SectionRef>{document.sections[2]->id});
    const Gap &gap = *finding.details<Gap>();
    QVERIFY(gap.other && finding.at);
    // To Rib, which runs to the back and front in the plane x = 0: 40 mm above its upper edge.
    QVERIFY(std::abs(gap.distance - 40.0) < 1e-9);
    QCOMPARE(*gap.other, SectionRef(document.sections[1]->id));
    QCOMPARE(textOf(analysis, kNotConnected),
             QStringLiteral("Nothing touches Spike. It is 40 mm away from Rib."));
    // What hangs in the air because nothing holds it is not named twice.
    QVERIFY(find(all, kStands) && !find(all, kNoContact));
    QCOMPARE(footingOf(all, kStands).sections, 2);
    QVERIFY(textOf(analysis, kStands).startsWith(QStringLiteral("Body and Rib: Stands")));
}

// Two things on one table: one of them falls.
void TestChecks::looseGroupStandsByItself()
{
    const ShapePointer leaning =
        polygonShape({{200, 0}, {203, 0}, {203, 40}, {260, 40}, {260, 60}, {200, 60}});
    const Analysis analysis = analysed(withSection(cross(), leaning, front()));
    const std::vector<Finding> all = checks(analysis);
    const Finding *topples = find(all, kTopples);
    QVERIFY(topples && find(all, kNotConnected));
    QCOMPARE(topples->sections.size(), 1U);
    QVERIFY(!find(all, kStands)); // good is not said while something falls
}

// A single plate on its edge stands in theory only.
void TestChecks::plateOnEdgeIsNotFirm()
{
    const Analysis analysis =
        analysed(withSection(newDocument(), polygonShape(rectangle(-80, 0, 80, 60)), front()));
    const std::vector<Finding> all = checks(analysis);
    const Finding *finding = find(all, kUnsteady);
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Warning);
    QCOMPARE(textOf(analysis, kUnsteady),
             QStringLiteral("Barely stands: tilted by 2° it tips over. Margin 1.5 mm."));
}

void TestChecks::weightsTip()
{
    Document document = cross();
    const auto add = [&](const Vec2 &at) {
        document.loads.push_back({LoadId{document.nextId++}, document.sections[0]->id, at, 5.0});
    };
    add({45, 30});
    QVERIFY(find(checks(analysed(document)), kUnsteady) ||
            find(checks(analysed(document)), kStands));
    document.loads.clear();
    document.sections[0] = cross().sections[0];
    add({90, 30}); // beyond the foot, as on an arm
    const Stability found = stabilityOf(analysed(document), {0, 1});
    QCOMPARE(found.standing, Standing::Topples);
    QVERIFY(found.margin < -35.0 && found.fall.x() > 0.99);
}

void TestChecks::heightsInWords()
{
    const auto at = [](double height) {
        const ShapePointer plate = polygonShape(rectangle(-50, height, 50, height + 60));
        return analysed(
            named(withSection(withSection(newDocument(), plate, front()), plate, side()), "Rib"));
    };
    QCOMPARE(textOf(at(12.5), kNoContact),
             QStringLiteral("Not on the ground. Its lowest point is 12.5 mm above it."));
    QCOMPARE(textOf(at(-3), kBelowGround),
             QStringLiteral("In the ground. Section 1 and Rib reach up to 3 mm below it."));
}

void TestChecks::tooLargeParts()
{
    const Analysis analysis = analysed(onSheets(cross(), {100, 90}));
    const std::vector<Finding> all = checks(analysis);
    QCOMPARE(
        std::count_if(all.begin(), all.end(), [](const Finding &c) { return c.is(kTooLarge); }), 2);
    QVERIFY(!find(all, kFitsSheet));
    QCOMPARE(textOf(analysis, kTooLarge),
             QStringLiteral("Body measures 100 × 60 mm and fits no sheet of 100 × 90 mm with a "
                            "margin of 5 mm, however it is turned."));
    // A long thin one fits from corner to corner.
    const Document stick =
        withSection(newDocument(), polygonShape(rectangle(0, 0, 110, 4)), front());
    QVERIFY(find(checks(analysed(onSheets(stick, {100, 90}))), kFitsSheet));
    QVERIFY(find(checks(analysed(onSheets(stick, {90, 70}))), kTooLarge));
}

void TestChecks::jointsThatCannotSlide()
{
    // Each meets the other between its own windows: neither can open its slit to the outside.
    const auto windows = [](double outer, double from, double to) {
        return polygonShape(rectangle(-30, -outer, 30, outer),
                            {rectangle(-10, -to, 10, -from), rectangle(-10, from, 10, to)});
    };
    const Analysis held = analysed(withSection(
        withSection(newDocument(), windows(50, 10, 40), front()), windows(30, 8, 20), side()));
    QCOMPARE(held.assembly.joints.size(), 1U);
    QCOMPARE(held.assembly.joints[0].kind, JointKind::None);
    const std::vector<Finding> found = checks(held);
    QVERIFY(find(found, kNoSlit));
    QCOMPARE(find(found, kNoSlit)->severity, Severity::Error); // nobody can make that
    QCOMPARE(find(found, kNoSlit)->details<MissingSlit>()->overlap, 16.0);
    // They touch, and yet nothing holds them together.
    QVERIFY(
        textOf(held, kNotConnected).endsWith(QStringLiteral("but nothing holds them together.")));

    const Analysis shallow = analysed(
        withSection(withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front()),
                    polygonShape(rectangle(-50, 0, 50, 60)), turned(radians(24))));
    const std::vector<Finding> all = checks(shallow);
    const Finding *finding = find(all, kShallowAngle);
    QVERIFY(finding);
    QCOMPARE(finding->severity, Severity::Warning);
    QVERIFY(textOf(shallow, kShallowAngle).contains(QStringLiteral("at 24°")));
}

void TestChecks::slitsThatDivide()
{
    // A low bar under a high plate that reaches beyond it on both sides: the slit goes through.
    const ShapePointer bar = polygonShape(rectangle(-50, 20, 50, 22));
    const ShapePointer high = polygonShape(rectangle(-40, 0, 40, 60));
    const Analysis analysis =
        analysed(withSection(withSection(newDocument(), high, front()), bar, side()));
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t parts = analysis.cuts[i]->parts().size();
        const std::vector<Finding> all = checks(analysis);
        const auto divided = std::count_if(all.begin(), all.end(), [&](const Finding &c) {
            return c.is(kDivided) && c.sections.front() == analysis.model.ref(i);
        });
        QCOMPARE(divided, parts > 1 ? 1 : 0);
    }
}

// A verdict must not hang on where the model stands or how it is turned about the vertical.
// Wrong: an edit of a spine would lay out all ribs and go round all feet anew, or what is kept of
// them would not be what there is.
void TestChecks::whatAnEditLeavesIsKept()
{
    constexpr int kRibs = 12;
    const auto comb = [](double top, double foot) {
        const double length = 30.0 * (kRibs + 1);
        Document document = withSection(
            newDocument(), polygonShape({{0, 0}, {length + foot, 0}, {length, 40}, {0, 40 + top}}),
            front());
        const ShapePointer rib = polygonShape(rectangle(-30, 0, 30, 50));
        for (int i = 1; i <= kRibs; ++i)
            document = withSection(std::move(document), rib, side(30.0 * i));
        return document;
    };
    AnalysisCaches caches;
    CheckCaches known;
    const auto check = [&](const Document &document) {
        const AnalysisPointer analysis = analyseNext(evaluate(document), caches);
        const std::vector<Finding> ours = checks(*analysis, known), all = checks(*analysis);
        if (ours.size() != all.size())
            return false;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (exactly(ours[i], analysis->model) != exactly(all[i], analysis->model))
                return false;
        return true;
    };
    QVERIFY(check(comb(0.0, 0.0)));
    // All slits a little deeper: other parts, as large and on the same feet.
    const Document first = onSheets(comb(0.0, 0.0), {300, 200});
    const Document deeper = onSheets(comb(0.3, 0.0), {300, 200});
    QVERIFY(check(first));
    const auto before = caches.last->cuts;
    const auto sheets = known.layout.stocks.front().sheets;
    const int since = known.stances.front().since;
    QVERIFY(check(deeper));
    QVERIFY(caches.last->cuts[kRibs / 2] != before[kRibs / 2]);
    QVERIFY(known.layout.stocks.front().sheets == sheets);
    QCOMPARE(known.stances.front().since, since);
    // A longer foot carries farther out; another sheet holds fewer.
    QVERIFY(check(onSheets(comb(0.3, 8.0), {300, 200})));
    QVERIFY(known.stances.front().since != since);
    QVERIFY(check(onSheets(comb(0.3, 8.0), {250, 160})));
    QVERIFY(known.layout.stocks.front().sheets != sheets);
    // Gone, and back again.
    QVERIFY(check(cross()));
    QVERIFY(check(deeper));
}

void TestChecks::turnedModelsHaveTurnedAnswers()
{
    const Document document = cross();
    const Stability before = stabilityOf(analysed(document), {0, 1});
    for (const double angle : {0.3, 1.0, 2.5}) {
        const Eigen::AngleAxisd turn(angle, Vec3::UnitY());
        Document moved = document;
        for (SectionPointer &pointer : moved.sections) {
            Section section = *pointer;
            section.frame = makeFrame(turn * section.frame.origin + Vec3(300, 0, -70),
                                      turn * section.frame.x, turn * section.frame.y)
                                .value();
            pointer = std::make_shared<const Section>(section);
        }
        const Stability after = stabilityOf(analysed(moved), {0, 1});
        QCOMPARE(after.standing, before.standing);
        QCOMPARE(after.contacts, before.contacts);
        QVERIFY(std::abs(after.margin - before.margin) < 1e-9);
        QVERIFY(std::abs(after.tipAngle - before.tipAngle) < 1e-9);
    }
}

// Hand-checked structures of the product's mechanics, read in place: mass, and where the resultant
// of weight and loads lies.
void TestChecks::mechanicsCases()
{
    const QDir folder(QStringLiteral(FFF_SHARED_MODELS "/../mechanics/cases"));
    const QStringList files =
        folder.entryList({QStringLiteral("c*.json")}, QDir::Files, QDir::Name);
    if (files.empty())
        FFF_WITHOUT_SHARED();
    const auto point = [](const QJsonValue &v) {
        // Their z is up; ours is y.
        const QJsonArray a = v.toArray();
        return Vec3(a[0].toDouble(), a[2].toDouble(), -a[1].toDouble());
    };
    const auto polygon = [](const QJsonValue &v) {
        Polygon result;
        for (const QJsonValue &p : v.toArray())
            result.emplace_back(p[0].toDouble(), p[1].toDouble());
        return result;
    };
    int toppling = 0, floating = 0, compared = 0;
    for (const QString &name : files) {
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject json = QJsonDocument::fromJson(file.readAll()).object();
        const QJsonObject truth = json[QLatin1String("truth")].toObject();
        Document document = newDocument();
        Stock stock = *document.stocks.front();
        const QJsonArray sections = json[QLatin1String("sections")].toArray();
        stock.density = json[QLatin1String("material")][QLatin1String("density_kg_m3")].toDouble();
        stock.thickness = sections[0][QLatin1String("thickness_mm")].toDouble();
        document = *setStock(document, stock);
        for (const QJsonValue &value : sections) {
            const QJsonValue frame = value[QLatin1String("frame")];
            std::vector<Polygon> holes;
            for (const QJsonValue &hole : value[QLatin1String("holes_mm")].toArray())
                holes.push_back(polygon(hole));
            document = withSection(
                document, polygonShape(polygon(value[QLatin1String("outline_mm")]), holes),
                makeFrame(point(frame[QLatin1String("origin_mm")]),
                          point(frame[QLatin1String("u")]), point(frame[QLatin1String("v")]))
                    .value());
        }
        constexpr double kGravity = 9.81;
        for (const QJsonValue &load : json[QLatin1String("loads")].toArray()) {
            const Vec3 force = point(load[QLatin1String("force_N")]);
            int host = 0;
            for (int i = 0; i < sections.size(); ++i)
                if (sections[i][QLatin1String("id")] == load[QLatin1String("section")])
                    host = i;
            const Section &section = *document.sections[static_cast<std::size_t>(host)];
            document.loads.push_back({LoadId{document.nextId++}, section.id,
                                      section.frame.toLocal(point(load[QLatin1String("point_mm")])),
                                      -force.y() / kGravity});
        }
        const Analysis analysis = analysed(document);
        const auto groups = heldGroups(analysis);
        const QString verdict = truth[QLatin1String("verdict")].toString();
        if (verdict == QStringLiteral("topples")) {
            ++toppling;
            const Stability found = stabilityOf(analysis, groups.front());
            QVERIFY2(found.standing == Standing::Topples, qPrintable(name));
            // Theirs is to a foot's middle, ours to its corner: half the foot between them.
            const double difference = found.margin - truth[QLatin1String("margin_mm")].toDouble();
            QVERIFY2(difference > -0.5 && difference < 6.0,
                     qPrintable(QStringLiteral("%1: %2").arg(name).arg(found.margin)));
        }
        if (verdict == QStringLiteral("floating component")) {
            ++floating;
            const std::vector<Finding> all = checks(analysis);
            QVERIFY(all.front().is(kNotConnected));
            QCOMPARE(all.front().sections, std::vector<SectionRef>{document.sections.back()->id});
            QCOMPARE(all.front().details<Gap>()->distance, 57.0); // 120 − 3 − 60
        }
        if (verdict.isEmpty() && truth.contains(QLatin1String("mass_kg"))) {
            ++compared;
            const double mass = analysis.bodies.mass().mass,
                         expected = truth[QLatin1String("mass_kg")].toDouble();
            QVERIFY2(std::abs(mass - expected) < 0.02 * expected,
                     qPrintable(QStringLiteral("%1: %2 kg").arg(name).arg(mass)));
        }
    }
    QCOMPARE(toppling, 1);
    QCOMPARE(floating, 1);
    qInfo("masses compared: %d", compared);
}

void TestChecks::sharedModels_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("kind");
    const auto row = [](const char *name, const FindingKind &kind) {
        QTest::newRow(name) << QString::fromLatin1(name) << QByteArray(kind.name);
    };
    row("ant.txt", kNoContact);
    row("bridge.txt", kStands);
    row("centipede.txt", kStands);
    row("dino.txt", kStands);
    row("dragon1.txt", kStands);
    row("fish.txt", kNoContact);
    row("gearspider_holes.txt", kBelowGround);
    row("man.txt", kStands);
    row("octopus.txt", kNoContact);
    row("physics_shape1.txt", kStands);
    row("physics_shape3.txt", kStands);
    row("physics_shape5.txt", kStands);
    row("spider.txt", kStands);
    row("teaser_waterglass1.txt", kStands);
    row("teaser_waterglass2.txt", kLineSupport);
}

// Verdicts on real models, looked at by eye once; and how they rest again by the way of least
// energy, over the corners of both faces of every part.
void TestChecks::sharedModels()
{
    QFETCH(QString, file);
    QFETCH(QByteArray, kind);
    const QString path = QStringLiteral(FFF_SHARED_MODELS "/") + file;
    if (!QFile::exists(path))
        FFF_WITHOUT_SHARED();
    Result<io::LoadedDocument> read = io::readDocument(path);
    QVERIFY(read);
    const Analysis analysis = analysed(read->document);
    const std::vector<Finding> all = checks(analysis);
    const auto finding = std::find_if(
        all.begin(), all.end(), [&kind](const Finding &one) { return one.kind->name == kind; });
    QVERIFY(finding != all.end());
    if (!finding->is(kStands) && !finding->is(kTopples))
        return;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < analysis.model.sectionCount(); ++i) {
        const Frame &frame = analysis.model.section(i)->frame;
        const Vec3 half = 0.5 * analysis.model.stockOf(i).thickness * frame.normal();
        for (const CurvedRegion &part : analysis.cuts[i]->parts())
            for (const Vec2 &corner : part.region.outer)
                for (const double side : {-1.0, 1.0})
                    points.push_back(frame.toWorld(corner) + side * half);
    }
    const Footing &footing = *finding->details<Footing>();
    const SettleOracle oracle(points, footing.mass.centre);
    QCOMPARE(finding->is(kStands), oracle.lean() < kFarthestLean);
    if (!finding->is(kStands))
        return;
    // What is told to stand may stand better, never worse.
    const double tip = oracle.tipAngle();
    QVERIFY2(footing.tipAngle < tip + radians(1.0) && footing.tipAngle > 0.5 * tip,
             qPrintable(QStringLiteral("%1 by hand, %2")
                            .arg(degrees(tip))
                            .arg(degrees(footing.tipAngle))));
    QVERIFY(std::abs(footing.lean - oracle.lean()) < radians(0.5));
}

FFF_TEST(TestChecks)
#include "tst_checks.moc"
