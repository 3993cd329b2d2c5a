#include "ui/base/cursors.h"

#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kSize = 28; // px
const QColor kInk(0x1b, 0x21, 0x27),
    kPaper(0xff, 0xff, 0xff); // seen on every ground, in both themes
const QColor kSlit(0xc2, 0x41, 0x0c);

void stroked(QPainter &painter, const QPainterPath &path, const QColor &colour, double width)
{
    painter.strokePath(path, QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

/// With a border of paper, 1 px wide.
void cased(QPainter &painter, const QPainterPath &path, const QColor &colour, double width)
{
    stroked(painter, path, kPaper, width + 2.0);
    stroked(painter, path, colour, width);
}

QPainterPath area(std::initializer_list<QPointF> corners)
{
    QPainterPath path;
    path.addPolygon(QPolygonF(corners));
    path.closeSubpath();
    return path;
}

/// Paper with an outline of ink, and a border of paper around that.
void body(QPainter &painter, const QPainterPath &path)
{
    stroked(painter, path, kPaper, 3.6);
    painter.fillPath(path, kPaper);
    stroked(painter, path, kInk, 1.6);
}

/// Ink with a border of paper.
void inked(QPainter &painter, const QPainterPath &path, double border)
{
    stroked(painter, path, kPaper, border);
    painter.fillPath(path, kInk);
}

/// Its tip is at (3, 25).
void pencil(QPainter &painter)
{
    body(painter, area({{3, 25}, {5, 19}, {18, 6}, {22, 10}, {9, 23}}));
    painter.fillPath(area({{3, 25}, {4, 22}, {6, 24}}), kInk);
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
    body(painter, area({{3, 25}, {7, 12}, {14, 8}, {20, 14}, {16, 21}}));
    inked(painter, area({{14, 8}, {17, 5}, {23, 11}, {20, 14}}), 3.6);
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
    inked(painter, area({{3, 3}, {3, 18}, {7, 14.5}, {9.5, 20}, {12, 19}, {9.5, 13.5}, {14, 13.5}}),
          2.6);
    QPainterPath plus;
    plus.moveTo(20, 16);
    plus.lineTo(20, 24);
    plus.moveTo(16, 20);
    plus.lineTo(24, 20);
    cased(painter, plus, kInk, 2.0);
}

struct Drawing
{
    QPoint tip;
    void (*shape)(QPainter &) = nullptr;
    void (*mark)(QPainter &) = nullptr;
};

Drawing drawingOf(Cursor cursor)
{
    const QPoint penTip(3, 25);
    switch (cursor) {
    case Cursor::PencilWithSlit:
        return {penTip, pencil, slitMark};
    case Cursor::PencilWithClock:
        return {penTip, pencil, clockMark};
    case Cursor::Pen:
        return {penTip, nib};
    case Cursor::PenCloses:
        return {penTip, nib, ringMark};
    case Cursor::TurningArrows:
        return {{14, 14}, turningArrows};
    case Cursor::ArrowWithPlus:
        return {{3, 3}, arrowWithPlus};
    default:
        return {penTip, pencil};
    }
}

QCursor drawn(Cursor cursor, double ratio)
{
    const int side = static_cast<int>(std::lround(kSize * ratio));
    QPixmap pixmap(side, side);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const Drawing drawing = drawingOf(cursor);
    drawing.shape(painter);
    if (drawing.mark)
        drawing.mark(painter);
    painter.end();
    return QCursor(pixmap, drawing.tip.x(), drawing.tip.y());
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
