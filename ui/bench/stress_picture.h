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
    /// It is elsewhere, or pressed.
    void leave();

Q_SIGNALS:
    void changed();

private:
    void light(int line);

    Workbench &m_bench;
    std::shared_ptr<const Holding> m_held; // that the marks are of
    StressMarks m_marks;
    std::vector<ForceMark> m_feet;
    QTimer m_rest;
};

} // namespace fff::ui
