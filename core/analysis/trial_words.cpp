// What a trial changes, in words.
#include "core/analysis/trial.h"

#include "core/analysis/finding.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/base/tolerances.h"
#include "core/model/changes.h"

#include <algorithm>
#include <map>
#include <vector>

namespace fff {

namespace {

struct Difference
{
    int turned = 0;                                  // joints whose slits open to the other side
    int made = 0, gone = 0, moved = 0, reshaped = 0; // sections
    Named one;                                       // of these, where there is one
    double way = 0.0;                                // mm, by which one was moved
    int morePieces = 0;                              // sections that are cut into more pieces
    int shifted = 0;                                 // joints whose slits meet elsewhere
};

/// To which side a section's first slit for its mate opens, in the world.
std::optional<Vec3> mouthOf(const Analysis &analysis, const Joint &joint)
{
    const auto host = static_cast<std::size_t>(joint.a);
    for (const Slit &slit : analysis.assembly.slits[host])
        if (slit.joint == joint.id && slit.role == SlitRole::Slit && slit.isOpen)
            return analysis.model.section(host)->frame.directionToWorld(slit.mouth - slit.inner);
    return {};
}

/// A stock that is of another thickness then.
const Stock *thickened(const Analysis &before, const Analysis &after)
{
    for (const std::shared_ptr<const Stock> &stock : after.model.document.stocks) {
        const Stock *was = before.model.document.find(stock->id);
        if (was && was->thickness != stock->thickness)
            return stock.get();
    }
    return nullptr;
}

Difference differenceOf(const Analysis &before, const Analysis &after)
{
    Difference difference;
    for (const SectionRef &ref : changedSections(before.model, after.model)) {
        const int was = before.model.indexOf(ref), is = after.model.indexOf(ref);
        if (was < 0) {
            ++difference.made;
            difference.one = nameOf(after.model, ref);
            continue;
        }
        difference.one = nameOf(before.model, ref);
        const Section &old = *before.model.section(static_cast<std::size_t>(was));
        const Section &now = *after.model.section(static_cast<std::size_t>(is));
        if (old.shape != now.shape)
            ++difference.reshaped;
        else if (!(old.frame == now.frame))
            ++difference.moved;
        difference.way = (now.frame.origin - old.frame.origin).norm();
    }
    for (std::size_t i = 0; i < before.model.sectionCount(); ++i) {
        const int is = after.model.indexOf(before.model.ref(i));
        if (is < 0) {
            ++difference.gone;
            difference.one = nameOf(before.model, before.model.ref(i));
        } else if (after.bodies.countOf(is) > before.bodies.countOf(static_cast<int>(i)))
            ++difference.morePieces;
    }
    for (const Joint &joint : before.assembly.joints) {
        const int a = after.model.indexOf(before.model.ref(static_cast<std::size_t>(joint.a)));
        const int b = after.model.indexOf(before.model.ref(static_cast<std::size_t>(joint.b)));
        const Joint *now =
            a < 0 || b < 0 ? nullptr : after.assembly.joints.find(std::min(a, b), std::max(a, b));
        if (!now)
            continue;
        const auto was = mouthOf(before, joint), is = mouthOf(after, *now);
        if (was && is && was->dot(*is) < 0.0)
            ++difference.turned;
        else if (was && is && std::abs(was->norm() - is->norm()) > kEqualEnds)
            ++difference.shifted;
    }
    if (difference.moved + difference.reshaped > 0 || thickened(before, after))
        difference.shifted = 0; // slits follow these
    return difference;
}

int problemsIn(std::span<const Finding> found)
{
    return static_cast<int>(std::count_if(found.begin(), found.end(), [](const Finding &finding) {
        return finding.severity >= Severity::Warning;
    }));
}

/// What is said of whether it holds; null where nothing is.
const Finding *heldIn(std::span<const Finding> found)
{
    const auto held = std::find_if(found.begin(), found.end(), [](const Finding &finding) {
        return finding.subject() == Subject::Strength && finding.details<Held>();
    });
    return held == found.end() ? nullptr : &*held;
}

/// What nothing like it was said of the same sections before; what holds is told by itself.
std::vector<const Finding *> newIn(std::span<const Finding> after, std::span<const Finding> before)
{
    std::vector<const Finding *> found;
    for (const Finding &finding : after)
        if (finding.severity >= Severity::Note && !finding.details<Held>() &&
            !isAmong(finding, before))
            found.push_back(&finding);
    return found;
}

constexpr Text kListed{nullptr, "%1, %2"};

} // namespace

Message changesBetween(const Analysis &before, const Analysis &after,
                       std::span<const Finding> foundBefore, std::span<const Finding> foundAfter)
{
    const Difference difference = differenceOf(before, after);
    std::vector<Message> parts;
    const auto add = [&parts](int count, Message one, const Text &many) {
        if (count > 0)
            parts.push_back(count == 1 ? std::move(one) : Message{many, {}, count});
    };
    const Named &name = difference.one;
    add(difference.turned, {FFF_TEXT("Checks", "1 joint flipped"), {}},
        FFF_TEXT_OF_MANY("Checks", "%n joints flipped"));
    if (const Stock *stock = thickened(before, after))
        //: %1 is the name of a stock, %2 a length
        parts.push_back({FFF_TEXT("Checks", "%1 becomes %2 thick"),
                         {Named{stock->name}, lengthOf(stock->thickness)}});
    add(difference.shifted, {FFF_TEXT("Checks", "The slits of 1 joint meet elsewhere"), {}},
        FFF_TEXT_OF_MANY("Checks", "The slits of %n joints meet elsewhere"));
    add(difference.moved,
        //: %1 is the name of a section, %2 a length
        {FFF_TEXT("Checks", "%1 moved by %2"), {name, lengthOf(difference.way)}},
        FFF_TEXT_OF_MANY("Checks", "%n sections moved"));
    add(difference.reshaped,
        //: %1 is the name of a section
        {FFF_TEXT("Checks", "%1 reshaped"), {name}},
        FFF_TEXT_OF_MANY("Checks", "%n sections reshaped"));
    add(difference.made,
        //: %1 is the name of a section
        {FFF_TEXT("Checks", "%1 added"), {name}}, FFF_TEXT_OF_MANY("Checks", "%n sections added"));
    add(difference.gone,
        //: %1 is the name of a section
        {FFF_TEXT("Checks", "%1 deleted"), {name}},
        FFF_TEXT_OF_MANY("Checks", "%n sections deleted"));
    if (difference.turned > 0 && difference.morePieces == 0)
        parts.push_back({FFF_TEXT("Checks", "nothing more is cut through"), {}});
    add(problemsIn(foundBefore) - problemsIn(foundAfter),
        {FFF_TEXT("Checks", "1 problem solved"), {}},
        FFF_TEXT_OF_MANY("Checks", "%n problems solved"));
    const Finding *was = heldIn(foundBefore), *is = heldIn(foundAfter);
    if (was && is && !was->is(*is->kind))
        //: after other things that change; %1 is a verdict such as "Holds 350 g"
        parts.push_back({FFF_TEXT("Checks", "then: %1"), {titleOf(*is)}});
    if (const auto added = newIn(foundAfter, foundBefore); !added.empty())
        //: after other things that change; %1 is a verdict such as "Too little material"
        add(static_cast<int>(added.size()),
            {FFF_TEXT("Checks", "new: %1"), {titleOf(*added.front())}},
            FFF_TEXT_OF_MANY("Checks", "%n new remarks"));
    Message all;
    for (Message &part : parts)
        all = all.isEmpty() ? std::move(part) : Message{kListed, {std::move(all), std::move(part)}};
    return all;
}

} // namespace fff
