// What the hand would do, shown over the window as it moves: a pointer that goes along a way, or a
// ring round a button. It takes no click, and is still after a while or where little motion is
// wanted.
#pragma once

#include <QElapsedTimer>
#include <QPolygonF>
#include <QTimer>
#include <QWidget>

namespace fff::ui {

class TourHint : public QWidget
{
    Q_OBJECT
public:
    explicit TourHint(QWidget *window);

    // In the window's coordinates. The same as before is not begun anew.
    void showWay(const QPolygonF &way);
    void showRing(const QRect &around);
    void showNothing();

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void begin(const QPolygonF &way, const QRect &ring);
    double share() const;
    void paintWay(QPainter &painter) const;
    void paintRing(QPainter &painter) const;

    QPolygonF m_way; // empty: a ring
    QRect m_ring;
    QElapsedTimer m_since;
    QTimer m_frames;
};

} // namespace fff::ui
