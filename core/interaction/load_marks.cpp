#include "core/interaction/load_marks.h"

#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kReach = 12.0;    // px
const Vec2 kAbove(0.0, -22.0);     // px
const Vec2 kHalfLabel(28.0, 10.0); // px: of its words at least so much can be taken hold of

/// An arrow of kUsualForce is kUsualLength long, one of ten times that kPerDecade more.
constexpr double kUsualForce = 5.0, kUsualLength = 60.0, kPerDecade = 60.0; // N, px
constexpr double kShortest = 24.0, kLongest = 200.0;                        // px

const Section &sectionOf(const PlacedLoad &placed, const Model &model)
{
    return *model.section(static_cast<std::size_t>(placed.section));
}

/// Of what stands there, world, mm: it is about twice as high as its centre of mass.
Vec3 topOf(const Load &load, const Vec3 &foot)
{
    return foot + 2.0 * load.height * Vec3::UnitY();
}

/// The tip of its arrow, world, mm.
Vec3 tipOf(const PlacedLoad &placed, const Vec3 &foot, const GestureContext &context)
{
    const Vec3 push = pushInWorld(placed.push, sectionOf(placed, context.model).frame);
    const double length = arrowLength(push.norm()) * context.camera.scaleAt(foot, context.viewport);
    return foot + length * push.normalized();
}

} // namespace

double arrowLength(double force)
{
    return std::clamp(kUsualLength + kPerDecade * std::log10(force / kUsualForce), kShortest,
                      kLongest);
}

double forceOfArrow(double length)
{
    const double px = std::clamp(length, kShortest, kLongest);
    const double force = kUsualForce * std::pow(10.0, (px - kUsualLength) / kPerDecade);
    // Two digits: nobody pulls an arrow to a hundredth.
    const double unit = std::pow(10.0, std::floor(std::log10(force)) - 1.0);
    return std::round(force / unit) * unit;
}

Vec3 pushInWorld(const Vec3 &push, const Frame &frame)
{
    return push.x() * frame.x + push.y() * frame.y + push.z() * frame.normal();
}

Vec3 pushInFrame(const Vec3 &push, const Frame &frame)
{
    return {frame.x.dot(push), frame.y.dot(push), frame.normal().dot(push)};
}

std::optional<LoadAt> loadAt(const Vec2 &position, const GestureContext &context)
{
    std::optional<LoadAt> nearest;
    double reach = kReach;
    const auto onScreen = [&](const Vec3 &at) {
        return context.camera.toScreen(at, context.viewport);
    };
    const auto look = [&](double away, const Vec3 &held, LoadAt load) {
        if (away > reach)
            return;
        reach = away;
        load.grip = onScreen(held) - position;
        nearest = load;
    };
    for (const PlacedLoad &placed : placedLoads(context.model)) {
        const Section &section = sectionOf(placed, context.model);
        if (context.view.isHidden(section.ref()))
            continue;
        const Load &load = context.model.document.loads[static_cast<std::size_t>(placed.load)];
        const Vec3 foot = section.frame.toWorld(placed.position);
        const LoadAt at{load.id, section.ref(), placed.position, placed.push};
        const Vec2 low = onScreen(foot), high = onScreen(topOf(load, foot));
        look(distanceToSegment(position, low, high), foot, at);
        // Marks come before words.
        if (((position - high - kAbove).cwiseAbs().array() <= kHalfLabel.array()).all())
            look(kReach, foot, at);
        if (load.isPush()) {
            LoadAt tip = at;
            tip.isTip = true;
            const Vec3 end = tipOf(placed, foot, context);
            look((onScreen(end) - position).norm(), end, tip);
        }
    }
    return nearest;
}

void addLoadMark(const Load &load, const PlacedLoad &placed, const Model &model, SignRole role,
                 Signs &signs)
{
    const Frame &frame = sectionOf(placed, model).frame;
    const Vec3 at = frame.toWorld(placed.position);
    signs.add(sign::Handle{role, at});
    const double force = placed.push.norm();
    if (load.isPush())
        signs.add(
            sign::Arrow{role, at, pushInWorld(placed.push, frame) / force, arrowLength(force)});
}

void addLoadWords(const Load &load, const PlacedLoad &placed, const Model &model, SignRole role,
                  Signs &signs)
{
    const Vec3 at = topOf(load, sectionOf(placed, model).frame.toWorld(placed.position));
    const Quantity amount = load.isPush() ? forceOf(placed.push.norm()) : massOf(load.mass);
    const Message words = load.name.empty()
                              ? Message{Text{nullptr, "%1"}, {amount}}
                              : Message{Text{nullptr, "%1, %2"}, {Named{load.name}, amount}};
    signs.add(sign::Label{role, {at}, words, kAbove});
}

} // namespace fff
