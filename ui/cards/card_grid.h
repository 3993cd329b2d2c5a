// Cards of one size side by side, in as many rows as the width makes of them.
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

    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    int columns(int width) const;
    void place();

    QSize m_card;
    int m_gap;
    std::vector<QWidget *> m_cards;
};

} // namespace fff::ui
