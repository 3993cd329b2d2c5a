#include "ui/dialogs/sheet_view.h"

#include "ui/base/theme.h"
#include "ui/dialogs/sheet_painting.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace fff::ui {

namespace {

constexpr double kAround = 14.0;   // px, round the sheet
constexpr double kMostZoom = 60.0; // of what fits
constexpr double kZoomStep = 1.25; // of a key; and of a notch of the wheel
constexpr double kPanStep = 40.0;  // px
constexpr double kOlderOpacity = 0.4;
constexpr int kNotch = 120; // of a wheel, eighths of a degree

} // namespace

SheetView::SheetView(QWidget *parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("sheetView"));
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Sheet, as it will be cut"));
    setAccessibleDescription(tr("Plus and minus zoom, the arrow keys move it, Home shows all of "
                                "it."));
}

void SheetView::setContent(const Content &content)
{
    const auto sizeOf = [](const Content &of) {
        return of.sheet ? std::pair(of.sheet->number, of.sheet->size) : std::pair(0, QSizeF());
    };
    const bool isOther = sizeOf(content) != sizeOf(m_content);
    m_content = content;
    m_hovered = -1;
    if (isOther)
        fit();
    drawAgain();
}

void SheetView::fit()
{
    const bool wasFitted = isFitted();
    m_zoom = 1.0;
    m_shift = {};
    drawAgain();
    if (!wasFitted)
        Q_EMIT fittedChanged();
}

QRectF SheetView::room() const
{
    const double above = m_content.caption.isEmpty() ? kAround : fontMetrics().height() + 14.0;
    return QRectF(rect()).adjusted(kAround, above, -kAround, -kAround);
}

QRectF SheetView::extent() const
{
    const QRectF sheet(QPointF(), m_content.sheet->size);
    return m_content.hasReference ? sheet.united(referenceBar()) : sheet;
}

double SheetView::fittingScale() const
{
    const QRectF room = this->room(), extent = this->extent();
    return std::max(0.0, std::min(room.width() / extent.width(), room.height() / extent.height()));
}

QTransform SheetView::transform() const
{
    if (!m_content.sheet)
        return {};
    const double scale = m_zoom * fittingScale();
    const QPointF from = extent().center(), to = room().center() + m_shift;
    QTransform transform;
    transform.translate(to.x(), to.y());
    transform.scale(scale, -scale); // y is up on a sheet
    transform.translate(-from.x(), -from.y());
    return transform;
}

int SheetView::partAt(const QPointF &place) const
{
    if (!m_content.sheet || m_content.isOlder)
        return -1;
    const QPointF onSheet = transform().inverted().map(place);
    const std::vector<PartPaths> &parts = m_content.sheet->parts;
    // What lies in a hole of another part is drawn later, or has that hole round it.
    const auto found = std::find_if(parts.rbegin(), parts.rend(), [&](const PartPaths &part) {
        return part.cuts.contains(onSheet);
    });
    return found == parts.rend() ? -1 : static_cast<int>(parts.rend() - found) - 1;
}

void SheetView::zoomAt(const QPointF &place, double factor)
{
    if (!m_content.sheet)
        return;
    const double zoom = std::clamp(m_zoom * factor, 1.0, kMostZoom);
    if (zoom == 1.0) {
        fit();
        return;
    }
    const bool wasFitted = isFitted();
    // What is under the cursor stays there.
    const QPointF from = place - room().center() - m_shift;
    m_shift += from * (1.0 - zoom / m_zoom);
    m_zoom = zoom;
    moveBy({});
    if (wasFitted)
        Q_EMIT fittedChanged();
}

/// The sheet's middle stays within half of itself from the view's.
void SheetView::moveBy(const QPointF &way)
{
    if (!m_content.sheet || isFitted())
        return;
    const QSizeF half = extent().size() * (0.5 * m_zoom * fittingScale());
    m_shift += way;
    m_shift = {std::clamp(m_shift.x(), -half.width(), half.width()),
               std::clamp(m_shift.y(), -half.height(), half.height())};
    drawAgain();
}

void SheetView::setHovered(int part)
{
    if (std::exchange(m_hovered, part) != part)
        update();
}

void SheetView::drawAgain()
{
    m_picture = {};
    update();
}

void SheetView::paintEvent(QPaintEvent *)
{
    const SheetPainting how{transform(), m_content.margin, m_content.hasReference};
    if (m_picture.isNull()) {
        m_picture = QPixmap(size() * devicePixelRatioF());
        m_picture.setDevicePixelRatio(devicePixelRatioF());
        m_picture.fill(theme().viewStyle().bottom);
        QPainter painter(&m_picture);
        painter.setFont(font());
        if (m_content.sheet) {
            painter.setOpacity(m_content.isOlder ? kOlderOpacity : 1.0);
            paintSheet(*m_content.sheet, how, painter);
            painter.setOpacity(1.0);
        }
    }
    QPainter painter(this);
    painter.drawPixmap(0, 0, m_picture);
    painter.setPen(theme().muted);
    if (!m_content.caption.isEmpty()) {
        const QRectF line(kAround, 4.0, width() - 2.0 * kAround, fontMetrics().height() + 4.0);
        painter.fillRect(QRectF(0.0, 0.0, width(), line.bottom() + 2.0),
                         theme().viewStyle().bottom);
        painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(m_content.caption, Qt::ElideRight,
                                                  static_cast<int>(line.width())));
    }
    if (m_content.sheet && m_hovered >= 0)
        paintHovered(m_content.sheet->parts[static_cast<std::size_t>(m_hovered)], how, painter);
    if (!m_content.note.isEmpty())
        painter.drawText(QRectF(rect()).adjusted(24, 24, -24, -24),
                         Qt::AlignCenter | Qt::TextWordWrap, m_content.note);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hasFocus() ? QPen(theme().accent, 2.0) : QPen(theme().strong, 1.0));
    const double inset = hasFocus() ? 1.0 : 0.5;
    painter.drawRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset));
}

void SheetView::wheelEvent(QWheelEvent *event)
{
    const double notches = static_cast<double>(event->angleDelta().y()) / kNotch;
    zoomAt(event->position(), std::pow(kZoomStep, notches));
    event->accept(); // the panel beside it does not scroll
}

void SheetView::mousePressEvent(QMouseEvent *event)
{
    m_isDragged = event->button() == Qt::LeftButton || event->button() == Qt::MiddleButton;
    m_pressed = event->position();
    if (m_isDragged && !isFitted())
        setCursor(Qt::ClosedHandCursor);
}

void SheetView::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isDragged) {
        moveBy(event->position() - m_pressed);
        m_pressed = event->position();
    } else {
        setHovered(partAt(event->position()));
    }
}

void SheetView::mouseReleaseEvent(QMouseEvent *)
{
    m_isDragged = false;
    unsetCursor();
}

void SheetView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (isFitted())
        zoomAt(event->position(), kZoomStep * kZoomStep * kZoomStep * kZoomStep);
    else
        fit();
}

void SheetView::leaveEvent(QEvent *)
{
    setHovered(-1);
}

void SheetView::keyPressEvent(QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Home:
        return fit();
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoomAt(room().center(), kZoomStep);
    case Qt::Key_Minus:
        return zoomAt(room().center(), 1.0 / kZoomStep);
    case Qt::Key_Left:
        return moveBy({kPanStep, 0.0});
    case Qt::Key_Right:
        return moveBy({-kPanStep, 0.0});
    case Qt::Key_Up:
        return moveBy({0.0, kPanStep});
    case Qt::Key_Down:
        return moveBy({0.0, -kPanStep});
    default:
        QWidget::keyPressEvent(event);
    }
}

void SheetView::resizeEvent(QResizeEvent *)
{
    drawAgain();
}

void SheetView::changeEvent(QEvent *event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
        drawAgain();
    QWidget::changeEvent(event);
}

bool SheetView::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        const int part = partAt(help->pos());
        QString tip;
        if (part >= 0) {
            const PartPaths &paths = m_content.sheet->parts[static_cast<std::size_t>(part)];
            //: a part on a sheet: its number, and its section's name
            tip = tr("%1  %2").arg(QString::number(paths.number), paths.name).toHtmlEscaped();
        }
        QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace fff::ui
