// Cards of one size side by side, in as many columns as the width has room for.
// Where they may, they become wider so that a row fills the width.
#pragma once

#include <QWidget>

#include <vector>

namespace fff::ui {

class CardGrid : public QWidget
{
public:
    CardGrid(const QSize &card, int gap, QWidget *parent = nullptr);

    /// Takes them over; the old ones are deleted.
    void setCards(const std::vector<QWidget *> &cards);
    const std::vector<QWidget *> &cards() const { return m_cards; }

    /// They fill a row, and are no narrower than this, px. 0: as wide as was said at first.
    void setLeastWidth(int width);
    /// Those that need more are not shown. 0: all are.
    void setMostRows(int rows);

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    int columns(int width) const;
    int cardWidth(int width) const;
    void place();

    QSize m_card;
    int m_gap;
    int m_leastWidth = 0;
    int m_mostRows = 0;
    std::vector<QWidget *> m_cards;
};

} // namespace fff::ui
