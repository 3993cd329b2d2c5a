#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/findings/few_sheets.h"
#include "core/analysis/nested.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "core/session/session.h"
#include "core/session/sheet_nesting.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/all_findings.h"
#include "tests/test_program.h"

#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>

#include <algorithm>
#include <stdexcept>

using namespace fff;
using namespace fff::test;

class TestCheckList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreOfTheModelThatIsShown();
    void whatIsLateSaysNothingOfAnEmptyModel();
    void rulesAreFollowedAtOnce();
    void aMoveOfADragTellsOnce();
    void aStageThatGoesOnBreakingIsReportedOnce();
    void sheetsAreCountedOnce();
};

// Wrong: a person cuts by the verdicts on another model.
void TestCheckList::theyAreOfTheModelThatIsShown()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"),
                   withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front()));
    session.currentAnalysis();
    list.finish();
    QVERIFY(!list.all().empty());
    QCOMPARE(list.model().sectionCount(), std::size_t(1));
    QCOMPARE(list.age(), CheckList::Age::Current);
    session.history()->undo();
    QVERIFY(list.all().empty());
    QCOMPARE(list.age(), CheckList::Age::Current);
}

// Wrong: "Falls over" beside an empty view, said to be current.
void TestCheckList::whatIsLateSaysNothingOfAnEmptyModel()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"),
                   withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front()));
    session.currentAnalysis(); // their checks are worked out from now on
    session.history()->undo();
    list.finish();
    QVERIFY(list.all().empty());
    QCOMPARE(list.model().sectionCount(), std::size_t(0));
}

// Wrong: a setting that does nothing until the next edit, or never.
void TestCheckList::rulesAreFollowedAtOnce()
{
    Session session;
    CheckList list(session);
    const ShapePointer plate = polygonShape(rectangle(-30, 0, 30, 40));
    session.commit(QStringLiteral("Draw"), withSection(withSection(newDocument(), plate, front()),
                                                       plate, turned(radians(40.0))));
    session.currentAnalysis();
    const auto severityOf = [&list](const FindingKind &kind) -> std::optional<Severity> {
        list.finish();
        for (const Finding &finding : list.all())
            if (finding.is(kind))
                return finding.severity;
        return {};
    };
    QVERIFY(!severityOf(kShallowAngle));
    session.scheduler().setRules({radians(45.0), 0.3, std::chrono::milliseconds(0)});
    QCOMPARE(severityOf(kShallowAngle), Severity::Warning);
    QCOMPARE(severityOf(kOrderUnknown), Severity::Unknown);
    QCOMPARE(list.age(), CheckList::Age::Current);
    session.scheduler().setRules({});
    QVERIFY(!severityOf(kShallowAngle));
    QCOMPARE(severityOf(kCanAssemble), Severity::Good);
}

// Wrong: docks that write all their rows anew for joints that no verdict is of yet.
void TestCheckList::aMoveOfADragTellsOnce()
{
    Session session;
    CheckList list(session);
    const Document one =
        withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front());
    session.commit(QStringLiteral("Draw"), one);
    list.finish();
    QSignalSpy changed(&list, &CheckList::changed);
    for (int i = 1; i <= 5; ++i) {
        session.preview(*moveSection(one, one.sections[0]->id, front(i)));
        session.scheduler().finish();
        // Verdicts, what the order of assembly says, and whether it holds.
        QCOMPARE(changed.count(), 3 * i);
    }
}

// Wrong: a disk that is written to sixty times a second, while a person drags.
void TestCheckList::aStageThatGoesOnBreakingIsReportedOnce()
{
    QTemporaryDir reports;
    Session session;
    CheckList list(session, reports.path());
    session.scheduler().setCompute(kVerdicts.name,
                                   [](const Snapshot &, const void *, Progress &,
                                      std::stop_token) -> Result<std::shared_ptr<const void>> {
                                       throw std::runtime_error("out of luck");
                                   });
    const Document one =
        withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60)), front());
    session.commit(QStringLiteral("Draw"), one);
    for (int i = 1; i <= 5; ++i) {
        session.scheduler().finish();
        session.preview(*moveSection(one, one.sections[0]->id, front(i)));
    }
    session.scheduler().finish();
    QCOMPARE(QDir(reports.path()).entryList({QStringLiteral("*.fff")}, QDir::Files).size(), 1);
}

// Wrong: "3 sheets, 28 %" among the checks, and "2 sheets, 42 %" under the sheets.
void TestCheckList::sheetsAreCountedOnce()
{
    Session session;
    CheckList list(session);
    SheetNesting nesting(session);
    // Their boxes fill a sheet each; turned about, both lie on one.
    const ShapePointer half = polygonShape({{0, 0}, {180, 0}, {0, 170}});
    const Document two = onSheets(
        withSection(withSection(newDocument(), half, front()), half, front(60)), {210, 200});
    session.commit(QStringLiteral("Draw"), two);
    const auto said = [&] {
        session.currentAnalysis();
        list.finish();
        for (const Finding &finding : list.all())
            if (finding.is(kFitsSheet))
                return findingText(finding, list.model()).replace(QChar(0x202f), u' ');
        return QString();
    };
    const QString packed = QStringLiteral("Fits the sheet. At most 2 sheets of 210 × 200 mm.");
    QCOMPARE(said(), packed);
    nesting.setWanted(this, true);
    const auto nested = [&] {
        session.scheduler().finish(kNested.name);
        return QStringLiteral("Fits the sheet. 1 sheet of 210 × 200 mm, %1 % used.")
            .arg(qRound(100.0 * nesting.result()->filled));
    };
    const QString lies = nested();
    QCOMPARE(said(), lies);
    nesting.setWanted(this, false); // the panels were closed: it still lies there
    session.scheduler().finish(kNested.name);
    QCOMPARE(said(), lies);
    session.commit(QStringLiteral("Move"), *moveSection(two, two.sections[1]->id, front(70)));
    QCOMPARE(said(), packed);
    // Of one sheet their boxes take more than there are; they themselves do not.
    Stock stock = *two.stocks.front();
    stock.sheetCount = 1;
    session.commit(QStringLiteral("One sheet"), *setStock(two, stock));
    const auto runsOut = [&] {
        said();
        return std::any_of(list.all().begin(), list.all().end(),
                           [](const Finding &finding) { return finding.is(kFewSheets); });
    };
    QVERIFY(runsOut());
    nesting.setWanted(this, true);
    session.scheduler().finish(kNested.name);
    QCOMPARE(said(), lies);
    QVERIFY(!runsOut());
}

FFF_TEST(TestCheckList)
#include "tst_check_list.moc"
