// What a round tool that follows the cuts of a file leaves of a part: by Clipper, in whole
// nanometres, from the part as it was designed and the file alone.
#pragma once

#include "tests/core/fabrication/swept_disc_oracle.h"
#include "tests/core/io/cut_readers.h"

#include <QString>
#include <polyclipping/clipper.hpp>

#include <cmath>
#include <vector>

namespace fff::test {

class SweptFileOracle
{
public:
    static constexpr double kMayEnter = 0.005; // mm
    static constexpr double kChord = 0.0004;   // mm, of outlines

    /// part   as designed, in its own coordinates; turn and shift put it on its sheet
    /// radius mm, of the tool
    SweptFileOracle(const CurvedRegion &part, const Vec2 &turn, const Vec2 &shift, double radius)
        : m_radius(radius)
    {
        addRing(part.outer, turn, shift, true);
        for (const Contour &hole : part.holes)
            addRing(hole, turn, shift, false);
        m_box = boxOf(m_part);
        // What the tool cannot reach from outside, or from within a hole, is filled up first.
        const Paths filled = offset(offset(m_part, m_radius + kReach), -(m_radius + kReach));
        m_edge = less(offset(filled, kEdge), offset(filled, -kEdge));
    }

    /// Empty, or what is wrong with those of the cuts that come near.
    QString verdict(const std::vector<ReadCut> &cuts) const
    {
        const std::vector<const ReadCut *> near = nearCuts(cuts);
        if (near.empty())
            return QStringLiteral("nothing is cut here");
        if (m_radius > kMayEnter)
            if (const QString bite = firstOf(both(m_part, swept(near, m_radius - kMayEnter)));
                !bite.isEmpty())
                return QStringLiteral("the tool enters the part at ") + bite;
        if (const QString rest = firstOf(less(m_edge, swept(near, m_radius + kMayEnter)));
            !rest.isEmpty())
            return QStringLiteral("the tool does not come to the part at ") + rest;
        return {};
    }

private:
    using Paths = ClipperLib::Paths;
    static constexpr double kUnit = 1e6;     // a mm
    static constexpr double kArc = 0.0004;   // mm, of round offsets
    static constexpr double kReach = 0.0015; // mm of room that a tool needs around it to get in
    static constexpr double kEdge = 0.0005;  // mm, half the width of what stands for an edge
    static constexpr double kSliver = 1e-4;  // mm², of what rounding leaves: 0.01 mm square

    static ClipperLib::IntPoint whole(const Vec2 &p)
    {
        return {std::llround(kUnit * p.x()), std::llround(kUnit * p.y())};
    }
    void addRing(const Contour &contour, const Vec2 &turn, const Vec2 &shift, bool isOuter)
    {
        ClipperLib::Path ring;
        for (const Vec2 &p : ChordBuckets::chordsOf(contour, kChord))
            ring.push_back(whole(
                Vec2(turn.x() * p.x() - turn.y() * p.y(), turn.y() * p.x() + turn.x() * p.y()) +
                shift));
        if (ClipperLib::Orientation(ring) != isOuter)
            ClipperLib::ReversePath(ring);
        m_part.push_back(std::move(ring));
    }

    struct Box
    {
        double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
        void extend(double x, double y)
        {
            left = std::min(left, x), right = std::max(right, x);
            low = std::min(low, y), high = std::max(high, y);
        }
    };
    static Box boxOf(const Paths &paths)
    {
        Box box;
        for (const ClipperLib::Path &path : paths)
            for (const ClipperLib::IntPoint &p : path)
                box.extend(double(p.X) / kUnit, double(p.Y) / kUnit);
        return box;
    }
    std::vector<const ReadCut *> nearCuts(const std::vector<ReadCut> &cuts) const
    {
        std::vector<const ReadCut *> near;
        const double room = 2.0 * m_radius;
        for (const ReadCut &cut : cuts) {
            Box box;
            for (const Vec2 &p : cut.points)
                box.extend(p.x(), p.y());
            if (box.left <= m_box.right + room && box.right >= m_box.left - room &&
                box.low <= m_box.high + room && box.high >= m_box.low - room)
                near.push_back(&cut);
        }
        return near;
    }

    static Paths swept(const std::vector<const ReadCut *> &cuts, double radius)
    {
        ClipperLib::ClipperOffset sweep(2.0, kUnit * kArc);
        for (const ReadCut *cut : cuts) {
            ClipperLib::Path path;
            for (const Vec2 &p : cut->points)
                path.push_back(whole(p));
            sweep.AddPath(path, ClipperLib::jtRound,
                          cut->isClosed ? ClipperLib::etClosedLine : ClipperLib::etOpenRound);
        }
        Paths area;
        sweep.Execute(area, kUnit * radius);
        return area;
    }
    static Paths offset(const Paths &paths, double by)
    {
        ClipperLib::ClipperOffset grow(2.0, kUnit * kArc);
        grow.AddPaths(paths, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
        Paths grown;
        grow.Execute(grown, kUnit * by);
        return grown;
    }
    static Paths combined(ClipperLib::ClipType type, const Paths &a, const Paths &b)
    {
        ClipperLib::Clipper clipper;
        clipper.AddPaths(a, ClipperLib::ptSubject, true);
        clipper.AddPaths(b, ClipperLib::ptClip, true);
        Paths result;
        clipper.Execute(type, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
        return result;
    }
    static Paths both(const Paths &a, const Paths &b)
    {
        return combined(ClipperLib::ctIntersection, a, b);
    }
    static Paths less(const Paths &a, const Paths &b)
    {
        return combined(ClipperLib::ctDifference, a, b);
    }
    static QString firstOf(const Paths &paths)
    {
        for (const ClipperLib::Path &path : paths)
            if (std::abs(ClipperLib::Area(path)) > kSliver * kUnit * kUnit)
                return QStringLiteral("%1, %2 (%3 mm²)")
                    .arg(double(path.front().X) / kUnit, 0, 'f', 4)
                    .arg(double(path.front().Y) / kUnit, 0, 'f', 4)
                    .arg(std::abs(ClipperLib::Area(path)) / (kUnit * kUnit), 0, 'g', 3);
        return {};
    }

    double m_radius;
    Paths m_part, m_edge; // the edge is a strip along it
    Box m_box;
};

} // namespace fff::test
