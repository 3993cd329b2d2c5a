// Models and weights that nobody would make: an answer to each, in numbers that are numbers and a
// sentence.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/holding.h"
#include "core/model/load_edits.h"
#include "core/session/finding_text.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/staged.h"
#include "tests/test_program.h"

#include <QRegularExpression>

using namespace fff;
using namespace fff::test;

namespace {

Document withMass(Document document, std::size_t section, const Vec2 &at, double mass)
{
    Load weight;
    weight.section = document.sections[section]->ref();
    weight.position = at;
    weight.mass = mass;
    return *addLoad(std::move(document), weight);
}

Document withPush(Document document, std::size_t section, const Vec2 &at, const Vec3 &force)
{
    Load push;
    push.section = document.sections[section]->ref();
    push.position = at;
    push.kind = LoadKind::Push;
    push.push = force;
    return *addLoad(std::move(document), push);
}

/// Upright, 100 by 60, with a cross-piece so that it stands.
Document standing(const std::vector<Polygon> &holes)
{
    return withSection(
        withSection(newDocument(), polygonShape(rectangle(-50, 0, 50, 60), holes), front()),
        plateOf(-30, 0, 30, 20), side(-30.0));
}

/// Two plates across each other and a shelf across both: its corners fall off.
Document split()
{
    const ShapePointer plate = plateOf(-50, 0, 50, 60);
    return withSection(withSection(withSection(newDocument(), plate, front()), plate, side()),
                       plateOf(-40, -40, 40, 40), level(30));
}

bool isNumber(const std::optional<NeckStress> &neck)
{
    return !neck ||
           (std::isfinite(neck->length) && neck->begin.allFinite() && neck->end.allFinite());
}

/// What is not finite of it; empty if all is.
QString spoiltIn(const Strength &strength)
{
    if (!std::isfinite(strength.cornerUse) || !std::isfinite(strength.neckUse))
        return QStringLiteral("use");
    for (const BodyStrength &body : strength.bodies)
        if (!std::isfinite(body.cornerUse) || !std::isfinite(body.neckUse) ||
            !isNumber(body.neck) || !isNumber(body.corner))
            return QStringLiteral("stress");
    for (const Equilibrium &solution : strength.envelope) {
        if (!std::isfinite(solution.worstResidual))
            return QStringLiteral("residual");
        for (const LinkForce &link : solution.links)
            if (!link.onA.force.allFinite() || !link.onA.moment.allFinite())
                return QStringLiteral("joint");
        for (const FootForce &foot : solution.feet)
            if (!foot.force.allFinite())
                return QStringLiteral("foot");
    }
    return {};
}

bool isNumber(const std::optional<double> &value)
{
    return !value || std::isfinite(*value);
}

} // namespace

class TestBadLoads : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachHasAnAnswer_data();
    void eachHasAnAnswer();
};

void TestBadLoads::eachHasAnAnswer_data()
{
    QTest::addColumn<Document>("document");
    QTest::addColumn<QString>("says"); // of its strength, where that is what the row is about
    const Polygon hole = rectangle(-10, 20, 0, 40);
    const auto said = [](const char *words) { return QString::fromLatin1(words); };

    QTest::newRow("two holes that meet in a point")
        << withMass(standing({hole, rectangle(0, 40, 10, 50)}), 0, {20, 50}, 1.0) << QString();
    QTest::newRow("two holes with an edge between them of no width")
        << withMass(standing({hole, rectangle(0, 20, 10, 40)}), 0, {20, 50}, 1.0) << QString();
    QTest::newRow("two holes a nanometre apart")
        << withMass(standing({hole, rectangle(1e-6, 20, 10, 40)}), 0, {20, 50}, 1.0) << QString();
    QTest::newRow("a hole that touches the edge")
        << withMass(standing({{{-5, 40}, {5, 40}, {0, 60}}}), 0, {20, 50}, 1.0) << QString();
    QTest::newRow("a slit that ends at a hole")
        << withMass(withSection(standing({rectangle(18, 10, 32, 35)}), plateOf(-20, 35, 20, 80),
                                side(25.0)),
                    0, {0, 50}, 1.0)
        << QString();
    QTest::newRow("slits from both sides that meet")
        << withMass(withSection(withSection(standing({}), plateOf(-20, 30, 20, 80), side(20.0)),
                                plateOf(-20, -1, 20, 30), side(20.0)),
                    0, {40, 50}, 1.0)
        << QString();
    QTest::newRow("a neck of nothing") << withMass(withSection(newDocument(),
                                                               polygonShape({{-50, 0},
                                                                             {50, 0},
                                                                             {50, 20},
                                                                             {1e-7, 20},
                                                                             {1e-7, 40},
                                                                             {30, 40},
                                                                             {30, 60},
                                                                             {-30, 60},
                                                                             {-30, 40},
                                                                             {-1e-7, 40},
                                                                             {-1e-7, 20},
                                                                             {-50, 20}}),
                                                               front()),
                                                   0, {0, 50}, 0.1)
                                       << QString();
    for (const auto &[name, at] :
         {std::pair("in the middle of a split shelf", Vec2(0, 0)),
          std::pair("on a piece of it", Vec2(30, 30)), std::pair("in the slit", Vec2(0, 20))})
        QTest::addRow("a weight %s", name) << withMass(split(), 2, at, 0.5) << QString();
    for (const double away : {60.0, 1e3, kMaxCoordinate})
        QTest::addRow("a weight %g mm from the middle", away)
            << withMass(standing({}), 0, {away, 30}, 0.1) << said("Off the material.");
    QTest::newRow("a weight in a hole")
        << withMass(standing({hole}), 0, {-5, 30}, 0.1) << said("Off the material.");
    const Vec2 slit(-30, 40);
    QTest::newRow("a gram") << withMass(standing({}), 0, slit, 1e-3) << said("Holds 1");
    QTest::newRow("a thousand tonnes")
        << withMass(standing({}), 0, slit, kMaxWeight) << said("Breaks under");
    QTest::newRow("a gram and a thousand tonnes")
        << withMass(withMass(standing({}), 0, slit, kMaxWeight), 1, {10, 10}, 1e-3)
        << said("Breaks under");
    QTest::newRow("a thousand tonnes beside the material")
        << withMass(standing({}), 0, {kMaxCoordinate, 30}, kMaxWeight) << said("Off the material.");
    QTest::newRow("a push of a thousandth of a newton")
        << withPush(standing({}), 0, slit, {1e-3, 0, 0}) << said("Holds");
    QTest::newRow("a push of a million newtons")
        << withPush(standing({}), 0, slit, {kMaxPush, 0, 0}) << said("Pushed over.");
    QTest::newRow("a push of a million newtons that lifts")
        << withPush(standing({}), 0, slit, {0, kMaxPush, 0}) << said("Pushed over.");
}

// Wrong: NaN in a sentence or a colour, a crash, or nothing said at all.
void TestBadLoads::eachHasAnAnswer()
{
    QFETCH(Document, document);
    QFETCH(QString, says);
    const Staged all = staged(document);
    QVERIFY(all.analysis);
    static const QRegularExpression noNumber(QStringLiteral("\\b(nan|inf)\\b"),
                                             QRegularExpression::CaseInsensitiveOption);
    bool isSaid = says.isEmpty(), isJudged = false;
    for (const Finding &finding : all.found) {
        const QString text = findingText(finding, all.analysis->model);
        QVERIFY(!text.isEmpty());
        QVERIFY2(!text.contains(noNumber), qPrintable(text));
        QVERIFY(!finding.at || finding.at->allFinite());
        isSaid = isSaid || (finding.subject() == Subject::Strength && text.startsWith(says));
        // Of what does not stand, or falls apart, that is what is said.
        isJudged = isJudged || finding.subject() == Subject::Strength ||
                   ((finding.subject() == Subject::Stability ||
                     finding.subject() == Subject::Connection) &&
                    finding.severity == Severity::Error);
    }
    QStringList texts;
    for (const Finding &finding : all.found)
        if (finding.subject() == Subject::Strength)
            texts += findingText(finding, all.analysis->model);
    QVERIFY2(isSaid, qPrintable(texts.join(u'|')));
    QVERIFY(isJudged);
    for (const bool isElastic : {false, true}) {
        StrengthRules rules;
        rules.isElastic = isElastic;
        const Holding held = holdingOf(all.analysis, rules, std::make_shared<StrengthCaches>());
        const QString spoilt = spoiltIn(held.strength);
        QVERIFY2(spoilt.isEmpty(), qPrintable(spoilt));
        QVERIFY(isNumber(held.bearable.cracksFrom) && isNumber(held.bearable.breaksAt) &&
                isNumber(held.bearable.fallsFrom));
    }
}

FFF_TEST(TestBadLoads)
#include "tst_bad_loads.moc"
