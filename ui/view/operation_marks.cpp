#include "ui/view/operation_marks.h"

#include "core/session/operation_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kTrackWidth = 3.0;                 // px
constexpr double kRadius = 6.0, kHoveredRadius = 8; // px
constexpr double kChipOff = 14.0;                   // px, of a chip beside its handle

/// The track between two values; of what lies beside them a thin line.
QPainterPath partOf(const MarkPen &pen, const OperationMarks &marks, double from, double to)
{
    QPainterPath path(pen.screen(placeOnTrack(marks.track, from)));
    for (const auto &[at, value] : marks.track)
        if (value > from && value < to)
            path.lineTo(pen.screen(at));
    path.lineTo(pen.screen(placeOnTrack(marks.track, to)));
    return path;
}

} // namespace

void paintOperation(MarkPen &pen, const OperationMarks &marks, const OperationKind &kind)
{
    if (marks.handles.empty())
        return;
    QPainter &painter = pen.painter();
    painter.save();
    painter.setBrush(Qt::NoBrush);
    const QColor &colour = pen.style().made;
    double from = marks.handles.front().value, to = marks.handles.back().value;
    const double begin = marks.track.front().second, end = marks.track.back().second;
    painter.strokePath(partOf(pen, marks, begin, end), roundPen(faded(colour, 0.45), 1.4));
    QPainterPath range;
    if (from > to && marks.isRing()) { // on over the place where the track begins
        range = partOf(pen, marks, from, end);
        range.connectPath(partOf(pen, marks, begin, to));
    } else {
        if (from > to)
            std::swap(from, to);
        range = partOf(pen, marks, from, to);
    }
    pen.cased(range, roundPen(colour, kTrackWidth));
    QPointF middle;
    for (const OperationHandle &handle : marks.handles)
        middle += pen.screen(handle.at) / static_cast<double>(marks.handles.size());
    for (std::size_t i = 0; i < marks.handles.size(); ++i) {
        const OperationHandle &handle = marks.handles[i];
        const ParameterSpec *spec = kind.parameter(handle.key);
        if (!spec)
            continue;
        const QPointF at = pen.screen(handle.at);
        const bool grows = marks.hovered == static_cast<int>(i);
        const double radius = grows ? kHoveredRadius : kRadius;
        pen.ring(at, radius, colour);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colour);
        painter.drawEllipse(at, 0.4 * radius, 0.4 * radius);
        painter.setBrush(Qt::NoBrush);
        // Away from the other one, so that neither chip lies on the sections between them.
        const bool isLeft = at.x() < middle.x() || (at.x() == middle.x() && i == 0);
        pen.chip(at + QPointF(isLeft ? -kChipOff : kChipOff, -kChipOff),
                 isLeft ? MarkPen::Anchor::Right : MarkPen::Anchor::Left,
                 //: %1 is the name of a number ("From"), %2 its value
                 QCoreApplication::translate("fff::ui::OperationMarks", "%1 %2")
                     .arg(operationText(spec->label), valueText(*spec, handle.value)),
                 colour, MarkPen::Rank::InHand);
        pen.keepFree(QRectF(at, QSizeF()).adjusted(-radius, -radius, radius, radius));
    }
    painter.restore();
}

} // namespace fff::ui
