#include "ui/cursors.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <cmath>
#include <map>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kSize = 28; // px
const QColor kInk(0x1b, 0x21, 0x27),
    kPaper(0xff, 0xff, 0xff); // seen on every ground, in both themes
const QColor kSlit(0xc2, 0x41, 0x0c);

void cased(QPainter &painter, const QPainterPath &path, const QColor &colour, double width)
{
    painter.strokePath(path, QPen(kPaper, width + 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.strokePath(path, QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

/// Its tip is at (3, 25).
void pencil(QPainter &painter)
{
    QPainterPath body;
    body.moveTo(3, 25);
    body.lineTo(5, 19);
    body.lineTo(18, 6);
    body.lineTo(22, 10);
    body.lineTo(9, 23);
    body.closeSubpath();
    painter.strokePath(body, QPen(kPaper, 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(body, kPaper);
    painter.strokePath(body, QPen(kInk, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath tip;
    tip.moveTo(3, 25);
    tip.lineTo(4, 22);
    tip.lineTo(6, 24);
    tip.closeSubpath();
    painter.fillPath(tip, kInk);
}

void slitMark(QPainter &painter)
{
    QPainterPath line;
    line.moveTo(21, 17);
    line.lineTo(21, 25);
    cased(painter, line, kSlit, 3.0);
    // Where the slit would begin: at the tip, so that the view has nothing to draw for it.
    painter.setPen(QPen(kPaper, 1.2));
    painter.setBrush(kSlit);
    painter.drawEllipse(QPointF(3.6, 24.4), 3.0, 3.0);
}

void clockMark(QPainter &painter)
{
    painter.setPen(QPen(kInk, 1.5));
    painter.setBrush(kPaper);
    painter.drawEllipse(QPointF(20.5, 20.5), 5.5, 5.5);
    const QPointF hands[] = {{20.5, 17.5}, {20.5, 20.5}, {23.0, 20.5}};
    painter.drawPolyline(hands, 3);
}

/// A nib with its tip at (3, 25).
void nib(QPainter &painter)
{
    QPainterPath body;
    body.moveTo(3, 25);
    body.lineTo(7, 12);
    body.lineTo(14, 8);
    body.lineTo(20, 14);
    body.lineTo(16, 21);
    body.closeSubpath();
    painter.strokePath(body, QPen(kPaper, 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(body, kPaper);
    painter.strokePath(body, QPen(kInk, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath holder;
    holder.moveTo(14, 8);
    holder.lineTo(17, 5);
    holder.lineTo(23, 11);
    holder.lineTo(20, 14);
    holder.closeSubpath();
    painter.strokePath(holder, QPen(kPaper, 3.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(holder, kInk);
    painter.setPen(QPen(kInk, 1.3));
    painter.drawLine(QPointF(4.5, 23.5), QPointF(10.5, 17.5));
    painter.setBrush(kInk);
    painter.drawEllipse(QPointF(11.0, 17.0), 1.3, 1.3);
}

/// The path comes back to its start.
void ringMark(QPainter &painter)
{
    for (const QPen &pen : {QPen(kPaper, 4.0), QPen(kInk, 1.8)}) {
        painter.setPen(pen);
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QPointF(21.5, 22.0), 4.0, 4.0);
    }
}

/// Two arrows that run round the middle.
void turningArrows(QPainter &painter)
{
    for (int half = 0; half < 2; ++half) {
        painter.save();
        painter.translate(14, 14);
        painter.rotate(180.0 * half);
        QPainterPath path;
        path.arcMoveTo(QRectF(-8, -8, 16, 16), 25);
        path.arcTo(QRectF(-8, -8, 16, 16), 25, 130);
        const QPointF end = path.currentPosition();
        path.moveTo(end + QPointF(-0.5, -5.0));
        path.lineTo(end);
        path.lineTo(end + QPointF(5.0, -0.6));
        cased(painter, path, kInk, 1.8);
        painter.restore();
    }
}

/// Its tip is at (3, 3).
void arrowWithPlus(QPainter &painter)
{
    QPainterPath arrow;
    arrow.moveTo(3, 3);
    for (const QPointF &p : {QPointF(3, 18), QPointF(7, 14.5), QPointF(9.5, 20), QPointF(12, 19),
                             QPointF(9.5, 13.5), QPointF(14, 13.5)})
        arrow.lineTo(p);
    arrow.closeSubpath();
    painter.strokePath(arrow, QPen(kPaper, 2.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.fillPath(arrow, kInk);
    QPainterPath plus;
    plus.moveTo(20, 16);
    plus.lineTo(20, 24);
    plus.moveTo(16, 20);
    plus.lineTo(24, 20);
    cased(painter, plus, kInk, 2.0);
}

QCursor drawn(Cursor cursor, double ratio)
{
    QPixmap pixmap(static_cast<int>(std::lround(kSize * ratio)),
                   static_cast<int>(std::lround(kSize * ratio)));
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    if (cursor == Cursor::TurningArrows) {
        turningArrows(painter);
        painter.end();
        return QCursor(pixmap, 14, 14);
    }
    if (cursor == Cursor::ArrowWithPlus) {
        arrowWithPlus(painter);
        painter.end();
        return QCursor(pixmap, 3, 3);
    }
    const bool isPen = cursor == Cursor::Pen || cursor == Cursor::PenCloses;
    if (isPen)
        nib(painter);
    else
        pencil(painter);
    if (cursor == Cursor::PenCloses)
        ringMark(painter);
    if (cursor == Cursor::PencilWithSlit)
        slitMark(painter);
    if (cursor == Cursor::PencilWithClock)
        clockMark(painter);
    painter.end();
    return QCursor(pixmap, 3, 25);
}

} // namespace

QCursor cursorFor(Cursor cursor, double pixelRatio)
{
    if (cursor == Cursor::Arrow)
        return QCursor(Qt::ArrowCursor);
    if (cursor == Cursor::MoveCross)
        return QCursor(Qt::SizeAllCursor);
    if (cursor == Cursor::Hand)
        return QCursor(Qt::PointingHandCursor);
    static std::map<std::pair<Cursor, double>, QCursor> made;
    const auto key = std::pair(cursor, pixelRatio);
    const auto found = made.find(key);
    return found != made.end() ? found->second
                               : made.emplace(key, drawn(cursor, pixelRatio)).first->second;
}

} // namespace fff::ui
