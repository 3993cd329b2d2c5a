// Of broken models those that break, come apart or fall.
#include "core/analysis/holding.h"
#include "core/model/load_edits.h"
#include "tests/core/analysed.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/broken_models.h"
#include "tests/core/session/dice.h"

namespace fff::test {

namespace {

Document onSheet(Dice &dice, double thinnest, double thickest)
{
    Document document = newDocument();
    Stock stock = *document.stocks.front();
    stock.thickness = dice.between(thinnest, thickest);
    stock.clearance = dice.oneIn(2) ? 0.0 : dice.between(0.0, 0.1);
    return *setStock(std::move(document), stock);
}

/// A body on legs across it.
struct Bench
{
    double half = 0.0, low = 0.0,
           high = 0.0;              // the body's: x from −half to half, y from low to high
    double legs = 0.0, width = 0.0; // where they are to both sides, and half of their width
};

Bench benchOf(Dice &dice)
{
    Bench bench;
    bench.half = dice.between(60.0, 120.0);
    bench.low = dice.between(28.0, 45.0);
    bench.high = bench.low + dice.between(20.0, 40.0);
    bench.legs = dice.between(0.6, 0.85) * bench.half;
    bench.width = dice.between(30.0, 60.0);
    return bench;
}

Document withLegs(Document document, const Bench &bench)
{
    const ShapePointer leg =
        plateOf(-bench.width, 0.0, bench.width, 0.5 * (bench.low + bench.high));
    document = withSection(std::move(document), leg, side(-bench.legs));
    return withSection(std::move(document), leg, side(bench.legs));
}

Document withLoad(Document document, std::size_t section, const Vec2 &at, double mass)
{
    Load weight;
    weight.section = document.sections[section]->ref();
    weight.position = at;
    weight.mass = mass;
    return *addLoad(std::move(document), weight);
}

/// With so much on the first section that its worst corner barely holds or does not, or that its
/// neck does not.
Document strained(Document document, Dice &dice, const Vec2 &at, bool isTooWeak)
{
    document = withLoad(std::move(document), 0, at, 1.0);
    const Analysis analysis = analysed(document);
    StrengthCaches caches;
    const Strength strength = strengthOf(analysis, {}, caches);
    const BearableMass bearable = bearableMass(analysis, strength, {}, caches);
    const double mass = (isTooWeak ? bearable.breaksAt : bearable.cracksFrom).value_or(1.0);
    document.loads.back().mass = dice.between(0.55, isTooWeak ? 1.3 : 0.95) * mass;
    return document;
}

Document slitAcross(std::uint64_t seed, bool isTooWeak)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 4.0);
    const Bench bench = benchOf(dice);
    document = withSection(std::move(document),
                           plateOf(-bench.half, bench.low, bench.half, bench.high), front());
    document = withLegs(std::move(document), bench);
    const double at = dice.between(-0.4, 0.4) * bench.legs, width = dice.between(15.0, 40.0);
    const double into = dice.between(0.7, 1.0) * (bench.high - bench.low);
    document = withSection(
        std::move(document),
        plateOf(-width, bench.high - into, width, bench.high + dice.between(5.0, 25.0)), side(at));
    document = downwards(std::move(document), 0, 3);
    return strained(std::move(document), dice, {at + 10.0, bench.high}, isTooWeak);
}

/// Two plates across each other, weight at their feet and a push at the top of the first.
Document pushed(Dice &dice, double half, double across, const Vec3 &way)
{
    Document document = onSheet(dice, 3.0, 4.0);
    const double height = dice.between(120.0, 200.0);
    document = withSection(std::move(document), plateOf(-half, 0.0, half, height), front());
    document = withSection(std::move(document),
                           plateOf(-across, 0.0, across, dice.between(0.5, 1.0) * height), side());
    const double mass = dice.between(0.3, 2.0);
    document = withLoad(std::move(document), 0, {5.0, 10.0}, mass);
    Load push;
    push.section = document.sections[0]->ref();
    push.position = {5.0, 0.95 * height};
    push.kind = LoadKind::Push;
    push.push = (dice.oneIn(2) ? 1.0 : -1.0) * dice.between(0.16, 0.24) * 9.81 * mass * way;
    return *addLoad(std::move(document), push);
}

} // namespace

Document overloadedBench(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 4.0);
    const Bench bench = benchOf(dice);
    document = withSection(std::move(document),
                           plateOf(-bench.half, bench.low, bench.half, bench.high), front());
    const double at = dice.between(-0.4, 0.4) * bench.legs;
    return strained(withLegs(std::move(document), bench), dice, {at, bench.high}, true);
}

Document overloadedNeck(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 4.0);
    const Bench bench = benchOf(dice);
    const double at = dice.between(-0.5, 0.5) * bench.legs, half = dice.between(4.0, 12.0);
    const double left = dice.between(0.25, 0.6) * (bench.high - bench.low);
    Polygon body{{-bench.half, bench.low}};
    if (dice.oneIn(2)) // from below
        body.insert(body.end(), {{at - half, bench.low},
                                 {at - half, bench.high - left},
                                 {at + half, bench.high - left},
                                 {at + half, bench.low}});
    body.insert(body.end(), {{bench.half, bench.low}, {bench.half, bench.high}});
    if (body.size() == 3) // from above
        body.insert(body.end(), {{at + half, bench.high},
                                 {at + half, bench.low + left},
                                 {at - half, bench.low + left},
                                 {at - half, bench.high}});
    body.push_back({-bench.half, bench.high});
    document = withSection(std::move(document), polygonShape(body), front());
    return strained(withLegs(std::move(document), bench), dice,
                    {at - 2.0 * half, 0.5 * (bench.low + bench.high)}, false);
}

Document overloadedSlit(std::uint64_t seed)
{
    return slitAcross(seed, false);
}

Document brokenSlit(std::uint64_t seed)
{
    return slitAcross(seed, true);
}

Document pulledModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 5.0);
    const Bench bench = benchOf(dice);
    document = withSection(std::move(document),
                           plateOf(-bench.half, bench.low, bench.half, bench.high), front());
    document = withLegs(std::move(document), bench);
    const double at = dice.between(-0.5, 0.5) * bench.legs, width = dice.between(15.0, 30.0);
    const double up = bench.low + dice.between(0.5, 0.8) * (bench.high - bench.low);
    document = withSection(std::move(document), plateOf(-width, 2.0, width, up), side(at));
    // Beside where the slit would be from below: a link that saws under a weight is not offered.
    return withLoad(std::move(document), 3, {0.5 * width, 10.0}, dice.between(0.05, 0.5));
}

Document pushedAlong(std::uint64_t seed)
{
    Dice dice(seed);
    return pushed(dice, dice.between(18.0, 25.0), dice.between(40.0, 70.0), Vec3::UnitX());
}

Document pushedAcross(std::uint64_t seed)
{
    Dice dice(seed);
    return pushed(dice, dice.between(50.0, 80.0), dice.between(18.0, 25.0), Vec3::UnitZ());
}

/// A plate with a wing to one side.
Document leaningModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 3.0, 5.0);
    const double half = dice.between(40.0, 80.0), height = dice.between(50.0, 100.0);
    document = withSection(std::move(document), plateOf(-half, 0.0, half, height), front());
    return withSection(std::move(document),
                       plateOf(-dice.between(30.0, 70.0), 0.5 * height, 10.0, height),
                       side(dice.between(-0.4, 0.4) * half));
}

Document topplingModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 3.0, 6.0);
    const double foot = dice.between(15.0, 25.0), reach = dice.between(70.0, 130.0),
                 low = dice.between(40.0, 80.0), high = low + dice.between(20.0, 40.0);
    document = withSection(
        std::move(document),
        polygonShape(
            {{-foot, 0}, {foot, 0}, {foot, low}, {reach, low}, {reach, high}, {-foot, high}}),
        front());
    const double width = dice.between(25.0, 50.0);
    return withSection(std::move(document), plateOf(-width, 0.0, width, dice.between(20.0, 35.0)),
                       side(dice.between(-5.0, 5.0)));
}

Document unsteadyModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 6.0);
    const double half = dice.between(45.0, 90.0), height = dice.between(50.0, 120.0);
    document = withSection(std::move(document), plateOf(-half, 0.0, half, height), front());
    if (dice.oneIn(2)) {
        const double width = dice.between(5.0, 0.12 * height);
        document = withSection(std::move(document), plateOf(-width, 0.0, width, 25.0),
                               side(dice.between(-0.3, 0.3) * half));
    }
    return document;
}

Document onShortLegs(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 3.0, 6.0);
    const Bench bench = benchOf(dice);
    document = withSection(std::move(document),
                           plateOf(-bench.half, bench.low, bench.half, bench.high), front());
    const double top = 0.5 * (bench.low + bench.high), shift = dice.between(0.0, 15.0);
    document = withSection(std::move(document), plateOf(-bench.width, 0.0, bench.width, top),
                           side(bench.legs));
    return withSection(
        std::move(document),
        plateOf(shift - bench.width, dice.between(0.5, 9.0), shift + bench.width, top),
        side(-bench.legs));
}

Document offTheGround(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = onSheet(dice, 2.0, 6.0);
    const Bench bench = benchOf(dice);
    document = withSection(std::move(document),
                           plateOf(-bench.half, bench.low, bench.half, bench.high), front());
    const double height = dice.between(0.3, 60.0);
    return moveAll(withLegs(std::move(document), bench),
                   Vec3(0.0, dice.oneIn(2) ? height : -height, 0.0));
}

} // namespace fff::test
