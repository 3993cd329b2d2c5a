#include "core/physics/line_cut.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>

namespace fff {

namespace {

/// Where a cut that begins at a boundary point may begin, mm from it.
constexpr double kBeginSlack = 1e-3;
/// Sides of less area are dust, mm².
constexpr double kSideDust = 1e-9;

/// The boundary point is on the cut's left, once it is known where the rings begin.
bool isBoundaryLeft(const LineCut &cut, const OutlinePoint &point)
{
    if (point.ring == 0) {
        // The left side is bounded by the outer ring from the cut's end to its beginning.
        const OutlinePoint &begin = cut.chords.front().begin, &end = cut.chords.back().end;
        return end.isBefore(begin) ? !point.isBefore(end) && point.isBefore(begin)
                                   : !point.isBefore(end) || point.isBefore(begin);
    }
    bool isLeft = cut.isHoleLeft[static_cast<std::size_t>(point.ring - 1)] != 0;
    for (const OutlineCrossing &c : cut.crossed)
        if (c.point.ring == point.ring && c.point.isBefore(point))
            isLeft = c.isToLeft;
    return isLeft;
}

/// The same of a point that is seen straight from there, through the material.
bool isSeenLeft(const LineCut &cut, const OutlinePoint &from, const Vec2 &point)
{
    const double there = cut.line.across(point);
    // From a boundary point on the cut, at a vertex that it passes or at its end, the way leads to
    // one side. On which of them the point itself is counted has no part in it.
    if (liesOnCut(cut, from.at))
        return there >= 0.0;
    const bool isFromLeft = isBoundaryLeft(cut, from);
    const double here = cut.line.across(from.at);
    if ((here >= 0.0) == (there >= 0.0))
        return isFromLeft;
    const double share = here / (here - there), along = cut.line.along(from.at);
    const double where = along + share * (cut.line.along(point) - along);
    const bool passes = where > cut.chords.front().from && where < cut.chords.back().to;
    return isFromLeft != passes;
}

/// What of the minus side is bounded by the crossings of one ring.
AreaMoment leftOf(const SectionOutline &outline, const OutlineCrossing *first,
                  const OutlineCrossing *end)
{
    AreaMoment sum;
    const OutlineCrossing *earliest = first;
    for (const OutlineCrossing *c = first; c != end; ++c) {
        if (c->isToLeft)
            sum -= outline.upTo(c->point);
        else
            sum += outline.upTo(c->point);
        if (c->point.isBefore(earliest->point))
            earliest = c;
    }
    if (!earliest->isToLeft) // the ring begins on the left side
        sum += outline.ofRing(first->point.ring);
    return sum;
}

void placeHoles(const SectionOutline &outline, LineCut &cut, AreaMoment &left)
{
    cut.isHoleLeft.assign(outline.bridges().size(), 0);
    std::sort(cut.crossed.begin(), cut.crossed.end(),
              [](const OutlineCrossing &a, const OutlineCrossing &b) {
                  return a.point.ring != b.point.ring ? a.point.ring < b.point.ring
                                                      : a.point.isBefore(b.point);
              });
    std::vector<char> isCrossed(cut.isHoleLeft.size(), 0);
    for (std::size_t i = 0; i < cut.crossed.size();) {
        const int ring = cut.crossed[i].point.ring;
        std::size_t j = i;
        while (j < cut.crossed.size() && cut.crossed[j].point.ring == ring)
            ++j;
        left += leftOf(outline, &cut.crossed[i], cut.crossed.data() + j);
        isCrossed[static_cast<std::size_t>(ring - 1)] = 1;
        cut.isHoleLeft[static_cast<std::size_t>(ring - 1)] = cut.crossed[i].isToLeft ? 0 : 1;
        i = j;
    }
    for (const int ring : outline.holeOrder()) {
        const auto hole = static_cast<std::size_t>(ring - 1);
        if (isCrossed[hole])
            continue;
        const SectionOutline::Bridge &bridge = outline.bridges()[hole];
        const bool isLeft = isSeenLeft(cut, bridge.to, bridge.from);
        cut.isHoleLeft[hole] = isLeft ? 1 : 0;
        if (isLeft)
            left += outline.ofRing(ring);
    }
}

bool isEntry(const OutlineCrossing &crossing)
{
    return crossing.point.ring == 0 && !crossing.isToLeft;
}

} // namespace

bool LineCutter::nextRun(std::span<const OutlineCrossing> crossings, Run &run)
{
    std::size_t i = run.next;
    while (i + 1 < crossings.size()) {
        // Up to where the line leaves the outer ring.
        std::size_t j = i + 1;
        while (j < crossings.size() && (crossings[j].point.ring != 0 || (j - i) % 2 == 0))
            ++j;
        if (crossings[i].point.ring == 0 && j < crossings.size()) {
            run = {&crossings[i], &crossings[j], j + 1};
            return true;
        }
        i += 2;
    }
    return false;
}

std::optional<CutChord> LineCutter::cutOf(const CutLine &line, const Run &run, int chord) const
{
    std::optional<CutChord> found(std::in_place);
    found->cut.line = line;
    found->chord = chord;
    const Chords chords(run);
    for (std::size_t i = 0; i < chords.size(); ++i)
        found->cut.chords.push_back(chords[i]);
    if (!weigh(run, found->cut))
        found.reset();
    return found;
}

bool LineCutter::weigh(const Run &run, LineCut &cut) const
{
    const OutlineCrossing outer[] = {*run.first, *run.last};
    // A chord that leaves the outer ring crosses it to the right, and to the left where it comes
    // back: anything else is rounding among rings that touch.
    if (outer[0].isToLeft || !outer[1].isToLeft)
        return false;
    AreaMoment left = leftOf(m_outline, outer, outer + 2);
    for (const Chord &chord : cut.chords)
        left += SectionOutline::ofStep(chord.begin.at - m_outline.base(),
                                       chord.end.at - m_outline.base());
    cut.crossed.assign(run.first + 1, run.last);
    placeHoles(m_outline, cut, left);
    cut.minus = left;
    cut.plus = m_outline.total();
    cut.plus -= left;
    return cut.minus.area > kSideDust && cut.plus.area > kSideDust;
}

bool LineCutter::Wanted::contains(double begin, double end) const
{
    return (isBeginning ? begin : end) >= from && begin <= to && end - begin > longerThan;
}

LineCutter::Found LineCutter::collect(const std::vector<OutlineCrossing> &crossings,
                                      const Wanted &wanted, bool isFromStart, bool isToEnd)
{
    Run run;
    const std::size_t known = m_candidates.size();
    if (!isFromStart) {
        if (wanted.isBeginning &&
            std::none_of(crossings.begin(), crossings.end(), [&wanted](const OutlineCrossing &c) {
                return wanted.from <= c.along && c.along <= wanted.to && !c.isToLeft;
            }))
            return Found::All;
        // From the last place where the material begins before what is wanted, or just there.
        auto begin = std::partition_point(
            crossings.begin(), crossings.end(),
            [&wanted](const OutlineCrossing &c) { return c.along < wanted.from; });
        if (begin == crossings.end() || !isEntry(*begin)) {
            while (begin != crossings.begin() && !isEntry(*std::prev(begin)))
                --begin;
            if (begin == crossings.begin())
                return Found::MoreBefore;
            --begin;
        }
        run.next = static_cast<std::size_t>(begin - crossings.begin());
    }
    while (run.next < crossings.size() && crossings[run.next].along <= wanted.to) {
        const std::size_t begin = run.next;
        if (!nextRun(crossings, run)) {
            if (!isToEnd)
                return Found::MoreBehind;
            break;
        }
        if (!isFromStart || !isToEnd) {
            // Of part of a line it is not known which crossings go together, but for what they say.
            for (std::size_t k = begin; k < run.next; ++k)
                if (crossings[k].isToLeft != ((k - begin) % 2 == 1))
                    return Found::Unclear;
        }
        int chord = 0;
        for (const OutlineCrossing *c = run.first; c < run.last; c += 2, ++chord)
            if (wanted.contains(c->along, (c + 1)->along))
                m_candidates.push_back({run, chord, c->along, (c + 1)->along});
    }
    // The material begins there, but nothing came of it: two crossings at one place, of which
    // either may be the first.
    if (wanted.isBeginning && !isFromStart && m_candidates.size() == known)
        return Found::Unclear;
    return Found::All;
}

void LineCutter::focus(const Vec2 &point, double reach)
{
    m_focus = point;
    m_focusReach = reach;
    m_outline.runsNear(point, reach, m_focused);
}

void LineCutter::findCrossings(const CutLine &line, const LineSpan &span)
{
    const auto isFocused = [&](double along) {
        return (line.at(along) - m_focus).norm() <= m_focusReach;
    };
    if (isFocused(span.from) && isFocused(span.to))
        m_outline.crossings(line, span, m_focused, m_crossings);
    else
        m_outline.crossings(line, span, m_crossings);
}

void LineCutter::search(const CutLine &line, const Wanted &wanted, double reach, bool isEitherWay)
{
    const LineSpan whole = m_outline.spanOn(line);
    LineSpan span{wanted.isBeginning ? wanted.from : wanted.from - reach, wanted.to + reach};
    if (!(whole.from <= whole.to) || !(span.from < span.to)) {
        m_candidates.clear();
        return; // it is no line
    }
    if (const double room = m_focusReach - (line.point - m_focus).norm(); room > 0.5 * reach)
        span = {std::max(span.from, -room), std::min(span.to, room)};
    for (;;) {
        const bool isFromStart = span.from <= whole.from, isToEnd = span.to >= whole.to;
        findCrossings(line, span);
        m_candidates.clear();
        Found found = collect(m_crossings.touchedLeft, wanted, isFromStart, isToEnd);
        if (found == Found::All && isEitherWay && m_crossings.isTouched)
            found = collect(m_crossings.touchedRight, wanted, isFromStart, isToEnd);
        if (found == Found::All)
            return;
        constexpr double kFarther = 4.0;
        const double length = kFarther * (span.to - span.from);
        if (found == Found::Unclear)
            span = whole;
        else if (found == Found::MoreBefore)
            span.from = wanted.from - length;
        else
            span.to = wanted.to + length;
    }
}

template <class Value>
std::optional<CutChord> LineCutter::least(const CutLine &line, Value value)
{
    while (!m_candidates.empty()) {
        const auto best = std::min_element(
            m_candidates.begin(), m_candidates.end(),
            [&](const Candidate &a, const Candidate &b) { return value(a) < value(b); });
        if (auto found = cutOf(line, best->run, best->chord))
            return found;
        m_candidates.erase(best);
    }
    return std::nullopt;
}

std::optional<CutChord> LineCutter::at(const CutLine &line, double along, double slack,
                                       double reach)
{
    search(line, {along - slack, along + slack, false, kClipGrid}, reach, true);
    return least(line, [](const Candidate &c) { return c.length(); });
}

std::optional<CutChord> LineCutter::from(const CutLine &line, double reach)
{
    search(line, {-kBeginSlack, kBeginSlack, true, kBeginSlack}, reach, true);
    return least(line, [](const Candidate &c) { return c.length(); });
}

/// From a vertex of the outer ring; nothing where that is not sure.
std::optional<OutlineCrossing> LineCutter::firstAhead(const CutLine &line, int ring, int vertex)
{
    if (ring != 0 || line.point != m_focus)
        return std::nullopt;
    for (;;) {
        const auto ahead = m_outline.firstAhead(line, ring, vertex, m_focused);
        if (!ahead)
            return std::nullopt;
        if (ahead->along <= m_focusReach) {
            // Over holes more than one chord counts.
            const bool isSure = ahead->point.ring == 0 && ahead->along > kBeginSlack;
            return isSure ? ahead : std::nullopt;
        }
        if (!(m_focusReach < m_outline.bounds().size().norm()))
            return std::nullopt;
        constexpr double kWider = 2.0;
        focus(m_focus, kWider * std::max(m_focusReach, kBeginSlack));
    }
}

std::optional<CutChord> LineCutter::fromVertex(const CutLine &line, int ring, int vertex,
                                               double reach)
{
    const std::optional<OutlineCrossing> ahead = firstAhead(line, ring, vertex);
    if (!ahead)
        return from(line, reach);
    const OutlineCrossing ends[] = {{0.0, m_outline.entryAt(line, ring, vertex), false}, *ahead};
    const Run run{&ends[0], &ends[1], 2};
    auto found = cutOf(line, run, 0);
    return found ? std::move(found) : from(line, reach);
}

std::optional<CutChord> LineCutter::nearest(const CutLine &line, double within, double reach)
{
    search(line, {-within, within, false, 0.0}, reach, false);
    std::erase_if(m_candidates, [within](const Candidate &c) { return c.away() >= within; });
    return least(line, [](const Candidate &c) { return c.away(); });
}

void cutsOn(const SectionOutline &outline, const CutLine &line, std::vector<LineCut> &cuts)
{
    cuts.clear();
    LineCutter(outline).eachOn(line, [&cuts](const LineCutter::Chords &, auto make) {
        if (auto found = make())
            cuts.push_back(std::move(found->cut));
    });
}

std::optional<CutChord> cutAt(const SectionOutline &outline, const CutLine &line, double along,
                              double slack)
{
    return LineCutter(outline).at(line, along, slack, outline.bounds().size().norm());
}

std::optional<CutChord> cutFrom(const SectionOutline &outline, const CutLine &line)
{
    return LineCutter(outline).from(line, outline.bounds().size().norm());
}

HeldPoint held(const SectionOutline &outline, const Vec2 &point)
{
    return {point, outline.nearest(point)};
}

HeldPoint held(const SectionOutline &outline, const Vec2 &point, const Vec2 &known)
{
    return {point, outline.nearest(point, known)};
}

bool liesOnCut(const LineCut &cut, const Vec2 &point)
{
    const double along = cut.line.along(point);
    return std::abs(cut.line.across(point)) <= kOnCut &&
           along >= cut.chords.front().from - kOnCut && along <= cut.chords.back().to + kOnCut;
}

bool isOnPlusSide(const LineCut &cut, const HeldPoint &point)
{
    return !isSeenLeft(cut, point.anchor, point.at);
}

} // namespace fff
