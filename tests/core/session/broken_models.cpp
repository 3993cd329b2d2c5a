#include "tests/core/session/broken_models.h"

#include "core/analysis/findings/broader_base.h"
#include "core/analysis/findings/connection.h"
#include "core/analysis/findings/ending_before.h"
#include "core/analysis/findings/in_each_other.h"
#include "core/analysis/findings/joining.h"
#include "core/analysis/findings/loose_joints.h"
#include "core/analysis/findings/loose_pieces.h"
#include "core/analysis/findings/moving_slits.h"
#include "core/analysis/findings/order.h"
#include "core/analysis/findings/pulled_joints.h"
#include "core/analysis/findings/pushed_over.h"
#include "core/analysis/findings/second_foot.h"
#include "core/analysis/findings/standing.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/analysis/findings/strengthening.h"
#include "core/analysis/findings/thin_webs.h"
#include "core/analysis/findings/turning_square.h"
#include "core/analysis/findings/wider_neck.h"
#include "tests/core/assembly/known_models.h"
#include "tests/core/session/dice.h"

#include <algorithm>

namespace fff::test {

namespace {

/// Two plates across each other, and what is on them.
Document crossOf(Dice &dice)
{
    const double height = dice.between(40.0, 80.0);
    const auto plate = [&] {
        return plateOf(-dice.between(35.0, 60.0), 0.0, dice.between(35.0, 60.0), height);
    };
    const ShapePointer first = plate(), second = plate();
    return withSection(withSection(newDocument(), first, front(dice.between(-10.0, 10.0))), second,
                       side(dice.between(-10.0, 10.0)));
}

/// A crate of two by two, each section of its own size.
Document crateOf(Dice &dice)
{
    const double wide = dice.between(20.0, 40.0), deep = dice.between(20.0, 40.0),
                 height = dice.between(25.0, 60.0), over = dice.between(12.0, 25.0);
    Document document = newDocument();
    for (const double at : {-0.5 * deep, 0.5 * deep})
        document =
            withSection(std::move(document),
                        plateOf(-0.5 * wide - over, 0.0, 0.5 * wide + over, height), front(at));
    for (const double at : {-0.5 * wide, 0.5 * wide})
        document =
            withSection(std::move(document),
                        plateOf(-0.5 * deep - over, 0.0, 0.5 * deep + over, height), side(at));
    return document;
}

Document withoutJoint(Document document, std::size_t first, std::size_t second)
{
    JointOverride none;
    none.a = document.sections[first]->ref();
    none.b = document.sections[second]->ref();
    none.kind = JointKind::None;
    return *setJointOverride(std::move(document), none);
}

Document looseModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = crossOf(dice);
    const double half = dice.between(12.0, 30.0), height = dice.between(20.0, 60.0),
                 away = dice.between(70.0, 140.0);
    return withSection(std::move(document), plateOf(-half, 0.0, half, height),
                       dice.oneIn(2) ? side(away) : front(-away));
}

Document strayModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = looseModel(seed);
    const double half = dice.between(3.0, 20.0);
    return withSection(std::move(document), plateOf(-half, 0.0, half, dice.between(3.0, 30.0)),
                       turned(dice.between(0.2, 1.4)));
}

Document unjoinedModel(std::uint64_t seed)
{
    Dice dice(seed);
    return withoutJoint(crateOf(dice), static_cast<std::size_t>(dice.below(2)),
                        2 + static_cast<std::size_t>(dice.below(2)));
}

Document unjoinedCross(std::uint64_t seed)
{
    Dice dice(seed);
    return withoutJoint(crossOf(dice), 0, 1);
}

/// A shelf that ends at a wall, in it or a little before it.
Document shelfAtAWall(Dice &dice, double from)
{
    const double half = dice.between(25.0, 45.0);
    Document document = withSection(newDocument(), plateOf(-half, 0.0, half, 100.0), side());
    document = withSection(std::move(document), plateOf(-60.0, 0.0, 80.0, 25.0),
                           front(dice.between(-10.0, 10.0)));
    const double width = dice.between(15.0, half - 5.0), reach = dice.between(40.0, 80.0);
    return withSection(std::move(document), plateOf(from, -width, reach, width),
                       level(dice.between(30.0, 70.0)));
}

Document touchingModel(std::uint64_t seed)
{
    Dice dice(seed);
    return shelfAtAWall(dice, 1.5 + (dice.oneIn(3) ? dice.between(0.0, 0.2) : 0.0));
}

Document endingInside(std::uint64_t seed)
{
    Dice dice(seed);
    return shelfAtAWall(dice, dice.between(0.2, 1.0));
}

Document obliqueModel(std::uint64_t seed)
{
    Dice dice(seed);
    const double height = dice.between(30.0, 70.0);
    Document document = withSection(newDocument(), plateOf(-50.0, 0.0, 50.0, height), front(0.0));
    const double angle = radians(dice.between(12.0, 28.0)) * (dice.oneIn(2) ? 1.0 : -1.0);
    return withSection(std::move(document),
                       plateOf(-dice.between(30.0, 60.0), 0.0, dice.between(30.0, 60.0),
                               dice.between(0.7, 1.3) * height),
                       turned(angle));
}

Document roundaboutModel(std::uint64_t seed)
{
    Dice dice(seed);
    return roundabout(crateOf(dice), 0);
}

Document alongAnEdge(std::uint64_t seed)
{
    Dice dice(seed);
    const double half = dice.between(30.0, 60.0), height = dice.between(40.0, 80.0);
    Document document = withSection(newDocument(), plateOf(-half, 0.0, half, height), front());
    return withSection(std::move(document),
                       plateOf(-dice.between(25.0, 50.0), 0.0, dice.between(25.0, 50.0),
                               dice.between(0.7, 1.0) * height),
                       side((dice.oneIn(2) ? 1.0 : -1.0) * (half + dice.between(-1.4, 0.5))));
}

Document nearAnEdge(std::uint64_t seed)
{
    Dice dice(seed);
    const double half = dice.between(30.0, 60.0), height = dice.between(40.0, 80.0);
    Document document = withSection(newDocument(), plateOf(-half, 0.0, half, height), front());
    return withSection(std::move(document),
                       plateOf(-dice.between(25.0, 50.0), 0.0, dice.between(25.0, 50.0), height),
                       side((dice.oneIn(2) ? 1.0 : -1.0) * (half - 1.5 - dice.between(0.5, 2.8))));
}

/// One slit goes nearly all through.
Document deepSlit(std::uint64_t seed)
{
    Dice dice(seed);
    const double height = dice.between(30.0, 50.0), at = dice.between(-20.0, 20.0);
    Document document = withSection(newDocument(), plateOf(-50.0, 0.0, 50.0, height), front());
    document = withSection(std::move(document), plateOf(-40.0, 0.0, 40.0, height), side(at));
    const double left = dice.between(std::max(1.0, kLeastShare * height), 2.8) / height;
    JointOverride deep;
    deep.a = document.sections[0]->ref();
    deep.b = document.sections[1]->ref();
    deep.shares = {{{at, 0.5 * height}, dice.oneIn(2) ? left : 1.0 - left}};
    return *setJointOverride(std::move(document), deep);
}

/// A shelf across two sections that cross: what is between the slits of both falls off.
Document slitThroughModel(std::uint64_t seed)
{
    Dice dice(seed);
    Document document = crossOf(dice);
    const double height = document.sections[0]->shape->region().outer[2].y();
    const double left = dice.between(20.0, 60.0), right = dice.between(20.0, 60.0),
                 near = dice.between(20.0, 60.0), far = dice.between(20.0, 60.0);
    return withSection(std::move(document), plateOf(-left, -near, right, far),
                       level(dice.between(0.3, 0.7) * height));
}

constexpr BrokenKind kBroken[] = {
    {"move it to the others", &kMoveToOther, &kNotConnected, looseModel},
    {"delete it", &kDeleteSections, &kNotConnected, strayModel},
    {"join again what is loose", &kJoinAgain, &kNotConnected, unjoinedCross},
    {"join again what collides", &kJoinAgain, &kNoSlit, unjoinedModel},
    {"trim it", &kTrim, &kNoSlit, unjoinedCross},
    {"tabs for what touches", &kJoinWithTabs, &kNotConnected, touchingModel},
    {"tabs for what ends inside", &kJoinWithTabs, &kInterference, endingInside},
    {"turn it square", &kTurnSquare, &kShallowAngle, obliqueModel},
    {"make assemblable", &kMakeAssemblable, &kCannotAssemble, roundaboutModel},
    {"move it in from the edge", &kMoveIn, &kLooseJoint, alongAnEdge},
    {"move the slit", &kMoveSlit, &kThinWeb, nearAnEdge},
    {"cut less deep", &kCutLessDeep, &kThinWeb, deepSlit},
    {"turn slits round, loose parts", &kTurnSlits, &kLoosePieces, slitThroughModel},
    {"end one at the other, loose parts", &kEndBefore, &kLoosePieces, slitThroughModel},
    {"turn slits round, pulled open", &kTurnPulledSlits, &kPulledOpen, pulledModel},
    {"stretch to the ground", &kStretchToGround, &kLeans, onShortLegs},
    {"drop, above", &kDropToGround, &kNoContact, offTheGround},
    {"drop, below", &kDropToGround, &kBelowGround, offTheGround},
    {"widen the base, falls", &kWidenBase, &kTopples, topplingModel},
    {"add a foot, falls", &kAddFoot, &kTopples, leaningModel},
    {"add a foot, tips easily", &kAddFoot, &kUnsteady, unsteadyModel},
    {"widen the base, pushed over", &kWidenBase, &kPushedOver, pushedAlong},
    {"add a foot, pushed over", &kAddFoot, &kPushedOver, pushedAcross},
    {"thicker stock, too weak", &kThickerStock, &kTooWeak, overloadedBench},
    {"thicker stock, barely holds", &kThickerStock, &kBarelyHolds, overloadedSlit},
    {"wider neck, too weak", &kWiderNeck, &kTooWeak, overloadedBench},
    {"wider neck, barely holds", &kWiderNeck, &kBarelyHolds, overloadedNeck},
    {"second foot, too weak", &kSecondFoot, &kTooWeak, overloadedBench},
    {"second foot, barely holds", &kSecondFoot, &kBarelyHolds, overloadedNeck},
    {"shallower slit, too weak", &kShallowerSlit, &kTooWeak, brokenSlit},
    {"shallower slit, barely holds", &kShallowerSlit, &kBarelyHolds, overloadedSlit},
};

} // namespace

std::span<const BrokenKind> brokenKinds()
{
    return kBroken;
}

} // namespace fff::test
