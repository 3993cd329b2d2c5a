// Where a section is strong enough, against weights that are really put there.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/asked_bearing.h"
#include "core/analysis/holding.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"
#include "core/session/scheduler.h"
#include "core/session/session.h"
#include "tests/core/shapes.h"
#include "tests/test_program.h"

#include <cmath>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

Document drawnIn(const QString &sample)
{
    const auto loaded = io::readDocument(QStringLiteral(FFF_SAMPLES "/") + sample);
    return loaded ? loaded->document : Document();
}

AnalysisPointer analysedFrom(const Document &document)
{
    AnalysisCaches caches;
    return analyseNext(evaluate(document), caches);
}

Result<BearingMap> mapOf(const Document &document, const SectionRef &section)
{
    StrengthCaches caches;
    return bearingMap(analysedFrom(document), section, {}, caches);
}

/// The verdict on the model with a weight there.
struct WithWeight
{
    Strength strength;

    WithWeight(Document document, const SectionRef &section, const Vec2 &at, double mass)
    {
        Load weight;
        weight.section = section;
        weight.position = at;
        weight.mass = mass;
        weight.isRepeated = false;
        weight.id = LoadId{document.nextId++};
        document.loads.push_back(weight);
        StrengthCaches caches;
        strength = strengthOf(*analysedFrom(document), {}, caches);
    }
    bool stands() const { return strength.equilibrium().balance() == Balance::Stands; }
    bool bears() const { return stands() && strength.cornerUse < 1.0; }
};

/// A plate that stands on 140 mm, upright on one across it, and reaches out farther above.
Document mushroom()
{
    Document document = newDocument();
    const auto add = [&](Contour contour, const Frame &frame) {
        NewSection section;
        section.shape = *Shape::make(std::move(contour));
        section.frame = frame;
        document = *addSection(std::move(document), std::move(section));
    };
    add(polygonContour({{-70, 0},
                        {70, 0},
                        {70, 100},
                        {120, 100},
                        {120, 140},
                        {-120, 140},
                        {-120, 100},
                        {-70, 100}}),
        {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()});
    add(polygonContour(rectangleAt(-70, 0, 140, 30)),
        {Vec3::Zero(), -Vec3::UnitZ(), Vec3::UnitY()});
    return document;
}

} // namespace

class TestBearingMap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPlaceBearsWhatIsSaid_data();
    void everyPlaceBearsWhatIsSaid();
    void triangles();
    void beyondTheFeetItTopples();
    void words();
    void whatCannotBeSaid();
    void itStops();
    void ofTheSectionThatIsAskedAbout();
};

void TestBearingMap::everyPlaceBearsWhatIsSaid_data()
{
    QTest::addColumn<QString>("sample"); // empty: the mushroom
    QTest::addColumn<int>("section");
    QTest::newRow("the shelf of a glass stand") << QStringLiteral("glass_three_legs.fff") << 0;
    QTest::newRow("its leg") << QStringLiteral("glass_three_legs.fff") << 1;
    QTest::newRow("a shelf of acrylic") << QStringLiteral("acrylic_thick_four.fff") << 0;
    QTest::newRow("a plate that topples") << QString() << 0;
    QTest::newRow("a man for cutlery") << QStringLiteral("cutlery_man.fff") << 0;
    QTest::newRow("a lamp") << QStringLiteral("lamp.fff") << 0;
}

/// The oracle is the verdict on the model with a weight there.
// Wrong: a mass that breaks it, or one that is far from what it bears.
void TestBearingMap::everyPlaceBearsWhatIsSaid()
{
    QFETCH(QString, sample);
    QFETCH(int, section);
    const Document document = sample.isEmpty() ? mushroom() : drawnIn(sample);
    const SectionRef ref = document.sections[static_cast<std::size_t>(section)]->ref();
    const auto map = mapOf(document, ref);
    QVERIFY(map);
    QCOMPARE(map->obstacle, BearingMap::Obstacle::None);
    QVERIFY(map->points.size() > 20);
    std::set<BearingEnd> ends;
    for (const Bearing &bearing : map->bearings)
        ends.insert(bearing.end);
    QVERIFY(!ends.contains(BearingEnd::NotWorkedOut));
    const std::size_t step = std::max<std::size_t>(1, map->points.size() / 17);
    for (std::size_t i = 0; i < map->points.size(); i += step) {
        const Bearing &bearing = map->bearings[i];
        const Vec2 &at = map->points[i];
        const QByteArray where = QStringLiteral("%1: %2, %3: %4 kg, end %5")
                                     .arg(i)
                                     .arg(at.x())
                                     .arg(at.y())
                                     .arg(bearing.mass)
                                     .arg(static_cast<int>(bearing.end))
                                     .toUtf8();
        if (bearing.mass > 0.0)
            QVERIFY2(WithWeight(document, ref, at, 0.99 * bearing.mass).bears(), where);
        const WithWeight more(document, ref, at, 1.01 * bearing.mass);
        if (bearing.end == BearingEnd::BearsAll)
            continue;
        QVERIFY2(!more.bears(), where);
        QVERIFY2(more.stands() == (bearing.end == BearingEnd::Cracks), where);
    }
}

// Wrong: colours beside the section, or a hole in them.
void TestBearingMap::triangles()
{
    const Document document = drawnIn(QStringLiteral("glass_three_legs.fff"));
    const auto map = mapOf(document, document.sections.front()->ref());
    QVERIFY(map);
    const int index = map->analysis->model.indexOf(map->section);
    double meshed = 0.0;
    for (const auto &[a, b, c] : map->triangles) {
        const Vec2 &p = map->points[static_cast<std::size_t>(a)];
        const double twice = cross(map->points[static_cast<std::size_t>(b)] - p,
                                   map->points[static_cast<std::size_t>(c)] - p);
        QVERIFY(twice > 0.0);
        meshed += 0.5 * twice;
    }
    double all = 0.0;
    const Bodies &bodies = map->analysis->bodies;
    for (int body = bodies.firstOf(index); body < bodies.firstOf(index) + bodies.countOf(index);
         ++body)
        all += fff::area(bodies.at(body).outline().region);
    QVERIFY2(std::abs(meshed / all - 1.0) < 0.01, qPrintable(QString::number(meshed / all)));
}

/// The oracle: moments about the end of the foot.
// Wrong: a weight out there is said to crack something, and all of it lies on its side by then.
void TestBearingMap::beyondTheFeetItTopples()
{
    const Document document = mushroom();
    const auto map = mapOf(document, document.sections.front()->ref());
    QVERIFY(map);
    QCOMPARE(map->obstacle, BearingMap::Obstacle::None);
    double own = 0.0; // kg, over the middle
    for (const Body &body : map->analysis->bodies)
        own += body.mass().mass;
    int topples = 0;
    for (std::size_t i = 0; i < map->points.size(); ++i) {
        const double beyond = std::abs(map->points[i].x()) - 70.0;
        if (beyond < 12.0)
            continue;
        const Bearing &bearing = map->bearings[i];
        QCOMPARE(bearing.end, BearingEnd::Falls);
        const double expected = own * 70.0 / beyond;
        QVERIFY2(std::abs(bearing.mass / expected - 1.0) < 0.02,
                 qPrintable(QString::number(bearing.mass / expected)));
        ++topples;
    }
    QVERIFY(topples > 10);
}

// Wrong: a card that says a number and not what then.
void TestBearingMap::words()
{
    const Document document = drawnIn(QStringLiteral("glass_three_legs.fff"));
    const auto map = mapOf(document, document.sections.front()->ref());
    QVERIFY(map);
    for (const Bearing &bearing : map->bearings) {
        const QString text = messageText(bearingText(bearing, map->analysis->model));
        QVERIFY2(text.startsWith(QStringLiteral("Holds ")) && text.endsWith(u'.'),
                 qPrintable(text));
        if (bearing.end == BearingEnd::Cracks)
            QVERIFY2(text.contains(QStringLiteral(" cracks ")), qPrintable(text));
    }
}

// Wrong: colours for what lies on its side, or of what nobody knows the strength.
void TestBearingMap::whatCannotBeSaid()
{
    Document document = drawnIn(QStringLiteral("glass_three_legs.fff"));
    const SectionRef shelf = document.sections.front()->ref();
    const auto gone = mapOf(document, SectionRef(SectionId{999999}));
    QVERIFY(gone && gone->obstacle == BearingMap::Obstacle::NotThere);
    Document fallen = document;
    Load weight;
    weight.section = shelf;
    weight.position = {40.0, 0.0};
    weight.mass = 500.0;
    weight.id = LoadId{fallen.nextId++};
    fallen.loads = {weight};
    const auto map = mapOf(fallen, shelf);
    QVERIFY(map);
    if (map->obstacle == BearingMap::Obstacle::None) // it stands, and broke long ago
        QCOMPARE(map->most, 0.0);
    for (auto &stock : document.stocks) {
        Stock other = *stock;
        other.tensileStrength = other.flexuralStrength = std::nullopt;
        stock = std::make_shared<const Stock>(other);
    }
    const auto unrated = mapOf(document, shelf);
    QVERIFY(unrated && unrated->obstacle == BearingMap::Obstacle::NotRated);
    QVERIFY(unrated->points.empty());
}

// Wrong: a person who has seen enough waits for the rest.
void TestBearingMap::itStops()
{
    const Document document = drawnIn(QStringLiteral("glass_three_legs.fff"));
    std::stop_source source;
    double last = 0.0;
    const LongWork work{source.get_token(), [&](double share) {
                            QVERIFY(share >= last && share <= 1.0);
                            last = share;
                            if (share > 0.2)
                                source.request_stop();
                        }};
    StrengthCaches caches;
    const auto map =
        bearingMap(analysedFrom(document), document.sections.front()->ref(), {}, caches, work);
    QVERIFY(!map);
    QCOMPARE(map.error().code, ErrorCode::Cancelled);
    QVERIFY(last < 0.3);
}

// Wrong: an answer about another section, one that nobody asked for, or for another document.
void TestBearingMap::ofTheSectionThatIsAskedAbout()
{
    const Document document = mushroom();
    Session session;
    Scheduler &scheduler = session.scheduler();
    session.reset(document);
    scheduler.want(kBearing.name);
    scheduler.finish();
    QVERIFY(scheduler.result(kBearing) && !scheduler.result(kBearing)->map);
    for (const SectionPointer &section : document.sections) {
        scheduler.ask({section->ref()});
        scheduler.finish();
        QVERIFY(scheduler.result(kBearing)->map);
        QCOMPARE(scheduler.result(kBearing)->map->section, section->ref());
    }
    const auto holding = scheduler.result(kHolding);
    scheduler.ask({});
    scheduler.finish();
    QVERIFY(!scheduler.result(kBearing)->map);
    QVERIFY(scheduler.result(kHolding) == holding); // a question changes no check
    scheduler.ask({document.sections.front()->ref()});
    session.reset(newDocument());
    QVERIFY(!scheduler.questions().bearing);
}

FFF_TEST(TestBearingMap)
#include "tst_bearing_map.moc"
