// What becomes of a model over the ranges of its values: which places are tried, what is said of
// them, and ranges in which all is well.
#include <QTest> // first: moc cannot read some of the standard library before it

#include "core/analysis/narrowed_ranges.h"
#include "core/base/units.h"
#include "core/interaction/value_trial_editing.h"
#include "core/operations/seeded.h"
#include "tests/core/operations/driven_models.h"
#include "tests/test_program.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace fff;
using namespace fff::test;

namespace {

Value shown(const char *name, ValueKind kind, const char *typed, ValueRange range)
{
    Value value;
    value.name = name;
    value.kind = kind;
    value.typed = typed;
    value.range = range;
    value.isShown = true;
    return value;
}

Document with(Document document, Value value)
{
    return addValue(std::move(document), std::move(value)).value();
}

/// A board as long as `width`, and one across it as deep as `depth`; both stand on the ground.
Document table(ValueRange width, ValueRange depth, bool isDepthFirst = false)
{
    Document document = newDocument();
    const SectionId a =
        add(document, "Board", shapeOf(polygonContour(rectangleAt(-50, 0, 100, 60))), frontFrame());
    const SectionId b = add(document, "Rib", shapeOf(polygonContour(rectangleAt(-40, 0, 80, 60))),
                            sideFrame({0, 0, 0}), Parent{a, {0, 30}, {0, 60}, false});
    const Value ofWidth = shown("width", ValueKind::Length, "100 mm", width),
                ofDepth = shown("Depth", ValueKind::Length, "80 mm", depth);
    document = with(std::move(document), isDepthFirst ? ofDepth : ofWidth);
    document = with(std::move(document), isDepthFirst ? ofWidth : ofDepth);
    document = madeOf(document, key("section", a.value, "width"), "width");
    return madeOf(document, key("section", b.value, "width"), "depth");
}

ValueTrials tried(const Document &document, std::size_t random = 12)
{
    Progress progress;
    TrialExtent extent;
    extent.random = random;
    return tryValues(evaluate(document), {}, extent, progress, {}).value();
}

/// Made up: of so many numbers from 0 to 100, the verdict of each place by `holds`.
template <class Holds>
ValueTrials madeUp(int count, std::uint64_t seed, Holds holds)
{
    ValueTrials trials;
    for (int i = 0; i < count; ++i)
        trials.values.push_back(
            {ValueId{i + 1}, "v" + std::to_string(i), ValueKind::Number, 0.0, 100.0, 0.0, {}});
    TrialExtent extent;
    extent.seed = seed;
    for (const TrialPlace &at : trialPlaces(trials.values, extent).all) {
        TriedPlace &place = trials.places.emplace_back();
        place.at = at;
        if (!holds(at))
            place.faults.push_back({kCannotBeMade, {}});
    }
    return trials;
}

bool isIn(const NarrowedRanges &box, const TrialPlace &at)
{
    for (std::size_t i = 0; i < at.size(); ++i)
        if (at[i] < box.ranges[i].least || at[i] > box.ranges[i].most)
            return false;
    return true;
}

} // namespace

class TestValueTrials : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOrderOfValuesDoesNotMatter();
    void cornersAreAllOrSoMany();
    void stepsCountsAndChoicesAreRespected();
    void onlyWhatIsShownRangedAndUsed();
    void goodRangesAreGood();
    void aBadCornerIsTold();
    void whatCannotBeMadeIsTold();
    void narrowingLeavesWhatHolds();
    void boxesHaveNoBadPlace();
    void narrowingIsRefusedWhereNothingHolds();
    void stoppedItGivesNothing();
};

void TestValueTrials::theOrderOfValuesDoesNotMatter()
{
    const ValueRange a{60.0, 200.0, {}}, b{40.0, 120.0, 7.0};
    const auto one = rangedValues(evaluate(table(a, b))),
               other = rangedValues(evaluate(table(a, b, true)));
    QCOMPARE(one.size(), std::size_t(2));
    QCOMPARE(one[0].name, std::string("Depth"));
    const TrialPlaces places = trialPlaces(one, {});
    QVERIFY(places.all == trialPlaces(other, {}).all);
    QCOMPARE(places.corners, std::size_t(4));
    QVERIFY(places.all.size() > 30);
    // Another seed, other places; the corners are the same.
    TrialExtent extent;
    extent.seed = 2;
    const TrialPlaces seeded = trialPlaces(one, extent);
    QVERIFY(seeded.all != places.all);
    QVERIFY(std::equal(places.all.begin(), places.all.begin() + 4, seeded.all.begin()));
    // One more value leaves what is drawn for the others.
    std::vector<RangedValue> more = one;
    more.push_back({ValueId{99}, "zeta", ValueKind::Number, 0.0, 1.0, 0.0, {}});
    const TrialPlaces wider = trialPlaces(more, {});
    QCOMPARE(wider.all.back()[0], places.all.back()[0]);
}

void TestValueTrials::cornersAreAllOrSoMany()
{
    std::vector<RangedValue> values;
    for (int i = 1; i <= 9; ++i) {
        values.push_back(
            {ValueId{i}, "v" + std::to_string(i), ValueKind::Length, 1.0, 2.0, 0.0, {}});
        const TrialPlaces places = trialPlaces(values, {});
        QCOMPARE(places.allCorners, std::pow(2.0, i));
        QVERIFY(places.corners <= 64);
        QCOMPARE(std::set<TrialPlace>(places.all.begin(), places.all.end()).size(),
                 places.all.size());
        if (i <= 6)
            QCOMPARE(places.corners, std::size_t(1) << i);
        else
            QVERIFY2(places.corners > 40, "so many of them are drawn");
        // All least and all most are among them, whatever is drawn.
        for (const double end : {1.0, 2.0})
            QVERIFY(
                std::count(places.all.begin(), places.all.end(), TrialPlace(values.size(), end)));
        for (std::size_t k = 0; k < places.corners; ++k)
            for (const double at : places.all[k])
                QVERIFY(at == 1.0 || at == 2.0);
    }
    QVERIFY(trialPlaces({}, {}).all.empty());
}

void TestValueTrials::stepsCountsAndChoicesAreRespected()
{
    const std::vector<RangedValue> values{
        {ValueId{1}, "boards", ValueKind::Count, 2.0, 8.0, 1.0, {}},
        {ValueId{2}, "gap", ValueKind::Length, 3.0, 23.0, 5.0, {}},
        {ValueId{3}, "wood", ValueKind::Choice, 0.0, 2.0, 1.0, {"ash", "beech", "birch"}},
        {ValueId{4}, "lid", ValueKind::Switch, 0.0, 1.0, 1.0, {}},
        {ValueId{5}, "lean", ValueKind::Angle, radians(5.0), radians(40.0), 0.0, {}}};
    const TrialPlaces places = trialPlaces(values, {});
    QCOMPARE(places.allCorners, 2.0 * 2.0 * 3.0 * 2.0 * 2.0);
    std::set<double> counts;
    for (const TrialPlace &at : places.all) {
        QCOMPARE(at[0], std::round(at[0]));
        QVERIFY(at[0] >= 2.0 && at[0] <= 8.0);
        counts.insert(at[0]);
        QCOMPARE(std::fmod(at[1] - 3.0, 5.0), 0.0);
        QVERIFY(at[2] == 0.0 || at[2] == 1.0 || at[2] == 2.0);
        QVERIFY(at[3] == 0.0 || at[3] == 1.0);
        QVERIFY(at[4] >= radians(5.0) - 1e-12 && at[4] <= radians(40.0) + 1e-12);
        // Numbers that read well.
        QVERIFY2(values[4].typedAt(at[4]).size() < 8, values[4].typedAt(at[4]).c_str());
    }
    QCOMPARE(counts.size(), std::size_t(7)); // each of them is tried some time
    QCOMPARE(values[2].typedAt(1.0), std::string("beech"));
    QCOMPARE(values[3].typedAt(1.0), std::string("yes"));
}

void TestValueTrials::onlyWhatIsShownRangedAndUsed()
{
    const ValueRange range{60.0, 200.0, {}};
    QCOMPARE(rangedValues(evaluate(table(range, {}))).size(), std::size_t(1)); // one has no range
    Document document = table(range, range);
    document = with(std::move(document), shown("idle", ValueKind::Length, "3 mm", {1.0, 5.0, {}}));
    document = with(std::move(document), shown("made", ValueKind::Length, "2*width", range));
    Value hidden = *document.values.find(std::string_view("depth"));
    hidden.isShown = false;
    document = changeValue(std::move(document), std::move(hidden)).value();
    const auto ranged = rangedValues(evaluate(document));
    QCOMPARE(ranged.size(), std::size_t(1));
    QCOMPARE(ranged[0].name, std::string("width"));
}

void TestValueTrials::goodRangesAreGood()
{
    const ValueTrials trials = tried(table({80.0, 200.0, {}}, {60.0, 120.0, {}}));
    QVERIFY(trials.places.size() > 12);
    for (const auto &[fault, times] : trials.faults())
        qInfo("%s: %d", fault.text.source, times);
    QCOMPARE(trials.failing(), std::size_t(0));
    QVERIFY(trials.worst().empty());
    QCOMPARE(trials.places[0].worstOf(Subject::Connection), Severity::Good);
}

// Wrong: a width that no sheet has is found out when it is cut.
void TestValueTrials::aBadCornerIsTold()
{
    const ValueTrials trials = tried(table({80.0, 3000.0, {}}, {60.0, 120.0, {}}));
    QVERIFY(trials.failing() > 0);
    QVERIFY(trials.failing() < trials.places.size());
    for (const std::size_t i : trials.worst()) {
        QVERIFY(!trials.places[i].holds());
        QVERIFY(!trials.places[i].faults.empty());
    }
    const auto isWide = [&](const TriedPlace &place) { return place.at[1] > 2900.0; };
    int wide = 0;
    for (const TriedPlace &place : trials.places)
        if (isWide(place)) {
            ++wide;
            QCOMPARE(place.worstOf(Subject::Size), Severity::Error);
        }
    QVERIFY(wide >= 2);
    QCOMPARE(worthsAt(trials.values, trials.places[0].at)[1].first, std::string("width"));
}

void TestValueTrials::whatCannotBeMadeIsTold()
{
    Document document = table({80.0, 200.0, {}}, {60.0, 120.0, {}});
    document = typed(std::move(document), "width", "160 mm");
    document = madeOf(document, stockKey(document, "thickness"), "(width - 120)/10");
    const ValueTrials trials = tried(document);
    const auto impossible =
        std::find_if(trials.places.begin(), trials.places.end(),
                     [](const TriedPlace &place) { return place.at[1] < 120.0; });
    QVERIFY(impossible != trials.places.end());
    QVERIFY(!impossible->wrong.isEmpty());
    QVERIFY(!impossible->holds());
    QCOMPARE(impossible->worstOf(Subject::Stability), Severity::Unknown);
}

void TestValueTrials::narrowingLeavesWhatHolds()
{
    Document document = table({80.0, 3000.0, {}}, {60.0, 120.0, {}});
    for (int round = 0; round < 12; ++round) {
        const Model model = evaluate(document);
        const ValueTrials trials = tried(document, 50);
        if (trials.failing() == 0) {
            QVERIFY(round > 0);
            const Value *width = document.values.find(std::string_view("width"));
            QVERIFY(*width->range.least == 80.0);
            QVERIFY2(*width->range.most > 200.0, "most of what holds is left");
            QCOMPARE(width->typed, std::string("100 mm")); // it was in there
            return;
        }
        const SectionEdit edit = rangesNarrowed(model, trials);
        QVERIFY(edit);
        const Document next = evaluate(edit->document).document;
        const Value *width = next.values.find(std::string_view("width"));
        for (const TriedPlace &place : trials.places)
            if (place.at[1] <= *width->range.most)
                QVERIFY(place.holds());
        QVERIFY(!(next == document));
        document = next;
    }
    QFAIL("it is never good");
}

/// As a law, on verdicts that are made up.
void TestValueTrials::boxesHaveNoBadPlace()
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Seeded dice(seed, "boxes");
        const int count = 1 + static_cast<int>(seed % 4);
        std::vector<double> weights;
        for (int i = 0; i < count; ++i)
            weights.push_back(dice.symmetric());
        const double limit = 60.0 * dice.symmetric();
        const ValueTrials trials = madeUp(count, seed, [&](const TrialPlace &at) {
            double sum = 0.0;
            for (std::size_t i = 0; i < at.size(); ++i)
                sum += weights[i] * at[i];
            return sum < limit;
        });
        const TrialPlace now(static_cast<std::size_t>(count), 50.0 + 50.0 * dice.symmetric());
        const auto box = narrowedRanges(trials, now);
        const auto good = static_cast<std::size_t>(
            std::count_if(trials.places.begin(), trials.places.end(),
                          [](const TriedPlace &place) { return place.holds(); }));
        QCOMPARE(box.has_value(), good > 0);
        if (!box)
            continue;
        ++found;
        std::size_t kept = 0;
        for (const TriedPlace &place : trials.places)
            if (isIn(*box, place.at)) {
                QVERIFY(place.holds());
                ++kept;
            }
        QVERIFY(kept > 0);
        if (good == trials.places.size())
            QCOMPARE(kept, good); // nothing is cut from what is good
        QCOMPARE(isIn(*box, now), !box->moves.has_value());
        if (box->moves)
            QVERIFY(isIn(*box, *box->moves));
    }
    QVERIFY(found > 50);
}

void TestValueTrials::narrowingIsRefusedWhereNothingHolds()
{
    const ValueTrials none = madeUp(2, 1, [](const TrialPlace &) { return false; });
    QVERIFY(!narrowedRanges(none, {10.0, 10.0}));
    // A choice that is never good goes; a switch cannot.
    ValueTrials trials = madeUp(1, 1, [](const TrialPlace &) { return true; });
    trials.values[0].kind = ValueKind::Choice;
    trials.values[0].choices = {"a", "b", "c"};
    trials.values[0].most = 2.0;
    trials.places.clear();
    for (const double at : {0.0, 1.0, 2.0}) {
        trials.places.emplace_back().at = {at};
        if (at == 1.0)
            trials.places.back().faults.push_back({kCannotBeMade, {}});
    }
    const auto box = narrowedRanges(trials, {1.0});
    QVERIFY(box);
    QVERIFY((box->ranges[0].choices == std::vector<std::string>{"a", "c"}));
    QVERIFY(box->moves && *box->moves == TrialPlace{0.0});
    trials.values[0].kind = ValueKind::Switch;
    QVERIFY(!narrowedRanges(trials, {0.0}));
}

void TestValueTrials::stoppedItGivesNothing()
{
    Progress progress;
    std::stop_source stop;
    stop.request_stop();
    QVERIFY(!tryValues(evaluate(table({80.0, 200.0, {}}, {60.0, 120.0, {}})), {}, {}, progress,
                       stop.get_token()));
}

FFF_TEST(TestValueTrials)
#include "tst_value_trials.moc"
