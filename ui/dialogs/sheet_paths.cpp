#include "ui/dialogs/sheet_paths.h"

#include "core/base/tolerances.h"
#include "core/fabrication/cutting_order.h"
#include "core/fabrication/joint_colours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fff::ui {

namespace {

QPointF pointOf(const Vec2 &p)
{
    return {p.x(), p.y()};
}

void appendLine(const CuttingLine &line, QPainterPath &path)
{
    path.moveTo(pointOf(line.start()));
    for (int i = 0; i < line.segmentCount(); ++i) {
        if (line.isStraight(i)) {
            path.lineTo(pointOf(line.end(i)));
        } else {
            const CubicBezier curve = line.segment(i);
            path.cubicTo(pointOf(curve.p1), pointOf(curve.p2), pointOf(curve.p3));
        }
    }
    if (line.isClosed())
        path.closeSubpath();
}

QPainterPath &pathFor(LineRole role, PartPaths &paths)
{
    switch (role) {
    case LineRole::Engrave:
        return paths.engraved;
    case LineRole::Score:
        return paths.scored;
    case LineRole::InnerCut:
    case LineRole::OuterCut:
        return paths.cuts;
    }
    return paths.cuts; // not reached: every role is above
}

double distanceTo(const QPointF &place, const QPointF &from, const QPointF &to)
{
    const QPointF way = to - from, there = place - from;
    const double length = QPointF::dotProduct(way, way);
    const double at =
        length > 0.0 ? std::clamp(QPointF::dotProduct(there, way) / length, 0.0, 1.0) : 0.0;
    const QPointF off = there - at * way;
    return std::hypot(off.x(), off.y());
}

/// Of a grid over its box the place inside that is farthest from every cut: a number is to be read
/// there, nothing is measured by it.
QPointF roomiestOf(const QPainterPath &cuts)
{
    constexpr int kGrid = 24;
    const QRectF box = cuts.boundingRect();
    const QList<QPolygonF> boundaries = cuts.toSubpathPolygons();
    QPointF best = box.center();
    double most = -1.0;
    for (int i = 0; i < kGrid * kGrid; ++i) {
        const QPointF place(box.left() + (i % kGrid + 0.5) / kGrid * box.width(),
                            box.top() + (i / kGrid + 0.5) / kGrid * box.height());
        double nearest = std::numeric_limits<double>::infinity();
        for (const QPolygonF &boundary : boundaries)
            for (qsizetype k = 0; k + 1 < boundary.size() && nearest > most; ++k)
                nearest = std::min(nearest, distanceTo(place, boundary[k], boundary[k + 1]));
        if (nearest > most && cuts.contains(place)) {
            most = nearest;
            best = place;
        }
    }
    return best;
}

void appendCuts(const ToolLine &line, QPainterPath &path)
{
    path.moveTo(pointOf(line.start()));
    for (const CubicBezier &curve : line.curves) {
        if (curve.isStraight(kClipGrid))
            path.lineTo(pointOf(curve.p3));
        else
            path.cubicTo(pointOf(curve.p1), pointOf(curve.p2), pointOf(curve.p3));
    }
    if (line.isClosed)
        path.closeSubpath();
}

/// The order says nothing here; what there is of each cut does.
void addFollowed(const CuttingSheet &sheet, SheetPaths &paths)
{
    for (const ToolLine &line : inCuttingOrder(sheet))
        if (line.purpose == Purpose::InnerCut || line.purpose == Purpose::OuterCut)
            appendCuts(line, paths.parts[line.part].followed);
}

void addLabel(const CuttingPart &part, const CuttingDrawing &drawing, PartPaths &paths)
{
    QPainterPath *path = &paths.label;
    int last = 0;
    part.forLabel([&](bool isFirst, const Vec2 &p, int joint) {
        if (isFirst && drawing.hasJointColours && joint != last) {
            path = joint == 0 ? &paths.label
                              : &paths.jointLabels
                                     .emplace_back(colourOf(Purpose::Number, joint, drawing),
                                                   QPainterPath())
                                     .second;
            last = joint;
        }
        if (isFirst)
            path->moveTo(pointOf(p));
        else
            path->lineTo(pointOf(p));
    });
}

PartPaths pathsOf(const CuttingPart &part, const CuttingDrawing &drawing)
{
    PartPaths paths;
    paths.number = part.number();
    paths.name = QString::fromStdString(part.name());
    part.forLines(
        [&paths](const CuttingLine &line) { appendLine(line, pathFor(line.role(), paths)); });
    addLabel(part, drawing, paths);
    paths.hasNumber = part.hasNumber();
    if (paths.hasNumber)
        paths.roomiest = roomiestOf(paths.cuts);
    return paths;
}

} // namespace

const QPainterPath &cutLines(const PartPaths &part)
{
    return part.followed.isEmpty() ? part.cuts : part.followed;
}

std::vector<SheetPaths> sheetPaths(const CuttingDrawing &drawing)
{
    std::vector<SheetPaths> sheets;
    for (const CuttingSheet &sheet : drawing.sheets) {
        SheetPaths &paths = sheets.emplace_back();
        paths.number = sheet.number;
        paths.size = {sheet.size.x(), sheet.size.y()};
        if (sheet.outline)
            for (const Polygon &ring : edgesOf(sheet)) {
                QPolygonF edge;
                for (const Vec2 &p : ring)
                    edge << pointOf(p);
                paths.outline.addPolygon(edge);
                paths.outline.closeSubpath();
            }
        paths.stock = sheet.stock;
        for (const CuttingPart &part : sheet.parts)
            paths.parts.push_back(pathsOf(part, drawing));
        if (!sheet.finish.isPlain())
            addFollowed(sheet, paths);
    }
    return sheets;
}

} // namespace fff::ui
