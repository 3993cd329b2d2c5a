// The stresses and forces that are drawn over the view, and which of them is asked about.
#pragma once

#include "core/analysis/holding.h"
#include "ui/view/stress_marks.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace fff::ui {

class Workbench;

class StressPicture : public QObject
{
    Q_OBJECT
public:
    explicit StressPicture(Workbench &bench, QObject *parent = nullptr);

    /// Of what was worked out last; it says where that is older than what is seen. Null: nothing is
    /// shown.
    const StressMarks *marks();

    /// Where the cursor is in a view of this size, px. What rests on a line gets its card.
    void hover(const QPointF &point, const Vec2 &viewport);
    /// It is elsewhere.
    void leave();
    /// A click on a line keeps its card open; another click, wherever, closes it. A drag does
    /// neither.
    void press(const QPointF &point);
    void release(const QPointF &point);
    bool isKept() const { return m_isKept; }
    void close();

Q_SIGNALS:
    void changed();

private:
    void light(int line);
    void dropWeaker();
    void keep(int line);
    void ask(const WeakPlace *place, bool opensCard);

    Workbench &m_bench;
    std::shared_ptr<const Holding> m_held; // that the marks are of
    StressMarks m_marks;
    std::vector<ForceMark> m_feet;
    bool m_isKept = false;    // the card of the line that is lit
    bool m_hasWeaker = false; // the first line is there for who asks about it alone
    int m_pressed = -1;       // the line that was lit where the button went down
    QPointF m_pressedAt;
    QTimer m_rest;
};

} // namespace fff::ui
