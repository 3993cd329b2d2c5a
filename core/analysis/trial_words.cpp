// What a trial changes, in words.
#include "core/analysis/trial.h"

#include "core/analysis/angle_words.h"
#include "core/analysis/finding.h"
#include "core/analysis/findings/strength_findings.h"
#include "core/assembly/joint_measures.h"
#include "core/base/tolerances.h"
#include "core/model/changes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace fff {

namespace {

/// Ways that differ by less are one way, mm.
constexpr double kSameWay = 1e-6;

/// So many of a kind, and the name of one of these.
struct Counted
{
    int count = 0;
    Named one;
    void add(Named name)
    {
        ++count;
        one = std::move(name);
    }
};

struct Difference
{
    int turned = 0;                             // joints whose slits open to the other side
    Counted made, gone, moved, swung, reshaped; // sections; swung: they lie at another angle
    Vec3 way = Vec3::Zero();                    // mm, by which the last of these was moved
    bool isOneWay = true;                       // and all others of them, too
    double angle = 0.0;                         // radians, by which one was swung
    int morePieces = 0;                         // sections that are cut into more pieces
    int shifted = 0;                            // joints whose slits meet elsewhere
    int joined = 0;                             // joints of sections that had none with each other
    std::optional<JointRef> one;                // of these
};

/// How far one frame is turned from the other, radians.
double angleBetween(const Frame &a, const Frame &b)
{
    const double trace = a.x.dot(b.x) + a.y.dot(b.y) + a.normal().dot(b.normal());
    return std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0));
}

/// To which side a section's first slit for its mate opens, in the world.
std::optional<Vec3> mouthOf(const Analysis &analysis, const Joint &joint)
{
    const auto host = static_cast<std::size_t>(joint.a);
    for (const Slit &slit : analysis.assembly.slits[host])
        if (slit.joint == joint.id && slit.role == SlitRole::Slit && slit.isOpen)
            return analysis.model.section(host)->frame.directionToWorld(slit.mouth - slit.inner);
    return {};
}

/// mm; 0 where the joint has none.
double longestSlit(const Model &model, const JointRef &joint)
{
    double longest = 0.0;
    if (const auto state = jointState(model, joint))
        for (const auto &slits : {measuresOfA(*state), measuresOfB(*state)})
            for (const SlitMeasure &slit : slits)
                longest = std::max(longest, slit.length);
    return longest;
}

/// Joints of sections that are there before and after.
void addJoined(const Analysis &before, const Analysis &after, Difference &difference)
{
    for (const Joint &joint : after.assembly.joints) {
        const JointRef ref(after.model.ref(static_cast<std::size_t>(joint.a)),
                           after.model.ref(static_cast<std::size_t>(joint.b)));
        const int a = before.model.indexOf(ref.a), b = before.model.indexOf(ref.b);
        if (a < 0 || b < 0 || before.assembly.joints.find(std::min(a, b), std::max(a, b)))
            continue;
        ++difference.joined;
        difference.one = ref;
    }
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
        const Named name = nameOf(after.model, ref);
        if (was < 0) {
            difference.made.add(name);
            continue;
        }
        const Section &old = *before.model.section(static_cast<std::size_t>(was));
        const Section &now = *after.model.section(static_cast<std::size_t>(is));
        const double angle = angleBetween(old.frame, now.frame);
        if (old.shape != now.shape) {
            difference.reshaped.add(name);
        } else if (angle > kPracticallyParallel) {
            difference.swung.add(name);
            difference.angle = angle;
        } else if (!(old.frame == now.frame)) {
            const Vec3 way = now.frame.origin - old.frame.origin;
            difference.isOneWay = difference.isOneWay && (difference.moved.count == 0 ||
                                                          (way - difference.way).norm() < kSameWay);
            difference.moved.add(name);
            difference.way = way;
        }
    }
    for (std::size_t i = 0; i < before.model.sectionCount(); ++i) {
        const int is = after.model.indexOf(before.model.ref(i));
        if (is < 0) {
            difference.gone.add(nameOf(before.model, before.model.ref(i)));
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
    addJoined(before, after, difference);
    if (difference.moved.count + difference.swung.count + difference.reshaped.count > 0 ||
        thickened(before, after))
        difference.shifted = 0; // slits follow these
    return difference;
}

/// What is said of whether it holds; null where nothing is.
const Finding *heldIn(std::span<const Finding> found)
{
    const auto held = std::find_if(found.begin(), found.end(), [](const Finding &finding) {
        return finding.subject() == Subject::Strength && finding.details<Held>();
    });
    return held == found.end() ? nullptr : &*held;
}

bool isProblem(const Finding &finding)
{
    return finding.severity >= Severity::Warning;
}

/// What became of what was said.
struct Outcome
{
    int solved = 0;                     // problems that are none any more
    std::vector<const Finding *> added; // what nothing like it was said before
};

/// The very same verdict first. A group that has another section then is said to be loose as it was
/// before, so what is left is paired by its kind alone.
Outcome outcomeOf(std::span<const Finding> before, std::span<const Finding> after)
{
    std::vector<const Finding *> gone, come;
    for (const Finding &finding : before)
        if (finding.severity >= Severity::Note)
            gone.push_back(&finding);
    for (const Finding &finding : after)
        if (finding.severity >= Severity::Note)
            come.push_back(&finding);
    const auto follow = [&](auto isSame, bool isWorse) {
        std::erase_if(come, [&](const Finding *now) {
            const auto was = std::find_if(gone.begin(), gone.end(), [&](const Finding *old) {
                return isSame(*old, *now) &&
                       (isWorse ? old->severity < now->severity : old->severity == now->severity);
            });
            if (was == gone.end())
                return false;
            gone.erase(was);
            return !isWorse; // what is worse is not what was said before, nor was that solved
        });
    };
    const auto isAlike = [](const Finding &old, const Finding &now) {
        return old.kind == now.kind;
    };
    follow(isSameVerdict, false);
    follow(isAlike, false);
    follow(isAlike, true);
    Outcome outcome;
    outcome.solved = static_cast<int>(std::count_if(
        gone.begin(), gone.end(), [](const Finding *old) { return isProblem(*old); }));
    for (const Finding *now : come)
        if (!now->details<Held>()) // it is told by itself
            outcome.added.push_back(now);
    return outcome;
}

/// Of several: by how much all of them go up or down, where that is all.
Message wordsOfMoved(const Difference &difference)
{
    const int count = difference.moved.count;
    const Vec3 &way = difference.way;
    const double height = way.y();
    if (!difference.isOneWay || (way - height * Vec3::UnitY()).norm() > kSameWay)
        return {FFF_TEXT_OF_MANY("Checks", "%n sections moved"), {}, count};
    //: %1 is a length
    return {height < 0.0 ? FFF_TEXT_OF_MANY("Checks", "%n sections moved down by %1")
                         //: %1 is a length
                         : FFF_TEXT_OF_MANY("Checks", "%n sections moved up by %1"),
            {lengthOf(std::abs(height))},
            count};
}

constexpr Text kListed{nullptr, "%1, %2"};

Message listed(std::vector<Message> parts)
{
    Message all;
    for (Message &part : parts)
        all = all.isEmpty() ? std::move(part) : Message{kListed, {std::move(all), std::move(part)}};
    return all;
}

} // namespace

Message changesBetween(const Analysis &before, const Analysis &after,
                       std::span<const Finding> foundBefore, std::span<const Finding> foundAfter)
{
    const Difference difference = differenceOf(before, after);
    std::vector<Message> parts;
    const auto addCounted = [&parts](int count, Message one, Message many) {
        if (count > 0)
            parts.push_back(count == 1 ? std::move(one) : std::move(many));
    };
    const auto add = [&addCounted](int count, Message one, const Text &many) {
        addCounted(count, std::move(one), {many, {}, count});
    };
    const auto addSections = [&add](const Counted &counted, const Text &one, const Text &many) {
        add(counted.count, {one, {counted.one}}, many);
    };
    add(difference.turned, {FFF_TEXT("Checks", "1 joint flipped"), {}},
        FFF_TEXT_OF_MANY("Checks", "%n joints flipped"));
    if (const Stock *stock = thickened(before, after))
        //: %1 is the name of a stock, %2 a length
        parts.push_back({FFF_TEXT("Checks", "%1 becomes %2 thick"),
                         {Named{stock->name}, lengthOf(stock->thickness)}});
    add(difference.shifted, {FFF_TEXT("Checks", "The slits of 1 joint meet elsewhere"), {}},
        FFF_TEXT_OF_MANY("Checks", "The slits of %n joints meet elsewhere"));
    addCounted(difference.moved.count,
               //: %1 is the name of a section, %2 a length
               {FFF_TEXT("Checks", "%1 moved by %2"),
                {difference.moved.one, lengthOf(difference.way.norm())}},
               wordsOfMoved(difference));
    add(difference.swung.count,
        //: %1 is the name of a section, %2 an angle
        {FFF_TEXT("Checks", "%1 turned by %2"),
         {difference.swung.one, nearestAngleOf(difference.angle)}},
        FFF_TEXT_OF_MANY("Checks", "%n sections turned"));
    const double slit = difference.joined == 1 ? longestSlit(after.model, *difference.one) : 0.0;
    if (slit > 0.0)
        //: %1 is a length
        parts.push_back({FFF_TEXT("Checks", "a new joint with a slit of %1"), {lengthOf(slit)}});
    else
        add(difference.joined, {FFF_TEXT("Checks", "1 new joint"), {}},
            FFF_TEXT_OF_MANY("Checks", "%n new joints"));
    //: %1 is the name of a section
    addSections(difference.reshaped, FFF_TEXT("Checks", "%1 reshaped"),
                FFF_TEXT_OF_MANY("Checks", "%n sections reshaped"));
    //: %1 is the name of a section
    addSections(difference.made, FFF_TEXT("Checks", "%1 added"),
                FFF_TEXT_OF_MANY("Checks", "%n sections added"));
    //: %1 is the name of a section
    addSections(difference.gone, FFF_TEXT("Checks", "%1 deleted"),
                FFF_TEXT_OF_MANY("Checks", "%n sections deleted"));
    if (difference.turned > 0 && difference.morePieces == 0)
        parts.push_back({FFF_TEXT("Checks", "nothing more is cut through"), {}});
    const Outcome outcome = outcomeOf(foundBefore, foundAfter);
    add(outcome.solved, {FFF_TEXT("Checks", "1 problem solved"), {}},
        FFF_TEXT_OF_MANY("Checks", "%n problems solved"));
    const Finding *was = heldIn(foundBefore), *is = heldIn(foundAfter);
    if (was && is && !was->is(*is->kind))
        //: after other things that change; %1 is a verdict such as "Holds 350 g"
        parts.push_back({FFF_TEXT("Checks", "then: %1"), {titleOf(*is)}});
    if (!outcome.added.empty())
        //: after other things that change; %1 is a verdict such as "Too little material"
        add(static_cast<int>(outcome.added.size()),
            {FFF_TEXT("Checks", "new: %1"), {titleOf(*outcome.added.front())}},
            FFF_TEXT_OF_MANY("Checks", "%n new remarks"));
    return listed(std::move(parts));
}

} // namespace fff
