#include "core/stroke/guided_line.h"

#include "core/base/tolerances.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff {

namespace {

/// Between a guide and a free stretch the line takes so many times their distance to pass over.
constexpr double kPassage = 2.0;
/// In so many steps.
constexpr int kPassageSteps = 8;
/// Points on a guide are no further apart than this, mm: what closes a line looks at these.
constexpr double kGuideStep = 2.0;
/// From one sample to the next a guide goes on by no more than so many times the hand's way, and
/// this part of the reach; nor is it further off than that, unless it is looked for further on.
constexpr double kNextSteps = 2.0, kNextReach = 0.5;
/// A line goes all round a guide if no more is missing than this many reaches, or this share of
/// the guide where that is more, but never more than the last share.
constexpr double kMissingReaches = 2.0, kMissingShare = 0.05, kMostMissing = 0.25;

/// Samples in a row that one guide has caught, and how far along it each of them is; of a closed
/// guide this goes on beyond its ends.
struct Run
{
    std::size_t guide = 0;
    std::size_t first = 0, last = 0; // samples
    std::vector<double> along;

    double way() const { return along.back() - along.front(); }
    double sign() const { return way() < 0.0 ? -1.0 : 1.0; }
};

/// The part of a run that lies on its guide, with the ways to it and from it.
struct Caught
{
    Run run;
    double from = 0.0, to = 0.0; // along the guide
    bool isFreeBefore = false, isFreeAfter = false;
};

double smooth(double share)
{
    return share * share * (3.0 - 2.0 * share);
}

class GuideFollower
{
public:
    GuideFollower(const std::vector<Vec2> &samples, const std::vector<FreeSamples> &free,
                  const Guides &guides)
        : m_samples(samples), m_free(free), m_guides(guides)
    {
    }

    GuidedLine follow();

private:
    bool isFree(std::size_t sample) const;
    const PathLocator &guideOf(const Run &run) const { return m_guides.lines[run.guide]; }
    void findRuns();
    bool goesOn(Run &run, std::size_t sample) const;
    std::optional<Run> caughtAt(std::size_t sample) const;
    std::optional<Caught> settled(const Run &run) const;
    double missing(const Run &run) const;
    void findWhole(GuidedLine &line) const;
    bool joinEnds();
    double offAt(const Run &run, std::size_t place) const;
    Vec2 drawnAt(const Run &run, double way) const;
    void addFree(std::size_t from, std::size_t end, GuidedLine &line);
    void lookHowFar(const Vec2 &p, GuidedLine &line);
    void addCaught(const Caught &caught, GuidedLine &line);
    void addPassage(const Caught &caught, double from, double to, bool isComing, GuidedLine &line);

    const std::vector<Vec2> &m_samples;
    const std::vector<FreeSamples> &m_free;
    const Guides &m_guides;
    std::vector<Run> m_runs;
    std::vector<Caught> m_caught;
    std::optional<Vec2> m_looked; // how far this is from the nearest guide is known:
    double m_off = 0.0;           // mm
    double m_most = 0.0;          // mm, the longest way along a guide
};

void add(const Vec2 &p, GuidedLine &line)
{
    if (!line.points.empty()) {
        const double step = (p - line.points.back()).norm();
        if (step <= kClipGrid)
            return;
        line.length += step;
    }
    line.points.push_back(p);
}

bool GuideFollower::isFree(std::size_t sample) const
{
    return std::any_of(m_free.begin(), m_free.end(), [sample](const FreeSamples &free) {
        return free.from <= sample && sample < free.to;
    });
}

/// The guide keeps the line as long as it comes near it where it was, or as far on as it has moved.
bool GuideFollower::goesOn(Run &run, std::size_t sample) const
{
    const PathLocator &guide = guideOf(run);
    const double reach = Guides::kRelease * m_guides.reach;
    const double step = (m_samples[sample] - m_samples[sample - 1]).norm();
    const double before = run.along.back();
    const double turns = guide.isClosed() ? std::floor(before / guide.length()) : 0.0;
    const double start = turns * guide.length();
    // Where the guide bends more than the hand does, it is further on than the hand has moved; but
    // at the other side of something thin it is not as long as this side will do.
    const auto within = [&](double window) {
        return guide.nearest(m_samples[sample], reach, before - start, window);
    };
    auto place = within(kNextSteps * step + kNextReach * m_guides.reach);
    if (!place || place->distance > kNextReach * m_guides.reach)
        place = within(kNextSteps * (step + m_guides.reach));
    if (!place)
        return false;
    double along = start + place->along;
    if (guide.isClosed()) // the nearer way round
        along += guide.length() * std::round((before - along) / guide.length());
    run.along.push_back(along);
    run.last = sample;
    return true;
}

std::optional<Run> GuideFollower::caughtAt(std::size_t sample) const
{
    std::optional<Run> best;
    double reach = m_guides.reach;
    for (std::size_t i = 0; i < m_guides.lines.size(); ++i) {
        const auto place = m_guides.lines[i].nearest(m_samples[sample], reach);
        if (!place || (best && place->distance >= reach))
            continue;
        reach = place->distance;
        best = Run{i, sample, sample, {place->along}};
    }
    return best;
}

void GuideFollower::findRuns()
{
    std::optional<Run> run;
    const auto end = [&] {
        if (run)
            m_runs.push_back(*std::move(run));
        run.reset();
    };
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
        if (isFree(i)) {
            end();
            continue;
        }
        if (run && goesOn(*run, i))
            continue;
        end();
        run = caughtAt(i);
    }
    end();
}

/// mm that a sample of the run is off the guide.
double GuideFollower::offAt(const Run &run, std::size_t place) const
{
    return (m_samples[run.first + place] - guideOf(run).at(run.along[place])).norm();
}

std::optional<Caught> GuideFollower::settled(const Run &run) const
{
    Caught caught{run, run.along.front(), run.along.back(), run.first > 0,
                  run.last + 1 < m_samples.size()};
    const double sign = run.sign();
    if (caught.isFreeBefore)
        caught.from += sign * kPassage * offAt(run, 0);
    if (caught.isFreeAfter)
        caught.to -= sign * kPassage * offAt(run, run.along.size() - 1);
    if (guideOf(run).isClosed()) // once round is all there is
        caught.to = caught.from + std::clamp(caught.to - caught.from, -guideOf(run).length(),
                                             guideOf(run).length());
    // What comes and goes at once has only crossed the guide.
    const bool isLong = sign * (caught.to - caught.from) >
                        (caught.isFreeBefore && caught.isFreeAfter ? m_guides.reach : kClipGrid);
    return isLong ? std::optional(caught) : std::nullopt;
}

/// Of a closed guide, what the run leaves out of it, mm; below 0 where it goes further than round.
double GuideFollower::missing(const Run &run) const
{
    return guideOf(run).length() - std::abs(run.way());
}

void GuideFollower::findWhole(GuidedLine &line) const
{
    for (const Run &run : m_runs) {
        const double length = guideOf(run).length();
        const double most =
            std::min(std::max(kMissingReaches * m_guides.reach, kMissingShare * length),
                     kMostMissing * length);
        if (guideOf(run).isClosed() && missing(run) <= most)
            line.whole = run.guide;
    }
}

/// Whether the last run goes on in the first one: then it does, and the line is a loop.
bool GuideFollower::joinEnds()
{
    if (m_caught.size() < 2 || m_caught.front().isFreeBefore || m_caught.back().isFreeAfter)
        return false;
    Caught &first = m_caught.front();
    const Caught &last = m_caught.back();
    const PathLocator &guide = guideOf(first.run);
    if (first.run.guide != last.run.guide || !guide.isClosed() ||
        first.run.sign() != last.run.sign())
        return false;
    const double sign = first.run.sign(), length = guide.length();
    // From where the last one ends to where the first begins; a little back where it overshot.
    double gap = std::fmod(sign * (first.from - last.to), length);
    if (gap < -0.5 * length)
        gap += length;
    if (gap > 0.5 * length)
        gap -= length;
    const double reach = kMissingReaches * m_guides.reach;
    const double ways = sign * (first.to - first.from) + sign * (last.to - last.from) + gap;
    if (std::abs(gap) > reach || ways >= length)
        return false;
    first.from = first.to - sign * ways;
    return true;
}

/// Where the hand was when the guide had it so far along.
Vec2 GuideFollower::drawnAt(const Run &run, double way) const
{
    const double sign = run.sign();
    const auto at = [&](std::size_t i) { return m_samples[run.first + i]; };
    for (std::size_t i = 1; i < run.along.size(); ++i) {
        const double before = sign * (run.along[i - 1] - run.along.front());
        const double here = sign * (run.along[i] - run.along.front());
        if (here >= way && here > before)
            return at(i - 1) +
                   std::clamp((way - before) / (here - before), 0.0, 1.0) * (at(i) - at(i - 1));
    }
    return at(run.along.size() - 1);
}

void GuideFollower::addFree(std::size_t from, std::size_t end, GuidedLine &line)
{
    for (std::size_t i = from; i < end; ++i) {
        add(m_samples[i], line);
        lookHowFar(m_samples[i], line);
    }
}

/// No point is further off than one beside it by more than their distance, so that most of them
/// need no look.
void GuideFollower::lookHowFar(const Vec2 &p, GuidedLine &line)
{
    if (m_guides.isEmpty())
        return;
    const double most = m_looked ? m_off + (p - *m_looked).norm() + kClipGrid
                                 : std::numeric_limits<double>::infinity();
    if (most <= line.farthest)
        return;
    double off = most;
    for (const PathLocator &guide : m_guides.lines)
        if (const auto place = guide.nearest(p, off))
            off = std::min(off, place->distance);
    if (!std::isfinite(off))
        return;
    m_looked = p;
    m_off = off;
    line.farthest = std::max(line.farthest, off);
}

/// From free to guided (isComing) between two places along the guide, or back.
void GuideFollower::addPassage(const Caught &caught, double from, double to, bool isComing,
                               GuidedLine &line)
{
    const PathLocator &guide = guideOf(caught.run);
    for (int k = 0; k <= kPassageSteps; ++k) {
        const double share = static_cast<double>(k) / kPassageSteps;
        const double along = from + share * (to - from);
        const double weight = smooth(isComing ? share : 1.0 - share);
        const Vec2 drawn =
            drawnAt(caught.run, caught.run.sign() * (along - caught.run.along.front()));
        // On the guide itself pieces say where it goes on.
        if (k == (isComing ? kPassageSteps : 0))
            continue;
        const Vec2 p = drawn + weight * (guide.at(along) - drawn);
        add(p, line);
        lookHowFar(p, line);
    }
}

void GuideFollower::addCaught(const Caught &caught, GuidedLine &line)
{
    const PathLocator &guide = guideOf(caught.run);
    if (caught.isFreeBefore) {
        addPassage(caught, caught.run.along.front(), caught.from, true, line);
        line.turnouts.push_back(guide.at(caught.from));
    }
    const double before = line.length;
    for (const CubicBezier &curve : guide.piece(caught.from, caught.to)) {
        add(curve.p0, line);
        FittedPiece piece{curve, line.points.size() - 1, 0, true, true, false};
        if (!line.pieces.empty() && line.pieces.back().to == piece.from)
            piece.curve.p0 = line.pieces.back().curve.p3;
        const int steps =
            std::max(1, static_cast<int>(std::ceil((curve.p3 - curve.p0).norm() / kGuideStep)));
        for (int k = 1; k <= steps; ++k)
            add(k == steps ? curve.p3 : curve.at(static_cast<double>(k) / steps), line);
        piece.to = line.points.size() - 1;
        line.pieces.push_back(piece);
    }
    line.onGuides += line.length - before;
    if (line.length - before > m_most) {
        m_most = line.length - before;
        line.mostOn = guide.at(0.5 * (caught.from + caught.to));
    }
    if (caught.isFreeAfter) {
        line.turnouts.push_back(guide.at(caught.to));
        addPassage(caught, caught.to, caught.run.along.back(), false, line);
    }
}

GuidedLine GuideFollower::follow()
{
    GuidedLine line;
    if (!m_guides.isEmpty())
        findRuns();
    findWhole(line);
    for (const Run &run : m_runs)
        if (std::optional<Caught> caught = settled(run))
            m_caught.push_back(*std::move(caught));
    line.isCaughtAtEnd = !m_caught.empty() && !m_caught.back().isFreeAfter;
    line.isLoop = !line.whole && joinEnds();
    std::size_t next = 0; // sample
    const std::size_t count = m_caught.size() - (line.isLoop ? 1 : 0);
    for (std::size_t k = 0; k < count; ++k) {
        addFree(next, m_caught[k].run.first, line);
        addCaught(m_caught[k], line);
        next = m_caught[k].run.last + 1;
    }
    if (!line.isLoop) {
        addFree(next, m_samples.size(), line);
        return line;
    }
    // The rest of the way to the guide; from there on it has been.
    const Caught &last = m_caught.back();
    addFree(next, last.run.first, line);
    if (last.isFreeBefore) {
        addPassage(last, last.run.along.front(), last.from, true, line);
        line.turnouts.push_back(guideOf(last.run).at(last.from));
    }
    add(line.points.front(), line);
    return line;
}

} // namespace

GuidedLine guided(const std::vector<Vec2> &samples, const std::vector<FreeSamples> &free,
                  const Guides &guides)
{
    return GuideFollower(samples, free, guides).follow();
}

} // namespace fff
