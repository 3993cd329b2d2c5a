#include "core/assembly/grips.h"

#include "core/assembly/cut_change.h"
#include "core/assembly/intervals.h"
#include "core/assembly/rings_near.h"
#include "core/base/groups.h"

#include <algorithm>
#include <array>
#include <map>

namespace fff {

namespace {

/// A guest that ends so much before a mortise's end has room to move, mm, beyond the clearance.
constexpr double kMortisePlay = 0.1;

/// A stretch of a slit's depth, mm from its bottom.
struct Span
{
    double from = 0.0, to = 0.0;
};
using Spans = std::vector<Span>; // apart, ascending

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
    for (std::size_t i = 0, k = 0; i < x.size() && k < y.size();) {
        const Span span{std::max(x[i].from, y[k].from), std::min(x[i].to, y[k].to)};
        if (span.from < span.to)
            both.push_back(span);
        x[i].to < y[k].to ? ++i : ++k;
    }
    return both;
}

/// Of each piece of a cut section where a line is inside of it, as far as `length`.
std::vector<Spans> insideOf(const CutSection &cut, const PlaneLine &line, double length)
{
    std::vector<Spans> inside(cut.parts().size());
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const RingsNear rings(
            line, cut.parts()[i].region, [&]() -> const RegionTree & { return cut.trees()[i]; },
            0.0);
        for (const Interval &interval : intervalsOn(line, rings.region())) {
            const Span span{std::max(interval.from.at, 0.0), std::min(interval.to.at, length)};
            if (span.from < span.to)
                inside[i].push_back(span);
        }
    }
    return inside;
}

/// What one section's slits have between their walls: [its piece][the other's piece], mm.
class Held
{
public:
    Held(std::size_t pieces, std::size_t others) : m_others(others), m_depths(pieces * others, 0.0)
    {
    }
    double &at(std::size_t piece, std::size_t other) { return m_depths[piece * m_others + other]; }
    double most() const
    {
        return m_depths.empty() ? 0.0 : *std::max_element(m_depths.begin(), m_depths.end());
    }

private:
    std::size_t m_others;
    std::vector<double> m_depths;
};

/// The walls of one slit, and what of the other section stands between them.
struct Walls
{
    std::array<std::vector<Spans>, 2> sides; // to the left and to the right, of each own piece
    std::array<std::vector<char>, 2> ends;   // whether it closes the ends, of each own piece
    std::vector<Spans> guest;                // of each piece of the other, on the axis
    std::array<std::vector<Spans>, 2> press; // and where it touches these walls
    double length = 0.0;                     // mm, of the slit
    Vec2 left = Vec2::Zero();                // unit, from the slit to its left wall
};

/// ownHalf: of the slit that the guest has, mm; 0 without one
Walls wallsOf(const Slit &slit, const GripSide &host, const GripSide &guest, double ownHalf)
{
    const Vec2 way = slit.mouth - slit.inner;
    const double length = way.norm();
    const PlaneLine axis{slit.inner, way / length};
    Walls walls;
    walls.length = length;
    for (const int end : {0, 1}) {
        const Vec2 beyond =
            axis.at(end == 0 ? -kGripWall : length + kGripWall); // just behind the end
        for (const CurvedRegion &piece : host.cut.parts())
            walls.ends[static_cast<std::size_t>(end)].push_back(
                !slit.isOpen && locate(beyond, piece.region) == Side::Inside);
    }
    walls.left = perpendicular(axis.direction);
    const double beside = 0.5 * slit.width + kGripWall;
    for (const int side : {0, 1}) {
        const Vec2 offset = (side == 0 ? beside : -beside) * walls.left;
        walls.sides[static_cast<std::size_t>(side)] =
            insideOf(host.cut, {axis.point + offset, axis.direction}, length);
    }
    const auto toGuest = [&](const Vec2 &direction) {
        return guest.frame.directionToLocal(host.frame.directionToWorld(direction));
    };
    const PlaneLine inGuest{guest.frame.toLocal(host.frame.toWorld(axis.point)),
                            toGuest(axis.direction).normalized()};
    walls.guest = insideOf(guest.cut, inGuest, length);
    // The cosine of the angle between the planes, along what is to the left in the guest.
    const Vec2 slant = toGuest(walls.left);
    const double cosine = slant.norm();
    const bool isOblique = ownHalf * cosine > kGripPlay;
    for (const int side : {0, 1}) {
        std::vector<Spans> &press = walls.press[static_cast<std::size_t>(side)];
        if (!isOblique) {
            press = walls.guest;
            continue;
        }
        const double offset = (ownHalf - kGripPlay / cosine) * (side == 0 ? 1.0 : -1.0);
        press = insideOf(guest.cut, {inGuest.point + (offset / cosine) * slant, inGuest.direction},
                         length);
        for (std::size_t i = 0; i < press.size(); ++i)
            press[i] = common(press[i], walls.guest[i]);
    }
    return walls;
}

/// Of a mortise, whether the own piece closes both of its ends, and the guest fills it from one to
/// the other: else the guest goes on along the axis.
bool isClosed(const Walls &walls, std::size_t own, std::size_t other)
{
    const Spans &guest = walls.guest[other];
    return walls.ends[0][own] && walls.ends[1][own] && !guest.empty() &&
           guest.front().from <= kMortisePlay && guest.back().to >= walls.length - kMortisePlay;
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
        pressed = std::max(pressed, depthOf(common(walls.press[0][i], walls.press[1][i])));
        for (const std::size_t side : {0U, 1U})
            for (const Spans &wall : walls.sides[side])
                depths[side] = std::max(depths[side], depthOf(common(wall, walls.press[side][i])));
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
std::optional<LooseSlit> addHeld(const Joint &joint, const GripSide &host, const GripSide &guest,
                                 Held &held)
{
    std::optional<LooseSlit> loose;
    const double needed = gripDepth(guest.thickness);
    const std::span<const Slit> slits = slitsOfJoint(host.slits, joint.id);
    double ownHalf = 0.0;
    for (const Slit &slit : slitsOfJoint(guest.slits, joint.id))
        if (slit.role == SlitRole::Slit)
            ownHalf = std::max(ownHalf, 0.5 * slit.width);
    for (auto at = slits.begin(); at != slits.end(); ++at) {
        const Slit &slit = *at;
        if (slit.role != SlitRole::Slit || slit.overlap < 0 || slit.inner == slit.mouth)
            continue;
        const Walls walls = wallsOf(slit, host, guest, ownHalf);
        for (std::size_t own = 0; own < host.cut.parts().size(); ++own) {
            const Spans both = common(walls.sides[0][own], walls.sides[1][own]);
            for (std::size_t other = 0; !both.empty() && other < walls.guest.size(); ++other)
                if (joint.kind != JointKind::Mortise || isClosed(walls, own, other))
                    held.at(own, other) +=
                        depthOf(common(both, common(walls.press[0][other], walls.press[1][other])));
        }
        LooseSlit why = whyLoose(walls, held.most(), needed);
        why.slit = static_cast<int>(at - slits.begin());
        if (!loose || why.depth > loose->depth)
            loose = why;
    }
    if (held.most() >= needed)
        return {};
    return loose;
}

/// Beside which joints both sections are cut as they were.
class Untouched
{
public:
    Untouched(const Assembly &assembly, const std::vector<CutSectionPointer> &cuts,
              const Grips::Before &before, const std::optional<std::vector<int>> &places)
        : m_changed(cuts.size(), 0), m_sides(assembly.joints.size(), 0)
    {
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const std::size_t place = places ? static_cast<std::size_t>((*places)[i]) : i;
            const bool isKnown = place < before.cuts.size();
            if (isKnown && cuts[i] == before.cuts[place])
                continue;
            m_changed[i] = 1;
            if (isKnown)
                findUntouched(assembly.slits[i],
                              CutChange(*cuts[i], assembly.slits[i], *before.cuts[place],
                                        before.assembly.slits[place]));
        }
    }

    /// Of one whose crossing is what it was.
    bool has(const Joint &joint) const
    {
        return m_changed[static_cast<std::size_t>(joint.a)] +
                   m_changed[static_cast<std::size_t>(joint.b)] ==
               m_sides[static_cast<std::size_t>(joint.id) - 1];
    }

private:
    void findUntouched(const std::vector<Slit> &slits, const CutChange &change)
    {
        if (change.isEverywhere())
            return;
        for (auto from = slits.begin(); from != slits.end();) {
            const auto to = std::find_if(
                from, slits.end(), [&](const Slit &slit) { return slit.joint != from->joint; });
            // What is looked at of a joint lies along its axis.
            if (std::none_of(from, to, [&](const Slit &slit) {
                    return slit.role != SlitRole::Slit || !slit.isOpen ||
                           change.isNear(slit, 0.5 * slit.width + 2.0 * kGripWall);
                }))
                ++m_sides[static_cast<std::size_t>(from->joint) - 1];
            from = to;
        }
    }

    std::vector<char> m_changed; // of each section whether its cut is another one
    std::vector<char> m_sides;   // of each joint how many of these are the same beside it
};

bool isOneEnough(JointKind kind)
{
    return kind == JointKind::Mortise || kind == JointKind::Tabs;
}

} // namespace

double gripDepth(double thickness)
{
    return std::max(kLeastGripDepth, std::sqrt(2.0 * kGripLoss * thickness));
}

JointGrips gripsOf(const Joint &joint, const GripSide &a, const GripSide &b)
{
    JointGrips grips;
    if (joint.kind == JointKind::None)
        return grips;
    const std::size_t countA = a.cut.parts().size(), countB = b.cut.parts().size();
    Held inA(countA, countB), inB(countB, countA);
    const std::optional<LooseSlit> looseA = addHeld(joint, a, b, inA);
    std::optional<LooseSlit> looseB = addHeld(joint, b, a, inB);
    const double neededInA = gripDepth(b.thickness), neededInB = gripDepth(a.thickness);
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

const JointGrips &Grips::of(const Joint &joint) const
{
    const auto row = static_cast<std::size_t>(joint.a);
    return m_rows[row][static_cast<std::size_t>(joint.id) - 1 - m_starts[row]]->grips;
}

Grips Grips::find(const Model &model, const Assembly &assembly,
                  const std::vector<CutSectionPointer> &cuts, const Before &before,
                  const std::optional<std::vector<int>> &places)
{
    static const std::vector<KnownPointer> none;
    Grips grips;
    const SharedRows<Joint> &rows = assembly.joints.rows();
    const SharedRows<KnownPointer> &knownRows = before.grips.m_rows;
    const Untouched untouched(assembly, cuts, before, places);
    const auto side = [&](int section) {
        const auto i = static_cast<std::size_t>(section);
        return GripSide{assembly.slits[i], *cuts[i], model.section(i)->frame,
                        model.stockOf(i).thickness};
    };
    const auto thicknesses = [&](const Joint &joint) {
        return std::array{model.stockOf(static_cast<std::size_t>(joint.a)).thickness,
                          model.stockOf(static_cast<std::size_t>(joint.b)).thickness};
    };
    grips.m_rows.resize(rows.size());
    grips.m_starts.reserve(rows.size());
    for (std::size_t a = 0; a < rows.size(); ++a) {
        grips.m_starts.push_back(assembly.joints.start(a));
        const std::vector<Joint> &joints = rows[a];
        if (joints.empty())
            continue;
        const std::size_t place = places ? static_cast<std::size_t>((*places)[a]) : a;
        const bool isKnown = place < knownRows.size();
        const std::vector<KnownPointer> &knownRow = isKnown ? knownRows[place] : none;
        const bool isSameRow =
            isKnown && rows.pointer(a) == before.assembly.joints.rows().pointer(place);
        const auto isOf = [&](const KnownPointer &known, const Joint &joint) {
            return untouched.has(joint) && known->thicknesses == thicknesses(joint) &&
                   (isSameRow || known->crossing == joint.crossing);
        };
        if (knownRow.size() == joints.size() &&
            std::equal(knownRow.begin(), knownRow.end(), joints.begin(), isOf)) {
            grips.m_rows.share(a, knownRows.pointer(place));
            continue;
        }
        std::vector<KnownPointer> row;
        row.reserve(joints.size());
        std::map<const Crossing *, KnownPointer> byCrossing;
        if (isKnown && knownRow.size() != joints.size())
            for (const KnownPointer &known : knownRow)
                byCrossing.emplace(known->crossing.get(), known);
        for (std::size_t i = 0; i < joints.size(); ++i) {
            const Joint &joint = joints[i];
            KnownPointer known;
            if (knownRow.size() == joints.size())
                known = knownRow[i];
            else if (const auto found = byCrossing.find(joint.crossing.get());
                     found != byCrossing.end())
                known = found->second;
            if (known && isOf(known, joint)) {
                row.push_back(std::move(known));
                continue;
            }
            row.push_back(std::make_shared<const Known>(Known{
                joint.crossing, thicknesses(joint), gripsOf(joint, side(joint.a), side(joint.b))}));
        }
        grips.m_rows.set(a, std::move(row));
    }
    return grips;
}

std::vector<int> sectionsOf(const Bodies &bodies, const std::vector<int> &group)
{
    std::vector<int> sections;
    sections.reserve(group.size());
    for (const int body : group) // which come in the order of their sections
        sections.push_back(bodies.sectionOf(body));
    sections.erase(std::unique(sections.begin(), sections.end()), sections.end());
    return sections;
}

std::vector<std::vector<int>> heldGroups(const Bodies &bodies, const JointList &joints,
                                         const Grips &grips)
{
    Groups held(bodies.size());
    for (const Joint &joint : joints) {
        if (joint.kind == JointKind::None)
            continue;
        for (const Grip &grip : grips.of(joint).held)
            held.join(static_cast<std::size_t>(bodies.firstOf(joint.a) + grip.a),
                      static_cast<std::size_t>(bodies.firstOf(joint.b) + grip.b));
    }
    struct Sized
    {
        std::size_t sections = 0;
        std::vector<int> bodies;
    };
    std::vector<Sized> sized;
    for (const std::vector<std::size_t> &group : held.all()) {
        std::vector<int> members(group.begin(), group.end());
        const std::size_t sections = sectionsOf(bodies, members).size();
        sized.push_back({sections, std::move(members)});
    }
    std::stable_sort(sized.begin(), sized.end(), [](const Sized &x, const Sized &y) {
        return std::pair(x.sections, x.bodies.size()) > std::pair(y.sections, y.bodies.size());
    });
    std::vector<std::vector<int>> groups;
    for (Sized &group : sized)
        groups.push_back(std::move(group.bodies));
    return groups;
}

} // namespace fff
