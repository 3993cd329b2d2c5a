// Shows the tour in a window: its card over the view, and what the hand would do.
#pragma once

#include <QObject> // first: moc stumbles over some standard headers

#include "ui/tour/tour.h"

#include <QPointF>
#include <QPolygonF>
#include <QTimer>

#include <functional>

namespace fff {
class CheckList;
}

namespace fff::ui {

class TourCard;
class TourHint;

class TourGuide : public QObject
{
    Q_OBJECT
public:
    /// What a step is done with, apart from the view; null: it is not in sight.
    using TargetOf = std::function<QWidget *(Tour::Step)>;

    /// top  of the card below the upper edge of the view, px
    TourGuide(Workbench &bench, const CheckList &checks, QWidget &window, QWidget &view, int top,
              TargetOf targetOf, QObject *parent);

    Tour &tour() { return m_tour; }
    void refreshColours();

private:
    QString sentence() const;
    void follow();
    void point();
    /// Along which a hand would draw or turn, in the view.
    QPolygonF wayOf(Tour::Step step) const;
    QPolygonF wayOfBody() const;
    double underCard() const;
    QPolygonF wayOfSlit() const;
    QPolygonF wayBeside() const;
    QPointF seen(const Vec3 &place) const;

    Workbench &m_bench;
    const CheckList &m_checks;
    QWidget &m_window;
    QWidget &m_view;
    const TargetOf m_targetOf;
    Tour m_tour;
    TourCard *m_card = nullptr;
    TourHint *m_hint = nullptr;
    QTimer m_look; // where targets are, and whether somebody is at work
};

} // namespace fff::ui
