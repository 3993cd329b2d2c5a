#include "ui/view/slit_covers.h"

#include "core/base/tolerances.h"
#include "core/geometry/box_runs.h"
#include "core/model/shape_change.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fff::ui {

namespace {

/// Cosine of the angle between two planes up to which they stand square to each other.
constexpr double kSquare = 1e-6;
/// Play between wall and guest that is not to be seen into, mm.
constexpr double kNoPlay = 0.01;
/// What lies this near to the border of a stretch is on it, mm.
constexpr double kOnBorder = 2e-3;

/// Ring points as (along, across) of a stretch.
struct Stretch
{
    Vec2 origin, along, across;

    Vec2 at(const Vec2 &p) const { return {along.dot(p - origin), across.dot(p - origin)}; }
};

/// Round a strip, `half` to both sides, and its border.
Box2 stripOf(const Stretch &stretch, double half, double length)
{
    Box2 strip;
    for (const double along : {0.0, length})
        for (const double across : {-half, half})
            strip.extend(Vec2(stretch.origin + along * stretch.along + across * stretch.across));
    strip.min.array() -= kOnBorder;
    strip.max.array() += kOnBorder;
    return strip;
}

/// Where the edges near the strip first come into it, at most `length` along it.
double firstIntrusion(const RegionTree &part, const Stretch &stretch, double half, double length)
{
    const Box2 strip = stripOf(stretch, half, length);
    part.visitNear(strip, [&](const Vec2 &from, const Vec2 &to) {
        const Vec2 begin = stretch.at(from), end = stretch.at(to);
        const bool rises = begin.y() <= end.y();
        const Vec2 &a = rises ? begin : end, &b = rises ? end : begin;
        if (b.y() <= -half || a.y() >= half || std::min(a.x(), b.x()) >= length ||
            std::max(a.x(), b.x()) <= kOnBorder)
            return;
        // The part of the edge between the strip's two borders.
        const auto atHeight = [&](double y) { return a + (y - a.y()) / (b.y() - a.y()) * (b - a); };
        const Vec2 low = a.y() < -half ? atHeight(-half) : a;
        const Vec2 high = b.y() > half ? atHeight(half) : b;
        const double least = std::min(low.x(), high.x());
        if (std::max(low.x(), high.x()) > kOnBorder)
            length = std::min(length, std::max(least, 0.0));
    });
    return length;
}

/// How far the parts fill the strip from its beginning on.
double filledLength(const std::vector<RegionTree> &parts, const Stretch &stretch, double half,
                    double length)
{
    const Vec2 start = stretch.origin + 2.0 * kOnBorder * stretch.along;
    const bool isInside = std::any_of(parts.begin(), parts.end(), [&](const RegionTree &part) {
        return part.locate(start) != Side::Outside;
    });
    if (!isInside)
        return 0.0;
    for (const RegionTree &part : parts)
        length = firstIntrusion(part, stretch, half, length);
    return length;
}

/// The stretch of a slit beside its guest, in the guest's frame; nothing where they do not touch.
struct CoveredSlit
{
    SlitCover cover; // without its length
    Stretch stretch;
    double half = 0.0, length = 0.0; // mm, of the stretch
};

std::optional<CoveredSlit> coveredSlit(const Analysis &analysis, std::size_t section,
                                       const Slit &slit)
{
    const Model &model = analysis.model;
    const Frame &host = model.section(section)->frame;
    const double half = 0.5 * model.stockOf(section).thickness - kOnBorder;
    const auto index = static_cast<std::size_t>(slit.guest);
    const Frame &guest = model.section(index)->frame;
    const bool touches = slit.role == SlitRole::Slit &&
                         std::abs(host.normal().dot(guest.normal())) < kSquare &&
                         std::abs(slit.width - model.stockOf(index).thickness) < kNoPlay;
    const double length = (slit.mouth - slit.inner).norm();
    if (!touches || !(length > 4.0 * kOnBorder) || !(half > 0.0))
        return std::nullopt;
    CoveredSlit covered;
    covered.cover.inner = slit.inner;
    covered.cover.direction = (slit.mouth - slit.inner) / length;
    covered.cover.halfWidth = 0.5 * slit.width;
    covered.stretch = {guest.toLocal(host.toWorld(slit.inner)),
                       guest.directionToLocal(host.directionToWorld(covered.cover.direction)),
                       guest.directionToLocal(host.normal())};
    covered.half = half;
    covered.length = length;
    return covered;
}

void addCover(const Analysis &analysis, const Slit &slit, CoveredSlit covered,
              SectionCovers &covers)
{
    const auto &parts = analysis.cuts[static_cast<std::size_t>(slit.guest)]->trees();
    const double filled = filledLength(parts, covered.stretch, covered.half, covered.length);
    covered.cover.length = kCoverStep * std::floor(filled / kCoverStep);
    if (covered.cover.length > kNoPlay) {
        covers.covers.push_back(covered.cover);
        covers.guests.push_back(slit.guest);
    }
}

bool cutsTheSame(const Slit &a, const Slit &b)
{
    return a.guest == b.guest && a.inner == b.inner && a.mouth == b.mouth && a.width == b.width &&
           a.role == b.role && (a.form == b.form || (a.form && b.form && *a.form == *b.form));
}

/// Round all that the slit cuts.
void addBoxes(const Slit &slit, std::vector<Box2> &boxes)
{
    if (slit.form) {
        for (const Polygon &outline : slit.outlines(kDrawChord))
            boxes.push_back(bounds(outline));
        return;
    }
    const Vec2 half = 0.5 * slit.width * perpendicular((slit.mouth - slit.inner).normalized());
    Box2 box;
    for (const Vec2 &end : {slit.inner, slit.mouth})
        for (const double side : {-1.0, 1.0})
            box.extend(Vec2(end + side * half));
    boxes.push_back(box);
}

/// Slits of one list that the other does not have; both are in the order of their guests.
void addOthers(const std::vector<Slit> &list, const std::vector<Slit> &other,
               std::vector<const Slit *> &result)
{
    auto at = other.begin();
    for (const Slit &slit : list) {
        while (at != other.end() && at->guest < slit.guest)
            ++at;
        bool isThere = false;
        for (auto it = at; it != other.end() && it->guest == slit.guest; ++it)
            isThere = isThere || cutsTheSame(*it, slit);
        if (!isThere)
            result.push_back(&slit);
    }
}

} // namespace

SectionCovers slitCovers(const Analysis &analysis, std::size_t section)
{
    SectionCovers covers;
    for (const Slit &slit : analysis.assembly.slits[section])
        if (const auto covered = coveredSlit(analysis, section, slit))
            addCover(analysis, slit, *covered, covers);
    return covers;
}

/// What of a section is not as it was before.
struct CoverUpdate::Change
{
    static constexpr std::size_t kFewBoxes = 8;

    bool isPlaced = true;            // frame and thickness are
    std::vector<const Slit *> added; // new slits
    std::vector<Box2> boxes; // round these, those that went, and where its shape is another one
    BoxRuns runs;            // of the boxes, where they are many

    bool isNothing() const { return isPlaced && boxes.empty(); }
    /// Whether something of its parts may differ near the stretch.
    bool reaches(const CoveredSlit &covered) const
    {
        if (!isPlaced)
            return true;
        const Box2 strip = stripOf(covered.stretch, covered.half, covered.length);
        const auto isNear = [&strip](const Box2 &box) { return box.intersects(strip); };
        if (boxes.size() <= kFewBoxes)
            return std::any_of(boxes.begin(), boxes.end(), isNear);
        return runs.any(isNear, [&](std::size_t i) { return isNear(boxes[i]); });
    }
};

CoverUpdate::CoverUpdate(const Analysis &now, const Analysis &before)
    : m_now(now), m_before(before), m_changes(now.model.sectionCount())
{
    for (std::size_t i = 0; i < m_changes.size(); ++i) {
        const Section &a = *now.model.section(i), &b = *before.model.section(i);
        Change &change = m_changes[i];
        if (&a != &b || &now.model.stockOf(i) != &before.model.stockOf(i))
            change.isPlaced = a.frame == b.frame &&
                              now.model.stockOf(i).thickness == before.model.stockOf(i).thickness;
        if (a.shape != b.shape)
            change.boxes.push_back(ShapeChange(*a.shape, *b.shape).box());
        if (now.assembly.slits.pointer(i) != before.assembly.slits.pointer(i)) {
            addOthers(now.assembly.slits[i], before.assembly.slits[i], change.added);
            std::vector<const Slit *> others = change.added;
            addOthers(before.assembly.slits[i], now.assembly.slits[i], others);
            change.boxes.reserve(change.boxes.size() + others.size());
            for (const Slit *slit : others)
                addBoxes(*slit, change.boxes);
        }
        if (change.boxes.size() > Change::kFewBoxes)
            change.runs.fill(change.boxes.size(),
                             [&change](std::size_t k) { return change.boxes[k]; });
    }
}

CoverUpdate::~CoverUpdate() = default;

bool CoverUpdate::isKept(std::size_t section) const
{
    if (!m_changes[section].isNothing())
        return false;
    const std::vector<Slit> &slits = m_now.assembly.slits[section];
    return std::all_of(slits.begin(), slits.end(), [&](const Slit &slit) {
        const Change &guest = m_changes[static_cast<std::size_t>(slit.guest)];
        if (guest.isNothing())
            return true;
        const auto covered = guest.isPlaced ? coveredSlit(m_now, section, slit) : std::nullopt;
        return guest.isPlaced && (!covered || !guest.reaches(*covered));
    });
}

SectionCovers CoverUpdate::of(std::size_t section, const std::vector<SlitCover> &known,
                              const std::vector<int> &guests) const
{
    const Change &own = m_changes[section];
    if (!own.isPlaced)
        return slitCovers(m_now, section);
    SectionCovers covers;
    covers.covers.reserve(m_now.assembly.slits[section].size());
    covers.guests.reserve(m_now.assembly.slits[section].size());
    auto added = own.added.begin();
    std::size_t next = 0; // of those known, which are in the order of the guests
    for (const Slit &slit : m_now.assembly.slits[section]) {
        const Change &guest = m_changes[static_cast<std::size_t>(slit.guest)];
        const bool isNew = added != own.added.end() && *added == &slit;
        added += isNew ? 1 : 0;
        if (isNew || !guest.isNothing()) {
            const auto covered = coveredSlit(m_now, section, slit);
            if (!covered)
                continue;
            if (isNew || guest.reaches(*covered)) {
                addCover(m_now, slit, *covered, covers);
                continue;
            }
        }
        while (next < guests.size() && guests[next] < slit.guest)
            ++next;
        for (std::size_t k = next; k < guests.size() && guests[k] == slit.guest; ++k) {
            if (known[k].inner == slit.inner) {
                covers.covers.push_back(known[k]);
                covers.guests.push_back(slit.guest);
            }
        }
    }
    return covers;
}

} // namespace fff::ui
