#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/checks.h"
#include "core/analysis/dropping.h"
#include "core/analysis/finding_action.h"
#include "core/analysis/findings/broader_base.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/joining_move.h"
#include "core/analysis/plan_checks.h"
#include "core/base/tolerances.h"
#include "core/session/message_text.h"
#include "core/session/session.h"
#include "core/session/session_host.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/test_program.h"

#include <random>

using namespace fff;
using namespace fff::test;

namespace {

struct Checked
{
    Analysis analysis;
    std::vector<Finding> checks;
    std::optional<Flips> flips;
};

Checked checked(const Document &document)
{
    Checked all{analysed(document), {}, {}};
    all.checks = checks(all.analysis);
    const ModelPlan plan = planOf(all.analysis);
    for (Finding &finding : planChecks(all.analysis, plan))
        all.checks.push_back(std::move(finding));
    all.flips = flipsThatHelp(all.analysis, plan);
    return all;
}

int count(const Checked &all, const FindingKind &kind)
{
    return static_cast<int>(
        std::count_if(all.checks.begin(), all.checks.end(),
                      [&](const Finding &finding) { return finding.is(kind); }));
}

/// What is wrong, by how many.
int problems(const Checked &all)
{
    return static_cast<int>(
        std::count_if(all.checks.begin(), all.checks.end(), [](const Finding &finding) {
            return finding.severity >= Severity::Warning;
        }));
}

/// The action of this kind that the checks offer, carried out.
std::optional<FindingEdit> done(const Checked &all, const ActionKind *kind)
{
    const Flips *flips = all.flips ? &*all.flips : nullptr;
    for (const Finding &finding : all.checks)
        for (const FindingAction &action : actionsOf(finding, all.analysis, flips))
            if (action.kind == kind)
                return carriedOut(action, finding, all.analysis, flips);
    return {};
}

/// Lying, x to the right, y to the back.
Frame lyingAt(double height)
{
    return {{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
}

/// Without a joint of the first section with another one.
Document without(Document document, std::size_t other = 1)
{
    JointOverride none;
    none.a = document.sections[0]->id;
    none.b = document.sections[other]->id;
    none.kind = JointKind::None;
    return *setJointOverride(std::move(document), none);
}

/// Two crossed plates, 100 x 60, and one beside them.
Document with(ShapePointer shape, const Frame &frame)
{
    return withSection(withSection(withSection(newDocument(), plateOf(-50, 0, 50, 60), front()),
                                   plateOf(-50, 0, 50, 60), side()),
                       std::move(shape), frame);
}

} // namespace

class TestCheckActions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editsMend_data();
    void editsMend();
    void aFootGoesThroughWhatStandsBesideIt();
    void whatOnlyShowsIsOffered();
    void looseSectionsAreJoined_data();
    void looseSectionsAreJoined();
    void whatCannotBeJoinedIsNotMoved_data();
    void whatCannotBeJoinedIsNotMoved();
    void whatWasDrawnOnItComesAlong();
    void anyLooseSectionIsJoinedWell();
    void whatWasWantedOfAJointComesBack();
    void aLaterModelIsAskedAnew();
    void onlyWhatDoesNotStandThereIsDropped();
};

void TestCheckActions::editsMend_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<const ActionKind *>("kind");
    QTest::addColumn<const FindingKind *>("finding");
    QTest::newRow("a loose plate is moved to the others")
        << with(plateOf(-20, 0, 20, 40), side(120)) << &kMoveToOther << &kNotConnected;
    QTest::newRow("a shelf that ends on a wall gets tabs")
        << withSection(withSection(newDocument(), plateOf(-40, 0, 40, 100), side()),
                       plateOf(1.5, -30, 60, 30), lyingAt(50))
        << &kJoinWithTabs << &kNotConnected;
    QTest::newRow("a shelf that ends in a wall gets tabs")
        << withSection(withSection(newDocument(), plateOf(-40, 0, 40, 100), side()),
                       plateOf(0.5, -30, 60, 30), lyingAt(50))
        << &kJoinWithTabs << &kInterference;
    QTest::newRow("what was not to be joined is joined again, so that it holds")
        << without(eggCrate(1, 1)) << &kJoinAgain << &kNotConnected;
    QTest::newRow("what was not to be joined is joined again, so that it does not collide")
        << without(eggCrate(2, 2), 2) << &kJoinAgain << &kNoSlit;
    QTest::newRow("what no slit holds is trimmed") << without(eggCrate(1, 1)) << &kTrim << &kNoSlit;
    QTest::newRow("a loose plate is deleted")
        << with(plateOf(-20, 0, 20, 40), front(90)) << &kDeleteSections << &kNotConnected;
    QTest::newRow("slits are turned round")
        << roundabout(eggCrate(2, 2), 0) << &kMakeAssemblable << &kCannotAssemble;
    QTest::newRow("what hangs is dropped")
        << moveAll(eggCrate(2, 2), {0, 12, 0}) << &kDropToGround << &kNoContact;
    QTest::newRow("feet that end too high are stretched")
        << withSection(withSection(withSection(newDocument(), plateOf(-100, 40, 100, 80), front()),
                                   plateOf(-30, 0, 30, 60), side(60)),
                       plateOf(-30, 6, 30, 60), side(-60))
        << &kStretchToGround << &kLeans;
    QTest::newRow("what is sunk is lifted")
        << moveAll(eggCrate(2, 2), {0, -12, 0}) << &kDropToGround << &kBelowGround;
}

// Wrong: it falls over, and no foot is offered, since it would end in the other leg.
void TestCheckActions::aFootGoesThroughWhatStandsBesideIt()
{
    for (const double apart : {10.0, 15.0, 20.0}) {
        const Document document =
            withSection(withSection(withSection(newDocument(), plateOf(-60, 30, 60, 90), front()),
                                    plateOf(-40, 0, 40, 70), side(-35.0 - apart)),
                        plateOf(-40, 0, 40, 70), side(-35));
        const Staged before = stagedWithMends(document);
        const auto falls = std::find_if(before.found.begin(), before.found.end(),
                                        [](const Finding &f) { return f.is(kTopples); });
        QVERIFY(falls != before.found.end());
        const std::vector<Mend> *mends = before.mends->of(*falls);
        QVERIFY(mends);
        const auto foot = std::find_if(mends->begin(), mends->end(), [](const Mend &mend) {
            return mend.action.kind == &kAddFoot;
        });
        QVERIFY2(foot != mends->end(), qPrintable(QString::number(apart)));
        const Staged after = staged(foot->edit->document);
        QVERIFY(std::none_of(after.found.begin(), after.found.end(),
                             [](const Finding &f) { return f.severity >= Severity::Warning; }));
    }
}

// Wrong: a link that promises to mend what is wrong and leaves it, or cannot be taken back.
void TestCheckActions::editsMend()
{
    QFETCH(Document, document);
    QFETCH(const ActionKind *, kind);
    QFETCH(const FindingKind *, finding);
    const Checked before = checked(document);
    QVERIFY(count(before, *finding) > 0);
    QVERIFY(isEdit(*kind));
    const std::optional<FindingEdit> edit = done(before, kind);
    QVERIFY(edit);
    QVERIFY(!edit->document.isSame(document));
    QVERIFY(!messageText(edit->step.words).isEmpty());
    const Checked after = checked(edit->document);
    QVERIFY(count(after, *finding) < count(before, *finding));
    QVERIFY(problems(after) < problems(before));
    QVERIFY(!done(after, kind)); // it is done

    Session session;
    session.reset(document);
    session.commit(messageText(edit->step.words), edit->document);
    QVERIFY(session.committed().document == edit->document);
    session.history()->undo();
    QVERIFY(session.committed().document == document);
}

// Wrong: a joint that comes back opens to the other side; one that is long gone hides the one that
// helps; or a link joins sections that the check is not about.
void TestCheckActions::whatWasWantedOfAJointComesBack()
{
    Document crate = eggCrate(1, 1);
    const SectionId a = crate.sections[0]->id, b = crate.sections[1]->id;
    JointOverride wanted;
    wanted.a = a;
    wanted.b = b;
    wanted.opens = Vec2(0, -1);
    wanted.shares = {{Vec2(20, 20), 0.3}};
    const Document before = *setJointOverride(crate, wanted);
    wanted.kind = JointKind::None;
    const Document loose = *setJointOverride(crate, wanted);
    const std::optional<FindingEdit> edit = done(checked(loose), &kJoinAgain);
    QVERIFY(edit);
    QVERIFY(edit->document == before);
    QCOMPARE(messageText(edit->step.words), QStringLiteral("Join Section 1 and Section 2"));

    // A third one, that neither of them meets, and that was not to be joined either.
    Document third = withSection(loose, plateOf(-10, 0, 10, 40), front(200));
    JointOverride gone;
    gone.a = a;
    gone.b = third.sections[2]->id;
    gone.kind = JointKind::None;
    third = *setJointOverride(std::move(third), gone);
    gone.a = b;
    third = *setJointOverride(std::move(third), gone);
    int offered = 0;
    const Checked all = checked(third);
    for (const Finding &finding : all.checks)
        for (const FindingAction &action : actionsOf(finding, all.analysis))
            if (action.kind == &kJoinAgain) {
                ++offered;
                const auto joined = carriedOut(action, finding, all.analysis);
                QVERIFY(joined && !joined->document.jointOverride(a, b)->kind);
            }
    QVERIFY(offered >= 2); // of what is loose, and of what collides

    // Two that are in each other beside their joint have nothing to do with it.
    const Document tabless = withSection(loose, plateOf(1.0, -30, 60, 30), lyingAt(60));
    const Checked deep = checked(tabless);
    for (const Finding &finding : deep.checks)
        if (finding.is(kInterference))
            for (const FindingAction &action : actionsOf(finding, deep.analysis))
                QVERIFY(action.kind != &kJoinAgain);
}

void TestCheckActions::whatOnlyShowsIsOffered()
{
    const auto offers = [](const Document &document, const ActionKind *kind) {
        const Checked all = checked(document);
        return std::any_of(all.checks.begin(), all.checks.end(), [&](const Finding &finding) {
            const auto actions = actionsOf(finding, all.analysis);
            return std::any_of(actions.begin(), actions.end(), [&](const FindingAction &action) {
                return action.kind == kind && !isEdit(*kind) &&
                       !carriedOut(action, finding, all.analysis);
            });
        });
    };
    Document milled = eggCrate(2, 2);
    Stock stock = *milled.stocks.front();
    stock.toolDiameter = 2.0 * stock.thickness;
    stock.slitEnd = SlitEnd::Round;
    QVERIFY(offers(*setStock(milled, stock), &kWidenSlits));
    QVERIFY(offers(eggCrate(2, 2), &kShowSteps));
    QVERIFY(!offers(withSection(newDocument(), plateOf(0, 0, 50, 50), front()), &kShowSteps));
    QVERIFY(offers(onSheets(eggCrate(2, 2), {50, 50}), &kChooseSheet));
    QVERIFY(!offers(eggCrate(2, 2), &kChooseSheet));
}

void TestCheckActions::looseSectionsAreJoined_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<double>("farthest"); // mm
    const auto add = [](const char *name, ShapePointer shape, const Frame &frame, double farthest) {
        QTest::newRow(name) << with(std::move(shape), frame) << farthest;
    };
    // To where the faces touch, and on through the half of the other one and a web, or by an
    // overlap; and what the search is off by.
    add("its edge goes into the face of the other one", plateOf(70, 10, 110, 40), front(20),
        68.5 + 9.0);
    add("it goes down onto the edge of the other one", plateOf(-20, 90, 20, 120), side(30),
        30.0 + 9.0);
    add("it hangs beside the other one", plateOf(-20, 20, 20, 50), side(80), 28.5 + 9.0);
    add("it stands oblique", plateOf(60, 0, 110, 40), turned(radians(-30.0)), 52.0 + 12.0);
    add("it touches already", plateOf(1.5, 0, 40, 40), front(20), 9.0);
}

// Wrong: a section that is moved beside the other one, or right through it.
void TestCheckActions::looseSectionsAreJoined()
{
    QFETCH(Document, document);
    QFETCH(double, farthest);
    const Checked before = checked(document);
    QCOMPARE(count(before, kNotConnected), 1);
    const std::optional<FindingEdit> edit = done(before, &kMoveToOther);
    QVERIFY(edit);
    const Checked after = checked(edit->document);
    QCOMPARE(count(after, kNotConnected), 0);
    for (const FindingKind *kind :
         {&kNoSlit, &kInterference, &kThinWeb, &kSlitsMeet, &kBelowGround, &kCannotAssemble})
        QCOMPARE(count(after, *kind), count(before, *kind));
    const Vec3 way = edit->document.sections[2]->frame.origin - document.sections[2]->frame.origin;
    QVERIFY2(way.norm() < farthest, qPrintable(QString::number(way.norm())));
    // It was not turned, and nobody else was moved.
    QVERIFY(edit->document.sections[2]->frame.x == document.sections[2]->frame.x);
    QVERIFY(edit->document.sections[0] == document.sections[0]);
    QVERIFY(edit->document.sections[1] == document.sections[1]);
}

void TestCheckActions::whatCannotBeJoinedIsNotMoved_data()
{
    QTest::addColumn<Document>("document");
    const Document one = withSection(newDocument(), plateOf(-50, 0, 50, 60), front());
    QTest::newRow("it is parallel to the other one")
        << withSection(one, plateOf(-20, 0, 20, 40), front(40));
    QTest::newRow("it lies in the other one's plane")
        << withSection(one, plateOf(80, 0, 120, 40), front());
    QTest::newRow("it is nearly parallel")
        << withSection(one, plateOf(60, 0, 90, 40), turned(radians(5.0)));
    QTest::newRow("it is a speck") << withSection(one, plateOf(-1, 20, 1, 22), side(80));
    QTest::newRow("there is no other one") << one;
}

// Wrong: a link after which nothing holds the section either.
void TestCheckActions::whatCannotBeJoinedIsNotMoved()
{
    QFETCH(Document, document);
    const Checked all = checked(document);
    QVERIFY(!done(all, &kMoveToOther));
    if (count(all, kNotConnected) > 0)
        QVERIFY(done(all, &kDeleteSections));
}

// Wrong: a fin that stays in the air when its tail goes, or the body that goes along with it.
void TestCheckActions::whatWasDrawnOnItComesAlong()
{
    // A loose tail with a fin in it, a plate drawn on it that nothing holds any more, and one of
    // the crossed plates drawn on it, too.
    Document document = with(plateOf(80, 0, 140, 40), front(20));
    const SectionId tail = document.sections[2]->id;
    const auto drawnOnTail = [&](ShapePointer shape, const Frame &frame) {
        NewSection section;
        section.shape = std::move(shape);
        section.frame = frame;
        section.parent = Parent{tail, {0, 0}, {0, 20}};
        document = *addSection(std::move(document), std::move(section));
    };
    drawnOnTail(plateOf(-40, 10, -8, 50), side(110));
    drawnOnTail(plateOf(-10, 0, 10, 20), side(400));
    drawnOnTail(plateOf(-20, 0, 20, 50), front(-30)); // held by the side plate
    const Checked before = checked(document);
    const Finding *loose = nullptr;
    for (const Finding &finding : before.checks)
        if (finding.is(kNotConnected) && finding.sections.size() == 2)
            loose = &finding;
    QVERIFY(loose);
    const std::optional<JoiningMove> move =
        joiningMove(before.analysis, loose->sections, before.analysis.model.ref(1));
    QVERIFY(move);
    std::vector<std::size_t> went;
    const Document next = moved(document, *move);
    for (std::size_t i = 0; i < next.sections.size(); ++i) {
        const Vec3 way = next.sections[i]->frame.origin - document.sections[i]->frame.origin;
        if (way.isZero())
            continue;
        went.push_back(i);
        QVERIFY((way - move->way).norm() < 1e-9);
    }
    QCOMPARE(went, (std::vector<std::size_t>{2, 3, 4}));
    QVERIFY(count(checked(next), kNotConnected) < count(before, kNotConnected));
}

// Wrong: a move that mends one thing and breaks another.
void TestCheckActions::anyLooseSectionIsJoinedWell()
{
    constexpr unsigned kSeed = 5; // of the places
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> place(-150, 150), turn(0, 3.14159), size(20, 60);
    int offered = 0;
    for (int i = 0; i < 60; ++i) {
        Frame frame = turned(turn(random));
        frame.origin = {place(random), std::abs(place(random)), place(random)};
        const Document document = with(plateOf(0, 0, size(random), size(random)), frame);
        const Checked before = checked(document);
        if (count(before, kNotConnected) == 0)
            continue;
        const std::optional<FindingEdit> edit = done(before, &kMoveToOther);
        if (!edit)
            continue;
        ++offered;
        const Checked after = checked(edit->document);
        const QByteArray which = "place " + QByteArray::number(i);
        QVERIFY2(count(after, kNotConnected) == 0, which);
        for (const FindingKind *kind : {&kNoSlit, &kInterference, &kSlitsMeet, &kBelowGround})
            QVERIFY2(count(after, *kind) <= count(before, *kind), which);
    }
    QVERIFY2(offered >= 30, qPrintable(QString::number(offered)));
}

// Wrong: what a row of an older model offers is done to sections that are not there any more.
void TestCheckActions::aLaterModelIsAskedAnew()
{
    const Document document = with(plateOf(-20, 0, 20, 40), side(120));
    const Checked all = checked(document);
    const auto loose =
        std::find_if(all.checks.begin(), all.checks.end(),
                     [](const Finding &finding) { return finding.is(kNotConnected); });
    QVERIFY(loose != all.checks.end());
    for (const std::size_t gone : {0u, 2u}) {
        const Analysis later =
            analysed(*removeSections(document, std::vector{document.sections[gone]->id}));
        QVERIFY(!carriedOut({&kMoveToOther, *loose->details<Gap>()->other}, *loose, later) ||
                later.model.indexOf(*loose->details<Gap>()->other) >= 0);
        QCOMPARE(carriedOut({&kDeleteSections, {}}, *loose, later).has_value(), gone == 0);
    }
}

// Wrong: a command that moves a model which stands on the ground, by what nobody sees.
void TestCheckActions::onlyWhatDoesNotStandThereIsDropped()
{
    const Document upright = eggCrate(2, 2);
    const auto isDropped = [](const Document &document, double height) {
        const auto next = droppedToGround(evaluate(moveAll(document, {0, height, 0})));
        return next && std::abs(*lowestPoint(evaluate(*next))) < 1e-9;
    };
    for (const double height : {0.0, 0.04, -0.04, -0.15})
        QVERIFY2(!isDropped(upright, height), qPrintable(QString::number(height)));
    for (const double height : {0.06, 20.0, -0.25, -20.0})
        QVERIFY2(isDropped(upright, height), qPrintable(QString::number(height)));
    // It lies there, with its middle or its lower face at Y = 0.
    const Document lying = withSection(newDocument(), plateOf(-40, -40, 40, 40), lyingAt(0));
    QVERIFY(!isDropped(lying, 0.0) && !isDropped(lying, 1.5));
    QVERIFY(isDropped(lying, 2.0) && isDropped(lying, -1.0));
    QVERIFY(!droppedToGround(evaluate(newDocument())));
}

FFF_TEST(TestCheckActions)
#include "tst_check_actions.moc"
