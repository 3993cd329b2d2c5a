// Straight cuts through a piece: what of a line is material, and what each cut parts.
#pragma once

#include "core/base/few.h"
#include "core/physics/section_outline.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace fff {

/// A stretch of a line in the material, between two points of the boundary.
struct Chord
{
    double from = 0.0, to = 0.0; // along the line, mm
    OutlinePoint begin, end;

    double length() const { return to - from; }
};

/// Chords of one line that part a piece in two: from the outer ring to the outer ring, over the
/// holes in between. The part to the left of the line is the minus side, that to its right the plus
/// side; cut sides see an outward normal of the minus side m = direction turned by −90°.
struct LineCut
{
    CutLine line;
    Few<Chord, 1> chords; // at least one, in their order along the line
    AreaMoment plus;      // of the plus side, about the outline's base
    AreaMoment minus;
    std::vector<char> isHoleLeft;         // by ring − 1: its first vertex is on the minus side
    std::vector<OutlineCrossing> crossed; // of holes, in the order of ring and way around

    Vec2 normal() const { return {line.direction.y(), -line.direction.x()}; }
};

/// A chord of one of the cuts of a line.
struct CutChord
{
    LineCut cut;
    int chord = 0;
};

/// Makes cuts through a piece, which outlives it. For those who make many of them: its room is used
/// again. Not for several threads at once.
class LineCutter
{
    struct Run;

public:
    /// Those of one cut, in their order along the line.
    class Chords
    {
    public:
        explicit Chords(const Run &run) : m_run(run) {}

        std::size_t size() const
        {
            return static_cast<std::size_t>(m_run.last - m_run.first + 1) / 2;
        }
        Chord operator[](std::size_t i) const
        {
            const OutlineCrossing &begin = m_run.first[2 * i], &end = m_run.first[2 * i + 1];
            return {begin.along, end.along, begin.point, end.point};
        }

    private:
        const Run &m_run;
    };

    explicit LineCutter(const SectionOutline &outline) : m_outline(outline) {}

    /// Calls use(chords, make) for every cut on the line. make() is all of it, with its first
    /// chord, or nothing if one of its sides has no area: it is none then. Robust against vertices
    /// on the line: they count as to its left. O(edges near the line + holes).
    template <class Use>
    void eachOn(const CutLine &line, Use use)
    {
        m_outline.crossings(line, {}, m_crossings);
        eachOf(line, std::span<const OutlineCrossing>(m_crossings.touchedLeft), use);
    }
    /// The same where the crossings are known, in their order along the line.
    template <class Use>
    void eachOf(const CutLine &line, std::span<const OutlineCrossing> crossings, Use use)
    {
        for (Run run; nextRun(crossings, run);)
            use(Chords(run), [&] { return cutOf(line, run, 0); });
    }

    /// The cuts to come are near to the point, most of them within so many mm: of these all are
    /// faster. Until the next one; rays from the point that go farther widen it.
    void focus(const Vec2 &point, double reach);

    /// The shortest chord that contains the place `along` of the line, within `slack` mm. Where
    /// vertices lie on the line it may be moved by nothing to either side, as is shorter. `reach`,
    /// mm: how long it is likely to be; the answer does not hang on it, but of a line along a long
    /// boundary only what is near is looked at.
    std::optional<CutChord> at(const CutLine &line, double along, double slack, double reach);
    /// The shortest chord that begins at the line's own point, which lies on the boundary.
    std::optional<CutChord> from(const CutLine &line, double reach);
    /// The same where that is a vertex of a ring, and the focus: faster.
    std::optional<CutChord> fromVertex(const CutLine &line, int ring, int vertex, double reach);
    /// The chord nearest to the line's own point, less than `within` mm away from it. Vertices on
    /// the line count as to its left.
    std::optional<CutChord> nearest(const CutLine &line, double within, double reach);

private:
    /// Of crossings, from where a line enters the outer ring to where it leaves that.
    struct Run
    {
        const OutlineCrossing *first = nullptr, *last = nullptr;
        std::size_t next = 0; // index of the crossing behind
    };
    static bool nextRun(std::span<const OutlineCrossing> crossings, Run &run);
    std::optional<CutChord> cutOf(const CutLine &line, const Run &run, int chord) const;
    bool weigh(const Run &run, LineCut &cut) const;

    /// Which chords are wanted: those that meet a stretch of the line, or begin there.
    struct Wanted
    {
        double from = 0.0, to = 0.0; // mm along the line
        bool isBeginning = false;
        double longerThan = 0.0; // mm

        bool contains(double begin, double end) const;
    };
    struct Candidate
    {
        Run run;
        int chord = 0;
        double from = 0.0, to = 0.0; // along the line

        double length() const { return to - from; }
        double away() const { return std::max({0.0, from, -to}); } // from the line's point
    };
    /// All chords that are wanted were among the crossings; or some may not be, since more of the
    /// line has to be known; or of all of it, since rings touch.
    enum class Found { All, MoreBefore, MoreBehind, Unclear };

    /// All chords that are wanted, of either way to count vertices on the line, or of one.
    void search(const CutLine &line, const Wanted &wanted, double reach, bool isEitherWay);
    Found collect(const std::vector<OutlineCrossing> &crossings, const Wanted &wanted,
                  bool isFromStart, bool isToEnd);
    /// The first of the least that is a cut.
    template <class Value>
    std::optional<CutChord> least(const CutLine &line, Value value);

    void findCrossings(const CutLine &line, const LineSpan &span);
    std::optional<OutlineCrossing> firstAhead(const CutLine &line, int ring, int vertex);

    const SectionOutline &m_outline;
    LineCrossings m_crossings;
    Vec2 m_focus = Vec2::Zero();
    double m_focusReach = -1.0; // none
    std::vector<EdgeRun> m_focused;
    std::vector<Candidate> m_candidates;
};

/// All cuts on the line; see LineCutter.
void cutsOn(const SectionOutline &outline, const CutLine &line, std::vector<LineCut> &cuts);
std::optional<CutChord> cutAt(const SectionOutline &outline, const CutLine &line, double along,
                              double slack);
std::optional<CutChord> cutFrom(const SectionOutline &outline, const CutLine &line);

/// Where a point of the material is held to the boundary, so that its side of a cut costs no
/// search: the straight way to `anchor` stays in the material.
struct HeldPoint
{
    Vec2 at = Vec2::Zero();
    OutlinePoint anchor;
};

HeldPoint held(const SectionOutline &outline, const Vec2 &point);
/// The same, faster the nearer a known point of the boundary is.
HeldPoint held(const SectionOutline &outline, const Vec2 &point, const Vec2 &known);
/// Between the two ends of the cut, on its line.
bool liesOnCut(const LineCut &cut, const Vec2 &point);
/// On the plus side; a point outside of the material counts as its anchor. O(crossings of holes).
bool isOnPlusSide(const LineCut &cut, const HeldPoint &point);

} // namespace fff
