#include "ui/cards/card_grid.h"

#include <algorithm>

namespace fff::ui {

CardGrid::CardGrid(const QSize &card, int gap, QWidget *parent)
    : QWidget(parent), m_card(card), m_gap(gap)
{
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
}

void CardGrid::setCards(const std::vector<QWidget *> &cards)
{
    for (QWidget *old : m_cards) {
        old->hide();
        old->deleteLater(); // one of them may be what asks for this
    }
    m_cards = cards;
    QWidget *before = nullptr;
    for (QWidget *card : m_cards) {
        card->setParent(this);
        if (before)
            setTabOrder(before, card);
        before = card;
    }
    place();
    updateGeometry();
}

int CardGrid::columns(int width) const
{
    const int least = m_leastWidth > 0 ? m_leastWidth : m_card.width();
    return std::max(1, (width + m_gap) / (least + m_gap));
}

int CardGrid::cardWidth(int width) const
{
    if (m_leastWidth <= 0)
        return m_card.width();
    const int across = columns(width);
    return std::max(m_leastWidth, (width - (across - 1) * m_gap) / across);
}

void CardGrid::setLeastWidth(int width)
{
    m_leastWidth = width;
    place();
    updateGeometry();
}

int CardGrid::heightForWidth(int width) const
{
    const int count = static_cast<int>(m_cards.size()), across = columns(width);
    int rows = (count + across - 1) / across;
    if (m_mostRows > 0)
        rows = std::min(rows, m_mostRows);
    return rows == 0 ? 0 : rows * m_card.height() + (rows - 1) * m_gap;
}

void CardGrid::setMostRows(int rows)
{
    m_mostRows = rows;
    place();
    updateGeometry();
}

QSize CardGrid::sizeHint() const
{
    return {m_card.width(), heightForWidth(width())};
}

QSize CardGrid::minimumSizeHint() const
{
    const int least = m_leastWidth > 0 ? m_leastWidth : m_card.width();
    return {least, heightForWidth(std::max(width(), least))};
}

void CardGrid::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    place();
    updateGeometry();
}

void CardGrid::place()
{
    const int across = columns(width()), wide = cardWidth(width());
    for (std::size_t i = 0; i < m_cards.size(); ++i) {
        int column = static_cast<int>(i) % across;
        const int row = static_cast<int>(i) / across;
        if (isRightToLeft())
            column = across - 1 - column;
        m_cards[i]->setVisible(m_mostRows == 0 || row < m_mostRows);
        m_cards[i]->setFixedSize(wide, m_card.height());
        m_cards[i]->move(column * (wide + m_gap), row * (m_card.height() + m_gap));
    }
}

} // namespace fff::ui
