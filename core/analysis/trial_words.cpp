// What a trial changes, in words.
#include "core/analysis/trial.h"

#include "core/model/changes.h"

#include <algorithm>
#include <map>

namespace fff {

namespace {

struct Difference
{
    int turned = 0;                                  // joints whose slits open to the other side
    int made = 0, gone = 0, moved = 0, reshaped = 0; // sections
    int morePieces = 0;                              // sections that are cut into more pieces
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

Difference differenceOf(const Analysis &before, const Analysis &after)
{
    Difference difference;
    for (const SectionRef &ref : changedSections(before.model, after.model)) {
        const int was = before.model.indexOf(ref), is = after.model.indexOf(ref);
        if (was < 0) {
            ++difference.made;
            continue;
        }
        const Section &old = *before.model.section(static_cast<std::size_t>(was));
        const Section &now = *after.model.section(static_cast<std::size_t>(is));
        if (old.shape != now.shape)
            ++difference.reshaped;
        else if (!(old.frame == now.frame))
            ++difference.moved;
    }
    for (std::size_t i = 0; i < before.model.sectionCount(); ++i) {
        const int is = after.model.indexOf(before.model.ref(i));
        if (is < 0)
            ++difference.gone;
        else if (after.bodies.countOf(is) > before.bodies.countOf(static_cast<int>(i)))
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
    }
    return difference;
}

int problemsIn(std::span<const Finding> found)
{
    return static_cast<int>(std::count_if(found.begin(), found.end(), [](const Finding &finding) {
        return finding.severity >= Severity::Warning;
    }));
}

constexpr Text kListed{nullptr, "%1, %2"};

} // namespace

Message changesBetween(const Analysis &before, const Analysis &after,
                       std::span<const Finding> foundBefore, std::span<const Finding> foundAfter)
{
    const Difference difference = differenceOf(before, after);
    std::vector<Message> parts;
    const auto add = [&parts](int count, const Text &one, const Text &many) {
        if (count > 0)
            parts.push_back(count == 1 ? Message{one, {}} : Message{many, {}, count});
    };
    add(difference.turned, FFF_TEXT("Checks", "One joint turned round"),
        FFF_TEXT_OF_MANY("Checks", "%n joints turned round"));
    add(difference.moved, FFF_TEXT("Checks", "One section moved"),
        FFF_TEXT_OF_MANY("Checks", "%n sections moved"));
    add(difference.reshaped, FFF_TEXT("Checks", "One section with another outline"),
        FFF_TEXT_OF_MANY("Checks", "%n sections with another outline"));
    add(difference.made, FFF_TEXT("Checks", "One section more"),
        FFF_TEXT_OF_MANY("Checks", "%n sections more"));
    add(difference.gone, FFF_TEXT("Checks", "One section less"),
        FFF_TEXT_OF_MANY("Checks", "%n sections less"));
    if (difference.turned > 0 && difference.morePieces == 0)
        parts.push_back({FFF_TEXT("Checks", "nothing is cut through"), {}});
    add(problemsIn(foundBefore) - problemsIn(foundAfter), FFF_TEXT("Checks", "one problem less"),
        FFF_TEXT_OF_MANY("Checks", "%n problems less"));
    Message all;
    for (Message &part : parts)
        all = all.isEmpty() ? std::move(part) : Message{kListed, {std::move(all), std::move(part)}};
    return all;
}

} // namespace fff
