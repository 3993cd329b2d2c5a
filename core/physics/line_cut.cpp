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

/// The way between two points, of which the first lies on the boundary, passes through the cut.
bool passesCut(const LineCut &cut, const Vec2 &a, const Vec2 &b)
{
    const double da = cut.line.across(a), db = cut.line.across(b);
    if ((da >= 0.0) == (db >= 0.0))
        return false;
    const double share = da / (da - db);
    const double along = cut.line.along(a) + share * (cut.line.along(b) - cut.line.along(a));
    return along > cut.chords.front().from && along < cut.chords.back().to;
}

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
        const bool isLeft =
            isBoundaryLeft(cut, bridge.to) != passesCut(cut, bridge.to.at, bridge.from);
        cut.isHoleLeft[hole] = isLeft ? 1 : 0;
        if (isLeft)
            left += outline.ofRing(ring);
    }
}

/// The sides of a cut of which the chords are known; false if one of them is nothing.
bool weighSides(const SectionOutline &outline, const OutlineCrossing *first,
                const OutlineCrossing *last, LineCut &cut)
{
    const OutlineCrossing outer[] = {*first, *last};
    // A chord that leaves the outer ring crosses it to the right, and to the left where it comes
    // back: anything else is rounding among rings that touch.
    if (first->isToLeft || !last->isToLeft)
        return false;
    AreaMoment left = leftOf(outline, outer, outer + 2);
    for (const Chord &chord : cut.chords)
        left +=
            SectionOutline::ofStep(chord.begin.at - outline.base(), chord.end.at - outline.base());
    for (const OutlineCrossing *c = first + 1; c != last; ++c)
        cut.crossed.push_back(*c);
    placeHoles(outline, cut, left);
    cut.minus = left;
    cut.plus = outline.total();
    cut.plus -= left;
    return cut.minus.area > kSideDust && cut.plus.area > kSideDust;
}

/// The better of two, by length of the chord.
void keepShorter(std::optional<CutChord> &best, LineCut &cut, std::size_t chord)
{
    if (!best || cut.chords[chord].length() <
                     best->cut.chords[static_cast<std::size_t>(best->chord)].length())
        best = CutChord{cut, static_cast<int>(chord)};
}

template <class IsWanted>
std::optional<CutChord> shortestWanted(const SectionOutline &outline, const CutLine &line,
                                       IsWanted isWanted)
{
    std::optional<CutChord> best;
    std::vector<LineCut> cuts;
    for (const int zero : {1, -1}) {
        const bool isTouched = cutsOn(outline, line, zero, cuts);
        for (LineCut &cut : cuts)
            for (std::size_t i = 0; i < cut.chords.size(); ++i)
                if (isWanted(cut.chords[i]))
                    keepShorter(best, cut, i);
        if (!isTouched)
            break;
    }
    return best;
}

} // namespace

bool cutsOn(const SectionOutline &outline, const CutLine &line, int zero,
            std::vector<LineCut> &cuts)
{
    cuts.clear();
    std::vector<OutlineCrossing> found;
    const bool isTouched = outline.crossings(line, zero, found);
    for (std::size_t i = 0; i + 1 < found.size();) {
        // Up to where the line leaves the outer ring.
        std::size_t j = i + 1;
        while (j < found.size() && (found[j].point.ring != 0 || (j - i) % 2 == 0))
            ++j;
        if (found[i].point.ring != 0 || j == found.size()) {
            i += 2;
            continue;
        }
        LineCut cut;
        cut.line = line;
        for (std::size_t k = i; k < j; k += 2)
            cut.chords.push_back(
                {found[k].along, found[k + 1].along, found[k].point, found[k + 1].point});
        if (weighSides(outline, &found[i], &found[j], cut))
            cuts.push_back(std::move(cut));
        i = j + 1;
    }
    return isTouched;
}

std::optional<CutChord> cutAt(const SectionOutline &outline, const CutLine &line, double along,
                              double slack)
{
    return shortestWanted(outline, line, [along, slack](const Chord &chord) {
        return chord.from - slack <= along && along <= chord.to + slack &&
               chord.length() > kClipGrid;
    });
}

std::optional<CutChord> cutFrom(const SectionOutline &outline, const CutLine &line)
{
    return shortestWanted(outline, line, [](const Chord &chord) {
        return std::abs(chord.from) <= kBeginSlack && chord.length() > kBeginSlack;
    });
}

HeldPoint held(const SectionOutline &outline, const Vec2 &point)
{
    return {point, outline.nearest(point)};
}

bool isOnPlusSide(const LineCut &cut, const HeldPoint &point)
{
    return isBoundaryLeft(cut, point.anchor) == passesCut(cut, point.anchor.at, point.at);
}

} // namespace fff
