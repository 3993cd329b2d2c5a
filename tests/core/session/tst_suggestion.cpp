// Suggested sections of a mesh: that they stand, hold and can be assembled, that a seed says all,
// and what is said where there are fewer than wanted.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/suggesting/first_slices.h"
#include "core/analysis/suggesting/main_faces.h"
#include "core/analysis/suggesting/suggested_ground.h"
#include "core/analysis/suggesting/suggestion.h"
#include "core/model/edits.h"
#include "core/operations/evaluate.h"
#include "core/session/message_text.h"
#include "tests/core/session/suggested_forms.h"
#include "tests/core/templates/made_polyhedra.h"
#include "tests/test_program.h"

#include <cmath>
#include <numbers>
#include <stop_token>

using namespace fff;
using namespace fff::test;
using namespace Qt::Literals::StringLiterals;

namespace {

Suggestion suggested(const Document &document, SuggestionOptions options)
{
    return suggestSections(evaluate(document), document.templates.front()->id, options).value();
}

/// A mesh as it comes, standing on the ground, 254 mm large or as large as said.
Document documentOf(MeshDraft draft, double size = 254.0)
{
    return documentWith({"Thing", std::move(draft)}, size);
}

} // namespace

class TestSuggestion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allIsGood_data();
    void allIsGood();
    void noWorseThanAnEvenGrid_data();
    void noWorseThanAnEvenGrid();
    void theSeedSaysAll();
    void oneMoreKeepsTheOthers();
    void aTurnedMeshGivesAsMuch();
    void aBoxIsCutAlongItsFaces_data();
    void aBoxIsCutAlongItsFaces();
    void facesOfABoxAndOfABall();
    void theGroundIsFlatUnderABall();
    void aFishStandsOnFeet();
    void feetReachDownNearTheMiddle();
    void thoseThatAreThereAreJoined();
    void othersAreLeftAlone();
    void whatCannotBeCut_data();
    void whatCannotBeCut();
    void asManyAsFit();
    void aBodyOfManyFlatFacesStands();
    void slicesBeginWithPlanesThatHold();
    void stopped();
    void wrongUse();
};

void TestSuggestion::allIsGood_data()
{
    QTest::addColumn<int>("form");
    const auto forms = madeForms();
    for (std::size_t i = 0; i < forms.size(); ++i)
        QTest::newRow(forms[i].name) << int(i);
}

void TestSuggestion::allIsGood()
{
    QFETCH(const int, form);
    const Document document = documentWith(madeForms()[std::size_t(form)]);
    double last = 0.0;
    LongWork work;
    work.progress = [&last](double share) {
        QVERIFY(share >= last && share <= 1.0);
        last = share;
    };
    const Suggestion made =
        suggestSections(evaluate(document), document.templates.front()->id, {.count = 8}, work)
            .value();
    QCOMPARE(made.sections.size(), std::size_t(8));
    QCOMPARE(made.document.sections.size(), std::size_t(8));
    QCOMPARE(faultsOf(evaluate(made.document)), QStringList());
    QCOMPARE(made.messages.size(), std::size_t(made.lowered > 0.0));
    QVERIFY(last > 0.99);
    // The template went down with the sections, which follow it.
    QVERIFY(std::abs(document.templates.front()->frame.origin.y() - made.lowered -
                     made.document.templates.front()->frame.origin.y()) < 1e-9);
    // They show no less than an even grid of as many.
    const double shown = silhouetteShown(*made.document.templates.front(), made.document.sections);
    const double ofGrid = silhouetteShown(*document.templates.front(),
                                          evenGridOf(document, made.sections.size()).sections());
    QVERIFY2(shown >= ofGrid, qPrintable(u"%1, of the grid %2"_s.arg(shown).arg(ofGrid)));
}

void TestSuggestion::noWorseThanAnEvenGrid_data()
{
    QTest::addColumn<int>("count");
    QTest::newRow("16 sections") << 16;
    if (qEnvironmentVariableIsSet("FFF_LONG_TESTS"))
        QTest::newRow("32 sections") << 32;
}

/// Of ten forms on eight, where the grid falls apart on most; and nothing is wrong with any but, of
/// many sections, walls beside slits that are thin.
void TestSuggestion::noWorseThanAnEvenGrid()
{
    QFETCH(const int, count);
    constexpr std::size_t kMostThatAreWorse = 2;
    QStringList worse;
    for (const MadeForm &form : madeForms()) {
        const Document document = documentWith(form);
        const Suggestion made = suggested(document, {.count = count});
        QVERIFY2(made.sections.size() == std::size_t(count) || count > 16, form.name);
        for (const QString &fault : faultsOf(evaluate(made.document)))
            QVERIFY2(!isGrave(fault), qPrintable(QLatin1String(form.name) + u": "_s + fault));
        const double shown =
            silhouetteShown(*made.document.templates.front(), made.document.sections);
        const double ofGrid = silhouetteShown(*document.templates.front(),
                                              evenGridOf(document, std::size_t(count)).sections());
        if (shown < ofGrid - kAsGood)
            worse +=
                u"%1 shows %2, the grid %3"_s.arg(QLatin1String(form.name)).arg(shown).arg(ofGrid);
    }
    QVERIFY2(std::size_t(worse.size()) <= kMostThatAreWorse, qPrintable(worse.join(u"; ")));
}

void TestSuggestion::theSeedSaysAll()
{
    const Document document = documentWith(madeForms()[3]);
    const Suggestion once = suggested(document, {.count = 6, .seed = 7});
    QVERIFY(suggested(document, {.count = 6, .seed = 7}).document == once.document);
    QVERIFY(!(suggested(document, {.count = 6, .seed = 8}).document == once.document));
}

void TestSuggestion::oneMoreKeepsTheOthers()
{
    const Document document = documentWith(madeForms()[1]);
    const Suggestion some = suggested(document, {.count = 6});
    const Suggestion more = suggested(document, {.count = 7});
    QCOMPARE(more.sections.size(), some.sections.size() + 1);
    for (std::size_t i = 0; i < some.sections.size(); ++i)
        QVERIFY(*some.document.sections[i] == *more.document.sections[i]);
}

/// What is suggested does not hang on where the mesh is and which way it looks.
void TestSuggestion::aTurnedMeshGivesAsMuch()
{
    const MeshDraft plain = bracket();
    const MeshDraft turned =
        mapped(plain, [](const Vec3 &p) { return Vec3(500.0 - p.z(), p.y() + 30.0, p.x()); });
    double shown[2] = {};
    for (int i = 0; i < 2; ++i) {
        const Suggestion made = suggested(documentOf(i == 0 ? plain : turned), {.count = 8});
        QCOMPARE(faultsOf(evaluate(made.document)), QStringList());
        shown[i] = silhouetteShown(*made.document.templates.front(), made.document.sections);
    }
    QVERIFY2(std::abs(shown[0] - shown[1]) < 0.15,
             qPrintable(u"%1 and %2"_s.arg(shown[0]).arg(shown[1])));
}

void TestSuggestion::aBoxIsCutAlongItsFaces_data()
{
    QTest::addColumn<Vec3>("size");
    QTest::addColumn<double>("turn"); // radians, about the upright axis
    QTest::newRow("a cube") << Vec3(100, 100, 100) << 0.0;
    QTest::newRow("a cube that is turned") << Vec3(100, 100, 100) << 0.5;
    QTest::newRow("a cube on its diagonal") << Vec3(100, 100, 100) << 0.25 * std::numbers::pi;
    QTest::newRow("a brick") << Vec3(100, 60, 30) << 0.0;
    QTest::newRow("a tower that is turned") << Vec3(50, 120, 60) << 1.1;
}

/// Its diagonals are larger, and of a cube planes of symmetry, but say little about a box.
void TestSuggestion::aBoxIsCutAlongItsFaces()
{
    QFETCH(const Vec3, size);
    QFETCH(const double, turn);
    const Eigen::AngleAxisd turned(turn, Vec3::UnitY());
    const Document document = documentOf(
        mapped(box(Vec3::Zero(), size), [&](const Vec3 &p) { return Vec3(turned * p); }));
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Suggestion made = suggested(document, {.count = 6, .seed = seed});
        QCOMPARE(made.sections.size(), std::size_t(6));
        QCOMPARE(made.lowered, 0.0);
        QCOMPARE(faultsOf(evaluate(made.document)), QStringList());
        for (const SectionPointer &section : made.document.sections) {
            const Vec3 normal = turned.inverse() * section->frame.normal();
            QVERIFY(normal.cwiseAbs().maxCoeff() > 1.0 - 1e-6);
        }
    }
}

void TestSuggestion::facesOfABoxAndOfABall()
{
    std::vector<Vec3> points, normals;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (int i = 0; i < 100; ++i) {
                Vec3 normal = Vec3::Zero();
                normal[axis] = side;
                Vec3 point = 50.0 * normal;
                point[(axis + 1) % 3] = i - 49.5;
                points.push_back(point);
                normals.push_back(normal);
            }
    const std::vector<MainFace> faces = mainFaces(points, normals, 1.0);
    QCOMPARE(faces.size(), std::size_t(3));
    for (const MainFace &face : faces) {
        QVERIFY(std::abs(face.share - 1.0 / 3.0) < 1e-9);
        QCOMPARE(face.places.size(), std::size_t(2));
        for (const MainFace::Place &place : face.places)
            QVERIFY(std::abs(place.offset - (place.looksAlong ? 50.0 : -50.0)) < 1e-9);
    }
    normals.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double up = (2.0 * double(i) + 1.0) / double(points.size()) - 1.0;
        const double around = 2.4 * double(i), radius = std::sqrt(1.0 - up * up);
        normals.emplace_back(radius * std::cos(around), up, radius * std::sin(around));
    }
    QVERIFY(mainFaces(points, normals, 1.0).empty());
}

void TestSuggestion::theGroundIsFlatUnderABall()
{
    const Suggestion made = suggested(documentOf(sphere(50.0, 60, 90)), {.count = 4});
    QCOMPARE(made.sections.size(), std::size_t(4));
    QVERIFY(made.lowered > 0.5 && made.lowered < 20.0);
    double lowest = 1.0;
    for (const SectionPointer &section : made.document.sections)
        lowest = std::min(lowest, worldBounds(*section->shape, section->frame).min.y());
    QVERIFY(std::abs(lowest) < 1e-6);
    QCOMPARE(made.messages.size(), std::size_t(1));
    QVERIFY(messageText(made.messages[0]).contains(u"lowered"));
    QCOMPARE(faultsOf(evaluate(made.document)), QStringList());
}

/// Cut flat until it stands, it would lose its belly.
void TestSuggestion::aFishStandsOnFeet()
{
    const Document document = documentWith(madeForms()[6]);
    const Suggestion made = suggested(document, {.count = 6});
    QCOMPARE(faultsOf(evaluate(made.document)), QStringList());
    QVERIFY(made.lowered > 0.0 && made.lowered < 3.0);
    QCOMPARE(made.messages.size(), std::size_t(1));
    QVERIFY(messageText(made.messages[0]).contains(u"feet"));
    const double shown = silhouetteShown(*made.document.templates.front(), made.document.sections);
    QVERIFY2(shown > 0.97, qPrintable(QString::number(shown)));
}

/// A disc 40 mm wide on the ground, filled up where it is less than 5 mm above that.
void TestSuggestion::feetReachDownNearTheMiddle()
{
    Region disc;
    for (int i = 0; i < 360; ++i) {
        const double around = std::numbers::pi * i / 180.0;
        disc.outer.emplace_back(20.0 * std::cos(around), 20.0 + 20.0 * std::sin(around));
    }
    const Frame front{Vec3(7, 0, 0), Vec3::UnitX(), Vec3::UnitY()};
    const auto feet = [&](const SuggestedGround &ground, const Frame &frame) {
        return feetOn(ground, frame, disc);
    };
    SuggestedGround ground{0.0, 5.0, {7.0, 0.0}, 100.0};
    QCOMPARE(feet(ground, front).size(), std::size_t(1));
    const double half = std::sqrt(20.0 * 20.0 - 15.0 * 15.0);
    const SuggestedFoot whole = feet(ground, front).front();
    QVERIFY(whole.from.x() > -half && whole.from.x() < -half + 0.5);
    QVERIFY(whole.to.x() < half && whole.to.x() > half - 0.5);
    QVERIFY(whole.from.y() == 0.0 && whole.to.y() == 0.0);
    QVERIFY((whole.up - Vec2(0.0, 5.0)).norm() < 1e-12);
    QVERIFY(signedArea(whole.outline()) > 0.0);
    // Only around the middle, which may be beside the plane.
    ground.around = 5.0;
    ground.middle = {8.0, 3.0};
    const SuggestedFoot some = feet(ground, front).front();
    QVERIFY(std::abs(some.from.x() + 3.0) < 1e-9 && std::abs(some.to.x() - 5.0) < 1e-9);
    ground.middle = {8.0, 5.5};
    QVERIFY(feet(ground, front).empty());
    // What lies has none, and where nothing is filled there are none.
    QVERIFY(feet(ground, {Vec3::Zero(), Vec3::UnitX(), -Vec3::UnitZ()}).empty());
    QVERIFY(feet({0.0, 0.0, {7.0, 0.0}, 100.0}, front).empty());
}

void TestSuggestion::thoseThatAreThereAreJoined()
{
    const Document document = documentWith(madeForms()[1]);
    const Document some = suggested(document, {.count = 3}).document;
    const Suggestion more = suggested(some, {.count = 2, .seed = 5});
    QCOMPARE(more.sections.size(), std::size_t(2));
    QCOMPARE(more.document.sections.size(), std::size_t(5));
    for (std::size_t i = 0; i < 3; ++i)
        QCOMPARE(more.document.sections[i], some.sections[i]);
    QCOMPARE(more.lowered, 0.0);
    QCOMPARE(faultsOf(evaluate(more.document)), QStringList());
    QVERIFY(more.document.sections[3]->name != more.document.sections[0]->name);
}

/// A model beside the mesh has nothing to do with it.
void TestSuggestion::othersAreLeftAlone()
{
    const Document document = documentWith(madeForms()[4]);
    Document beside = document;
    NewSection plate;
    plate.shape = Shape::make(Contour::ofPolygon({{0, 0}, {40, 0}, {40, 40}, {0, 40}}), {}).value();
    plate.frame.origin = {2000, 0, 0};
    beside = addSection(beside, plate).value();
    const Suggestion alone = suggested(document, {.count = 4});
    const Suggestion made = suggested(beside, {.count = 4});
    QCOMPARE(made.document.sections.size(), std::size_t(5));
    QCOMPARE(made.document.sections[0], beside.sections[0]);
    for (std::size_t i = 0; i < 4; ++i)
        QVERIFY(*made.document.sections[i + 1]->shape == *alone.document.sections[i]->shape);
}

void TestSuggestion::whatCannotBeCut_data()
{
    QTest::addColumn<int>("thing");
    QTest::newRow("a flat sheet that lies") << 0;
    QTest::newRow("a single triangle") << 1;
    QTest::newRow("a needle") << 2;
    QTest::newRow("smaller than the stock is thick") << 3;
    QTest::newRow("a flat sheet that stands") << 4;
    QTest::newRow("a ball too small for two slits") << 5;
}

void TestSuggestion::whatCannotBeCut()
{
    QFETCH(const int, thing);
    MeshDraft draft;
    double size = 254.0;
    switch (thing) {
    case 0:
    case 4: {
        const bool lies = thing == 0;
        for (const Vec2 &p : {Vec2(0, 0), Vec2(9, 0), Vec2(9, 5), Vec2(0, 5)})
            addPoint(draft, lies ? Vec3(p.x(), 0, p.y()) : Vec3(p.x(), p.y(), 0));
        addQuad(draft, 0, 1, 2, 3);
        break;
    }
    case 1:
        draft.positions = {{0, 0, 0}, {4, 1, 0}, {1, 3, 2}};
        draft.triangles = {{0, 1, 2}};
        break;
    case 2:
        draft = box({0, 0, 0}, {0.01, 30, 0.01});
        break;
    case 3:
        draft = cube(1.0);
        size = 1.0;
        break;
    default:
        draft = sphere(1.0, 20, 30);
        size = 9.0;
    }
    const Document document = documentOf(draft, size);
    const Suggestion made = suggested(document, {.count = 8});
    QVERIFY(made.document.isSame(document));
    QCOMPARE(made.sections.size(), std::size_t(0));
    QCOMPARE(made.messages.size(), std::size_t(1));
    QVERIFY(messageText(made.messages[0]).contains(u"Thing"));
}

void TestSuggestion::asManyAsFit()
{
    const Document document = documentOf(cube(10.0), 60.0);
    const Suggestion made = suggested(document, {.count = 60});
    QVERIFY(made.sections.size() >= 4 && made.sections.size() < 60);
    QCOMPARE(made.messages.size(), std::size_t(1));
    QVERIFY(
        messageText(made.messages[0]).contains(u"Only %1 sections"_s.arg(made.sections.size())));
    // The last ones leave thin walls beside slits; nothing graver.
    for (const QString &fault : faultsOf(evaluate(made.document)))
        QVERIFY2(fault.startsWith(u"thinWeb"), qPrintable(fault));
}

/// A stone of fourteen corners: "No sections of rock were found that hold each other and stand."
void TestSuggestion::aBodyOfManyFlatFacesStands()
{
    const std::vector<Vec3> corners{
        {36.3536568, 86.4299487, 34.7602591},    {-79.0571126, 54.9241633, 27.0796831},
        {-61.6361617, 66.7057894, 41.84879},     {47.3290085, 4.5734372, 87.9718627},
        {-82.2690288, -18.1986134, -53.85738},   {89.6977452, 5.94974703, -43.8054221},
        {-94.9884544, -31.2444418, 0.989135148}, {-16.5771814, 77.8363732, 60.5532499},
        {-81.9335938, -57.0875576, -5.28175855}, {-81.0830495, 41.0308365, 41.7373877},
        {87.4541615, -45.9198525, -15.592844},   {91.0754994, 28.8327868, 29.5622024},
        {-29.6347182, -95.0187507, 9.65507585},  {7.73738268, -87.1125257, -48.4926879}};
    const Suggestion made = suggested(documentOf(hullOf(corners), 150.0), {.count = 8});
    QVERIFY(made.sections.size() >= 4);
    for (const QString &fault : faultsOf(evaluate(made.document)))
        QVERIFY2(!isGrave(fault), qPrintable(fault));
}

/// A round vase, 120 mm high: six planes across X and six across Z block each other there, leave
/// nothing beside slits and do not hold.
void TestSuggestion::slicesBeginWithPlanesThatHold()
{
    std::vector<Vec2> profile{{0.0, 0.0}};
    for (int z = 0; z <= 120; z += 4) {
        const double up = z / 120.0;
        profile.emplace_back(25.0 + 12.0 * std::sin(up * std::numbers::pi * 1.6 + 0.2) + 6.0 * up,
                             z);
    }
    profile.emplace_back(0.0, 120.0);
    const Document document = documentOf(revolved(profile, 64), 120.0);
    const FirstSlices usual;
    QVERIFY(!faultsOf(slicesOf(document, usual.direction, usual.count)).isEmpty());
    const TemplateId of = document.templates.front()->id;
    const FirstSlices found = firstSlices(evaluate(document), of).value();
    QVERIFY(found.shift == 0.0);
    QCOMPARE(faultsOf(slicesOf(document, found.direction, found.count)), QStringList());
    // What is there already is another thing.
    QVERIFY(firstSlices(slicesOf(document, "xz", 6), of).value() == found);
    // Where the usual ones hold they are it, and where none does.
    const Document cube = documentOf(box({0, 0, 0}, {100, 100, 100}), 150.0);
    QVERIFY(firstSlices(evaluate(cube), cube.templates.front()->id).value() == usual);
    const Document crumb = documentOf(box({0, 0, 0}, {1, 1, 1}), 4.0);
    QVERIFY(firstSlices(evaluate(crumb), crumb.templates.front()->id).value() == usual);
    QCOMPARE(firstSlices(evaluate(cube), TemplateId{999}).error().code,
             ErrorCode::UnknownReference);
    std::stop_source stop;
    stop.request_stop();
    QCOMPARE(firstSlices(evaluate(cube), cube.templates.front()->id, {stop.get_token(), {}})
                 .error()
                 .code,
             ErrorCode::Cancelled);
}

void TestSuggestion::stopped()
{
    const Document document = documentWith(madeForms()[0]);
    for (const double when : {0.0, 0.05, 0.3, 0.6}) {
        std::stop_source stop;
        LongWork work{stop.get_token(), [&](double share) {
                          if (share >= when)
                              stop.request_stop();
                      }};
        const auto made = suggestSections(evaluate(document), document.templates.front()->id,
                                          {.count = 12}, work);
        QVERIFY(!made);
        QVERIFY(made.error().code == ErrorCode::Cancelled);
    }
}

void TestSuggestion::wrongUse()
{
    const Document document = documentWith(madeForms()[4]);
    const Model model = evaluate(document);
    const TemplateId id = document.templates.front()->id;
    QVERIFY(suggestSections(model, {999}).error().code == ErrorCode::UnknownReference);
    for (const int count : {0, -3, kMostSuggested + 1})
        QVERIFY(suggestSections(model, id, {.count = count}).error().place == "count");
}

FFF_TEST(TestSuggestion)
#include "tst_suggestion.moc"
