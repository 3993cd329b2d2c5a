#include "ui/cards/model_card.h"

#include "ui/base/icon.h"
#include "ui/base/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

namespace fff::ui {

namespace {

constexpr double kRadius = 3.0;               // px
constexpr int kMargin = 8, kPlaceholder = 32; // px

} // namespace

ModelCard::ModelCard(const QString &name, QWidget *parent) : QAbstractButton(parent)
{
    setText(name);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::PointingHandCursor);
    describe();
}

void ModelCard::setPicture(const QImage &picture)
{
    m_picture = picture;
    update();
}

void ModelCard::setNote(const QString &note)
{
    m_note = note;
    describe();
    update();
}

void ModelCard::setMissing()
{
    m_isMissing = true;
    m_picture = {};
    update();
}

void ModelCard::describe()
{
    setAccessibleName(m_note.isEmpty() ? text() : text() + QStringLiteral(", ") + m_note);
}

void ModelCard::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const bool isFocused = hasFocus(), isHovered = underMouse();
    const double line = isFocused ? 2.0 : 1.0;
    const QRectF frame = QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2);
    QPainterPath card;
    card.addRoundedRect(frame, kRadius, kRadius);
    painter.fillPath(card, isDown() ? theme().soft : isHovered ? theme().hover : theme().panel);

    const QRect picture(0, 0, width(), kPictureHeight);
    painter.save();
    painter.setClipPath(card);
    if (m_picture.isNull()) {
        painter.fillRect(picture, theme().alternate);
        const QPixmap mark =
            tintedPixmap(m_isMissing ? QStringLiteral("warn") : QStringLiteral("section"),
                         kPlaceholder, theme().muted, devicePixelRatioF());
        painter.setOpacity(0.5);
        painter.drawPixmap(picture.center() - QPoint(kPlaceholder / 2, kPlaceholder / 2), mark);
        painter.setOpacity(1.0);
    } else {
        drawPicture(painter, picture);
    }
    painter.restore();
    painter.setPen(QPen(isFocused   ? theme().accent
                        : isHovered ? theme().strong
                                    : theme().border,
                        line));
    painter.drawPath(card);

    const QRect words = rect().adjusted(kMargin, kPictureHeight + 4, -kMargin, -4);
    const QFontMetrics metrics(font());
    painter.setPen(m_isMissing ? theme().muted : theme().text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                     metrics.elidedText(text(), Qt::ElideMiddle, words.width()));
    QFont small = font();
    small.setPointSizeF(font().pointSizeF() * 0.92);
    painter.setFont(small);
    painter.setPen(theme().muted);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignBottom,
                     QFontMetrics(small).elidedText(m_note, Qt::ElideRight, words.width()));
}

/// As high as its room, in the middle; its borders go on to the sides of a card that is wider.
void ModelCard::drawPicture(QPainter &painter, const QRect &room) const
{
    const double scale = static_cast<double>(room.height()) / m_picture.height();
    const int width = qRound(scale * m_picture.width()), left = (room.width() - width) / 2;
    if (left > 0) {
        const QRect border(0, 0, 1, m_picture.height());
        painter.drawImage(QRect(0, 0, left + 1, room.height()), m_picture, border);
        painter.drawImage(
            QRect(left + width - 1, 0, room.width() - left - width + 1, room.height()), m_picture,
            border.translated(m_picture.width() - 1, 0));
    }
    painter.drawImage(QRect(left, 0, width, room.height()), m_picture);
}

void ModelCard::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else if (event->key() == Qt::Key_Delete)
        Q_EMIT removalWanted();
    else
        QAbstractButton::keyPressEvent(event);
}

void ModelCard::enterEvent(QEnterEvent *event)
{
    QAbstractButton::enterEvent(event);
    update();
}

void ModelCard::leaveEvent(QEvent *event)
{
    QAbstractButton::leaveEvent(event);
    update();
}

} // namespace fff::ui
