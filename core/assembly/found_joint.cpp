#include "core/assembly/found_joint.h"

#include "core/assembly/crossing.h"
#include "core/assembly/joint_wish.h"
#include "core/assembly/slice_wish.h"

#include <memory>
#include <utility>

namespace fff {

namespace {

/// Drawn sections by their id, all others by their place behind them.
bool isLower(const Model &model, int a, int b)
{
    const SectionId i = model.section(static_cast<std::size_t>(a))->id;
    const SectionId j = model.section(static_cast<std::size_t>(b))->id;
    return i.isValid() && j.isValid() ? i < j : a < b;
}

void setGuest(std::vector<Slit> &slits, int guest)
{
    for (Slit &slit : slits)
        slit.guest = guest;
}

FoundJoint found(int a, int b, Crossing crossing, JointSlits slits)
{
    FoundJoint found;
    found.joint.a = a;
    found.joint.b = b;
    found.joint.kind = slits.kind;
    found.joint.crossing = std::make_shared<const Crossing>(std::move(crossing));
    found.slitsOfA = std::move(slits.a);
    found.slitsOfB = std::move(slits.b);
    setGuest(found.slitsOfA, b);
    setGuest(found.slitsOfB, a);
    return found;
}

} // namespace

JointSide sideOf(const Model &model, int section)
{
    const auto index = static_cast<std::size_t>(section);
    return {*model.section(index), model.stockOf(index)};
}

JointSlits slitsOf(const Model &model, int a, int b, Crossing &crossing, const JointWish &wish)
{
    JointWish known = wish;
    const JointWish ofSlices = wishInSlices(model, a, b, crossing);
    if (known.sign == 0)
        known.sign = ofSlices.sign;
    if (known.shares.empty() && known.sign == ofSlices.sign)
        known.shares = ofSlices.shares;
    return cutSlits(crossing, sideOf(model, a), sideOf(model, b), isLower(model, a, b), known);
}

tl::expected<TabJoint, NoTabs> tabsOf(const Model &model, int a, int b)
{
    return cutTabs(sideOf(model, a), sideOf(model, b));
}

std::optional<FoundJoint> findJoint(const Model &model, int a, int b)
{
    if (wantsTabs(model, a, b))
        if (auto tabs = tabsOf(model, a, b))
            return found(a, b, std::move(tabs->crossing), std::move(tabs->slits));
    const Section &sectionA = *model.section(static_cast<std::size_t>(a));
    const Section &sectionB = *model.section(static_cast<std::size_t>(b));
    Crossing crossing =
        findCrossing(*sectionA.shape, sectionA.frame, *sectionB.shape, sectionB.frame);
    if (crossing.overlaps.empty())
        return {};
    JointSlits slits = slitsOf(model, a, b, crossing, wishFor(model, a, b, crossing));
    return found(a, b, std::move(crossing), std::move(slits));
}

NoSlit whyNoSlit(const Model &model, const Joint &joint)
{
    return whyNoSlit(*joint.crossing, sideOf(model, joint.a), sideOf(model, joint.b),
                     wishFor(model, joint.a, joint.b, *joint.crossing));
}

} // namespace fff
