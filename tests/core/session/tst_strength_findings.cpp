// What is said of whether a model holds.
#include <QTest> // first: moc stumbles over some standard headers

#include "core/analysis/findings/broader_base.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/strengthening.h"
#include "core/analysis/findings/thin_necks.h"
#include "core/analysis/holding.h"
#include "core/analysis/stress_lines.h"
#include "core/assembly/joint_editing.h"
#include "core/io/document_file.h"
#include "core/model/edits.h"
#include "core/model/load_edits.h"
#include "core/operations/evaluate.h"
#include "core/session/check_list.h"
#include "core/session/finding_text.h"
#include "core/session/session.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/plates.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>

using namespace fff;
using namespace fff::test;

namespace {

Document sampleNamed(const char *name)
{
    const auto loaded = io::readDocument(QStringLiteral(FFF_SAMPLES) + u'/' + QLatin1String(name));
    return loaded ? loaded->document : Document();
}

/// Verdicts on a model in a session.
struct Judged
{
    Session session;
    CheckList list{session};

    explicit Judged(Document document)
    {
        session.reset(std::move(document));
        list.finish();
    }
    void become(Document document)
    {
        session.commit(QStringLiteral("Change"), std::move(document));
        list.finish();
    }
    std::vector<Finding> strength() const
    {
        std::vector<Finding> found;
        for (const Finding &finding : list.all())
            if (finding.subject() == Subject::Strength && finding.severity != Severity::Note)
                found.push_back(finding);
        return found;
    }
    const Holding &held() const { return *session.scheduler().result(kHolding); }
};

Document scaledWeights(Document document, double factor)
{
    for (Load &weight : document.loads)
        weight.mass *= factor;
    return document;
}

Document inStock(Document document, std::optional<double> strength)
{
    for (auto &stock : document.stocks) {
        Stock other = *stock;
        other.tensileStrength = other.flexuralStrength = strength;
        stock = std::make_shared<const Stock>(other);
    }
    return document;
}

} // namespace

class TestStrengthFindings : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pushesHaveTheirOwnWords();
    void whatHangsByFrictionIsSaid();
    void droppingIsOfferedThoughItFallsOver();
    void pushesMoveWhatIsNotHeld();
    void whatIsPushedOverGetsABase();
    void oneVerdictNamesWhatHangs();
    void fromHoldingToBreaking();
    void theSafetyFactorIsTheVerdictsAlone();
    void whatIsTooWeakIsMended_data();
    void whatIsTooWeakIsMended();
    void thicknessChangesItLittleByLittle();
    void notRatedIsUnknown();
    void whatFallsHasNoVerdict();
    void linesAreFewAndInTheMaterial();
    void ofNothingNothingIsSaid();
    void hangsByAThread();
};

// Wrong: a badge that says nothing of the glass, or a number that is not that of the weights.
void TestStrengthFindings::oneVerdictNamesWhatHangs()
{
    const Document document = sampleNamed("glass_four_legs.fff");
    double placed = 0.0;
    for (const Load &weight : document.loads)
        placed += weight.mass;
    Judged judged(document);
    QCOMPARE(judged.strength().size(), std::size_t(1));
    const Finding finding = judged.strength().front();
    QVERIFY(finding.details<Held>());
    QVERIFY(std::abs(finding.details<Held>()->placed - placed) < 1e-12);
    const QString title = messageText(titleOf(finding));
    QVERIFY2(title.contains(metricUnits().mass(placed)), qPrintable(title));
    QVERIFY(findingText(finding, judged.list.model()).startsWith(title + u'.'));
    Document bare = document;
    bare.loads.clear();
    judged.become(bare);
    QCOMPARE(judged.strength().size(), std::size_t(1));
    QCOMPARE(judged.strength().front().details<Held>()->placed, 0.0);
}

// Wrong: what holds less is said to hold, or limits that it has passed already.
void TestStrengthFindings::fromHoldingToBreaking()
{
    const Document document = sampleNamed("glass_three_legs.fff");
    Judged judged(document);
    const BearableMass bearable = judged.held().bearable;
    QVERIFY(bearable.cracksFrom && bearable.breaksAt);
    const double placed = placedMass(judged.held().strength.made.structure);
    const auto verdictAt = [&](double mass) {
        judged.become(scaledWeights(document, mass / placed));
        return judged.strength().front();
    };
    // The factor is 2, and all stresses but those of its own weight are in proportion.
    QVERIFY(verdictAt(0.3 * *bearable.cracksFrom).is(kHolds));
    const Finding barely = verdictAt(0.9 * *bearable.cracksFrom);
    QVERIFY(barely.is(kBarelyHolds) || *bearable.breaksAt < 1.8 * *bearable.cracksFrom);
    const Finding weak = verdictAt(0.9 * *bearable.breaksAt);
    QVERIFY(weak.is(kTooWeak));
    QVERIFY(messageText(titleOf(weak)).startsWith(QStringLiteral("Too weak")));
    const Finding broken = verdictAt(1.1 * *bearable.breaksAt);
    QVERIFY(broken.is(kTooWeak));
    QVERIFY(messageText(titleOf(broken)).startsWith(QStringLiteral("Breaks")));
    QCOMPARE(broken.severity, Severity::Error);
    QVERIFY(!broken.sections.empty());
    // The masses at which it gives way are those that they were.
    const BearableMass again = judged.held().bearable;
    QVERIFY(again.breaksAt && std::abs(*again.breaksAt - *bearable.breaksAt) < 2e-3 * placed);
}

// Wrong: masses that hang on how strict a person is.
void TestStrengthFindings::theSafetyFactorIsTheVerdictsAlone()
{
    const Document document = sampleNamed("glass_three_legs.fff");
    Judged judged(document);
    const double breaksAt = *judged.held().bearable.breaksAt;
    const double use = judged.held().strength.neckUse;
    CheckRules strict;
    strict.strength.safety = 1.01 / use;
    judged.session.scheduler().setRules(strict);
    judged.list.finish();
    QVERIFY(judged.strength().front().is(kTooWeak));
    QVERIFY(std::abs(*judged.held().bearable.breaksAt - breaksAt) < 1e-3 * breaksAt);
    strict.strength.safety = 0.99 / judged.held().strength.cornerUse;
    judged.session.scheduler().setRules(strict);
    judged.list.finish();
    QVERIFY(judged.strength().front().is(kHolds));
}

void TestStrengthFindings::whatIsTooWeakIsMended_data()
{
    QTest::addColumn<double>("factor"); // on the weights
    QTest::newRow("barely") << 1.0;
    QTest::newRow("too weak") << 3.0;
}

// Wrong: five green ticks for a body that hangs in its slits, until 15 g more pull them open.
void TestStrengthFindings::whatHangsByFrictionIsSaid()
{
    const ShapePointer leg = polygonShape(rectangle(-30, 0, 30, 50));
    Document document =
        withSection(newDocument(), polygonShape(rectangle(-60, 35, 60, 75)), front());
    for (const double x : {-40.0, 40.0})
        document = withSection(std::move(document), leg, side(x));
    Stock stock = *document.stocks.front();
    stock.clearance = 0.0;
    document = setStock(document, stock).value();
    const auto hanging = [](const Judged &judged) {
        return std::count_if(judged.list.all().begin(), judged.list.all().end(),
                             [](const Finding &f) { return f.is(kHeldByFriction); });
    };
    Judged judged(document);
    const Model model = evaluate(document);
    for (const int guest : {1, 2})
        document = flipSlits(evaluate(document),
                             JointRef(model.ref(0), model.ref(static_cast<std::size_t>(guest))))
                       ->document;
    Judged flipped(document);
    // One way the body rests in its slits, the other way it hangs in them.
    QCOMPARE(std::min(hanging(judged), hanging(flipped)), std::ptrdiff_t(0));
    QCOMPARE(std::max(hanging(judged), hanging(flipped)), std::ptrdiff_t(2));
    const Judged &bad = hanging(judged) > 0 ? judged : flipped;
    const auto said = std::find_if(bad.list.all().begin(), bad.list.all().end(),
                                   [](const Finding &f) { return f.is(kHeldByFriction); });
    QCOMPARE(said->severity, Severity::Note);
    const std::vector<Mend> mends = bad.list.mendsOf(*said);
    QVERIFY(!mends.empty() && mends.front().action.kind == &kTurnPulledSlits);
}

// Wrong: a model in the air, in red, with nothing to be done, since once it stands something else
// is wrong with it.
void TestStrengthFindings::droppingIsOfferedThoughItFallsOver()
{
    const Frame leaning{Vec3(0, 30, 0), Vec3::UnitX(), Vec3(0, 1, 1).normalized()};
    Judged judged(withSection(newDocument(), polygonShape(rectangle(-30, 0, 30, 40)), leaning));
    const auto inAir = std::find_if(judged.list.all().begin(), judged.list.all().end(),
                                    [](const Finding &f) { return f.is(kNoContact); });
    QVERIFY(inAir != judged.list.all().end());
    const std::vector<Mend> mends = judged.list.mendsOf(*inAir);
    QVERIFY(!mends.empty() && mends.front().action.kind == &kDropToGround);
    Judged dropped(mends.front().edit->document);
    QVERIFY(std::any_of(dropped.list.all().begin(), dropped.list.all().end(), [](const Finding &f) {
        return f.subject() == Subject::Stability && f.severity == Severity::Error;
    }));
}

// Wrong: a verdict that leaves a person alone, or a link after which it is no better.
void TestStrengthFindings::whatIsTooWeakIsMended()
{
    QFETCH(double, factor);
    const Document document = scaledWeights(sampleNamed("glass_three_legs.fff"), factor);
    Judged judged(document);
    const std::vector<Finding> before = judged.strength();
    const auto verdict = std::find_if(before.begin(), before.end(),
                                      [](const Finding &f) { return f.details<Held>(); });
    QVERIFY(verdict != before.end() && verdict->severity > Severity::Good);
    const std::vector<Mend> mends = judged.list.mendsOf(*verdict);
    QVERIFY(!mends.empty());
    const double use = verdict->details<Held>()->cornerUse;
    bool isThicker = false;
    for (const Mend &mend : mends) {
        QVERIFY(mend.isEdit());
        const bool isOfStock = mend.action.kind == &kThickerStock;
        QCOMPARE(!mend.edit->offered.isEmpty(), isOfStock); // how thick is known by now
        isThicker = isThicker || isOfStock;
        Judged after(mend.edit->document);
        QVERIFY(after.held().strength.cornerUse < use);
        QVERIFY(after.held().strength.verdict == HoldVerdict::Holds ||
                verdict->severity == Severity::Error);
        QCOMPARE(mend.edit->document.loads, document.loads);
    }
    QVERIFY(isThicker);
}

// Wrong: forces on walls of a slit that are not there, as where an outline is round they end before
// the slit's middle does: a tip of nothing broke under 0.2 g, and the next thickness bore 8 kg.
void TestStrengthFindings::thicknessChangesItLittleByLittle()
{
    const Document document = sampleNamed("glass_three_legs.fff");
    double last = 0.0;
    for (double thickness = 3.0; thickness <= 12.0; thickness += 0.5) {
        Document thicker = document;
        for (const auto &stock : document.stocks) {
            Stock changed = *stock;
            changed.thickness = thickness;
            thicker = *setStock(std::move(thicker), changed);
        }
        const Judged judged(thicker);
        const std::optional<double> cracksFrom = judged.held().bearable.cracksFrom;
        QVERIFY2(cracksFrom, qPrintable(QString::number(thickness)));
        if (last > 0.0)
            QVERIFY2(*cracksFrom > 0.8 * last && *cracksFrom < 1.25 * last,
                     qPrintable(QStringLiteral("%1 mm: %2 kg after %3 kg")
                                    .arg(thickness)
                                    .arg(*cracksFrom)
                                    .arg(last)));
        last = *cracksFrom;
    }
}

// Wrong: a green verdict on what nobody knows the strength of.
void TestStrengthFindings::notRatedIsUnknown()
{
    Judged judged(inStock(sampleNamed("glass_four_legs.fff"), std::nullopt));
    QCOMPARE(judged.strength().size(), std::size_t(1));
    QVERIFY(judged.strength().front().is(kNotRated));
    QCOMPARE(judged.strength().front().severity, Severity::Unknown);
    QVERIFY(stressLines(*judged.held().analysis, judged.held().strength, 0.0).empty());
}

// Wrong: stresses of what lies on its side.
void TestStrengthFindings::whatFallsHasNoVerdict()
{
    Document document = sampleNamed("glass_four_legs.fff");
    Load weight = document.loads.front();
    weight.position = {5000.0, 0.0};
    weight.mass = 50.0;
    document.loads = {weight};
    Judged judged(document);
    for (const Finding &finding : judged.strength())
        QVERIFY(!finding.details<Held>());
    QVERIFY(!judged.held().bearable.breaksAt);
    QVERIFY(stressLines(*judged.held().analysis, judged.held().strength, 0.0).empty());
}

// Wrong: lines that bury the model, or run where nothing is.
void TestStrengthFindings::linesAreFewAndInTheMaterial()
{
    Judged judged(sampleNamed("glass_three_legs.fff"));
    const Analysis &analysis = *judged.held().analysis;
    const std::vector<StressLine> lines = stressLines(analysis, judged.held().strength, 0.05);
    QVERIFY(!lines.empty());
    QVERIFY(lines.size() < 60 * analysis.bodies.size());
    QCOMPARE(lines.back().use, judged.held().strength.cornerUse);
    for (const StressLine &line : lines) {
        QVERIFY(line.use >= 0.05);
        const Body &body = analysis.bodies.at(line.body);
        const Vec2 middle = body.frame().toLocal(0.5 * (line.from + line.to));
        QVERIFY(distanceTo(middle, body.outline().region) < 1e-6);
    }
    QVERIFY(stressLines(analysis, judged.held().strength, 0.9).size() <= lines.size());
}

// Wrong: a crash in whoever looks at the forces before there is a section.
void TestStrengthFindings::ofNothingNothingIsSaid()
{
    Judged judged(newDocument());
    QVERIFY(judged.strength().empty());
    QVERIFY(!judged.held().strength.envelope.empty());
    QVERIFY(stressLines(*judged.held().analysis, judged.held().strength, 0.0).empty());
}

namespace {

/// The glass stand with this push in the middle of its shelf, and with its weight or without.
QStringList saidOf(const Vec3 &push, bool hasWeight)
{
    Document document =
        io::readDocument(QStringLiteral(FFF_SAMPLES "/glass_four_legs.fff")).value().document;
    if (!hasWeight)
        document.loads.clear();
    Load load;
    load.section = document.sections.front()->ref();
    load.kind = LoadKind::Push;
    load.push = push;
    document.loads.push_back(load);
    document.loads.back().id = LoadId{document.nextId++};
    AnalysisCaches caches;
    const auto analysis = analyseNext(evaluate(document), caches);
    const Holding held = holdingOf(analysis, {}, std::make_shared<StrengthCaches>());
    QStringList said;
    for (const Finding &finding : held.findings)
        if (finding.severity != Severity::Note)
            said += findingText(finding, analysis->model);
    return said;
}

} // namespace

// Wrong: newtons that are said in grams, or a sum of both.
void TestStrengthFindings::pushesHaveTheirOwnWords()
{
    const QStringList alone = saidOf({0.0, 0.0, -5.0}, false);
    QVERIFY2(alone.size() == 1 && alone[0].startsWith(QStringLiteral("Holds 5\u202FN.")),
             qPrintable(alone.join(u'|')));
    QVERIFY(!alone[0].contains(QStringLiteral("kg")));
    const QStringList both = saidOf({0.0, 0.0, -5.0}, true);
    QVERIFY2(both.size() == 1 && both[0].startsWith(QStringLiteral("Holds its load.")),
             qPrintable(both.join(u'|')));
    QVERIFY(both[0].contains(QStringLiteral("times as much")));
}

// Wrong: any breath of wind moves it, or nothing does and nobody hears of it.
void TestStrengthFindings::pushesMoveWhatIsNotHeld()
{
    const QStringList held = saidOf({0.5, 0.0, 0.0}, true); // of 6.7 N feet hold 2 N
    QVERIFY2(held.size() == 1 && held[0].startsWith(QStringLiteral("Holds")),
             qPrintable(held.join(u'|')));
    const QStringList slid = saidOf({3.0, 0.0, 0.0}, true);
    QVERIFY2(slid.size() == 1 && slid[0].startsWith(QStringLiteral("Slides away.")),
             qPrintable(slid.join(u'|')));
    const QStringList over = saidOf({30.0, 0.0, 0.0}, true);
    QVERIFY2(over.size() == 1 && over[0].startsWith(QStringLiteral("Pushed over.")),
             qPrintable(over.join(u'|')));
    const QStringList lifted = saidOf({0.0, 0.0, 30.0}, true);
    QVERIFY2(lifted.size() == 1 && lifted[0].startsWith(QStringLiteral("Pushed over.")),
             qPrintable(lifted.join(u'|')));
}

// Wrong: a verdict that leaves a person alone, a base on the side to which nothing falls, or one
// that is offered against a push that lifts.
void TestStrengthFindings::whatIsPushedOverGetsABase()
{
    const ShapePointer post = plateOf(-25, 0, 25, 150), across = plateOf(-60, 0, 60, 80);
    Document document = withSection(withSection(newDocument(), post, front()), across, side());
    Load weight;
    weight.section = document.sections[0]->ref();
    weight.position = {3.0, 10.0};
    weight.mass = 1.0;
    document = *addLoad(std::move(document), weight);
    Load push = weight;
    push.kind = LoadKind::Push;
    push.position = {3.0, 140.0};
    const auto mendsOf = [&](const Vec3 &force) {
        push.push = force;
        Judged judged(*addLoad(document, push));
        for (const Finding &finding : judged.list.all())
            if (finding.is(kPushedOver))
                return judged.list.mendsOf(finding);
        return std::vector<Mend>();
    };
    // The post ends at x = 25; the push brings what presses on the ground beyond that.
    for (const double sign : {1.0, -1.0}) {
        const std::vector<Mend> mends = mendsOf({sign * 2.5, 0.0, 0.0});
        QVERIFY(!mends.empty());
        QCOMPARE(mends.front().action.kind, &kWidenBase);
        const Box2 box = bounds(mends.front().edit->document.sections[0]->shape->region().outer);
        QVERIFY(sign > 0.0 ? box.max.x() > 40.0 && box.min.x() == -25.0
                           : box.min.x() < -25.0 && box.max.x() == 25.0);
    }
    QVERIFY(mendsOf({0.0, 15.0, 0.0}).empty());
}

// Wrong: of a piece that hung on 0.01 mm it was said that its strength is not known, and no more.
void TestStrengthFindings::hangsByAThread()
{
    const auto found = [](double neck) {
        // Two squares, one over the other, with a waist between them.
        const Polygon outline{{-30, 0}, {30, 0},   {30, 30},  {0.5 * neck, 32},  {30, 34},
                              {30, 64}, {-30, 64}, {-30, 34}, {-0.5 * neck, 32}, {-30, 30}};
        return Judged(withSection(withSection(newDocument(), polygonShape(outline), front()),
                                  plateOf(-30, 0, 30, 20), side()))
            .strength();
    };
    const auto of = [](const std::vector<Finding> &all, const FindingKind &kind) {
        const auto one = std::find_if(all.begin(), all.end(),
                                      [&kind](const Finding &finding) { return finding.is(kind); });
        return one == all.end() ? nullptr : &*one;
    };
    for (const double neck : {0.01, 0.04, 0.08}) {
        const auto all = found(neck);
        const Finding *apart = of(all, kHangsByNothing);
        QVERIFY(apart);
        QCOMPARE(apart->severity, Severity::Error);
    }
    const auto thin = found(0.3), sound = found(4.0);
    QVERIFY(of(thin, kThinNeck));
    QVERIFY(!of(thin, kHangsByNothing));
    QVERIFY(!of(sound, kThinNeck));
    QVERIFY(!of(sound, kHangsByNothing));
}

FFF_TEST(TestStrengthFindings)
#include "tst_strength_findings.moc"
