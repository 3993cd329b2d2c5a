// How wide a slit is drawn, as a picture: what the lines leave of the sheet, what the cut takes off
// them, and the other sheet between. True to scale, the thickness as wide as there is room for.
#pragma once

#include <QWidget> // first: moc stumbles over some standard headers

#include "core/model/stock.h"

namespace fff::ui {

class SlitPicture : public QWidget
{
public:
    explicit SlitPicture(QWidget *parent = nullptr);

    void setStock(const Stock &stock);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    Stock m_stock;
};

} // namespace fff::ui
