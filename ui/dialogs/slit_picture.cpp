#include "ui/dialogs/slit_picture.h"

#include "ui/base/theme.h"
#include "ui/view/view_style.h"

#include <QPainter>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kHeight = 52, kLeastWidth = 120; // px
constexpr double kShareOfWidth = 0.45;         // that the other sheet takes
constexpr double kBottom = 14.0, kAbove = 8.0; // px, of material below the slit; of the guest
constexpr float kKerfAlpha = 0.35F, kGuestAlpha = 0.75F;

} // namespace

SlitPicture::SlitPicture(QWidget *parent) : QWidget(parent)
{
    setMinimumWidth(kLeastWidth);
    setFixedHeight(kHeight);
}

void SlitPicture::setStock(const Stock &stock)
{
    if (stock == m_stock)
        return;
    m_stock = stock;
    update();
}

void SlitPicture::paintEvent(QPaintEvent *)
{
    const double cut = std::max(m_stock.thickness + m_stock.clearance, 0.0);
    const double drawn = std::max(cut - m_stock.kerf, 0.0);
    const double scale = kShareOfWidth * width() / std::max({m_stock.thickness, cut, 1e-3});
    const double middle = 0.5 * width(), top = kAbove, bottom = height() - kBottom;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor face = stockLook(m_stock).face;
    // The sheet, of which what lies between the walls is gone.
    const QRectF slit(middle - 0.5 * scale * cut, top, scale * cut, bottom - top);
    painter.setPen(Qt::NoPen);
    painter.setBrush(face);
    painter.drawRect(QRectF(0.0, top, slit.left(), height() - top));
    painter.drawRect(QRectF(slit.right(), top, width() - slit.right(), height() - top));
    painter.drawRect(QRectF(slit.left(), bottom, slit.width(), height() - bottom));
    // The other sheet stands in it; where it presses it is wider than the slit.
    const double thick = scale * m_stock.thickness;
    QColor guest = face.darker(125);
    guest.setAlphaF(kGuestAlpha);
    painter.setBrush(guest);
    painter.drawRect(QRectF(middle - 0.5 * thick, 0.0, thick, bottom));
    // What the machine takes, about the lines that it follows.
    QColor kerf = theme().problem;
    const double half = 0.5 * scale * m_stock.kerf, left = middle - 0.5 * scale * drawn,
                 right = middle + 0.5 * scale * drawn, low = bottom - half;
    if (drawn > 0.0) {
        QPolygonF line{QPointF(left, top), QPointF(left, low), QPointF(right, low),
                       QPointF(right, top)};
        QColor band = kerf;
        band.setAlphaF(kKerfAlpha);
        QPen pen(band, std::max(2.0 * half, 1.0));
        pen.setJoinStyle(Qt::MiterJoin);
        pen.setCapStyle(Qt::FlatCap);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(pen);
        painter.drawPolyline(line);
        painter.setPen(QPen(kerf, 1.0));
        painter.drawPolyline(line);
    }
}

} // namespace fff::ui
