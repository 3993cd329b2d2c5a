#include "core/assembly/fingers.h"

#include "core/assembly/edge_room.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// In thicknesses of the thicker one: how wide a finger is by itself, and at least.
constexpr double kShareOfFinger = 3.0, kLeastFinger = 1.0;
constexpr int kFewestFingers = 3; // of fewer none is held from both sides

/// One of the two, along the axis in its plane.
struct CornerSide
{
    const Shape &shape;
    PlaneLine line;
    double half = 0.0; // of the thickness, mm
    double far = 0.0;  // mm: beyond the axis there is no material after that
    int side = 0;      // on which its material lies, ±1
    FingerCut cuts = {};

    /// Where fingers begin, mm from the axis: there is material all along.
    double root() const { return cuts.back + kEdgeReach + kOvershoot; }
    PlaneLine at(double across) const { return shifted(line, side * across); }
    std::vector<Stretch> inside(double across) const { return stretchesIn(at(across), shape); }
};

/// On which side of the axis there is material that far from it; 0: on both, or on none.
int sideWithMaterial(CornerSide plate)
{
    plate.side = 1;
    const bool isLeft = !plate.inside(plate.far).empty();
    const bool isRight = !plate.inside(-plate.far).empty();
    return isLeft == isRight ? 0 : isLeft ? 1 : -1;
}

/// Where a section has material to hold fingers. Its boundary beside the edge, carried on to where
/// they end, is not crossed: beyond it others have theirs.
std::vector<Stretch> roomOf(const CornerSide &plate)
{
    const double root = plate.root();
    const std::vector<Stretch> deeper = plate.inside(2.0 * root + plate.cuts.beyond);
    std::vector<Stretch> room;
    for (const Stretch &span : plate.inside(root)) {
        double low = span.from, high = span.to;
        for (const Stretch &next : deeper) {
            if (next.from >= span.to || next.to <= span.from)
                continue;
            low = std::max(low, 2.0 * span.from - next.from);
            high = std::min(high, 2.0 * span.to - next.to);
        }
        if (low < high)
            room.push_back({low, high});
    }
    return room;
}

int fingersOn(const Stretch &room, double thickness)
{
    const double length = room.to - room.from;
    const int pairs = static_cast<int>(std::lround(0.5 * length / (kShareOfFinger * thickness)));
    const int count = std::max(kFewestFingers, 2 * pairs - 1);
    return length / count < kLeastFinger * thickness ? 0 : count;
}

Slit fingerOf(const CornerSide &plate, double from, double to, int overlap)
{
    Slit slit;
    slit.inner = plate.at(plate.root()).at(0.5 * (from + to));
    slit.mouth = plate.at(-plate.cuts.beyond).at(0.5 * (from + to));
    slit.width = to - from;
    slit.isOpen = false;
    slit.role = SlitRole::Tab;
    slit.overlap = overlap;
    return slit;
}

/// All of the section along the edge, as long as the other one is there, from where it is cut back.
Slit shoulderOf(const CornerSide &plate, const Stretch &edge, int overlap)
{
    Slit slit;
    slit.width = plate.cuts.back + plate.far;
    const PlaneLine middle = plate.at(plate.cuts.back - 0.5 * slit.width);
    slit.inner = middle.at(edge.from);
    slit.mouth = middle.at(edge.to);
    slit.isOpen = false;
    slit.role = SlitRole::Shoulder;
    slit.overlap = overlap;
    return slit;
}

/// They take turns; a begins. Of the play that a finger has, each of the two gives half.
void addFingers(const CornerSide &a, const CornerSide &b, const Stretch &room, int count,
                double play, int overlap, JointSlits &slits)
{
    const double share = (room.to - room.from) / count;
    // None at the ends, where a step would be a crumb.
    const auto between = [&](int k, double offset) {
        return room.from + k * share + (k == 0 || k == count ? 0.0 : offset);
    };
    for (int k = 0; k < count; ++k)
        (k % 2 == 0 ? slits.a : slits.b)
            .push_back(fingerOf(k % 2 == 0 ? a : b, between(k, 0.25 * play),
                                between(k + 1, -0.25 * play), overlap));
    for (const Stretch &edge : common(a.inside(a.root()), b.inside(b.root()))) {
        if (edge.to <= room.from || edge.from >= room.to)
            continue;
        slits.a.push_back(shoulderOf(a, edge, overlap));
        slits.b.push_back(shoulderOf(b, edge, overlap));
    }
}

} // namespace

FingerCut fingerCut(double half, double otherHalf, double cosine)
{
    const double sine = std::sqrt(1.0 - cosine * cosine);
    FingerCut cut;
    // Of the two edges of its own end, the one that is nearer to the other's outer face.
    const auto end = [&](double own, double others) {
        return (others - own * std::abs(cosine)) / sine;
    };
    cut.beyond = end(half, otherHalf);
    // Of a finger of the other, either its face or the inner corner of its end comes furthest.
    const bool isFace = cosine >= 0.0 || otherHalf * -cosine > half;
    cut.back = isFace ? (otherHalf + half * std::abs(cosine)) / sine
                      : end(otherHalf, half) * -cosine + otherHalf * sine;
    return cut;
}

tl::expected<TabJoint, NoTabs> cutFingers(const JointSide &a, const JointSide &b)
{
    const std::optional<Axis> axis = intersectionAxis(a.section.frame, b.section.frame);
    const Vec3 na = a.section.frame.normal(), nb = b.section.frame.normal();
    const double angle = std::atan2(na.cross(nb).norm(), std::abs(na.dot(nb)));
    if (!axis || angle < kMinTabAngle - kTabAngleRounding)
        return tl::unexpected(NoTabs::TooOblique);
    CornerSide one{*a.section.shape, lineInFrame(*axis, a.section.frame), 0.5 * a.stock.thickness};
    CornerSide other{*b.section.shape, lineInFrame(*axis, b.section.frame),
                     0.5 * b.stock.thickness};
    // Half of the strip that the other's slab takes up, on both sides of the axis.
    const auto far = [&](const CornerSide &own, const CornerSide &others) {
        return (others.half + own.half * std::cos(angle)) / std::sin(angle) + kEdgeReach;
    };
    one.far = far(one, other);
    other.far = far(other, one);
    one.side = sideWithMaterial(one);
    other.side = sideWithMaterial(other);
    if (one.side == 0 || other.side == 0)
        return tl::unexpected(NoTabs::EndsNowhere);
    const auto away = [](const CornerSide &plate, const Frame &frame) {
        return Vec3(frame.directionToWorld(plate.side * perpendicular(plate.line.direction)));
    };
    const double cosine = away(one, a.section.frame).dot(away(other, b.section.frame));
    one.cuts = fingerCut(one.half, other.half, cosine);
    other.cuts = fingerCut(other.half, one.half, cosine);

    const std::vector<Stretch> rooms = common(roomOf(one), roomOf(other));
    if (rooms.empty())
        return tl::unexpected(NoTabs::EndsNowhere);
    TabJoint joint;
    joint.crossing.axis = *axis;
    joint.crossing.angle = angle;
    joint.slits.kind = JointKind::Tabs;
    const double thickness = 2.0 * std::max(one.half, other.half);
    const double play = std::max({0.0, a.stock.clearance, b.stock.clearance});
    for (const Stretch &room : rooms) {
        const int count = fingersOn(room, thickness);
        if (count == 0)
            continue;
        addFingers(one, other, room, count, play, static_cast<int>(joint.crossing.overlaps.size()),
                   joint.slits);
        const Interval interval{{room.from, 0, 0}, {room.to, 0, 0}};
        joint.crossing.overlaps.push_back(
            {room.from, room.to, 0.5 * (room.from + room.to), interval, interval});
    }
    if (joint.crossing.overlaps.empty())
        return tl::unexpected(NoTabs::NoRoom);
    return joint;
}

bool areFingers(std::span<const Slit> slits)
{
    // Of tabs in a slot, one section has slots alone and the other its tabs; here each has both.
    return !slits.empty() && std::all_of(slits.begin(), slits.end(), [](const Slit &slit) {
        return slit.role != SlitRole::Slit;
    });
}

} // namespace fff
