#include "ui/tour/tour_hint.h"

#include "ui/base/theme.h"
#include "ui/settings/settings.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr int kFrame = 33;                     // ms
constexpr int kMoving = 1800, kRound = 2600;   // ms: on its way, and with the rest behind it
constexpr int kRounds = 8;                     // until it is still
constexpr int kAround = 26, kRingAround = 8;   // px, of room for pointer and ring
constexpr double kLine = 3.0, kRingLine = 2.5; // px
constexpr double kPointer = 20.0;              // px

QPainterPath pointerAt(const QPointF &tip)
{
    QPainterPath path;
    path.addPolygon(QPolygonF{{0.0, 0.0},
                              {0.0, 1.0},
                              {0.27, 0.76},
                              {0.45, 1.14},
                              {0.6, 1.07},
                              {0.43, 0.71},
                              {0.74, 0.71}});
    path.closeSubpath();
    return QTransform::fromScale(kPointer, kPointer).map(path).translated(tip);
}

/// Its begin, of that share.
QPolygonF partOf(const QPolygonF &way, double share)
{
    double length = 0.0;
    for (int i = 1; i < way.size(); ++i)
        length += QLineF(way[i - 1], way[i]).length();
    QPolygonF part{way.front()};
    double left = share * length;
    for (int i = 1; i < way.size() && left > 0.0; ++i) {
        const QLineF line(way[i - 1], way[i]);
        part += line.length() <= left ? line.p2() : line.pointAt(left / line.length());
        left -= line.length();
    }
    return part;
}

} // namespace

TourHint::TourHint(QWidget *window) : QWidget(window)
{
    setObjectName(QStringLiteral("tourHint"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    m_frames.setInterval(kFrame);
    connect(&m_frames, &QTimer::timeout, this, [this] {
        if (m_since.elapsed() > kRounds * kRound)
            m_frames.stop();
        update();
    });
    hide();
}

void TourHint::showWay(const QPolygonF &way)
{
    if (way.size() >= 2)
        begin(way, {});
    else
        showNothing();
}

void TourHint::showRing(const QRect &around)
{
    begin({}, around);
}

void TourHint::showNothing()
{
    hide();
    m_frames.stop();
}

void TourHint::begin(const QPolygonF &way, const QRect &ring)
{
    if (!isHidden() && way == m_way && ring == m_ring)
        return;
    m_way = way;
    m_ring = ring;
    const QRect box =
        way.isEmpty()
            ? ring.adjusted(-kRingAround, -kRingAround, kRingAround, kRingAround)
            : way.boundingRect().toAlignedRect().adjusted(-kAround, -kAround, kAround, kAround);
    setGeometry(box);
    m_since.start();
    if (settings().reducesMotion())
        m_frames.stop();
    else
        m_frames.start();
    show();
    raise();
    update();
}

/// Of a round, how far it has come; 1 when it is still.
double TourHint::share() const
{
    if (!m_frames.isActive())
        return 1.0;
    return static_cast<double>(m_since.elapsed() % kRound) / kMoving;
}

void TourHint::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(-pos());
    if (m_way.isEmpty())
        paintRing(painter);
    else
        paintWay(painter);
}

void TourHint::paintWay(QPainter &painter) const
{
    const double now = std::min(1.0, share());
    // As a hand does: slow at both ends.
    const QPolygonF done = partOf(m_way, 0.5 - 0.5 * std::cos(3.14159265358979 * now));
    QColor colour = theme().accent;
    painter.setPen(QPen(colour, kLine, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(done);
    painter.setBrush(colour);
    painter.drawEllipse(m_way.front(), kLine, kLine);
    if (const double rest = share() - 1.0; rest > 0.0 && m_frames.isActive()) {
        // The button is still down.
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour, 2.0));
        painter.drawEllipse(done.back(), 4.0 + 24.0 * rest, 4.0 + 24.0 * rest);
    }
    painter.setPen(QPen(theme().panel, 1.5));
    painter.setBrush(theme().text);
    painter.drawPath(pointerAt(done.back()));
}

void TourHint::paintRing(QPainter &painter) const
{
    const double wave =
        m_frames.isActive() ? 0.5 - 0.5 * std::cos(6.28318530717959 * share()) : 0.5;
    const double out = 1.0 + (kRingAround - kRingLine - 1.0) * wave;
    QColor colour = theme().accent;
    colour.setAlphaF(static_cast<float>(1.0 - 0.4 * wave));
    painter.setPen(QPen(colour, kRingLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(m_ring).adjusted(-out, -out, out, out), 6.0, 6.0);
}

} // namespace fff::ui
