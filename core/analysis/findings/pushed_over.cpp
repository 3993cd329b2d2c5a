#include "core/analysis/findings/pushed_over.h"

#include "core/analysis/finding_action.h"
#include "core/analysis/findings/broader_base.h"
#include "core/geometry/convex_hull.h"

#include <algorithm>

namespace fff {

namespace {

Message pushedOverSentence(const Finding &, const Model &)
{
    return {FFF_TEXT("Checks", "Pushed over. Without its pushes it would stand."), {}};
}

/// No base holds what is lifted.
std::vector<FindingAction> broadenBase(const Finding &finding, const Analysis &)
{
    if (!finding.details<PushedOver>())
        return {};
    return {{&kWidenBase}, {&kAddFoot}};
}

/// Below the centre of all that weighs, over the ground.
Vec2 weightOnGround(const ModelStructure &made, const Component &component)
{
    const Structure &structure = made.structure;
    double weight = 0.0;
    Vec3 sum = Vec3::Zero();
    const auto add = [&](double share, const Vec3 &point) {
        weight += share;
        sum += share * point;
    };
    const double pull = structure.gravity.norm();
    for (const int member : component.members) {
        const Member &own = structure.members[static_cast<std::size_t>(member)];
        add(own.mass * pull, own.centroid);
    }
    std::vector<int> weights = component.loads;
    std::erase_if(weights, [&](int load) {
        return std::find(made.pushLoads.begin(), made.pushLoads.end(), load) !=
               made.pushLoads.end();
    });
    for (const int load : weights) {
        const MemberLoad &own = structure.loads[static_cast<std::size_t>(load)];
        add(-own.force.dot(structure.up), own.point);
    }
    return weight > 0.0 ? Vec2(sum.x() / weight, sum.z() / weight) : Vec2::Zero();
}

} // namespace

const FindingKind kPushedOver{"pushedOver",
                              Subject::Strength,
                              FFF_TEXT("Checks", "Pushed over"),
                              pushedOverSentence,
                              broadenBase,
                              nullptr,
                              nullptr,
                              nullptr,
                              FFF_TEXT("Checks", "Give it a broader base or more weight, or push "
                                                 "less, or lower down.")};

void findPushedOver(const Strength &strength, std::vector<Finding> &found)
{
    if (!strength.standsUnpushed)
        return;
    const auto isOver = [](const ComponentState &state) {
        return state.balance == Balance::Topples || state.balance == Balance::LineSupport ||
               state.balance == Balance::Floating || state.balance == Balance::NoContact;
    };
    const std::vector<ComponentState> &all = strength.equilibrium().components;
    const auto state = std::find_if(all.begin(), all.end(), isOver);
    if (state == all.end())
        return;
    Finding finding = makeFinding(kPushedOver, Severity::Error);
    if (state->body.pressing > 0.0) {
        const Vec3 &at = state->body.onGround;
        std::vector<Vec2> feet;
        for (const int foot : state->parts.feet) {
            const Vec3 &point = strength.made.structure.feet[static_cast<std::size_t>(foot)].point;
            feet.emplace_back(point.x(), point.z());
        }
        finding.setDetails(PushedOver{Vec2(at.x(), at.z()),
                                      weightOnGround(strength.made, state->parts),
                                      convexHull(std::move(feet))});
    }
    found.push_back(std::move(finding));
}

} // namespace fff
