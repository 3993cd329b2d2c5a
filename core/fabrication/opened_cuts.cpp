#include "core/fabrication/opened_cuts.h"

#include "core/base/tolerances.h"
#include "core/fabrication/line_stations.h"
#include "core/fabrication/shared_cuts.h"
#include "core/geometry/box_runs.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace fff {

namespace {

constexpr double kStationStep = 1.0; // mm between places that are looked at
constexpr int kFewestStations = 16, kMostStations = 4000;
/// Another cut as near as this, in mm, would cut a tab through.
constexpr double kOtherCut = 0.2;
/// A lead near its line is near that line; the rest of it has to be off it, too.
constexpr double kOwnShare = 0.25, kOwnRoom = 0.15;

struct OtherChord
{
    Vec2 from, to;
    std::size_t line;
};

double distanceToChord(const Vec2 &p, const OtherChord &chord)
{
    const Vec2 way = chord.to - chord.from;
    const double square = way.squaredNorm();
    const double share =
        square > 0.0 ? std::clamp((p - chord.from).dot(way) / square, 0.0, 1.0) : 0.0;
    return (p - chord.from - share * way).norm();
}

bool areNearer(const OtherChord &a, const OtherChord &b, double room)
{
    if (std::min({distanceToChord(a.from, b), distanceToChord(a.to, b), distanceToChord(b.from, a),
                  distanceToChord(b.to, a)}) < room)
        return true;
    const auto side = [](const OtherChord &of, const Vec2 &p) {
        return cross(of.to - of.from, p - of.from);
    };
    return side(a, b.from) * side(a, b.to) < 0.0 && side(b, a.from) * side(b, a.to) < 0.0;
}

/// All cuts of a sheet, to ask what is near.
class CutChords
{
public:
    explicit CutChords(std::span<const ToolLine *const> cuts)
    {
        for (std::size_t i = 0; i < cuts.size(); ++i)
            for (const CubicBezier &curve : cuts[i]->curves) {
                const int count =
                    curve.isStraight(2.0 * kClipGrid) ? 1 : curve.chordCount(kDrawChord);
                Vec2 at = curve.p0;
                for (int k = 1; k <= count; ++k) {
                    const Vec2 next = curve.at(static_cast<double>(k) / count);
                    m_chords.push_back({at, next, i});
                    at = next;
                }
            }
        m_runs.fill(m_chords.size(), [this](std::size_t i) {
            Box2 box;
            box.extend(m_chords[i].from);
            box.extend(m_chords[i].to);
            return box;
        });
    }

    /// Whether one is nearer than that. except  a line that does not count
    bool isNear(const OtherChord &chord, double room, std::optional<std::size_t> except) const
    {
        Box2 near;
        near.extend(chord.from);
        near.extend(chord.to);
        near.min -= Vec2::Constant(room);
        near.max += Vec2::Constant(room);
        return m_runs.any([&near](const Box2 &box) { return box.intersects(near); },
                          [&](std::size_t i) {
                              return m_chords[i].line != except &&
                                     areNearer(chord, m_chords[i], room);
                          });
    }

private:
    std::vector<OtherChord> m_chords;
    BoxRuns m_runs;
};

/// Round a closed line the shorter way.
double wayBetween(double a, double b, double length)
{
    const double off = std::fmod(std::abs(a - b), length);
    return std::min(off, length - off);
}

/// One cut, being opened.
class OpenedCut
{
public:
    OpenedCut(const ToolLine &line, std::size_t index, const CuttingSheet &sheet,
              std::vector<LineSpan> shared, const CutChords &all)
        : m_line(line), m_index(index), m_sheet(sheet), m_all(all), m_stations(line),
          m_corners(m_stations.corners()), m_left(std::move(shared))
    {
    }

    std::vector<ToolLine> pieces()
    {
        if (m_line.purpose == Purpose::OuterCut)
            placeTabs();
        if (m_sheet.finish.lead > 0.0)
            placeLead();
        if (m_left.empty() && !m_lead)
            return {m_line};
        std::sort(m_left.begin(), m_left.end(),
                  [](const LineSpan &a, const LineSpan &b) { return a.from < b.from; });
        const double all = m_stations.length();
        // From the lead, or from behind what is left out first, all the way round.
        const double begin = m_lead.value_or(m_left.empty() ? 0.0 : m_left.front().to);
        double at = begin;
        std::vector<ToolLine> pieces;
        for (const LineSpan &span : inOrderFrom(begin)) {
            addPiece(at, span.from, pieces);
            at = span.to;
        }
        addPiece(at, begin + all, pieces);
        if (m_lead && !pieces.empty())
            addLeads(pieces);
        return pieces;
    }

    /// Of what pieces() gave.
    bool hasLead() const { return m_lead.has_value(); }

private:
    /// What is left out, each once, from that station on.
    std::vector<LineSpan> inOrderFrom(double begin) const
    {
        const double all = m_stations.length();
        std::vector<LineSpan> spans;
        for (LineSpan span : m_left) {
            while (span.from < begin - kClipGrid) {
                span.from += all;
                span.to += all;
            }
            spans.push_back(span);
        }
        std::sort(spans.begin(), spans.end(),
                  [](const LineSpan &a, const LineSpan &b) { return a.from < b.from; });
        const double end = begin + all;
        for (LineSpan &span : spans)
            span = {std::min(span.from, end), std::min(span.to, end)};
        return spans;
    }

    void addPiece(double from, double to, std::vector<ToolLine> &pieces) const
    {
        if (to - from <= kTouchingDepth)
            return;
        ToolLine piece{m_line.purpose, m_line.part, m_stations.between(from, to), false};
        if (!piece.curves.empty())
            pieces.push_back(std::move(piece));
    }

    /// Whether so much to both sides of it is a place for a tab or a lead.
    bool isFree(double station, double half) const
    {
        const double room = half + kTabRoom, all = m_stations.length();
        for (const double corner : m_corners)
            if (wayBetween(station, corner, all) < room)
                return false;
        for (const LineSpan &span : m_left) {
            const double middle = 0.5 * (span.from + span.to);
            if (wayBetween(station, middle, all) < room + 0.5 * (span.to - span.from))
                return false;
        }
        const Vec2 from = m_stations.at(station - half), to = m_stations.at(station + half);
        if (m_all.isNear({from, to, m_index}, kOtherCut, m_index))
            return false;
        const CuttingPart &part = m_sheet.parts[m_line.part];
        return !part.isAtSlit(from, kTabRoom) && !part.isAtSlit(to, kTabRoom) &&
               !part.isAtSlit(m_stations.at(station), kTabRoom);
    }

    int stationCount() const
    {
        return std::clamp(static_cast<int>(m_stations.length() / kStationStep), kFewestStations,
                          kMostStations);
    }

    /// The place next to the station for which that is true.
    template <class IsGood>
    std::optional<double> nextPlace(double station, const IsGood &isGood) const
    {
        const int count = stationCount();
        const double step = m_stations.length() / count;
        for (int i = 0; i <= count / 2; ++i)
            for (const double way : {i * step, -i * step})
                if (isGood(station + way))
                    return station + way;
        return std::nullopt;
    }

    void placeTabs()
    {
        const CutFinish &finish = m_sheet.finish;
        const double half = 0.5 * finish.tabWidth, all = m_stations.length();
        for (int i = 0; i < finish.tabs; ++i) {
            const double wanted = (i + 0.5) / finish.tabs * all;
            const auto place =
                nextPlace(wanted, [&](double station) { return isFree(station, half); });
            if (!place)
                return;
            const double station = *place - all * std::floor(*place / all);
            m_left.push_back({station - half, station + half});
        }
    }

    Vec2 leadEnd(double station, bool isIn) const
    {
        const Vec2 along = m_stations.along(station), waste = -perpendicular(along);
        return m_stations.at(station) + m_sheet.finish.lead / std::numbers::sqrt2 *
                                            (isIn ? Vec2(waste - along) : Vec2(waste + along));
    }

    bool fitsAt(double station) const
    {
        const double lead = m_sheet.finish.lead, room = std::min(kLeadRoom, kOwnRoom * lead);
        const Vec2 from = m_stations.at(station);
        for (const bool isIn : {true, false}) {
            const Vec2 end = leadEnd(station, isIn);
            if (end.minCoeff() < 0.0 || (m_sheet.size - end).minCoeff() < 0.0)
                return false;
            if (m_all.isNear({from, end, m_index}, kLeadRoom, m_index) ||
                m_all.isNear({from + kOwnShare * (end - from), end, m_index}, room, std::nullopt))
                return false;
        }
        return true;
    }

    void placeLead()
    {
        const auto isGood = [&](double station) { return isFree(station, 0.0) && fitsAt(station); };
        if (const auto place = nextPlace(0.0, isGood))
            m_lead = *place - m_stations.length() * std::floor(*place / m_stations.length());
    }

    void addLeads(std::vector<ToolLine> &pieces) const
    {
        std::vector<CubicBezier> &first = pieces.front().curves, &last = pieces.back().curves;
        first.insert(first.begin(), CubicBezier::line(leadEnd(*m_lead, true), first.front().p0));
        last.push_back(CubicBezier::line(last.back().p3, leadEnd(*m_lead, false)));
    }

    const ToolLine &m_line;
    std::size_t m_index;
    const CuttingSheet &m_sheet;
    const CutChords &m_all;
    LineStations m_stations;
    std::vector<double> m_corners;
    std::vector<LineSpan> m_left; // out: shared ones, then tabs
    std::optional<double> m_lead;
};

/// Calls visit(index, pieces, hasLead) for each cut in turn.
template <class Visit>
void openEach(std::span<const ToolLine *const> cuts, const CuttingSheet &sheet, const Visit &visit)
{
    std::vector<std::vector<LineSpan>> shared(cuts.size());
    if (sheet.finish.sharesCuts)
        shared = sharedSpans(cuts);
    const CutChords all(cuts);
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        OpenedCut cut(*cuts[i], i, sheet, std::move(shared[i]), all);
        std::vector<ToolLine> pieces = cut.pieces();
        visit(i, std::move(pieces), cut.hasLead());
    }
}

} // namespace

std::vector<std::vector<ToolLine>> openedCuts(std::span<const ToolLine *const> cuts,
                                              const CuttingSheet &sheet)
{
    std::vector<std::vector<ToolLine>> opened;
    openEach(cuts, sheet, [&](std::size_t, std::vector<ToolLine> pieces, bool) {
        opened.push_back(std::move(pieces));
    });
    return opened;
}

std::vector<std::size_t> cutsWithoutLead(std::span<const ToolLine *const> cuts,
                                         const CuttingSheet &sheet)
{
    std::vector<std::size_t> without;
    if (sheet.finish.lead > 0.0)
        openEach(cuts, sheet,
                 [&](std::size_t i, const std::vector<ToolLine> &pieces, bool hasLead) {
                     if (!hasLead && !pieces.empty()) // else another one cuts all of it
                         without.push_back(i);
                 });
    return without;
}

} // namespace fff
