// A row of the weakest places: a chip in the colour of its stress, where it is, and how much of
// what the sheet bears is used there. Long names are cut short, numbers never; its tip says all of
// it.
#pragma once

#include <QPushButton> // first: moc stumbles over some standard headers

#include <QColor>

namespace fff::ui {

class PlaceButton : public QPushButton
{
    Q_OBJECT
public:
    explicit PlaceButton(QWidget *parent = nullptr);

    /// words  what is read out, and the tip
    void tell(const QString &place, const QString &share, const QColor &chip, const QString &words);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString m_place, m_share;
    QColor m_chip;
};

} // namespace fff::ui
