// What is green speaks of what is really there: beside parts that nothing holds nobody knows.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/doubted_verdicts.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/thin_necks.h"
#include "core/model/edits.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/session.h"
#include "tests/core/assembly/plates.h"
#include "tests/core/session/all_findings.h"
#include "tests/core/session/staged.h"
#include "tests/test_program.h"

#include <QLocale>

using namespace fff;
using namespace fff::test;

namespace {

/// Two plates across each other on the ground, so far to the right.
Document withCross(Document document, double right)
{
    const ShapePointer plate = plateOf(-50, 0, 50, 60);
    Frame one = front(), other = side();
    one.origin.x() = other.origin.x() = right;
    return withSection(withSection(std::move(document), plate, one), plate, other);
}

/// Two crosses that both stand by themselves.
Document twoCrosses()
{
    return withCross(withCross(newDocument(), 0.0), 200.0);
}

/// A shelf goes all through two plates that cross, and one of the pieces carries a flag.
Document withSeveredPiece()
{
    Document document = withCross(newDocument(), 0.0);
    const Frame shelf{{0, 30, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
    document = withSection(std::move(document), plateOf(-60, -60, 60, 60), shelf);
    document = withSection(std::move(document), plateOf(-10, 45, 10, 80), side(25));
    for (const double foot : {-35.0, 35.0}) // of what is left below, which is the largest group
        document = withSection(std::move(document), plateOf(-10, 0, 10, 15), side(foot));
    return document;
}

QString textOf(const Staged &all, const FindingKind &kind)
{
    const Finding *finding = find(all.found, kind);
    return finding ? findingText(*finding, all.analysis->model) : QString();
}

} // namespace

class TestDoubtedVerdicts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void nothingIsGreenBesideWhatIsLoose();
    void alsoWhileAModelIsBegun();
    void aMendMakesThemGreenAgain();
    void aPieceWithWhatItCarries();
    void whatHangsByNothing();
    void slitsThatDoNotFit_data();
    void slitsThatDoNotFit();
};

// Wrong: "Stands" and "Strong enough" were green, of a heap of parts.
void TestDoubtedVerdicts::nothingIsGreenBesideWhatIsLoose()
{
    const Staged held = staged(withCross(newDocument(), 0.0));
    QVERIFY(find(held.found, kStands) && find(held.found, kHolds));
    const Staged loose = staged(twoCrosses());
    QVERIFY(find(loose.found, kNotConnected));
    QVERIFY(!find(loose.found, kStands) && !find(loose.found, kHolds));
    for (const auto &[kind, begins] :
         {std::pair(&kWouldStand, "Would stand if it held together. "),
          std::pair(&kWouldHold, "Would be strong enough if it held together. ")}) {
        QCOMPARE(find(loose.found, *kind)->severity, Severity::Unknown);
        const QString text = textOf(loose, *kind);
        QVERIFY2(text.contains(QLatin1String(begins)), qPrintable(text));
    }
}

void TestDoubtedVerdicts::alsoWhileAModelIsBegun()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"), twoCrosses());
    list.setBeginning(true);
    list.finish();
    QVERIFY(find(list.all(), kNotConnected)->isYet);
    QVERIFY(find(list.all(), kWouldStand) && find(list.all(), kWouldHold));
    session.commit(QStringLiteral("Draw"), withCross(newDocument(), 0.0));
    list.finish();
    QVERIFY(find(list.all(), kStands) && find(list.all(), kHolds));
}

// A verdict that is known again is none that a mend has made worse, or better.
void TestDoubtedVerdicts::aMendMakesThemGreenAgain()
{
    Session session;
    CheckList list(session);
    session.commit(QStringLiteral("Draw"), twoCrosses());
    list.finish();
    int offered = 0;
    for (const Mend &mend : list.mendsOf(*find(list.all(), kNotConnected))) {
        if (!mend.isEdit())
            continue;
        ++offered;
        const bool isWhole = !find(mend.tried->findings, kNotConnected);
        QCOMPARE(find(mend.tried->findings, kHolds) != nullptr, isWhole);
        QCOMPARE(find(mend.tried->findings, kWouldHold) == nullptr, isWhole);
    }
    QVERIFY(offered > 0);
}

// Wrong: it was said to meet the very section that it was a piece of.
void TestDoubtedVerdicts::aPieceWithWhatItCarries()
{
    const Staged all = staged(withSeveredPiece());
    const Finding *severed = find(all.found, kSevered);
    QStringList said;
    for (const Finding &finding : all.found)
        said += findingText(finding, all.analysis->model);
    QVERIFY2(severed && severed->severity == Severity::Error, qPrintable(said.join(u'\n')));
    QVERIFY(!find(all.found, kNotConnected));
    const QString text = textOf(all, kSevered);
    QVERIFY2(
        text.startsWith(QStringLiteral("Slits cut Section 1 apart. Nothing holds its part of ")) &&
            text.endsWith(QStringLiteral(" with Section 4.")),
        qPrintable(text));
}

// Wrong: "Stands" was green beside "Falls apart".
void TestDoubtedVerdicts::whatHangsByNothing()
{
    // Wrong: what was not on the ground was green until it was raised to it.
    for (const double height : {1.5, -20.0, 30.0}) // mm, of its middle
        for (const double half : {0.005, 4.0}) {   // mm, of the neck
            const ShapePointer dumbbell = polygonShape({{-60, -30},
                                                        {-20, -30},
                                                        {-20, -half},
                                                        {20, -half},
                                                        {20, -30},
                                                        {60, -30},
                                                        {60, 30},
                                                        {20, 30},
                                                        {20, half},
                                                        {-20, half},
                                                        {-20, 30},
                                                        {-60, 30}});
            const Frame lying{{0, height, 0}, Vec3::UnitX(), -Vec3::UnitZ()};
            const Staged all = staged(withSection(newDocument(), dumbbell, lying));
            const bool hangs = half < 1.0;
            QCOMPARE(find(all.found, kHangsByNothing) != nullptr, hangs);
            QCOMPARE(find(all.found, kStands) == nullptr, hangs || height != 1.5);
            QCOMPARE(find(all.found, kWouldStand) != nullptr, hangs && height == 1.5);
            QCOMPARE(find(all.found, kConnected) == nullptr, hangs);
            QCOMPARE(find(all.found, kCanAssemble) == nullptr, hangs);
            if (!hangs)
                continue;
            QCOMPARE(textOf(all, kWouldConnect),
                     QStringLiteral("Would be connected if nothing fell apart."));
            QCOMPARE(textOf(all, kCouldAssemble),
                     QStringLiteral("Could be assembled if nothing fell apart."));
        }
}

void TestDoubtedVerdicts::slitsThatDoNotFit_data()
{
    QTest::addColumn<double>("clearance"); // mm
    QTest::addColumn<double>("kerf");
    QTest::addColumn<bool>("connects");
    QTest::addColumn<bool>("goesTogether");
    QTest::addColumn<bool>("stands");
    QTest::newRow("they fit") << 0.0 << 0.15 << true << true << true;
    QTest::newRow("wide, but it stands") << 0.6 << 0.15 << true << true << true;
    QTest::newRow("10 mm too wide") << 10.0 << 0.15 << false << true << false;
    QTest::newRow("closed by the kerf") << 0.0 << 20.0 << false << false << false;
    QTest::newRow("too tight") << -0.5 << 0.15 << true << false << true;
}

// Wrong: "Stands" was green beside slits in which nothing is held, "Can be assembled" beside a slit
// that is not there when it is cut.
void TestDoubtedVerdicts::slitsThatDoNotFit()
{
    QFETCH(double, clearance);
    QFETCH(double, kerf);
    QFETCH(bool, connects);
    QFETCH(bool, goesTogether);
    QFETCH(bool, stands);
    Document document = withCross(newDocument(), 0.0);
    Stock stock = *document.stocks.front();
    stock.clearance = clearance;
    stock.kerf = kerf;
    document = *setStock(std::move(document), stock);
    const Staged all = staged(document);
    QStringList said;
    for (const Finding &finding : all.found)
        said += findingText(finding, all.analysis->model);
    const QByteArray list = said.join(u'\n').toUtf8();
    QVERIFY2((find(all.found, kConnected) != nullptr) == connects, list.constData());
    QVERIFY2((find(all.found, kWouldConnect) != nullptr) != connects, list.constData());
    QVERIFY2((find(all.found, kCanAssemble) != nullptr) == goesTogether, list.constData());
    QVERIFY2((find(all.found, kCouldAssemble) != nullptr) != goesTogether, list.constData());
    QVERIFY2((find(all.found, kStands) != nullptr) == stands, list.constData());
    QVERIFY2((find(all.found, kWouldStand) != nullptr) != stands, list.constData());
}

FFF_TEST(TestDoubtedVerdicts)
#include "tst_doubted_verdicts.moc"
