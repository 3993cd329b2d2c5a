#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/gap.h"
#include "core/analysis/trial.h"
#include "core/base/units.h"
#include "core/model/edits.h"
#include "core/session/message_text.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/test_program.h"

using namespace fff;
using namespace fff::test;

namespace {

/// Three plates, called "One", "Two" and "Three".
Document threePlates()
{
    Document document = eggCrate(1, 1);
    document = withSection(std::move(document), polygonShape(rectangle(0, 0, 20, 20)), front(90));
    const char *const names[] = {"One", "Two", "Three"};
    for (std::size_t i = 0; i < 3; ++i)
        document = *renameSection(document, document.sections[i]->id, names[i]);
    return document;
}

QString saidOf(const Document &before, const Document &after, const std::vector<Finding> &was = {},
               const std::vector<Finding> &is = {})
{
    return messageText(changesBetween(analysed(before), analysed(after), was, is));
}

Finding loose(const Document &document, std::vector<std::size_t> sections)
{
    Finding finding = makeFinding(kNotConnected, Severity::Error, Gap{});
    for (const std::size_t section : sections)
        finding.sections.push_back(document.sections[section]->ref());
    return finding;
}

Finding unsteady(Severity severity)
{
    return makeFinding(kUnsteady, severity, Footing{});
}

} // namespace

class TestTrialWords : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsTurnedIsSaidToBe();
    void whatGoesDownIsSaidToDoSo();
    void eachChangeNamesItsSection();
    void aNewJointIsToldWithItsSlit();
    void aLooseGroupThatGrowsIsNotNew();
    void oneMoreIsNew();
    void whatIsLessGraveIsSolved();
    void whatIsWorseIsNotSolved();
    void nothingIsTradedForAnother();
};

// Wrong: "Three moved by 0 mm".
void TestTrialWords::whatIsTurnedIsSaidToBe()
{
    const Document before = threePlates();
    Frame frame = before.sections[2]->frame;
    const Vec3 x = frame.x;
    const double angle = radians(69.6);
    frame.x = std::cos(angle) * x + std::sin(angle) * frame.normal();
    const Document after = *moveSection(before, before.sections[2]->id, frame);
    QCOMPARE(saidOf(before, after), QStringLiteral("Three turned by 70°"));
}

void TestTrialWords::whatGoesDownIsSaidToDoSo()
{
    const Document before = threePlates();
    const QString down = saidOf(before, moveAll(before, Vec3(0, -12, 0)));
    QVERIFY2(down.startsWith(QStringLiteral("3 sections moved down by 12")), qPrintable(down));
    const QString up = saidOf(before, moveAll(before, Vec3(0, 12, 0)));
    QVERIFY2(up.startsWith(QStringLiteral("3 sections moved up by 12")), qPrintable(up));
    QCOMPARE(saidOf(before, moveAll(before, Vec3(1, -12, 0))), QStringLiteral("3 sections moved"));
}

// Wrong: all changes by the name of the last one.
void TestTrialWords::eachChangeNamesItsSection()
{
    Document before = withSection(threePlates(), polygonShape(rectangle(0, 0, 20, 20)), front(130));
    before = *renameSection(before, before.sections[3]->id, "Four");
    Document after =
        *setShape(before, before.sections[2]->id, polygonShape(rectangle(0, 0, 30, 20)));
    after = withSection(std::move(after), polygonShape(rectangle(0, 0, 10, 10)), side(70));
    after = *renameSection(after, after.sections[4]->id, "Foot");
    after = *removeSections(after, std::vector{before.sections[3]->id});
    QCOMPARE(saidOf(before, after), QStringLiteral("Three reshaped, Foot added, Four deleted"));
}

// Wrong: a link that moves a section cuts a slit across another one, and nobody said so.
void TestTrialWords::aNewJointIsToldWithItsSlit()
{
    Document before = withSection(newDocument(), polygonShape(rectangle(0, 0, 40, 60)), front());
    before = withSection(std::move(before), polygonShape(rectangle(-20, 0, 20, 60)), side(200));
    before = *renameSection(before, before.sections[1]->id, "Two");
    const Document after = *moveSection(before, before.sections[1]->id, side(20));
    QCOMPARE(saidOf(before, after),
             QStringLiteral("Two moved by 180\u202Fmm, a new joint with a slit of 30\u202Fmm"));
}

// Wrong: "1 problem solved, new: Not connected" of what was loose and has one section more.
void TestTrialWords::aLooseGroupThatGrowsIsNotNew()
{
    const Document document = threePlates();
    QCOMPARE(saidOf(document, document, {loose(document, {2})}, {loose(document, {1, 2})}),
             QString());
}

void TestTrialWords::oneMoreIsNew()
{
    const Document document = threePlates();
    QCOMPARE(saidOf(document, document, {loose(document, {2})},
                    {loose(document, {1}), loose(document, {2})}),
             QStringLiteral("new: Not connected"));
}

// Wrong: nothing said of an error that is a warning now.
void TestTrialWords::whatIsLessGraveIsSolved()
{
    const Document document = threePlates();
    QCOMPARE(saidOf(document, document, {unsteady(Severity::Error)}, {unsteady(Severity::Warning)}),
             QStringLiteral("1 problem solved, new: Tips easily"));
    QCOMPARE(saidOf(document, document, {makeFinding(kTopples, Severity::Error, Footing{})},
                    {unsteady(Severity::Warning)}),
             QStringLiteral("1 problem solved, new: Tips easily"));
}

void TestTrialWords::whatIsWorseIsNotSolved()
{
    const Document document = threePlates();
    QCOMPARE(saidOf(document, document, {unsteady(Severity::Warning)}, {unsteady(Severity::Error)}),
             QStringLiteral("new: Falls at a touch"));
}

// Wrong: a link that makes one section whole and cuts another one in two, one that solves seven
// problems and leaves a section joined to nothing, one after which it falls farther.
void TestTrialWords::nothingIsTradedForAnother()
{
    const Document document = threePlates();
    const auto apart = [&](std::size_t section, int pieces) {
        Finding finding = makeFinding(kLoosePieces, Severity::Error,
                                      LoosePieces{pieces + 1, pieces, 20.0, 10.0, true});
        finding.sections = {document.sections[section]->ref()};
        return finding;
    };
    const std::vector<Finding> before{apart(0, 3), apart(1, 2)};
    QVERIFY(isNoWorse(before, std::vector<Finding>{apart(0, 2), apart(1, 2)}));
    QVERIFY(!isNoWorse(before, std::vector<Finding>{apart(0, 1), apart(2, 1)}));
    QVERIFY(!isNoWorse(before, std::vector<Finding>{apart(0, 1), loose(document, {2})}));
    const auto falls = [](double margin) {
        Footing footing;
        footing.margin = margin;
        return std::vector<Finding>{makeFinding(kTopples, Severity::Error, footing)};
    };
    QVERIFY(isNoWorse(falls(-37.0), falls(-30.0)));
    QVERIFY(isNoWorse(falls(-37.0), falls(-37.0)));
    QVERIFY(!isNoWorse(falls(-37.0), falls(-44.0)));
}

FFF_TEST(TestTrialWords)
#include "tst_trial_words.moc"
