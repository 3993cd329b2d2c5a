#include "core/assembly/slits.h"

#include "core/assembly/lobes.h"
#include "core/assembly/upwards.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

// A slit's rectangle reaches this far beyond the contour, so that no skin of rounding closes its
// mouth.
constexpr double kMouthOvershoot = 0.05; // mm

/// What one way of sliding makes of one overlap. `sign` +1: a opens along the axis' direction and b
/// against it. An end on a hole opens to nothing; then the other section's slit must take the whole
/// overlap, and the one with the hole stays uncut there.
struct Cut
{
    bool cutsA = true, cutsB = true;
    double meet = 0.0;   // mm along the axis
    double excess = 0.0; // mm cut beyond the overlap

    bool isGrip() const { return cutsA && cutsB; }
    bool isOpen() const { return cutsA || cutsB; }
};

Cut cutOf(const Overlap &o, int sign)
{
    const AxisEnd &endA = sign > 0 ? o.a.to : o.a.from;
    const AxisEnd &endB = sign > 0 ? o.b.from : o.b.to;
    Cut cut{!endA.isOnHole(), !endB.isOnHole(), o.meet, 0.0};
    if (!cut.cutsA)
        cut.meet = sign > 0 ? o.to : o.from;
    else if (!cut.cutsB)
        cut.meet = sign > 0 ? o.from : o.to;
    const double beyondA = sign > 0 ? endA.at - o.to : o.from - endA.at;
    const double beyondB = sign > 0 ? o.from - endB.at : endB.at - o.to;
    cut.excess = (cut.cutsA ? beyondA : 0.0) + (cut.cutsB ? beyondB : 0.0);
    return cut;
}

/// One of the two ways to slide: all overlaps of a joint go the same way.
struct Way
{
    int sign = 1;
    bool isOpen = true;  // every overlap has a slit that ends outside, and one of them has two
    double excess = 0.0; // mm
};

Way wayOf(const Crossing &crossing, int sign)
{
    Way way;
    way.sign = sign;
    bool hasGrip = false;
    for (const Overlap &o : crossing.overlaps) {
        const Cut cut = cutOf(o, sign);
        way.isOpen &= cut.isOpen();
        hasGrip |= cut.isGrip();
        way.excess += cut.excess;
    }
    way.isOpen &= hasGrip;
    return way;
}

struct Host
{
    const Section &section;
    const Stock &stock;
    PlaneLine line;
    double trace = 0.0; // mm: what the other's slab takes up, the width without a clearance
    double width = 0.0; // mm

    /// What of the strip must be free. What only touches the other's faces needs no slit.
    double needed() const { return 0.5 * trace - kTouchingDepth; }
};

/// The lead-in of a wall, given where it leaves the section. No longer than half of the wall.
LeadIn leadInOf(const WallEnd &wall, double chamfer, double meet)
{
    const double length = std::min(chamfer, 0.5 * (wall.at - meet));
    LeadIn leadIn;
    if (!wall.isThere || !(length > kClipSlack))
        return leadIn;
    leadIn.from = wall.at - length - meet;
    const Vec2 end(wall.chamferEnd.x() - meet, wall.chamferEnd.y());
    const Vec2 way = (end - Vec2(leadIn.from, 0.0)).normalized();
    leadIn.to = end + kMouthOvershoot * way;
    leadIn.top = std::max(wall.reach - meet, leadIn.to.x()) + kMouthOvershoot;
    return leadIn;
}

/// What of the slit is no rectangle, or null. held: mm along the line towards `sign`, as far as the
/// guest reaches.
std::shared_ptr<const SlitForm> openForm(const Host &host, const AxisEnd &end, double meet,
                                         double held, int sign)
{
    if (!hasForm(host.stock))
        return nullptr;
    SlitForm form = formOf(host.stock, host.width);
    const double start = sign * meet;
    form.held = sign * held - start;
    if (host.stock.leadIn > 0.0 || form.bumps > 0.0) {
        const Region &region = host.section.shape->region();
        const auto walls = [&](double chamfer) {
            return wallEnds(host.line, region, end, 0.5 * host.width, start, sign, chamfer);
        };
        double chamfer = host.stock.leadIn;
        for (const WallEnd &wall : walls(chamfer)) {
            if (!wall.isThere)
                continue;
            form.held = std::min(form.held, wall.at - start);
            chamfer = std::min(chamfer, 0.5 * (wall.at - start));
        }
        // Seen out of the slit, left is right where it opens against the line.
        const std::array<WallEnd, 2> ends = walls(chamfer);
        for (const std::size_t side : {0, 1})
            form.leadIns[sign > 0 ? side : 1 - side] = leadInOf(ends[side], chamfer, start);
    }
    return std::make_shared<const SlitForm>(form);
}

// Slits lie on a grid in their host: those that are equal but for rounding, as in the ribs of a
// row, are equal bit for bit then, and cut once. Steps of a mm.
constexpr double kSlitSteps = 1e10;

Vec2 onGrid(const Vec2 &p)
{
    return (kSlitSteps * p).array().round() / kSlitSteps;
}

/// So that the angle's rounding makes no other width.
double withoutRounding(double width)
{
    constexpr double kWidthSteps = 1e12; // of a mm
    return std::round(kWidthSteps * width) / kWidthSteps;
}

Slit slitFrom(const Host &host, double inner, double end, int sign, int overlap)
{
    Slit slit;
    slit.inner = onGrid(host.line.at(inner));
    slit.mouth = onGrid(host.line.at(end + sign * kMouthOvershoot));
    slit.width = host.width;
    slit.overlap = overlap;
    return slit;
}

/// The open slit of one section for one overlap: from the meeting point to its end towards `sign`.
Slit openSlit(const Host &host, const Interval &interval, const Overlap &shared, double meet,
              int sign, int overlap)
{
    const AxisEnd &end = sign > 0 ? interval.to : interval.from;
    const double reach =
        mouthReach(host.line, host.section.shape->region(), end, host.needed(), sign * meet, sign);
    Slit slit = slitFrom(host, meet, sign * reach, sign, overlap);
    slit.form = openForm(host, end, meet, sign > 0 ? shared.to : shared.from, sign);
    return slit;
}

/// Whether the guest, slid square through the host, fits through the slot between `from` and `to`:
/// on one side of the line all of it lies within the slot.
bool fitsThrough(const Region &guest, const PlaneLine &line, double from, double to)
{
    bool fits[2] = {true, true};
    for (const Vec2 &p : guest.outer) {
        const double s = line.along(p);
        if (s < from - kEqualEnds || s > to + kEqualEnds)
            fits[line.across(p) > 0.0] = false;
    }
    return fits[0] || fits[1];
}

/// A closed slit in `host` for a guest that ends inside of it both ways, or nothing when it does
/// not fit. The slot holds the guest's whole width within the host's thickness, also where its
/// contour is oblique.
bool cutMortise(const Crossing &crossing, const Host &host, const Host &guest, bool hostIsA,
                std::vector<Slit> &slits)
{
    if (crossing.overlaps.size() != 1)
        return false;
    const Overlap &o = crossing.overlaps.front();
    const Interval &inHost = hostIsA ? o.a : o.b;
    const Interval &inGuest = hostIsA ? o.b : o.a;
    const Region &guestRegion = guest.section.shape->region();
    const double halfTrace =
        0.5 * guest.width; // what the host's slab takes up in the guest's plane
    const double from =
        -mouthReach(guest.line, guestRegion, inGuest.from, halfTrace, -inGuest.to.at, -1);
    const double to =
        mouthReach(guest.line, guestRegion, inGuest.to, halfTrace, inGuest.from.at, 1);
    if (from <= inHost.from.at || to >= inHost.to.at ||
        !fitsThrough(guestRegion, guest.line, from, to))
        return false;
    Slit slit;
    slit.inner = host.line.at(from);
    slit.mouth = host.line.at(to);
    slit.width = host.width;
    slit.isOpen = false;
    if (hasForm(host.stock)) {
        SlitForm form = formOf(host.stock, host.width);
        form.held = to - from;
        slit.form = std::make_shared<const SlitForm>(form);
    }
    slits.push_back(slit);
    return true;
}

/// For what meets beside the axis: it holds nothing, so it has neither bumps nor a lead-in.
Slit besideSlit(const Host &host, double inner, double end, int sign)
{
    constexpr int kBeside = -1;
    Slit slit = slitFrom(host, inner, end, sign, kBeside);
    if (!hasForm(host.stock))
        return slit;
    SlitForm form = formOf(host.stock, host.width);
    form.bumps = 0.0;
    slit.form = std::make_shared<const SlitForm>(form);
    return slit;
}

/// The slits of a joint, slid together one way.
struct Laps
{
    std::vector<double> meets; // of the overlaps
    std::vector<Slit> a, b;
    double beside = 0.0; // mm that are cut for what meets beside the axis
};

/// What a row of slits leaves of its section in the strip that must be free.
std::vector<Stretch> leftBy(const std::vector<Slit> &slits, const Host &host)
{
    std::vector<Stretch> cuts;
    for (const Slit &slit : slits) {
        const double inner = host.line.along(slit.inner), mouth = host.line.along(slit.mouth);
        cuts.push_back({std::min(inner, mouth), std::max(inner, mouth)});
    }
    return leftOf(lobesIn(host.line, *host.section.shape, host.needed()), std::move(cuts));
}

/// The first two that are in each other.
std::optional<std::pair<Stretch, Stretch>> firstShared(const std::vector<Stretch> &inA,
                                                       const std::vector<Stretch> &inB)
{
    for (const Stretch &a : inA)
        for (const Stretch &b : inB)
            if (std::min(a.to, b.to) - std::max(a.from, b.from) >= kTouchingDepth)
                return std::pair(a, b);
    return {};
}

/// Slits for what still is in each other though the axis is cut: where contours are oblique, or run
/// along the axis without reaching it, they meet in the strips of both slabs alone. They take as
/// little as the way of sliding allows.
void cutBesides(const Host &a, const Host &b, int sign, Laps &laps)
{
    std::vector<Stretch> inA = leftBy(laps.a, a), inB = leftBy(laps.b, b);
    const auto cut = [&laps](const Host &host, double meet, double end, int way,
                             std::vector<Slit> &slits, std::vector<Stretch> &left) {
        if (meet == end)
            return;
        slits.push_back(besideSlit(host, meet, end, way));
        left = leftOf(left, {{std::min(meet, end), std::max(meet, end)}});
        laps.beside += std::abs(end - meet);
    };
    while (const auto shared = firstShared(inA, inB)) {
        const auto &[ofA, ofB] = *shared;
        const double from = std::max(ofA.from, ofB.from), to = std::min(ofA.to, ofB.to);
        // a is cut from where they meet to its end towards the sign, b from its other end on:
        // wherever that is, or one of them not at all.
        const double endA = sign > 0 ? ofA.to : ofA.from, endB = sign > 0 ? ofB.from : ofB.to;
        const double low = sign > 0 ? from : to, high = sign > 0 ? to : from;
        double meet = 0.5 * (from + to);
        const bool sparesA = high == endA, sparesB = low == endB;
        if (sparesA && (!sparesB || std::abs(high - endB) <= std::abs(endA - low)))
            meet = high;
        else if (sparesB)
            meet = low;
        cut(a, meet, endA, sign, laps.a, inA);
        cut(b, meet, endB, -sign, laps.b, inB);
    }
}

/// Whether nothing can meet beside the axis: nearly all pairs are so.
bool isPlain(const Crossing &crossing, const Host &a, const Host &b)
{
    return crossing.overlaps.size() == 1 && isOneLobe(a.line, *a.section.shape, a.needed()) &&
           isOneLobe(b.line, *b.section.shape, b.needed());
}

/// hasBesides: something may meet beside the axis (isPlain).
Laps lapsOf(const Crossing &crossing, const Host &a, const Host &b, int sign,
            const std::vector<double> &shares, bool hasBesides)
{
    Laps laps;
    for (std::size_t i = 0; i < crossing.overlaps.size(); ++i) {
        const Overlap &o = crossing.overlaps[i];
        Cut cut = cutOf(o, sign);
        if (cut.isGrip() && i < shares.size())
            cut.meet = sign > 0 ? o.to - shares[i] * (o.to - o.from)
                                : o.from + shares[i] * (o.to - o.from);
        const int index = static_cast<int>(i);
        laps.meets.push_back(cut.meet);
        if (cut.cutsA)
            laps.a.push_back(openSlit(a, o.a, o, cut.meet, sign, index));
        if (cut.cutsB)
            laps.b.push_back(openSlit(b, o.b, o, cut.meet, -sign, index));
    }
    if (hasBesides)
        cutBesides(a, b, sign, laps);
    return laps;
}

/// To which end of the axis a opens: what is wanted, else where less is cut beyond the overlaps,
/// with halves, so that a meeting point that moves turns nothing round.
int chosenSign(const Crossing &crossing, const Host &a, const Host &b, bool aIsLower, int wanted,
               bool hasBesides)
{
    const Way plus = wayOf(crossing, 1), minus = wayOf(crossing, -1);
    if (!plus.isOpen || !minus.isOpen)
        return plus.isOpen ? 1 : -1;
    if (wanted != 0)
        return wanted;
    double costs[] = {plus.excess, minus.excess};
    if (hasBesides) {
        costs[0] += lapsOf(crossing, a, b, 1, {}, true).beside;
        costs[1] += lapsOf(crossing, a, b, -1, {}, true).beside;
    }
    if (std::abs(costs[0] - costs[1]) > kEqualEnds)
        return costs[0] < costs[1] ? 1 : -1;
    return pointsUp(crossing.axis.direction) == aIsLower ? 1 : -1;
}

/// Without a clearance.
double widthAt(double hostThickness, double guestThickness, double sine, double cosine)
{
    return (guestThickness + hostThickness * std::abs(cosine)) / sine;
}

} // namespace

Result<double> slitWidth(double hostThickness, double guestThickness, double angle,
                         double clearance)
{
    if (angle < kMinJointAngle)
        return failure(ErrorCode::NearlyParallel);
    const double width =
        widthAt(hostThickness, guestThickness, std::sin(angle), std::cos(angle)) + clearance;
    if (!(width > 0.0))
        return failure(ErrorCode::BadValue, "clearance");
    return width;
}

JointSlits cutSlits(Crossing &crossing, const JointSide &a, const JointSide &b, bool aIsLower,
                    const JointWish &wish)
{
    JointSlits result;
    if (wish.kind == JointKind::None)
        return result;
    // As slitWidth(), with one sine and cosine for both.
    const double sine = std::sin(crossing.angle), cosine = std::cos(crossing.angle);
    const double traceA = widthAt(a.stock.thickness, b.stock.thickness, sine, cosine);
    const double traceB = widthAt(b.stock.thickness, a.stock.thickness, sine, cosine);
    const double widthA = withoutRounding(traceA + a.stock.clearance);
    const double widthB = withoutRounding(traceB + b.stock.clearance);
    if (crossing.angle < kMinJointAngle || !(widthA > 0.0 && widthB > 0.0) ||
        crossing.overlaps.empty())
        return result;
    const Host hostA{a.section, a.stock, lineInFrame(crossing.axis, a.section.frame), traceA,
                     widthA};
    const Host hostB{b.section, b.stock, lineInFrame(crossing.axis, b.section.frame), traceB,
                     widthB};
    const bool hasWay = wayOf(crossing, 1).isOpen || wayOf(crossing, -1).isOpen;
    if (!hasWay || wish.kind == JointKind::Mortise) {
        if (cutMortise(crossing, hostB, hostA, false, result.b) ||
            cutMortise(crossing, hostA, hostB, true, result.a))
            result.kind = JointKind::Mortise;
        if (!hasWay || result.kind == JointKind::Mortise)
            return result;
    }
    const bool hasBesides = !isPlain(crossing, hostA, hostB);
    const int sign = chosenSign(crossing, hostA, hostB, aIsLower, wish.sign, hasBesides);
    Laps laps = lapsOf(crossing, hostA, hostB, sign, wish.shares, hasBesides);
    result.kind =
        wayOf(crossing, sign).excess > kEqualEnds * static_cast<double>(crossing.overlaps.size())
            ? JointKind::ExtendedCrossLap
            : JointKind::CrossLap;
    for (std::size_t i = 0; i < crossing.overlaps.size(); ++i)
        crossing.overlaps[i].meet = laps.meets[i];
    result.a = std::move(laps.a);
    result.b = std::move(laps.b);
    return result;
}

NoSlit whyNoSlit(const Crossing &crossing, const JointSide &a, const JointSide &b,
                 const JointWish &wish)
{
    if (wish.kind == JointKind::None)
        return NoSlit::Wanted;
    if (!slitWidth(a.stock.thickness, b.stock.thickness, crossing.angle, a.stock.clearance) ||
        !slitWidth(b.stock.thickness, a.stock.thickness, crossing.angle, b.stock.clearance))
        return NoSlit::NoWidth;
    bool someOnlyUp = false, someOnlyDown = false;
    for (const Overlap &overlap : crossing.overlaps) {
        const bool up = cutOf(overlap, 1).isOpen(), down = cutOf(overlap, -1).isOpen();
        someOnlyUp |= up && !down;
        someOnlyDown |= down && !up;
    }
    if (someOnlyUp && someOnlyDown)
        return NoSlit::OppositeWays;
    const auto isOpen = [&](int sign) {
        return std::all_of(crossing.overlaps.begin(), crossing.overlaps.end(),
                           [sign](const Overlap &o) { return cutOf(o, sign).isOpen(); });
    };
    return isOpen(1) || isOpen(-1) ? NoSlit::NothingHolds : NoSlit::Enclosed;
}

} // namespace fff
