#include "ui/docks/place_button.h"

#include "ui/base/theme.h"

#include <QPainter>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kChipWidth = 10, kChipHeight = 14, kBesideChip = 8, kPlaceRow = 24; // px

} // namespace

PlaceButton::PlaceButton(QWidget *parent) : QPushButton(parent)
{
    setFlat(true);
    setAutoDefault(false);
    setAttribute(Qt::WA_Hover);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void PlaceButton::tell(const QString &place, const QString &share, const QColor &chip,
                       const QString &words)
{
    m_place = place;
    m_share = share;
    m_chip = chip;
    setAccessibleName(words);
    setToolTip(words);
    update();
}

QSize PlaceButton::sizeHint() const
{
    const int numbers = fontMetrics().horizontalAdvance(m_share);
    return {4 * kBesideChip + kChipWidth + numbers,
            std::max(kPlaceRow, fontMetrics().height() + 6)};
}

void PlaceButton::paintEvent(QPaintEvent *)
{
    const Theme &t = theme();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || isDown()) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(isDown() ? t.soft : t.hover);
        painter.drawRoundedRect(rect(), 3.0, 3.0);
    }
    const QRect room = rect().adjusted(4, 0, -4, 0);
    const QRect chip(room.left(), (height() - kChipHeight) / 2, kChipWidth, kChipHeight);
    painter.setPen(QPen(t.strong, 1.0));
    painter.setBrush(m_chip);
    painter.drawRoundedRect(QRectF(chip).adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    const int share = fontMetrics().horizontalAdvance(m_share);
    const QRect words(chip.right() + 1 + kBesideChip, 0,
                      room.right() - share - kBesideChip - chip.right() - kBesideChip, height());
    painter.setPen(t.text);
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, m_share);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     fontMetrics().elidedText(m_place, Qt::ElideMiddle, words.width()));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(t.accent, 1.0));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
    }
}

} // namespace fff::ui
