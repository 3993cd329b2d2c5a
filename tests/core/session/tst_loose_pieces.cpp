#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/findings/broader_base.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/moving_slits.h"
#include "core/analysis/findings/narrow_slits.h"
#include "core/analysis/findings/touching_pairs.h"
#include "core/analysis/findings/turning_square.h"
#include "core/analysis/findings/waste.h"
#include "core/analysis/plan_checks.h"
#include "core/base/units.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

#include <QLocale>

#include <cmath>
#include <numbers>

using namespace fff;
using namespace fff::test;

namespace {

Frame shelfAt(double y)
{
    return {{0, y, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
}

ShapePointer ellipseOf(const Vec2 &middle, double width, double height)
{
    Polygon corners;
    for (int i = 0; i < 96; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 96;
        corners.push_back(middle + Vec2(width * std::sin(angle), -height * std::cos(angle)));
    }
    return polygonShape(corners);
}

/// Two plates across each other on the ground.
Document twoAcrossEachOther()
{
    const ShapePointer plate = plateOf(-50, 0, 50, 60);
    return withSection(withSection(newDocument(), plate, front()), plate, side());
}

/// A plate, and one that runs along its edge: 1.5 mm of it would be beyond.
Document alongTheEdge(double at)
{
    return withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), front()),
                       plateOf(-40, 0, 40, 60), side(at));
}

struct Judged
{
    Analysis analysis;
    std::vector<Finding> all;
};

Judged judged(const Document &document)
{
    Judged judged{analysed(document), {}};
    judged.all = checks(judged.analysis);
    for (Finding &finding : planChecks(judged.analysis, planOf(judged.analysis)))
        judged.all.push_back(std::move(finding));
    return judged;
}

bool hasError(const std::vector<Finding> &all)
{
    return std::any_of(all.begin(), all.end(),
                       [](const Finding &finding) { return finding.severity == Severity::Error; });
}

/// It is said in red that it does not hold together, or cannot be put together.
bool fallsApart(const std::vector<Finding> &all)
{
    return worst(all, Subject::Connection) == Severity::Error ||
           worst(all, Subject::Assembly) == Severity::Error;
}

/// What is offered for the first finding of the kind.
std::vector<Mend> mendsOf(CheckList &list, const FindingKind &kind)
{
    list.finish();
    const Finding *finding = find(list.all(), kind);
    return finding ? list.mendsOf(*finding) : std::vector<Mend>();
}

const Mend *find(const std::vector<Mend> &mends, const ActionKind &kind)
{
    const auto mend = std::find_if(mends.begin(), mends.end(),
                                   [&](const Mend &one) { return one.action.kind == &kind; });
    return mend == mends.end() ? nullptr : &*mend;
}

/// Does it, and says whether that is one step of the history which undo takes back to the very
/// document.
bool isDoneAndUndone(Session &session, CheckList &list, const Mend &mend)
{
    const Document before = session.committed().document;
    session.commit(QStringLiteral("Mend"), mend.edit->document);
    list.finish();
    const bool isDone = !session.committed().document.isSame(before);
    session.history()->undo();
    list.finish();
    return isDone && session.committed().document.isSame(before);
}

} // namespace

class TestLoosePieces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void squaresThroughOneCentre();
    void shelfAcrossTwoCrossed();
    void sectionAlongAnEdge_data();
    void sectionAlongAnEdge();
    void itIsMovedIn();
    void whatStandsOnALineGetsAFoot();
    void whatStandsOnARoundEdgeGetsAFoot();
    void aShallowAngleIsTurnedSquare();
    void aThinWebIsWidened();
    void chipsAreWaste();
    void whatOnlyTouchesIsOneLine();
    void pressedFarTooTight();
    void playAsksForDepth();
    void partsInOnePlace();
};

// Wrong: green over a model that falls into pieces which nothing holds.
void TestLoosePieces::squaresThroughOneCentre()
{
    const ShapePointer upright = plateOf(-50, 0, 50, 100);
    Document document = withSection(newDocument(), upright, front());
    document = withSection(document, upright, side());
    document = withSection(document, plateOf(-50, -50, 50, 50), shelfAt(50.0));
    QVERIFY(fallsApart(judged(document).all));
}

// Wrong: the link cuts the body into four parts, and everything is green.
void TestLoosePieces::shelfAcrossTwoCrossed()
{
    const Document document =
        withSection(twoAcrossEachOther(), plateOf(-50, -50, 50, 50), shelfAt(30));
    QVERIFY(fallsApart(judged(document).all));
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"), document);
    list.finish();
    const std::vector<Finding> before = list.all();
    int offered = 0;
    for (const Finding &finding : before) {
        for (const Mend &mend : list.mendsOf(finding)) {
            if (!mend.isEdit())
                continue;
            ++offered;
            const std::vector<Finding> after = judged(mend.edit->document).all;
            QVERIFY2(isNoWorse(before, after), qPrintable(findingText(finding, list.model())));
        }
        // A person is told what to do where no link does it.
        if (finding.severity == Severity::Error && list.isMendless(finding))
            QVERIFY2(adviceOf(finding).source, finding.kind->name);
    }
    QVERIFY(offered > 0); // one of the three ends before the others
}

// Wrong: what stands on a round or narrow edge, which needs a foot most, was offered none.
void TestLoosePieces::whatStandsOnARoundEdgeGetsAFoot()
{
    for (const double half : {4.0, 40.0}) { // of a post, and of an ellipse
        const bool isRound = half > 10.0;
        const ShapePointer shape =
            isRound ? ellipseOf({0.0, 50.0}, half, 50.0) : plateOf(-half, 0, half, 100);
        Session session;
        CheckList list(session);
        session.commit(QStringLiteral("Draw"), withSection(newDocument(), shape, front()));
        list.finish();
        const Finding *falls = nullptr;
        for (const Finding &finding : list.all())
            if (finding.subject() == Subject::Stability)
                falls = &finding;
        QVERIFY(falls && falls->severity == Severity::Error);
        const std::vector<Mend> mends = list.mendsOf(*falls);
        const Mend *foot = ::find(mends, kAddFoot);
        QVERIFY2(foot, falls->kind->name);
        QVERIFY(isDoneAndUndone(session, list, *foot));
        const Judged after = judged(foot->edit->document);
        QVERIFY(fff::test::find(after.all, kStands));
        QVERIFY(!hasError(after.all));
    }
}

void TestLoosePieces::sectionAlongAnEdge_data()
{
    QTest::addColumn<double>("at");
    QTest::addColumn<bool>("holds");
    QTest::newRow("in the middle") << 0.0 << true;
    QTest::newRow("with a wall of a mm") << 47.5 << true;
    QTest::newRow("half beyond the edge") << 49.5 << false;
    QTest::newRow("with all of its thickness beside it") << 50.0 << false;
}

// Wrong: a step with one wall is called a joint.
void TestLoosePieces::sectionAlongAnEdge()
{
    QFETCH(double, at);
    QFETCH(bool, holds);
    const Judged found = judged(alongTheEdge(at));
    QCOMPARE(fff::test::find(found.all, kConnected) != nullptr, holds);
    QCOMPARE(hasError(found.all), !holds);
    const Finding *loose = fff::test::find(found.all, kLooseJoint);
    const bool doTheyMeet = at < 50.0; // else there is no slit at all
    QCOMPARE(loose != nullptr, !holds && doTheyMeet);
    if (loose)
        QVERIFY(findingText(*loose, found.analysis.model)
                    .contains(QStringLiteral("material on one side only")));
}

void TestLoosePieces::itIsMovedIn()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"), alongTheEdge(49.5));
    const std::vector<Mend> mends = mendsOf(list, kLooseJoint);
    const Mend *moveIn = ::find(mends, kMoveIn);
    QVERIFY(moveIn);
    QVERIFY(!moveIn->changes.isEmpty());
    QVERIFY(isDoneAndUndone(session, list, *moveIn));
    const Judged after = judged(moveIn->edit->document);
    QVERIFY(fff::test::find(after.all, kConnected));
    QVERIFY(!fff::test::find(after.all, kLooseJoint));
}

void TestLoosePieces::whatStandsOnALineGetsAFoot()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"),
                   withSection(newDocument(), plateOf(-50, 0, 50, 60), front()));
    std::vector<Mend> mends = mendsOf(list, kUnsteady);
    if (mends.empty())
        mends = mendsOf(list, kLineSupport);
    const Mend *foot = ::find(mends, kAddFoot);
    QVERIFY(foot);
    QVERIFY(isDoneAndUndone(session, list, *foot));
    const Judged after = judged(foot->edit->document);
    QVERIFY(fff::test::find(after.all, kStands));
    QVERIFY(!hasError(after.all));
}

void TestLoosePieces::aShallowAngleIsTurnedSquare()
{
    Session session;
    CheckList list(session);
    const ShapePointer plate = plateOf(-50, 0, 50, 60);
    session.commit(QStringLiteral("Draw"), withSection(withSection(newDocument(), plate, front()),
                                                       plate, turned(radians(20.0))));
    const std::vector<Mend> mends = mendsOf(list, kShallowAngle);
    const Mend *square = ::find(mends, kTurnSquare);
    QVERIFY(square);
    QVERIFY(isDoneAndUndone(session, list, *square));
    const Model after = evaluate(square->edit->document);
    QVERIFY(std::abs(after.section(0)->frame.normal().dot(after.section(1)->frame.normal())) <
            1e-12);
}

void TestLoosePieces::aThinWebIsWidened()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"), alongTheEdge(47.5));
    const std::vector<Mend> mends = mendsOf(list, kThinWeb);
    const Mend *moved = ::find(mends, kMoveSlit);
    QVERIFY(moved);
    QVERIFY(isDoneAndUndone(session, list, *moved));
    QVERIFY(!fff::test::find(judged(moved->edit->document).all, kThinWeb));
}

// Wrong: what nobody finds on the bed of a laser has a number of its own.
void TestLoosePieces::chipsAreWaste()
{
    // A hook that stands in the slit and reaches beyond: its tip is cut off.
    const ShapePointer hooked = polygonShape({{-50, 0},
                                              {50, 0},
                                              {50, 60},
                                              {1.4, 60},
                                              {1.4, 60.2},
                                              {1.9, 60.2},
                                              {1.9, 60.5},
                                              {1, 60.5},
                                              {1, 60},
                                              {-50, 60}});
    const Document document =
        withSection(withSection(newDocument(), hooked, front()), plateOf(-50, 0, 50, 60), side());
    const Judged found = judged(document);
    QCOMPARE(found.analysis.bodies.size(), std::size_t(2));
    QCOMPARE(found.analysis.cuts[0]->waste().size(), std::size_t(1));
    const Finding *waste = fff::test::find(found.all, kWaste);
    QVERIFY(waste);
    QCOMPARE(waste->severity, Severity::Note);
    QVERIFY(findingText(*waste, found.analysis.model).contains(QStringLiteral("waste")));
    QVERIFY(!fff::test::find(found.all, kLoosePieces));
}

void TestLoosePieces::whatOnlyTouchesIsOneLine()
{
    // Three plates whose upper edges reach 0.2 mm into a level one.
    Document document = withSection(newDocument(), plateOf(-60, -60, 60, 60), shelfAt(60));
    for (const double at : {-30.0, 0.0, 30.0})
        document = withSection(document, plateOf(-20, 0, 20, 58.7), front(at));
    const Judged found = judged(document);
    const auto count = std::count_if(found.all.begin(), found.all.end(), [](const Finding &one) {
        return one.subject() == Subject::Joints && one.severity > Severity::Good;
    });
    QCOMPARE(count, 1);
    const Finding *touching = fff::test::find(found.all, kTouching);
    QVERIFY(touching);
    QCOMPARE(touching->severity, Severity::Note);
    QVERIFY(!touching->at); // there are three places

    Document one = withSection(newDocument(), plateOf(-60, -60, 60, 60), shelfAt(60));
    one = withSection(one, plateOf(-20, 0, 20, 58.7), front(0.0));
    const Judged single = judged(one);
    const Finding *pair = fff::test::find(single.all, kTouching);
    QVERIFY(pair && pair->at);
    // In both of them.
    const Vec3 where = *pair->at;
    QVERIFY(std::abs(where.x()) <= 20.0 && std::abs(where.z()) <= 1.5);
    QVERIFY(where.y() >= 58.5 && where.y() <= 58.7);
}

void TestLoosePieces::pressedFarTooTight()
{
    Document document = twoAcrossEachOther();
    Stock stock = *document.stocks.front();
    stock.clearance = -0.2;
    QVERIFY(!fff::test::find(judged(*setStock(document, stock)).all, kTightSlits));
    stock.clearance = -2.0;
    const Judged tight = judged(*setStock(document, stock));
    QVERIFY(fff::test::find(tight.all, kTightSlits));
    QCOMPARE(fff::test::find(tight.all, kTightSlits)->severity, Severity::Error);
    // Bumps leave as little room.
    stock.clearance = 0.0;
    stock.bumps = 0.1;
    QVERIFY(!fff::test::find(judged(*setStock(document, stock)).all, kTightSlits));
    stock.bumps = 1.0;
    QVERIFY(fff::test::find(judged(*setStock(document, stock)).all, kTightSlits));
}

// Wrong: a board that lies 1 mm deep in a groove with 0.2 mm of play turned out of it, and was
// called held.
void TestLoosePieces::playAsksForDepth()
{
    // Tilted about one of its corners, by trying all angles: is it ever as wide as the slit?
    const auto staysIn = [](double thickness, double depth, double width) {
        for (double angle = 0.0; angle < 1.5; angle += 1e-4)
            if (thickness * std::cos(angle) + depth * std::sin(angle) >= width)
                return true;
        return false;
    };
    constexpr double kBurnt = 0.05; // mm, taken off both
    for (const double thickness : {1.0, 3.0, 12.0})
        for (const double clearance : {0.0, 0.1, 0.3}) {
            const double needed = gripDepth(thickness, clearance);
            const double width = thickness + clearance + kBurnt;
            QVERIFY(staysIn(thickness, 1.03 * needed, width));
            if (needed > kLeastGripDepth)
                QVERIFY(!staysIn(thickness, 0.97 * needed, width));
        }
    QCOMPARE(gripDepth(3.0, -0.2), gripDepth(3.0, 0.0)); // what presses has no play
}

// Wrong: parts that take up one place are said to go together.
void TestLoosePieces::partsInOnePlace()
{
    Document document = withSection(twoAcrossEachOther(), plateOf(-20, 0, 20, 40), front(1.0));
    const Judged found = judged(document);
    QVERIFY(!fff::test::find(found.all, kCanAssemble));
}

FFF_TEST(TestLoosePieces)
#include "tst_loose_pieces.moc"
