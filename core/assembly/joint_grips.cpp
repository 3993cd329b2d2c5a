#include "core/assembly/joint_grips.h"

#include "core/assembly/finger_grips.h"
#include "core/assembly/fingers.h"
#include "core/assembly/intervals.h"
#include "core/assembly/rings_near.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace fff {

namespace {

/// A guest that ends so much before a mortise's end has room to move, mm, beyond the clearance.
constexpr double kMortisePlay = 0.1;

/// A stretch of a slit's depth, mm from its bottom.
struct Span
{
    double from = 0.0, to = 0.0;
};

/// Apart, ascending. Mostly one or two, which are kept without an allocation.
class Spans
{
public:
    void add(const Span &span)
    {
        if (m_size == m_few.size())
            m_many.assign(m_few.begin(), m_few.end());
        if (m_size >= m_few.size())
            m_many.push_back(span);
        else
            m_few[m_size] = span;
        ++m_size;
    }
    bool empty() const { return m_size == 0; }
    const Span *begin() const { return m_size > m_few.size() ? m_many.data() : m_few.data(); }
    const Span *end() const { return begin() + m_size; }

private:
    std::size_t m_size = 0;
    std::array<Span, 2> m_few;
    std::vector<Span> m_many; // all, where there are more
};

/// Of whole microns: outlines that were cut in another order differ by less, and what is half a
/// millimetre deep as drawn is so however it came about.
double depthOf(const Spans &spans)
{
    double sum = 0.0;
    for (const Span &span : spans)
        sum += span.to - span.from;
    return std::round(sum * 1e3) / 1e3;
}

Spans common(const Spans &x, const Spans &y)
{
    Spans both;
    for (const Span *a = x.begin(), *b = y.begin(); a != x.end() && b != y.end();) {
        const Span span{std::max(a->from, b->from), std::min(a->to, b->to)};
        if (span.from < span.to)
            both.add(span);
        a->to < b->to ? ++a : ++b;
    }
    return both;
}

/// The slits of a joint in one of its sections that hold the other; those without a length do not.
bool isHolding(const Slit &slit)
{
    return slit.role == SlitRole::Slit && slit.overlap >= 0 && slit.inner != slit.mouth;
}

/// A section of a joint as what is asked of it sees it: along the joint's axis, as far beside that
/// as the walls of its slits. Can be set to another one.
class AlongAxis
{
public:
    void set(const Joint &joint, const GripSide &side)
    {
        m_side = &side;
        m_slits = slitsOfJoint(side.slits, joint.id);
        m_halfWidth = 0.0;
        const PlaneLine axis = lineInFrame(joint.crossing->axis, side.frame);
        double beside = 0.0;
        for (const Slit &slit : m_slits) {
            if (slit.role != SlitRole::Slit)
                continue;
            m_halfWidth = std::max(m_halfWidth, 0.5 * slit.width);
            for (const Vec2 &end : {slit.inner, slit.mouth})
                beside = std::max(beside, std::abs(axis.across(end)));
        }
        findEdges(LineStrip(axis.point, axis.direction,
                            beside + m_halfWidth + 2.0 * kGripWall)); // once for rounding
    }

    const GripSide &side() const { return *m_side; }
    std::span<const Slit> slits() const { return m_slits; }
    double halfWidth() const { return m_halfWidth; } // mm, of the widest; 0 without one
    std::size_t pieceCount() const { return m_ends.size(); }
    /// Of each piece where the line is inside of it, as far as `length`.
    void findInside(const PlaneLine &line, double length, std::vector<Spans> &inside)
    {
        inside.assign(pieceCount(), Spans());
        for (std::size_t i = 0, first = 0; i < pieceCount(); first = m_ends[i++]) {
            const auto add = [&](const auto &intervals) {
                for (const Interval &interval : intervals) {
                    const Span span{std::max(interval.from.at, 0.0),
                                    std::min(interval.to.at, length)};
                    if (span.from < span.to)
                        inside[i].add(span);
                }
            };
            const std::span<const LineEdge> edges(m_edges.data() + first, m_ends[i] - first);
            if (const auto intervals = intervalsOn(line, edges, m_memory))
                add(*intervals);
            else // through a corner
                add(intervalsOn(
                    line, RingsNear(
                              line, m_side->cut.parts()[i].region,
                              [&]() -> const RegionTree & { return m_side->cut.trees()[i]; }, 0.0)
                              .region()));
        }
    }

private:
    void findEdges(const LineStrip &strip)
    {
        m_edges.clear();
        m_ends.clear();
        const auto add = [&](const Vec2 &from, const Vec2 &to) { m_edges.push_back({from, to}); };
        for (std::size_t i = 0; i < m_side->cut.parts().size(); ++i) {
            const Region &region = m_side->cut.parts()[i].region;
            if (RingsNear::isShort(region)) {
                const auto addOf = [&](const Polygon &ring) {
                    for (std::size_t to = 0, from = ring.size() - 1; to < ring.size(); from = to++)
                        if (strip.sideOf(ring[from], ring[to]) == 0)
                            add(ring[from], ring[to]);
                };
                addOf(region.outer);
                for (const Polygon &hole : region.holes)
                    addOf(hole);
            } else {
                for (const PolygonTree &ring : m_side->cut.trees()[i].rings())
                    ring.visitIn(strip, add);
            }
            m_ends.push_back(m_edges.size());
        }
    }

    const GripSide *m_side = nullptr;
    std::span<const Slit> m_slits;
    double m_halfWidth = 0.0;
    std::vector<LineEdge> m_edges;   // that come near
    std::vector<std::size_t> m_ends; // of those of each piece
    IntervalMemory m_memory;
};

/// What one section's slits have between their walls: [its piece][the other's piece], mm.
class Held
{
public:
    void set(std::size_t pieces, std::size_t others)
    {
        m_others = others;
        m_depths.assign(pieces * others, 0.0);
    }
    double &at(std::size_t piece, std::size_t other) { return m_depths[piece * m_others + other]; }
    double most() const
    {
        return m_depths.empty() ? 0.0 : *std::max_element(m_depths.begin(), m_depths.end());
    }

private:
    std::size_t m_others = 0;
    std::vector<double> m_depths;
};

/// The walls of one slit, and what of the other section stands between them.
struct Walls
{
    std::array<std::vector<Spans>, 2> sides;   // to the left and to the right, of each own piece
    std::array<std::vector<char>, 2> ends;     // of a mortise whether each own piece closes them
    std::vector<Spans> guest;                  // of each piece of the other, on the axis
    std::array<std::vector<Spans>, 2> slanted; // where it touches these walls, if oblique
    bool isOblique = false;
    double length = 0.0;      // mm, of the slit
    Vec2 left = Vec2::Zero(); // unit, from the slit to its left wall

    /// Where a piece of the other touches the wall on a side.
    const Spans &press(std::size_t side, std::size_t piece) const
    {
        return isOblique ? slanted[side][piece] : guest[piece];
    }
    /// Where it touches both.
    Spans pressed(std::size_t piece) const
    {
        return isOblique ? common(slanted[0][piece], slanted[1][piece]) : guest[piece];
    }
};

void findWalls(const Slit &slit, AlongAxis &host, AlongAxis &guest, Walls &walls)
{
    const Vec2 way = slit.mouth - slit.inner;
    const double length = way.norm();
    const PlaneLine axis{slit.inner, way / length};
    const Frame &hostFrame = host.side().frame, &guestFrame = guest.side().frame;
    walls.length = length;
    for (const std::size_t end : {0U, 1U}) {
        walls.ends[end].clear();
        if (slit.isOpen)
            continue;
        const Vec2 beyond =
            axis.at(end == 0 ? -kGripWall : length + kGripWall); // just behind the end
        for (const CurvedRegion &piece : host.side().cut.parts())
            walls.ends[end].push_back(locate(beyond, piece.region) == Side::Inside);
    }
    walls.left = perpendicular(axis.direction);
    const double beside = 0.5 * slit.width + kGripWall;
    for (const std::size_t side : {0U, 1U}) {
        const Vec2 offset = (side == 0 ? beside : -beside) * walls.left;
        host.findInside({axis.point + offset, axis.direction}, length, walls.sides[side]);
    }
    const auto toGuest = [&](const Vec2 &direction) {
        return guestFrame.directionToLocal(hostFrame.directionToWorld(direction));
    };
    const PlaneLine inGuest{guestFrame.toLocal(hostFrame.toWorld(axis.point)),
                            toGuest(axis.direction).normalized()};
    guest.findInside(inGuest, length, walls.guest);
    // The cosine of the angle between the planes, along what is to the left in the guest.
    const Vec2 slant = toGuest(walls.left);
    const double cosine = slant.norm(), ownHalf = guest.halfWidth();
    walls.isOblique = ownHalf * cosine > kGripPlay;
    if (!walls.isOblique)
        return;
    for (const std::size_t side : {0U, 1U}) {
        std::vector<Spans> &press = walls.slanted[side];
        const double offset = (ownHalf - kGripPlay / cosine) * (side == 0 ? 1.0 : -1.0);
        guest.findInside({inGuest.point + (offset / cosine) * slant, inGuest.direction}, length,
                         press);
        for (std::size_t i = 0; i < press.size(); ++i)
            press[i] = common(press[i], walls.guest[i]);
    }
}

/// Of a mortise, whether the own piece closes both of its ends, and the guest fills it from one to
/// the other: else the guest goes on along the axis.
bool isClosed(const Walls &walls, std::size_t own, std::size_t other)
{
    const Spans &guest = walls.guest[other];
    return !walls.ends[0].empty() && walls.ends[0][own] && walls.ends[1][own] && !guest.empty() &&
           guest.begin()->from <= kMortisePlay &&
           std::prev(guest.end())->to >= walls.length - kMortisePlay;
}

/// Why the slit holds nothing; of what it has between its walls by now nothing is enough.
LooseSlit whyLoose(const Walls &walls, double held, double needed)
{
    LooseSlit loose;
    loose.needed = needed;
    std::array<double, 2> depths{0.0, 0.0}; // of each wall, the most of any piece
    double inside = 0.0, pressed = 0.0;
    for (std::size_t i = 0; i < walls.guest.size(); ++i) {
        inside = std::max(inside, depthOf(walls.guest[i]));
        pressed = std::max(pressed, depthOf(walls.pressed(i)));
        for (const std::size_t side : {0U, 1U})
            for (const Spans &wall : walls.sides[side])
                depths[side] = std::max(depths[side], depthOf(common(wall, walls.press(side, i))));
    }
    loose.depth = std::max(depths[0], depths[1]);
    const double least = std::min(depths[0], depths[1]);
    if (!(inside >= needed))
        loose.why = inside > 0.0 && held > 0.0 ? NoGrip::Shallow : NoGrip::Empty;
    else if (!(pressed >= needed))
        loose.why = NoGrip::Shallow;
    else if (least >= needed)
        loose.why = NoGrip::CutThrough;
    else if (loose.depth >= needed) {
        loose.why = NoGrip::OneWall;
        loose.missing = depths[0] < depths[1] ? walls.left : Vec2(-walls.left);
    } else
        loose.why = held > 0.0 || loose.depth > 0.0 ? NoGrip::Shallow : NoGrip::NoWall;
    return loose;
}

/// Adds what the slits of `host` hold of `guest`. Why the one that holds most does not hold
/// enough, if none does; nothing where it has no slits at all.
std::optional<LooseSlit> addHeld(JointKind kind, AlongAxis &host, AlongAxis &guest, Walls &walls,
                                 Held &held)
{
    std::optional<LooseSlit> loose;
    const double needed = gripDepth(guest.side().thickness, host.side().clearance);
    for (std::size_t slit = 0; slit < host.slits().size(); ++slit) {
        if (!isHolding(host.slits()[slit]))
            continue;
        findWalls(host.slits()[slit], host, guest, walls);
        for (std::size_t own = 0; own < host.pieceCount(); ++own) {
            const Spans both = common(walls.sides[0][own], walls.sides[1][own]);
            for (std::size_t other = 0; !both.empty() && other < walls.guest.size(); ++other)
                if (kind != JointKind::Mortise || isClosed(walls, own, other))
                    held.at(own, other) += depthOf(common(both, walls.pressed(other)));
        }
        if (held.most() >= needed) // and not less with other slits
            continue;
        LooseSlit why = whyLoose(walls, held.most(), needed);
        why.slit = static_cast<int>(slit);
        if (!loose || why.depth > loose->depth)
            loose = why;
    }
    if (held.most() >= needed)
        return {};
    return loose;
}

bool isOneEnough(JointKind kind)
{
    return kind == JointKind::Mortise || kind == JointKind::Tabs;
}

} // namespace

double gripDepth(double thickness, double play)
{
    const double clearance = std::max(play, 0.0);
    return std::max(kLeastGripDepth,
                    std::sqrt(2.0 * (kGripLoss + clearance) * thickness + clearance * clearance));
}

struct GripFinder::Memory
{
    AlongAxis alongA, alongB;
    Walls walls;
    Held inA, inB;
};

GripFinder::GripFinder() : m_memory(std::make_unique<Memory>()) {}
GripFinder::~GripFinder() = default;

JointGrips GripFinder::find(const Joint &joint, const GripSide &a, const GripSide &b)
{
    JointGrips grips;
    if (joint.kind == JointKind::None)
        return grips;
    if (joint.kind == JointKind::Tabs && areFingers(slitsOfJoint(a.slits, joint.id)) &&
        areFingers(slitsOfJoint(b.slits, joint.id)))
        return fingerGrips(joint, a, b);
    const std::size_t countA = a.cut.parts().size(), countB = b.cut.parts().size();
    auto &[alongA, alongB, walls, inA, inB] = *m_memory;
    inA.set(countA, countB);
    inB.set(countB, countA);
    alongA.set(joint, a);
    alongB.set(joint, b);
    const std::optional<LooseSlit> looseA = addHeld(joint.kind, alongA, alongB, walls, inA);
    std::optional<LooseSlit> looseB = addHeld(joint.kind, alongB, alongA, walls, inB);
    const double neededInA = gripDepth(b.thickness, a.clearance);
    const double neededInB = gripDepth(a.thickness, b.clearance);
    for (std::size_t i = 0; i < countA; ++i) {
        for (std::size_t k = 0; k < countB; ++k) {
            const Grip grip{static_cast<int>(i), static_cast<int>(k), inA.at(i, k), inB.at(k, i)};
            const bool holdsB = grip.inA >= neededInA, holdsA = grip.inB >= neededInB;
            if (isOneEnough(joint.kind) ? holdsA || holdsB : holdsA && holdsB)
                grips.held.push_back(grip);
        }
    }
    if (grips.held.empty()) {
        if (looseB)
            looseB->isInA = false;
        grips.loose = looseA ? looseA : looseB;
        if (!grips.loose) // each holds some piece, but no two hold each other
            grips.loose = LooseSlit{NoGrip::CutThrough};
    }
    return grips;
}

} // namespace fff
