#include "core/assembly/tabs.h"

#include "core/assembly/edge_room.h"
#include "core/assembly/fingers.h"
#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// In thicknesses of the section that has the tabs.
constexpr double kShareOfTab = 8.0, kLeastTab = 1.0;
/// What stays round a slot, in thicknesses of the section that has it.
constexpr double kRoundSlot = 0.5;

/// One list ascending and without overlaps.
std::vector<Stretch> merged(std::vector<Stretch> all)
{
    std::sort(all.begin(), all.end(),
              [](const Stretch &p, const Stretch &q) { return p.from < q.from; });
    std::vector<Stretch> result;
    for (const Stretch &next : all) {
        if (!result.empty() && next.from <= result.back().to)
            result.back().to = std::max(result.back().to, next.to);
        else
            result.push_back(next);
    }
    return result;
}

/// Whether the shape fills a rectangle along the line: no edge of it comes in.
bool fills(const Shape &shape, const PlaneLine &line, const Stretch &along, double half)
{
    if (shape.boundaries().locate(line.at(0.5 * (along.from + along.to))) != Side::Inside)
        return false;
    Box2 around;
    for (const double at : {along.from, along.to})
        for (const double across : {-half, half})
            around.extend(line.at(at) + across * perpendicular(line.direction));
    around.min.array() -= kTouchingDepth; // more than rounding
    around.max.array() += kTouchingDepth;
    bool staysOut = true;
    shape.boundaries().visitNear(around, [&](const Vec2 &a, const Vec2 &b) {
        const Vec2 begin(line.along(a), line.across(a)), end(line.along(b), line.across(b));
        // What of the edge lies in the strip, as its share of the edge.
        double from = 0.0, to = 1.0;
        const Vec2 way = end - begin;
        const auto clip = [&](double start, double speed, double low, double high) {
            if (speed == 0.0) {
                if (start <= low || start >= high)
                    to = -1.0;
                return;
            }
            const double p = (low - start) / speed, q = (high - start) / speed;
            from = std::max(from, std::min(p, q));
            to = std::min(to, std::max(p, q));
        };
        clip(begin.x(), way.x(), along.from, along.to);
        clip(begin.y(), way.y(), -half, half);
        staysOut = staysOut && from >= to;
    });
    return staysOut;
}

struct Plate
{
    const Shape &shape;
    const Stock &stock;
    PlaneLine line; // the axis
};

/// The one that ends on the other's face, and what follows.
class Ending
{
public:
    Ending(const Plate &guest, const Plate &host, double half, double slot)
        : m_guest(guest), m_host(host), m_half(half), m_slot(slot)
    {
    }

    /// Empty, or why there are no tabs.
    std::optional<NoTabs> find()
    {
        m_reached = merged(lobesIn(m_host.line, m_host.shape, 0.5 * m_slot));
        const std::vector<Stretch> left = beyond(1), right = beyond(-1);
        if (left.empty() == right.empty())
            return NoTabs::EndsNowhere;
        m_side = left.empty() ? -1 : 1;
        m_stretches = left.empty() ? right : left;
        placeTabs();
        return m_tabs.empty() ? std::optional(NoTabs::NoRoom) : std::nullopt;
    }

    const std::vector<Stretch> &stretches() const { return m_stretches; }
    double length() const
    {
        double sum = 0.0;
        for (const Tab &tab : m_tabs)
            sum += tab.at.to - tab.at.from;
        return sum;
    }
    std::vector<Slit> slots() const;
    std::vector<Slit> tabsAndShoulders() const;

private:
    struct Tab
    {
        Stretch at;
        int overlap = 0;
    };

    /// Where there is material of the guest beyond the strip, as far as the host reaches.
    std::vector<Stretch> beyond(int side) const
    {
        const PlaneLine line = shifted(m_guest.line, side * (m_half + kEdgeReach));
        return common(stretchesIn(line, m_guest.shape), m_reached);
    }
    void placeTabs();
    Slit shoulder(const Stretch &span) const;

    const Plate &m_guest, &m_host;
    double m_half; // of the strip that the host takes up in the guest's plane, mm
    double m_slot; // width of the slots in the host, mm
    int m_side = 1;
    std::vector<Stretch> m_reached, m_stretches;
    std::vector<Tab> m_tabs;
};

void Ending::placeTabs()
{
    const double margin = kRoundSlot * m_host.stock.thickness;
    const double around = 0.5 * m_slot + margin;
    std::vector<Stretch> solid = stretchesIn(m_host.line, m_host.shape);
    for (const int side : {-1, 1})
        solid = common(solid, stretchesIn(shifted(m_host.line, side * around), m_host.shape));
    for (Stretch &stretch : solid)
        stretch = {stretch.from + margin, stretch.to - margin};
    const double thickness = m_guest.stock.thickness;
    for (std::size_t i = 0; i < m_stretches.size(); ++i) {
        for (const Stretch &room : common({m_stretches[i]}, solid)) {
            const double length = room.to - room.from;
            const double count = std::max(1.0, std::round(length / (kShareOfTab * thickness)));
            const double share = length / count, width = 0.5 * share;
            if (width < kLeastTab * thickness)
                continue;
            for (int k = 0; k < static_cast<int>(count); ++k) {
                const double from = room.from + k * share + 0.5 * (share - width);
                const Stretch needed{from - margin, from + width + margin};
                if (fills(m_host.shape, m_host.line, needed, around))
                    m_tabs.push_back({{from, from + width}, static_cast<int>(i)});
            }
        }
    }
}

std::vector<Slit> Ending::slots() const
{
    std::vector<Slit> slits;
    const double play = 0.5 * std::max(0.0, m_host.stock.clearance);
    for (const Tab &tab : m_tabs) {
        Slit slit;
        slit.inner = m_host.line.at(tab.at.from - play);
        slit.mouth = m_host.line.at(tab.at.to + play);
        slit.width = m_slot;
        slit.isOpen = false;
        slit.overlap = tab.overlap;
        if (hasForm(m_host.stock)) {
            SlitForm form = formOf(m_host.stock, m_slot);
            form.held = (slit.mouth - slit.inner).norm();
            slit.form = std::make_shared<const SlitForm>(form);
        }
        slits.push_back(slit);
    }
    return slits;
}

/// All of the guest that would be in the host, from the strip's edge on.
Slit Ending::shoulder(const Stretch &span) const
{
    const double width = 2.0 * m_half + kEdgeReach + kOvershoot;
    const PlaneLine middle = shifted(m_guest.line, m_side * (m_half - 0.5 * width));
    Slit slit;
    slit.inner = middle.at(span.from - kOvershoot);
    slit.mouth = middle.at(span.to + kOvershoot);
    slit.width = width;
    slit.isOpen = false;
    slit.role = SlitRole::Shoulder;
    return slit;
}

std::vector<Slit> Ending::tabsAndShoulders() const
{
    std::vector<Slit> slits;
    const PlaneLine root = shifted(m_guest.line, m_side * (m_half + kEdgeReach + kOvershoot));
    const PlaneLine tip = shifted(m_guest.line, -m_side * m_half);
    for (const Tab &tab : m_tabs) {
        const double middle = 0.5 * (tab.at.from + tab.at.to);
        Slit slit;
        slit.inner = root.at(middle);
        slit.mouth = tip.at(middle);
        slit.width = tab.at.to - tab.at.from;
        slit.isOpen = false;
        slit.role = SlitRole::Tab;
        slit.overlap = tab.overlap;
        slits.push_back(slit);
    }
    // Where it ends it may be wider in the strip than beyond it.
    const std::vector<Stretch> inStrip = lobesIn(m_guest.line, m_guest.shape, m_half + kEdgeReach);
    for (std::size_t i = 0; i < m_stretches.size(); ++i) {
        Stretch span = m_stretches[i];
        for (const Stretch &lobe : inStrip)
            if (lobe.from < span.to && lobe.to > span.from)
                span = {std::min(span.from, lobe.from), std::max(span.to, lobe.to)};
        for (const Stretch &reached : common({span}, m_reached)) {
            slits.push_back(shoulder(reached));
            slits.back().overlap = static_cast<int>(i);
        }
    }
    return slits;
}

} // namespace

tl::expected<TabJoint, NoTabs> cutTabs(const JointSide &a, const JointSide &b)
{
    const std::optional<Axis> axis = intersectionAxis(a.section.frame, b.section.frame);
    const Vec3 na = a.section.frame.normal(), nb = b.section.frame.normal();
    const double angle = std::atan2(na.cross(nb).norm(), std::abs(na.dot(nb)));
    if (!axis || angle < kMinTabAngle - kTabAngleRounding)
        return tl::unexpected(NoTabs::TooOblique);
    const double ta = a.stock.thickness, tb = b.stock.thickness;
    const auto slotInA = slitWidth(ta, tb, angle, a.stock.clearance);
    const auto slotInB = slitWidth(tb, ta, angle, b.stock.clearance);
    const auto stripInA = slitWidth(ta, tb, angle, 0.0), stripInB = slitWidth(tb, ta, angle, 0.0);
    if (!slotInA || !slotInB || !stripInA || !stripInB)
        return tl::unexpected(NoTabs::NoWidth);
    const Plate plateA{*a.section.shape, a.stock, lineInFrame(*axis, a.section.frame)};
    const Plate plateB{*b.section.shape, b.stock, lineInFrame(*axis, b.section.frame)};
    Ending ofA(plateA, plateB, 0.5 * *stripInA, *slotInB);
    Ending ofB(plateB, plateA, 0.5 * *stripInB, *slotInA);
    const std::optional<NoTabs> whyNotA = ofA.find(), whyNotB = ofB.find();
    if (whyNotA && whyNotB) {
        if (auto fingers = cutFingers(a, b))
            return *std::move(fingers);
        const bool hasNoRoom = *whyNotA == NoTabs::NoRoom || *whyNotB == NoTabs::NoRoom;
        return tl::unexpected(hasNoRoom ? NoTabs::NoRoom : NoTabs::EndsNowhere);
    }
    const bool aHasTabs = !whyNotA && (whyNotB || ofA.length() > ofB.length());
    const Ending &ending = aHasTabs ? ofA : ofB;
    TabJoint joint;
    joint.crossing.axis = *axis;
    joint.crossing.angle = angle;
    for (const Stretch &s : ending.stretches()) {
        const Interval interval{{s.from, 0, 0}, {s.to, 0, 0}};
        joint.crossing.overlaps.push_back(
            {s.from, s.to, 0.5 * (s.from + s.to), interval, interval});
    }
    joint.slits.kind = JointKind::Tabs;
    joint.slits.a = aHasTabs ? ending.tabsAndShoulders() : ending.slots();
    joint.slits.b = aHasTabs ? ending.slots() : ending.tabsAndShoulders();
    return joint;
}

} // namespace fff
