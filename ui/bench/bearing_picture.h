// Where the section that is asked about is strong enough, as it is drawn over the view.
#pragma once

#include "ui/view/bearing_marks.h"

#include <QObject>

namespace fff {
class Scheduler;
} // namespace fff

namespace fff::ui {

class Workbench;

/// How far the answer has come, or why there is none, in a few words; empty where it is there, or
/// nobody asks.
QString bearingState(const Scheduler &scheduler);

class BearingPicture : public QObject
{
    Q_OBJECT
public:
    explicit BearingPicture(Workbench &bench, QObject *parent = nullptr);

    /// Null: nobody asks.
    const BearingMarks *marks();

    /// Where the cursor is in a view of this size, px.
    void hover(const QPointF &point, const Vec2 &viewport);
    /// It is elsewhere, or pressed.
    void leave();

Q_SIGNALS:
    void changed();

private:
    bool isAsked() const;

    Workbench &m_bench;
    BearingMarks m_marks;
};

} // namespace fff::ui
