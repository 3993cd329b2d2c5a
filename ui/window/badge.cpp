#include "ui/window/badge.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"
#include "ui/bench/check_words.h"
#include "ui/settings/settings.h"
#include "ui/view/heading_weight.h"

#include <QPainter>
#include <QPainterPath>

namespace fff::ui {

namespace {

constexpr int kHeight = 27, kGlyph = 16, kMargin = 11, kGap = 7; // px
constexpr int kFillTime = 150;                                   // ms

} // namespace

Badge::Badge(QWidget *parent) : QAbstractButton(parent)
{
    setFocusPolicy(Qt::TabFocus); // a click leaves the focus where the hand draws
    setAttribute(Qt::WA_Hover);
    setCursor(Qt::ArrowCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    m_fill.setStartValue(0.0);
    m_fill.setEndValue(1.0);
    connect(&m_fill, &QVariantAnimation::valueChanged, this, [this] { update(); });
}

void Badge::setContent(const Content &content)
{
    if (content == m_content)
        return;
    const bool turnsBad =
        content.severity == Severity::Error && m_content.severity != Severity::Error && isVisible();
    const bool isResized = content.title != m_content.title;
    m_content = content;
    setAccessibleName(content.title);
    setAccessibleDescription(severityWord(content.severity) + QStringLiteral(". ") +
                             (content.isOlder ? tr("Older than the drawing") : content.sentence));
    setToolTip(content.isOlder ? tr("%1: older than the drawing").arg(content.title)
                               : content.sentence);
    m_fill.stop();
    const int time = settings().animationTime(kFillTime);
    if (turnsBad && time > 0) {
        m_fill.setDuration(time);
        m_fill.start();
    }
    if (isResized)
        updateGeometry();
    update();
}

void Badge::setFolded(bool isFolded)
{
    if (isFolded == m_isFolded)
        return;
    m_isFolded = isFolded;
    updateGeometry();
    update();
}

QFont Badge::words() const
{
    QFont f = font();
    if (m_content.severity == Severity::Error)
        f.setWeight(headingWeight());
    f.setItalic(m_content.isOlder);
    return f;
}

QSize Badge::sizeHint() const
{
    return {widthWhen(m_isFolded), kHeight};
}

int Badge::widthWhen(bool isFolded) const
{
    if (isFolded)
        return kGlyph + 2 * 8;
    QFont widest = font(); // so that turning bad moves no neighbour
    widest.setWeight(headingWeight());
    return kMargin + kGlyph + kGap + QFontMetrics(widest).horizontalAdvance(m_content.title) +
           kMargin + 2;
}

void Badge::paintEvent(QPaintEvent *)
{
    const Theme &t = theme();
    const bool isBad = m_content.severity == Severity::Error && !m_content.isOlder;
    const double filled =
        m_fill.state() == QAbstractAnimation::Running ? m_fill.currentValue().toDouble() : 1.0;
    // On red, white reads in both themes; the dark theme's red is too light for it.
    const QColor red = t.isHighContrast ? QColor(0x8c, 0x0d, 0x0d)
                       : t.isDark       ? QColor(0xb3, 0x26, 0x1e)
                                        : t.problem;

    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF pill = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    const double radius = pill.height() / 2.0;
    QColor border = m_content.severity == Severity::Warning ? t.warning : t.border;
    if (isBad)
        border = red;
    if (hasFocus())
        border = t.accent;
    QPainterPath path;
    path.addRoundedRect(pill, radius, radius);
    painter.fillPath(path, underMouse() && !isBad ? t.hover : t.panel);
    if (isBad) {
        painter.save();
        painter.setClipRect(QRectF(0, 0, width() * filled, height()));
        painter.fillPath(path, red);
        painter.restore();
    }
    QPen pen(border, hasFocus()                                         ? 2.0
                     : isBad || m_content.severity == Severity::Warning ? 1.3
                                                                        : 1.0);
    if (m_content.isProvisional) {
        pen.setDashPattern({4.0, 3.0});
        pen.setColor(isBad ? QColor(0xff, 0xff, 0xff) : t.muted);
        pen.setWidthF(1.3);
    }
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(path);

    const bool onRed = isBad && filled > 0.5;
    const QColor white(0xff, 0xff, 0xff);
    const QColor mark = onRed               ? white
                        : m_content.isOlder ? t.muted
                                            : checkColour(m_content.severity);
    const QPointF at(m_isFolded ? (width() - kGlyph) / 2.0 : kMargin, (height() - kGlyph) / 2.0);
    painter.drawPixmap(
        at, tintedPixmap(checkGlyph(m_content.severity), kGlyph, mark, devicePixelRatioF()));
    if (m_isFolded)
        return;
    painter.setPen(onRed ? white : m_content.isOlder ? t.muted : t.text);
    painter.setFont(words());
    painter.drawText(rect().adjusted(kMargin + kGlyph + kGap, 0, 0, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, m_content.title);
}

} // namespace fff::ui
