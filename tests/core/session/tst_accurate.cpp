// Sections that bend: worked out beside the quick answer, and in its place once that is there.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/accurate.h"
#include "core/analysis/analysed.h"
#include "core/analysis/check_rules.h"
#include "core/io/document_file.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/session.h"
#include "tests/core/analysed.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>

using namespace fff;
using namespace fff::test;

// What would be wrong: two verdicts beside each other, one that is of another model, or a window
// that waits.

namespace {

Document glass()
{
    return io::readDocument(QStringLiteral(FFF_SAMPLES "/glass_four_legs.fff")).value().document;
}

CheckRules bending(bool isElastic)
{
    CheckRules rules;
    rules.strength.isElastic = isElastic;
    return rules;
}

int countOf(const CheckList &list, Subject subject)
{
    return static_cast<int>(
        std::count_if(list.all().begin(), list.all().end(), [&](const Finding &finding) {
            return finding.subject() == subject && finding.severity != Severity::Note;
        }));
}

/// The very sentence.
bool says(const CheckList &list, const Finding &wanted)
{
    const Model &model = list.model();
    return std::any_of(list.all().begin(), list.all().end(), [&](const Finding &finding) {
        return finding.kind == wanted.kind &&
               findingText(finding, model) == findingText(wanted, model);
    });
}

} // namespace

class TestAccurate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nobodyAsks();
    void takesThePlaceOfTheQuickOne();
    void stoppedTheQuickOneStays();
    void anEditBringsTheQuickOneBack();
    void stoppedBeforehandItDoesNothing();
    void saysHowFarItBends();
};

void TestAccurate::nobodyAsks()
{
    Session session;
    const CheckList list(session);
    session.scheduler().setRules(bending(false));
    session.commit(QStringLiteral("Open"), glass());
    session.scheduler().finish();
    const auto accurate = session.scheduler().result(kAccurate);
    QVERIFY(accurate && !accurate->held && accurate->findings.empty());
    QVERIFY(!session.scheduler().result(kHolding)->strength.isElastic);
    QCOMPARE(countOf(list, Subject::Strength), 1);
}

void TestAccurate::takesThePlaceOfTheQuickOne()
{
    Session session;
    CheckList list(session);
    session.scheduler().setRules(bending(true));
    session.commit(QStringLiteral("Open"), glass());
    session.scheduler().finish();
    const auto quick = session.scheduler().result(kHolding);
    const auto accurate = session.scheduler().result(kAccurate);
    QVERIFY(!quick->strength.isElastic); // it follows a drag
    QVERIFY(accurate && accurate->held && accurate->held->strength.isElastic);
    // The numbers are those of the command line.
    StrengthCaches caches;
    const Strength alone = strengthOf(*quick->analysis, bending(true).strength, caches);
    QCOMPARE(accurate->held->strength.neckUse, alone.neckUse);
    QCOMPARE(accurate->held->strength.cornerUse, alone.cornerUse);
    QVERIFY(alone.neckUse != quick->strength.neckUse);
    // One verdict, and that one.
    QCOMPARE(countOf(list, Subject::Strength), 1);
    QVERIFY(says(list, accurate->findings.front()));
    session.scheduler().setRules(bending(false));
    session.scheduler().finish();
    QVERIFY(says(list, quick->findings.front()));
}

void TestAccurate::stoppedTheQuickOneStays()
{
    Session session;
    CheckList list(session);
    session.scheduler().setCompute(kAccurate.name,
                                   [](const Snapshot &, const void *, Progress &,
                                      std::stop_token stop) -> Result<std::shared_ptr<const void>> {
                                       while (!stop.stop_requested())
                                           std::this_thread::yield();
                                       return failure(ErrorCode::Cancelled);
                                   });
    session.scheduler().setRules(bending(true));
    session.commit(QStringLiteral("Open"), glass());
    session.scheduler().finish(kHolding.name);
    QTRY_VERIFY(session.scheduler().isRunning(kAccurate.name));
    QCOMPARE(list.age(), CheckList::Age::Current); // nobody waits for it
    QCOMPARE(countOf(list, Subject::Strength), 1);
    session.scheduler().cancel(kAccurate.name);
    session.scheduler().finish();
    QVERIFY(session.scheduler().failureOf(kAccurate.name));
    const auto quick = session.scheduler().result(kHolding);
    QVERIFY(says(list, quick->findings.front()));
}

/// While a weight is dragged, what was accurate of the model before is none of this one.
void TestAccurate::anEditBringsTheQuickOneBack()
{
    Session session;
    CheckList list(session);
    session.scheduler().setRules(bending(true));
    session.commit(QStringLiteral("Open"), glass());
    session.scheduler().finish();
    Document heavier = session.committed().document;
    heavier.loads.front().mass *= 1.5;
    session.preview(heavier);
    session.scheduler().finish();
    const auto quick = session.scheduler().result(kHolding);
    QVERIFY(session.scheduler().revisionOf(kAccurate.name) !=
            session.scheduler().revisionOf(kHolding.name));
    QVERIFY(says(list, quick->findings.front()));
    session.commit(QStringLiteral("Heavier"), heavier);
    session.scheduler().finish();
    QCOMPARE(session.scheduler().revisionOf(kAccurate.name),
             session.scheduler().revisionOf(kHolding.name));
}

void TestAccurate::stoppedBeforehandItDoesNothing()
{
    const auto analysis = std::make_shared<const Analysis>(analysed(evaluate(glass())));
    Snapshot::Results results{
        {kAnalysed.name, std::make_shared<const Analysed>(Analysed{analysis, {}})},
        {kRules.name, std::make_shared<const CheckRules>(bending(true))}};
    std::stop_source stop;
    stop.request_stop();
    Progress progress;
    const auto out = accurate(Snapshot(0, results), nullptr, progress, stop.get_token());
    QVERIFY(!out && out.error().code == ErrorCode::Cancelled);
    QVERIFY(progress.share() < 0.5);
}

// Wrong: a stand that sags by millimetres, of which nothing is said; or a chair that does not.
void TestAccurate::saysHowFarItBends()
{
    const auto wordsOf = [](const char *name) {
        Session session;
        CheckList list(session);
        session.scheduler().setRules(bending(true));
        session.commit(
            QStringLiteral("Open"),
            io::readDocument(QStringLiteral(FFF_SAMPLES) + QLatin1String(name)).value().document);
        session.scheduler().finish();
        const auto accurate = session.scheduler().result(kAccurate);
        return std::pair(findingText(accurate->findings.front(), list.model()),
                         accurate->bent->most);
    };
    const auto [stand, sag] = wordsOf("/acrylic_thick_three.fff");
    QVERIFY(sag > 1.0);
    const QString said = QStringLiteral("Bends %1").arg(std::floor(sag));
    QVERIFY2(stand.contains(said), qPrintable(stand));
    const auto [chair, none] = wordsOf("/chair.fff");
    QVERIFY(none < 1.0 && !chair.contains(QStringLiteral("Bends")));
}

FFF_TEST(TestAccurate)
#include "tst_accurate.moc"
