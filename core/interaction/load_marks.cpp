#include "core/interaction/load_marks.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

constexpr double kReach = 12.0; // px
const Vec2 kAbove(0.0, -22.0);  // px

/// An arrow of kUsualForce is kUsualLength long, one of ten times that kPerDecade more.
constexpr double kUsualForce = 5.0, kUsualLength = 60.0, kPerDecade = 60.0; // N, px
constexpr double kShortest = 24.0, kLongest = 200.0;                        // px

const Section &sectionOf(const PlacedLoad &placed, const Model &model)
{
    return *model.section(static_cast<std::size_t>(placed.section));
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
    const auto look = [&](const Vec3 &at, const LoadAt &load) {
        const double away = (context.camera.toScreen(at, context.viewport) - position).norm();
        if (away <= reach) {
            reach = away;
            nearest = load;
        }
    };
    for (const PlacedLoad &placed : placedLoads(context.model)) {
        const Section &section = sectionOf(placed, context.model);
        if (context.view.isHidden(section.ref()))
            continue;
        const Load &load = context.model.document.loads[static_cast<std::size_t>(placed.load)];
        const Vec3 foot = section.frame.toWorld(placed.position);
        look(foot, {load.id, section.ref(), placed.position, placed.push, false});
        if (load.isPush())
            look(tipOf(placed, foot, context),
                 {load.id, section.ref(), placed.position, placed.push, true});
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
    // Above what stands there, which is about twice as high as its centre of mass.
    const Vec3 at = sectionOf(placed, model).frame.toWorld(placed.position) +
                    2.0 * load.height * Vec3::UnitY();
    const Quantity amount = load.isPush() ? forceOf(placed.push.norm()) : massOf(load.mass);
    const Message words = load.name.empty()
                              ? Message{Text{nullptr, "%1"}, {amount}}
                              : Message{Text{nullptr, "%1, %2"}, {Named{load.name}, amount}};
    signs.add(sign::Label{role, {at}, words, kAbove});
}

} // namespace fff
