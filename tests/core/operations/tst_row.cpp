#include "core/operations/row.h"
#include "tests/test_program.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace fff;

class TestRow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bySpacingGoesToTheEnd();
    void bySpacingStopsAtTheMost();
    void byCountFillsTheRange_data();
    void byCountFillsTheRange();
    void numbersStayWhenTheRangeGrows();
    void ringsHaveEqualSteps();
    void nothingWithoutRoom();
};

// Wrong: the last rib would be missing by a rounding, or stand beyond the root.
void TestRow::bySpacingGoesToTheEnd()
{
    RowRequest request{.from = -30.0, .to = 0.3 * 10.0, .isByCount = false, .spacing = 0.3};
    request.goesBack = true;
    const Row row = placesOf(request);
    QCOMPARE(row.places.size(), 110U); // 10 ahead, 100 behind
    QCOMPARE(row.places.front().number, -100);
    QCOMPARE(row.places.back().number, 10);
    for (const RowPlace &place : row.places)
        QVERIFY(std::abs(place.at - 0.3 * place.number) < 1e-12);
    QVERIFY(!row.isStopped);
}

// Wrong: half a millimetre on two metres would make thousands of sections.
void TestRow::bySpacingStopsAtTheMost()
{
    const Row row = placesOf({.from = 0.0, .to = 2000.0, .isByCount = false, .spacing = 0.5});
    QVERIFY(row.isStopped);
    QCOMPARE(row.places.size(), static_cast<std::size_t>(kMostReplicas));
}

void TestRow::byCountFillsTheRange_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<int>("count");
    QTest::newRow("ahead") << 0.0 << 100.0 << 8;
    QTest::newRow("two") << 0.0 << 100.0 << 2;
    QTest::newRow("behind") << -50.0 << 0.0 << 5;
    QTest::newRow("both") << -30.0 << 100.0 << 9;
    QTest::newRow("hardly behind") << -1.0 << 100.0 << 9;
    QTest::newRow("beyond the source") << 20.0 << 100.0 << 4;
}

// Wrong: fewer or more than was asked for, one where the root has come to nothing, or a gap.
void TestRow::byCountFillsTheRange()
{
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(int, count);
    RowRequest request{.from = from, .to = to, .count = count};
    request.goesBack = true;
    const Row row = placesOf(request);
    QCOMPARE(static_cast<int>(row.places.size()), count - 1);
    std::set<int> numbers;
    double last = 0.0, least = 1e9;
    for (const RowPlace &place : row.places) {
        QVERIFY(place.at > from && place.at < to);
        QVERIFY(place.number != 0 && (place.number > 0) == (place.at > 0.0));
        numbers.insert(place.number);
        if (&place != &row.places.front() && place.number != 1)
            least = std::min(least, place.at - last);
        last = place.at;
    }
    QCOMPARE(static_cast<int>(numbers.size()), count - 1);
    if (count > 3)
        QVERIFY(least > 0.5 * (to - from) / count);
}

// Wrong: what was hidden, weighted or joined by hand would be another section than before.
void TestRow::numbersStayWhenTheRangeGrows()
{
    const auto numbers = [](double from, double to) {
        RowRequest request{.from = from, .to = to, .isByCount = false, .spacing = 7.0};
        request.goesBack = true;
        std::map<int, double> result;
        for (const RowPlace &place : placesOf(request).places)
            result.emplace(place.number, place.at);
        return result;
    };
    const auto small = numbers(-20.0, 40.0), large = numbers(-60.0, 90.0);
    for (const auto &[number, at] : small)
        QCOMPARE(large.at(number), at);
}

// Wrong: the first and the last tooth of a wheel would be in one place.
void TestRow::ringsHaveEqualSteps()
{
    RowRequest request{.from = 0.0, .to = 120.0, .count = 12, .isRing = true};
    const Row byCount = placesOf(request);
    QCOMPARE(byCount.places.size(), 11U);
    for (const RowPlace &place : byCount.places)
        QVERIFY(std::abs(place.at - 10.0 * place.number) < 1e-12);
    request.isByCount = false;
    request.spacing = 10.0;
    QCOMPARE(placesOf(request).places.size(), 11U);
    request.spacing = 11.0; // the last would stand 10 mm before the source
    QCOMPARE(placesOf(request).places.size(), 10U);
    request.spacing = 13.0; // 117: 3 mm before it, on it all but
    QCOMPARE(placesOf(request).places.size(), 8U);
}

// Wrong: a range of no length would divide by nothing.
void TestRow::nothingWithoutRoom()
{
    QVERIFY(placesOf({.from = 0.0, .to = 0.0, .count = 5}).places.empty());
    QVERIFY(placesOf({.from = -10.0, .to = 0.0, .count = 5}).places.empty());
    QVERIFY(placesOf({.from = 5.0, .to = 5.0, .isByCount = false}).places.empty());
    QVERIFY(placesOf({.from = 0.0, .to = 3.0, .isByCount = false, .spacing = 4.0}).places.empty());
}

FFF_TEST(TestRow)
#include "tst_row.moc"
