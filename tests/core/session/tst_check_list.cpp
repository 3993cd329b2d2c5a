#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/session/check_list.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"

using namespace fff;
using namespace fff::test;

class TestCheckList : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theyAreOfTheModelThatIsShown();
    void whatIsLateSaysNothingOfAnEmptyModel();
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

QTEST_GUILESS_MAIN(TestCheckList)
#include "tst_check_list.moc"
