#include "core/fabrication/cutting_order.h"

#include "core/fabrication/opened_cuts.h"
#include "core/geometry/arc_fit.h"
#include "core/geometry/point_tree.h"
#include "core/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace fff {

namespace {

/// Appends a curve to a line, unless it has no length that could be written.
void addCurve(CubicBezier curve, bool isStraight, ToolLine &line)
{
    if (!line.curves.empty())
        curve.p0 = line.end();
    if (isStraight) {
        if ((curve.p3 - curve.p0).cwiseAbs().maxCoeff() <= kClipGrid)
            return;
        curve = CubicBezier::line(curve.p0, curve.p3);
    }
    line.curves.push_back(curve);
}

/// Where what closes it was too short to be a curve of its own.
void endWhereItStarts(ToolLine &line)
{
    CubicBezier &last = line.curves.back();
    if (last.p3 == line.start())
        return;
    last = last.isStraight(2.0 * kClipGrid) ? CubicBezier::line(last.p0, line.start())
                                            : CubicBezier{last.p0, last.p1, last.p2, line.start()};
}

void addLine(ToolLine line, std::vector<ToolLine> &lines)
{
    if (line.curves.empty())
        return;
    if (line.isClosed)
        endWhereItStarts(line);
    lines.push_back(std::move(line));
}

void addLabel(const CuttingPart &part, std::size_t index, std::vector<ToolLine> &lines)
{
    ToolLine stroke{Purpose::Number, index, {}, false};
    Vec2 at = Vec2::Zero();
    part.forLabel([&](bool isFirst, const Vec2 &p, int joint) {
        if (isFirst)
            addLine(std::exchange(stroke, ToolLine{Purpose::Number, index, {}, false, joint}),
                    lines);
        else
            addCurve(CubicBezier::line(at, p), true, stroke);
        at = p;
    });
    addLine(std::move(stroke), lines);
}

bool isCut(const ToolLine &line)
{
    return line.purpose == Purpose::InnerCut || line.purpose == Purpose::OuterCut;
}

Polygon polygonOf(const ToolLine &line)
{
    Polygon polygon;
    for (const CubicBezier &curve : line.curves) {
        const int count = curve.isStraight(2.0 * kClipGrid) ? 1 : curve.chordCount(kDrawChord);
        for (int i = 0; i < count; ++i)
            polygon.push_back(curve.at(static_cast<double>(i) / count));
    }
    return polygon;
}

/// In how many holes of other parts each part lies.
std::vector<int> depthsOf(const CuttingSheet &sheet, const std::vector<ToolLine> &lines)
{
    std::vector<int> depths(sheet.parts.size(), 0);
    // Of each part a point, from left to right.
    std::vector<std::pair<Vec2, std::size_t>> places;
    for (const ToolLine &line : lines)
        if (line.purpose == Purpose::OuterCut)
            places.emplace_back(line.start(), line.part);
    std::sort(places.begin(), places.end(), [](const auto &a, const auto &b) {
        return a.first.x() != b.first.x() ? a.first.x() < b.first.x() : a.second < b.second;
    });
    for (const ToolLine &line : lines) {
        if (line.purpose != Purpose::InnerCut)
            continue;
        const Polygon hole = polygonOf(line);
        const Box2 box = bounds(hole);
        auto place = std::lower_bound(places.begin(), places.end(), box.min.x(),
                                      [](const auto &one, double x) { return one.first.x() < x; });
        for (; place != places.end() && place->first.x() <= box.max.x(); ++place)
            if (place->second != line.part && box.contains(place->first) &&
                locate(place->first, hole) == Side::Inside)
                ++depths[place->second];
    }
    return depths;
}

/// Lines of a lower rank come first.
int rankOf(const ToolLine &line, const std::vector<int> &depths)
{
    switch (line.purpose) {
    case Purpose::Guide:
    case Purpose::Engrave:
    case Purpose::Number:
        return -1'000'000'001;
    case Purpose::Score:
        return -1'000'000'000;
    case Purpose::InnerCut:
        return -2 * depths[line.part] - 1;
    case Purpose::OuterCut:
        return -2 * depths[line.part];
    }
    return 0; // not reached: every purpose is above
}

using GridPoint = std::pair<std::int64_t, std::int64_t>;

/// The points of a line on the grid that all is written on, in an order that does not tell where it
/// starts, nor which way it runs.
std::vector<GridPoint> signOf(const ToolLine &line)
{
    std::vector<GridPoint> points;
    const auto add = [&points](const Vec2 &p) {
        points.emplace_back(std::llround(p.x() / kClipGrid), std::llround(p.y() / kClipGrid));
    };
    for (const CubicBezier &curve : line.curves)
        for (const Vec2 &p : {curve.p0, curve.p1, curve.p2, curve.p3})
            add(p);
    std::sort(points.begin(), points.end());
    return points;
}

std::uint64_t hashOf(const ToolLine &line)
{
    // The handles' sum is the same from either end, and wherever it starts.
    std::int64_t x = 0, y = 0;
    for (const CubicBezier &curve : line.curves)
        for (const Vec2 &p : {curve.p1, curve.p2}) {
            x += std::llround(p.x() / kClipGrid);
            y += std::llround(p.y() / kClipGrid);
        }
    return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^ static_cast<std::uint64_t>(y);
}

/// Remembers what was followed already.
class Followed
{
public:
    /// Whether no such line was there before: one that is cut, or one of its purpose.
    bool isNew(const ToolLine &line)
    {
        std::vector<const ToolLine *> &alike = m_known[hashOf(line)];
        for (const ToolLine *other : alike)
            if ((other->purpose == line.purpose || (isCut(*other) && isCut(line))) &&
                other->curves.size() == line.curves.size() && signOf(*other) == signOf(line))
                return false;
        alike.push_back(&line);
        return true;
    }

private:
    std::unordered_map<std::uint64_t, std::vector<const ToolLine *>> m_known;
};

void reverse(ToolLine &line)
{
    std::reverse(line.curves.begin(), line.curves.end());
    for (CubicBezier &curve : line.curves)
        curve = curve.reversed();
}

/// By what is followed first, none twice.
std::map<int, std::vector<ToolLine *>> rankedOnce(std::vector<ToolLine> &lines,
                                                  const std::vector<int> &depths)
{
    std::map<int, std::vector<ToolLine *>> ranks;
    for (ToolLine &line : lines)
        ranks[rankOf(line, depths)].push_back(&line);
    Followed followed;
    for (auto &[rank, some] : ranks)
        std::erase_if(some, [&](const ToolLine *line) { return !followed.isNew(*line); });
    return ranks;
}

std::vector<const ToolLine *> cutsOf(const std::map<int, std::vector<ToolLine *>> &ranks)
{
    std::vector<const ToolLine *> cuts;
    for (const auto &[rank, some] : ranks)
        std::copy_if(some.begin(), some.end(), std::back_inserter(cuts),
                     [](const ToolLine *line) { return isCut(*line); });
    return cuts;
}

/// In place of each cut what is followed of it; these are kept in `opened`.
void openCuts(const CuttingSheet &sheet, std::map<int, std::vector<ToolLine *>> &ranks,
              std::vector<std::vector<ToolLine>> &opened)
{
    opened = openedCuts(cutsOf(ranks), sheet);
    std::size_t next = 0;
    for (auto &[rank, some] : ranks) {
        std::vector<ToolLine *> all;
        for (ToolLine *line : some) {
            if (!isCut(*line)) {
                all.push_back(line);
                continue;
            }
            for (ToolLine &piece : opened[next++])
                all.push_back(&piece);
        }
        some = std::move(all);
    }
}

/// Moves the lines behind the others, nearest next; `at` is where the tool is, and will be.
void addNearestNext(std::vector<ToolLine *> lines, Vec2 &at, std::vector<ToolLine> &ordered)
{
    std::vector<Vec2> ends; // two of each line
    for (const ToolLine *line : lines) {
        ends.push_back(line->start());
        ends.push_back(line->end());
    }
    PointTree tree(ends);
    for (int end = tree.nearest(at); end >= 0; end = tree.nearest(at)) {
        tree.remove(end);
        tree.remove(end ^ 1);
        ToolLine &line = *lines[static_cast<std::size_t>(end / 2)];
        if (end % 2 == 1 && !line.isClosed)
            reverse(line);
        at = line.end();
        ordered.push_back(std::move(line));
    }
}

} // namespace

std::vector<ToolLine> toolLines(const CuttingSheet &sheet)
{
    std::vector<ToolLine> lines;
    for (std::size_t i = 0; i < sheet.parts.size(); ++i) {
        addLabel(sheet.parts[i], i, lines);
        sheet.parts[i].forLines([&](const CuttingLine &drawn) {
            ToolLine line{purposeOf(drawn.role()), i, {}, drawn.isClosed()};
            line.curves.reserve(static_cast<std::size_t>(drawn.segmentCount()));
            for (int k = 0; k < drawn.segmentCount(); ++k)
                addCurve(drawn.segment(k), drawn.isStraight(k), line);
            addLine(std::move(line), lines);
        });
    }
    return lines;
}

std::vector<ToolLine> inCuttingOrder(const CuttingSheet &sheet, const Vec2 &from)
{
    std::vector<ToolLine> lines = toolLines(sheet);
    const std::vector<int> depths = depthsOf(sheet, lines);
    std::map<int, std::vector<ToolLine *>> ranks = rankedOnce(lines, depths);
    std::vector<std::vector<ToolLine>> opened;
    if (!sheet.finish.isPlain())
        openCuts(sheet, ranks, opened);
    std::vector<ToolLine> ordered;
    ordered.reserve(lines.size());
    Vec2 at = from;
    for (auto &[rank, some] : ranks)
        addNearestNext(std::move(some), at, ordered);
    return ordered;
}

std::vector<std::size_t> partsWithoutLead(const CuttingSheet &sheet)
{
    std::vector<ToolLine> lines = toolLines(sheet);
    const auto ranks = rankedOnce(lines, depthsOf(sheet, lines));
    const std::vector<const ToolLine *> cuts = cutsOf(ranks);
    std::set<std::size_t> parts;
    for (const std::size_t index : cutsWithoutLead(cuts, sheet))
        parts.insert(cuts[index]->part);
    return {parts.begin(), parts.end()};
}

double lengthOf(const ToolLine &line)
{
    constexpr double kLengthError = 1e-4; // mm, of arcs from curves: their lengths differ far less
    double length = 0.0;
    std::vector<ArcStep> steps;
    for (const CubicBezier &curve : line.curves) {
        if (curve.isStraight(2.0 * kClipGrid)) {
            length += (curve.p3 - curve.p0).norm();
            continue;
        }
        steps.clear();
        appendArcs(curve, kLengthError, steps);
        length += ArcPath{curve.p0, steps, false}.length();
    }
    return length;
}

ToolWay &ToolWay::operator+=(const ToolWay &other)
{
    engraved += other.engraved;
    scored += other.scored;
    cut += other.cut;
    travel += other.travel;
    seconds += other.seconds;
    return *this;
}

ToolWay wayAlong(const std::vector<ToolLine> &lines, const Machine &machine, const Vec2 &from)
{
    ToolWay way;
    Vec2 at = from;
    for (const ToolLine &line : lines) {
        const double before = (line.start() - at).norm(), length = lengthOf(line);
        way.travel += before;
        (isCut(line)                      ? way.cut
         : line.purpose == Purpose::Score ? way.scored
                                          : way.engraved) += length;
        way.seconds += before / machine.travel + length / machine.of(line.purpose).speed;
        at = line.end();
    }
    return way;
}

} // namespace fff
