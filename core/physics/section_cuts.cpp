#include "core/physics/section_cuts.h"

#include "core/base/tolerances.h"
#include "core/geometry/segment_distance.h"
#include "core/physics/parallel_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace fff {

namespace {

/// Material that is no wider than this holds nothing, mm: where two corners meet at a point.
constexpr double kMinLigament = 0.05;
constexpr int kDirections = 8;
/// A line of the grid that leans by more than one step of the directions is left to a squarer one.
/// The cosine of that, and rounding: between straight edges lines lean by just one.
constexpr double kGridStraight = 0.9238795325112867 - 1e-6;
constexpr double kFanStep = std::numbers::pi / 16;
constexpr int kFanSteps = 6; // to each side
/// How far below a slit's root the line square to it runs, mm.
constexpr double kBelowRoot = 1e-3;
/// A vertex this near to where the corner of a slit should be is that corner, mm: fillets and
/// relief cuts are no larger.
constexpr double kCornerReach = 0.5;
/// A ligament leans by no more than this from being square to an edge of its corner (40°, radians):
/// else it would run along the corner's own walls.
constexpr double kLigamentLean = 0.6981317007977318;
/// Lines this near are one, mm.
constexpr double kSameLine = 1e-6;
/// Of two ligaments that are as long, up to this, mm, the first one is taken.
constexpr double kSameLength = 1e-7;
/// How many spacings of the grid a member is wide, to begin with; and how much longer than the one
/// before the next chord may be that is found at once.
constexpr double kFirstReach = 8.0;
constexpr double kNextReach = 1.5;
/// Cuts that a slit comes to, and the grid, mostly.
constexpr std::size_t kOfSlit = 2 * (2 * kFanSteps + 2) + 2;
constexpr std::size_t kUsualOfGrid = 128;
/// Lines of one direction at the most, whatever the spacing given.
constexpr int kMaxLines = 1000;

Vec2 unit(double angle)
{
    return {std::cos(angle), std::sin(angle)};
}

/// By the angle of a unit vector.
Vec2 rotated(const Vec2 &a, const Vec2 &turn)
{
    return turn.x() * a + turn.y() * perpendicular(a);
}

/// Of the rays of a fan, from its middle.
const std::array<Vec2, 2 * kFanSteps + 1> &fanTurns()
{
    static const auto turns = [] {
        std::array<Vec2, 2 * kFanSteps + 1> all;
        for (int k = -kFanSteps; k <= kFanSteps; ++k)
            all[static_cast<std::size_t>(k + kFanSteps)] = unit(k * kFanStep);
        return all;
    }();
    return turns;
}

/// What of the edge from a corner's p to q has values ≥ 0 of something linear: narrows from … to.
void keepPositive(double here, double there, double &from, double &to)
{
    if (here < 0.0 && there < 0.0)
        to = -1.0;
    else if (here < 0.0)
        from = std::max(from, here / (here - there));
    else if (there < 0.0)
        to = std::min(to, here / (here - there));
}

/// Which way boundary may face a re-entrant corner: the directions between the inward normals of
/// its two edges, widened by kLigamentLean, but no more than half of all.
class FacingCone
{
public:
    FacingCone(const Vec2 &before, const Vec2 &after) // the outward normals
        : m_low(rotated(-after, unit(-kLigamentLean))),
          m_high(rotated(-before, unit(kLigamentLean)))
    {
        // An outward normal turned left is its edge's direction: this points away from the void.
        m_axis = perpendicular(before) - perpendicular(after);
        m_isWide = cross(m_low, m_high) <= 0.0;
    }

    /// The nearest point to the corner, which is the origin, on the edge from p to q.
    std::optional<Vec2> nearest(const Vec2 &p, const Vec2 &q) const
    {
        double from = 0.0, to = 1.0;
        if (m_isWide) {
            keepPositive(m_axis.dot(p), m_axis.dot(q), from, to);
        } else {
            keepPositive(cross(m_low, p), cross(m_low, q), from, to);
            keepPositive(cross(p, m_high), cross(q, m_high), from, to);
        }
        if (from > to)
            return std::nullopt;
        const Vec2 way = q - p;
        return Vec2(p + std::clamp(-way.dot(p) / way.squaredNorm(), from, to) * way);
    }

private:
    Vec2 m_low, m_high, m_axis = Vec2::Zero();
    bool m_isWide = false;
};

/// mm², of the two parts of a ring that a chord from its vertex to a point of one of its edges
/// leaves the smaller one: of a tooth that clearance left beside the mouth of a slit next to
/// nothing.
double partedArea(const Polygon &ring, int vertex, int edge, const Vec2 &at)
{
    const int count = static_cast<int>(ring.size());
    Polygon part{at};
    for (int i = (edge + 1) % count; i != vertex; i = (i + 1) % count)
        part.push_back(ring[static_cast<std::size_t>(i)]);
    part.push_back(ring[static_cast<std::size_t>(vertex)]);
    const double one = std::abs(signedArea(part));
    return std::min(one, std::abs(std::abs(signedArea(ring)) - one));
}

/// Fills the lists of cuts and of samples on them.
class SampleMaker
{
public:
    SampleMaker(const PieceShape &shape, double spacing, std::vector<LineCut> &cuts,
                std::vector<CutSample> &samples)
        : m_shape(shape), m_spacing(spacing), m_cuts(cuts), m_samples(samples),
          m_cutter(shape.outline), m_reach(kFirstReach * spacing)
    {
    }

    void addGrid(double shift);
    void addSlit(std::size_t index);
    void addLigament(const ReentrantCorner &corner);
    bool isPinched() const { return m_isPinched; }

private:
    /// Of a line, mm along it.
    struct Stretch
    {
        CutLine line;
        double from = 0.0, to = 0.0;
    };

    void addLine(const CutLine &line, std::span<const OutlineCrossing> crossings);
    OutlinePoint cornerNear(const Vec2 &wanted) const;
    void addFrom(const OutlinePoint &point, const Vec2 &direction, SampleKind kind);
    void addChord(CutChord &&found, SampleKind kind);
    bool isKnown(const CutLine &line) const;

    const PieceShape &m_shape;
    double m_spacing;
    std::vector<LineCut> &m_cuts;
    std::vector<CutSample> &m_samples;
    LineCutter m_cutter;
    double m_reach;                    // mm: how long the next chord is likely to be
    std::vector<Stretch> m_squareNets; // the lines square to slits, just below their roots
    std::vector<CutSample> m_found;    // of one cut
    bool m_isPinched = false;
};

void SampleMaker::addGrid(double shift)
{
    ParallelLines lines(m_shape.outline);
    for (int i = 0; i < kDirections; ++i) {
        lines.find(unit(std::numbers::pi * i / kDirections), shift * m_spacing, m_spacing);
        for (std::size_t k = 0; k < lines.size(); ++k)
            addLine(lines.line(k), lines.crossings(k));
    }
}

/// Of a slit's root, or where the boundary is if it is rounded off.
OutlinePoint SampleMaker::cornerNear(const Vec2 &wanted) const
{
    const ReentrantCorner *nearest = nullptr;
    double least = kCornerReach;
    m_shape.cornerBoxes.any([&](const Box2 &box) { return distanceToBox(box, wanted) < least; },
                            [&](std::size_t i) {
                                const ReentrantCorner &corner = m_shape.corners[i];
                                if (const double away = (corner.at - wanted).norm(); away < least) {
                                    least = away;
                                    nearest = &corner;
                                }
                                return false;
                            });
    if (nearest)
        return {nearest->ring, nearest->vertex, 0.0, nearest->at};
    return m_shape.outline.nearest(wanted);
}

void SampleMaker::addSlit(std::size_t index)
{
    const SlitLine &slit = m_shape.slits[index];
    const Vec2 side = perpendicular(slit.opening);
    for (const double sign : {-0.5, 0.5}) {
        const OutlinePoint corner = cornerNear(slit.root + sign * slit.width * side);
        m_cutter.focus(corner.at, m_reach);
        for (const Vec2 &turn : fanTurns())
            addFrom(corner, rotated(-slit.opening, turn), SampleKind::SlitFan);
        addFrom(corner, sign > 0.0 ? side : Vec2(-side), SampleKind::ProngRoot);
    }
    if (m_shape.netCuts[index])
        addChord(CutChord(*m_shape.netCuts[index]), SampleKind::NetSection);
    const CutLine below{slit.root - kBelowRoot * slit.opening, side};
    if (isKnown(below))
        return;
    if (auto found = m_cutter.at(below, 0.0, 0.0, m_reach)) {
        const Chord &chord = found->cut.chords[static_cast<std::size_t>(found->chord)];
        m_squareNets.push_back({below, chord.from, chord.to});
        addChord(*std::move(found), SampleKind::NetSection);
    }
}

/// Slits that are cut to one height have one line square to them.
bool SampleMaker::isKnown(const CutLine &line) const
{
    return std::any_of(m_squareNets.begin(), m_squareNets.end(), [&line](const Stretch &known) {
        const double along = known.line.along(line.point);
        return known.from < along && along < known.to &&
               std::abs(known.line.across(line.point)) < kSameLine &&
               std::abs(cross(known.line.direction, line.direction)) < kSameDirection;
    });
}

void SampleMaker::addLigament(const ReentrantCorner &corner)
{
    const SectionOutline &outline = m_shape.outline;
    const FacingCone cone(outline.outward(corner.ring, corner.vertex - 1),
                          outline.outward(corner.ring, corner.vertex));
    double least = m_reach;
    std::optional<Vec2> nearest;
    const auto look = [&](int ring, int edge) {
        const int count = static_cast<int>(outline.rings()[static_cast<std::size_t>(ring)].size());
        if (ring == corner.ring && (edge == corner.vertex || (edge + 1) % count == corner.vertex))
            return;
        const auto p = cone.nearest(outline.vertex(ring, edge) - corner.at,
                                    outline.vertex(ring, edge + 1) - corner.at);
        if (p && p->norm() <= kMinLigament) {
            m_isPinched = m_isPinched || ring != corner.ring ||
                          partedArea(outline.rings()[static_cast<std::size_t>(ring)], corner.vertex,
                                     edge, corner.at + *p) > kWasteArea;
        } else if (p && p->norm() < least - kSameLength) {
            least = p->norm();
            nearest = *p;
        }
    };
    outline.visitNear(corner.at, least, look);
    if (!nearest) {
        least = std::numeric_limits<double>::infinity();
        outline.visitNear(corner.at, least, look);
    }
    if (nearest) {
        m_cutter.focus(corner.at, kNextReach * least);
        addFrom({corner.ring, corner.vertex, 0.0, corner.at}, *nearest / least,
                SampleKind::Ligament);
    }
}

void SampleMaker::addLine(const CutLine &line, std::span<const OutlineCrossing> crossings)
{
    m_cutter.eachOf(line, crossings, [&](const LineCutter::Chords &chords, auto make) {
        m_found.clear();
        const int index = static_cast<int>(m_cuts.size());
        for (std::size_t i = 0; i < chords.size(); ++i) {
            const Neck neck = leaningNeck(m_shape, line, chords[i]);
            if (counts(neck) && neck.straight >= kGridStraight)
                m_found.push_back({SampleKind::Grid, index, static_cast<int>(i), neck});
        }
        if (m_found.empty())
            return;
        auto made = make();
        if (!made)
            return;
        for (CutSample &sample : m_found) {
            measure(m_shape, made->cut, sample.chord, sample.neck);
            m_samples.push_back(sample);
        }
        m_cuts.push_back(std::move(made->cut));
    });
}

void SampleMaker::addFrom(const OutlinePoint &point, const Vec2 &direction, SampleKind kind)
{
    const CutLine line{point.at, direction};
    if (auto found = point.share == 0.0 ? m_cutter.fromVertex(line, point.ring, point.edge, m_reach)
                                        : m_cutter.from(line, m_reach))
        addChord(*std::move(found), kind);
}

void SampleMaker::addChord(CutChord &&found, SampleKind kind)
{
    const Chord &chord = found.cut.chords[static_cast<std::size_t>(found.chord)];
    m_reach = kNextReach * chord.length();
    Neck neck = leaningNeck(m_shape, found.cut.line, chord);
    if (!counts(neck))
        return;
    measure(m_shape, found.cut, found.chord, neck);
    m_samples.push_back({kind, static_cast<int>(m_cuts.size()), found.chord, neck});
    m_cuts.push_back(std::move(found.cut));
}

/// What hangs on a neck is a piece of its own from so many mm² on; less is the end of a point.
constexpr double kPieceArea = 50.0;

bool isAtSlit(const PieceShape &shape, const Neck &neck)
{
    return shape.slitZones.any(
        [&neck](const Box2 &zone) {
            return std::min(distanceToBox(zone, neck.begin), distanceToBox(zone, neck.end)) <
                   kCornerReach;
        },
        [&](std::size_t i) {
            const SlitLine &slit = shape.slits[i];
            const Vec2 mouth = slit.root + slit.depth * slit.opening;
            const double reach = 0.5 * slit.width + kCornerReach;
            return std::min(distanceToSegment(neck.begin, slit.root, mouth),
                            distanceToSegment(neck.end, slit.root, mouth)) < reach;
        });
}

/// Of those that have nothing to do with slits. −1: there is none.
int thinnestOf(const PieceShape &shape, const std::vector<LineCut> &cuts,
               const std::vector<CutSample> &samples)
{
    int thinnest = -1;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Neck &neck = samples[i].neck;
        const LineCut &cut = cuts[static_cast<std::size_t>(samples[i].cut)];
        if (cut.chords.size() == 1 && std::min(cut.minus.area, cut.plus.area) >= kPieceArea &&
            (thinnest < 0 ||
             neck.length < samples[static_cast<std::size_t>(thinnest)].neck.length) &&
            !isAtSlit(shape, neck))
            thinnest = static_cast<int>(i);
    }
    return thinnest;
}

} // namespace

SectionCuts::SectionCuts(PieceShape shape, const SampleOptions &options) : m_shape(std::move(shape))
{
    m_spacing = std::max(options.spacing > 0.0 ? options.spacing
                                               : std::clamp(m_shape.size / 24.0, 1.0, 10.0),
                         m_shape.size / kMaxLines);
    if (m_shape.outline.isEmpty())
        return;
    // About as many as there will be: lists that grow are copied over and over.
    const std::size_t about =
        kUsualOfGrid + kOfSlit * m_shape.slits.size() + m_shape.corners.size();
    m_cuts.reserve(about);
    m_samples.reserve(about);
    SampleMaker maker(m_shape, m_spacing, m_cuts, m_samples);
    maker.addGrid(std::clamp(options.gridShift, 0.0, 1.0));
    for (std::size_t i = 0; i < m_shape.slits.size(); ++i)
        maker.addSlit(i);
    for (const ReentrantCorner &corner : m_shape.corners)
        maker.addLigament(corner);
    m_isPinched = maker.isPinched();
    m_cuts.shrink_to_fit(); // kept for as long as the piece is
    m_samples.shrink_to_fit();
    m_thinnest = thinnestOf(m_shape, m_cuts, m_samples);
}

} // namespace fff
