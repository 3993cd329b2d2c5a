#include "core/analysis/suggesting/suggested_group.h"

#include "core/analysis/findings/standing.h"
#include "core/assembly/intervals.h"
#include "core/base/tolerances.h"
#include "core/geometry/segment_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

// Times the thickness.
constexpr double kLeastHold = 3.0;     // of an overlap: half of it is a slit
constexpr double kBetweenSlits = 1.7;  // from the middle of one to that of the next
constexpr double kBetweenPlanes = 1.7; // the same of sections side by side
constexpr double kFootLook = 0.15;  // above the ground, where what is off by kCutError has its feet
constexpr double kBesideSlit = 0.6; // from its wall to the edge, or what stays there is weak
/// What a slit holds by: so far from its walls there is material, over so much of its depth.
constexpr double kGripBeside = 0.05, kGripDepth = 0.55;
/// Slits and what is not looked at closely take something of how far it may be tilted.
constexpr double kSpareTilt = 1.02;
/// Radians (40°): slits of sections at less get wide.
constexpr double kLeastAngle = 0.6981317007977318;
/// Sine: ways that differ by less are one.
constexpr double kSameWay = 0.01;

Box3 boxOf(const SuggestedCut &cut, double margin)
{
    Box3 box;
    for (const Vec2 &p : cut.region.outer)
        box.extend(cut.frame.toWorld(p));
    box.min.array() -= margin;
    box.max.array() += margin;
    return box;
}

/// Of two segments in one plane.
double distanceBetweenSegments(const Vec2 &a, const Vec2 &b, const Vec2 &c, const Vec2 &d)
{
    const bool areCrossing = cross(b - a, c - a) * cross(b - a, d - a) < 0.0 &&
                             cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
    if (areCrossing)
        return 0.0;
    return std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d),
                     distanceToSegment(c, a, b), distanceToSegment(d, a, b)});
}

/// Whether there is material enough along both sides of a slit: but for its ends, where the edge
/// may come in at a slant.
bool isFramed(const PlaneLine &line, double from, double to, const Region &region, double half,
              double beside)
{
    const double reach = half + beside;
    constexpr double kSlant = 3.0;   // along the slit for each mm across
    constexpr double kAtLeast = 0.6; // of a short one
    const double length = to - from;
    const double needed = std::max(kAtLeast * length, length - 2.0 * kSlant * reach);
    for (const double side : {-reach, reach}) {
        const PlaneLine along{line.point + side * perpendicular(line.direction), line.direction};
        double inside = 0.0;
        for (const Interval &interval : intervalsOn(along, region))
            inside +=
                std::max(0.0, std::min(to, interval.to.at) - std::max(from, interval.from.at));
        if (inside < needed)
            return false;
    }
    return true;
}

/// Of a stretch of a slit, how much has material on both of its sides.
double walled(const PlaneLine &line, double from, double to, const Region &region, double reach)
{
    const auto beside = [&](double side) {
        return intervalsOn({line.point + side * perpendicular(line.direction), line.direction},
                           region);
    };
    double length = 0.0;
    const std::vector<Interval> left = beside(reach), right = beside(-reach);
    for (const Interval &a : left)
        for (const Interval &b : right)
            length += std::max(0.0, std::min({to, a.to.at, b.to.at}) -
                                        std::max({from, a.from.at, b.from.at}));
    return length;
}

/// Of an overlap one half is the one section's slit and one the other's: whether that is good for
/// both, one way round or the other. isGood(line, from, to, region)
template <class IsGood>
bool areHalvesGood(const PlaneLine &inOne, const Region &one, const PlaneLine &inOther,
                   const Region &other, double from, double to, IsGood isGood)
{
    const double middle = 0.5 * (from + to);
    return (isGood(inOne, from, middle, one) && isGood(inOther, middle, to, other)) ||
           (isGood(inOne, middle, to, one) && isGood(inOther, from, middle, other));
}

/// Where the ground carries a section, (x, z), once all below it is cut off and its feet are there.
void addFeet(const SuggestedCut &cut, const SuggestedGround &ground, double thickness,
             std::vector<Vec2> &corners)
{
    if (cut.frame.directionToLocal(Vec3::UnitY()).norm() < kUprightSine)
        return;
    const Vec3 normal = cut.frame.normal();
    const Vec2 across = 0.5 * thickness * Vec2(normal.x(), normal.z());
    const auto add = [&](const Vec2 &end) {
        const Vec3 p = cut.frame.toWorld(end);
        corners.emplace_back(p.x() + across.x(), p.z() + across.y());
        corners.emplace_back(p.x() - across.x(), p.z() - across.y());
    };
    const LevelLine low = levelLine(cut.frame, ground.level + kFootLook * thickness);
    const PlaneLine line{low.point, low.direction};
    for (const Interval &interval : intervalsOn(line, cut.region)) {
        add(line.at(interval.from.at));
        add(line.at(interval.to.at));
    }
    for (const SuggestedFoot &foot : feetOn(ground, cut.frame, cut.region)) {
        add(foot.from);
        add(foot.to);
    }
}

} // namespace

bool SuggestedGroup::liesAlong(const SuggestedCut &cut, const SuggestedCut &other) const
{
    const double room = kBetweenPlanes * m_thickness;
    Box2 box = bounds(other.region.outer);
    box.min.array() -= room;
    box.max.array() += room;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2 &p : cut.region.outer) {
        const Vec3 world = cut.frame.toWorld(p);
        if (!box.contains(other.frame.toLocal(world)))
            continue;
        low = std::min(low, other.frame.height(world));
        high = std::max(high, other.frame.height(world));
    }
    return low < room && high > -room;
}

bool SuggestedGroup::crossOne(const SuggestedCut &cut, const Box3 &box, std::size_t member,
                              Crossings &found) const
{
    const SuggestedCut &other = *m_members[member].cut;
    if (!box.intersects(m_members[member].box))
        return true;
    const std::optional<Axis> axis = intersectionAxis(other.frame, cut.frame);
    if (!axis)
        return !liesAlong(cut, other);
    const PlaneLine inOther = lineInFrame(*axis, other.frame);
    const std::vector<Interval> theirs = intervalsOn(inOther, other.region);
    const PlaneLine inCut = lineInFrame(*axis, cut.frame);
    const std::vector<Interval> ours = intervalsOn(inCut, cut.region);
    const double sine = other.frame.normal().cross(cut.frame.normal()).norm();
    const double half = 0.5 * m_thickness / sine, beside = kBesideSlit * m_thickness;
    for (const Interval &a : theirs)
        for (const Interval &b : ours) {
            const double from = std::max(a.from.at, b.from.at), to = std::min(a.to.at, b.to.at);
            if (to <= from)
                continue;
            if (to - from < kLeastHold * m_thickness || sine < std::sin(kLeastAngle))
                return false;
            const auto areGood = [&](auto isGood) {
                return areHalvesGood(inOther, other.region, inCut, cut.region, from, to, isGood);
            };
            const auto isStrong = [&](const PlaneLine &line, double start, double end,
                                      const Region &region) {
                return isFramed(line, start, end, region, half, beside);
            };
            const auto isHeld = [&](const PlaneLine &line, double start, double end,
                                    const Region &region) {
                return walled(line, start, end, region, half + kGripBeside * m_thickness) >=
                       kGripDepth * m_thickness;
            };
            if (!areGood(isStrong)) {
                if (!areGood(isHeld))
                    return false;
                found.isWeak = true;
            }
            found.all.push_back({member, {axis->at(from), axis->at(to)}, axis->direction});
        }
    return true;
}

std::optional<SuggestedGroup::Crossings> SuggestedGroup::crossed(const SuggestedCut &cut) const
{
    Crossings crossings;
    const Box3 box = boxOf(cut, m_thickness);
    for (std::size_t i = 0; i < m_members.size(); ++i)
        if (!crossOne(cut, box, i, crossings))
            return {};
    const std::vector<Crossed> &found = crossings.all;
    const double room = kBetweenSlits * m_thickness;
    const auto areNear = [room](const Frame &frame, const Segment &a, const Segment &b) {
        return distanceBetweenSegments(frame.toLocal(a.from), frame.toLocal(a.to),
                                       frame.toLocal(b.from), frame.toLocal(b.to)) < room;
    };
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Member &member = m_members[found[i].member];
        for (const Segment &slit : member.slits)
            if (areNear(member.cut->frame, slit, found[i].segment))
                return {};
        for (std::size_t k = 0; k < i; ++k)
            if (found[i].direction.cross(found[k].direction).norm() > kSameWay ||
                areNear(cut.frame, found[i].segment, found[k].segment))
                return {};
    }
    return crossings;
}

SuggestedGroup::Fit SuggestedGroup::fitOf(const SuggestedCut &cut) const
{
    const std::optional<Crossings> found = crossed(cut);
    if (!found)
        return Fit::InTheWay;
    if (found->all.empty())
        return Fit::Loose;
    return found->isWeak ? Fit::Weak : Fit::Fits;
}

void SuggestedGroup::add(const SuggestedCut &cut)
{
    Member member{&cut, boxOf(cut, m_thickness), {}};
    for (const Crossed &one : crossed(cut).value_or(Crossings()).all) {
        m_members[one.member].slits.push_back(one.segment);
        member.slits.push_back(one.segment);
    }
    m_members.push_back(std::move(member));
}

Vec3 SuggestedGroup::centreOfMass() const
{
    double area = 0.0;
    Vec3 centre = Vec3::Zero();
    for (const Member &member : m_members) {
        area += member.cut->area;
        centre += member.cut->area * member.cut->centre;
    }
    return area > 0.0 ? Vec3(centre / area) : centre;
}

SuggestedGround SuggestedGroup::groundAt(double level, double filled) const
{
    const Vec3 centre = centreOfMass();
    // Feet of two sections across each other reach to the corners of a square.
    constexpr double kToCorners = 2.0;
    const double around = kToCorners * std::tan(kSteadyTilt) * (centre.y() - level);
    return {level, filled, {centre.x(), centre.z()}, std::max(0.0, around)};
}

Stability SuggestedGroup::stability(const SuggestedGround &ground) const
{
    GroundContact contact;
    Box3 box;
    for (const Member &member : m_members) {
        addFeet(*member.cut, ground, m_thickness, contact.corners);
        box.extend(member.box);
    }
    contact.stretches = static_cast<int>(contact.corners.size() / 4);
    return fff::stability(contact, centreOfMass() - ground.level * Vec3::UnitY(), m_thickness,
                          box.size().maxCoeff());
}

SuggestedGroup SuggestedGroup::with(const SuggestedCut &cut) const
{
    SuggestedGroup both(*this);
    both.m_members.push_back({&cut, boxOf(cut, m_thickness), {}});
    return both;
}

SuggestedGroup::Stood SuggestedGroup::stoodWith(const SuggestedCut &cut, double level,
                                                double filled) const
{
    const SuggestedGroup both = with(cut);
    const SuggestedGround ground = both.groundAt(level, filled);
    return {both.stability(ground), ground};
}

bool SuggestedGroup::isSteadyWith(const SuggestedCut &cut, const SuggestedGround &ground) const
{
    const Stability stability = with(cut).stability(ground);
    return stability.standing == Standing::Stands && stability.tipAngle > kSpareTilt * kSteadyTilt;
}

} // namespace fff
