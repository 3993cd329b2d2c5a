// What the view shows of how the model bears what it has to: stresses and forces, where a section
// is strong enough, and the model where it moves.
#pragma once

#include "ui/bench/bearing_picture.h"
#include "ui/bench/stress_picture.h"
#include "ui/view/moved_scene.h"
#include "ui/view/render_options.h"

#include <QObject>

#include <optional>

namespace fff::ui {

class StrainedView : public QObject
{
    Q_OBJECT
public:
    explicit StrainedView(Workbench &bench, QObject *parent = nullptr);

    /// Puts on the scene of the model what is shown on it, and into the options how; the scene that
    /// is to be drawn is that one, or the model where it moves.
    const Scene &shown(Scene &scene, RenderOptions &options);
    const StressMarks *stress() { return m_stress.marks(); }
    const BearingMarks *bearing() { return m_bearing.marks(); }
    /// How many times as far as it really moves the model is shown to; 0: where it stands. As long
    /// as it moves, what is drawn beside it at its places would be beside others.
    double timesMoved() const;

    // The mouse in a view of this size, px.
    void hover(const QPointF &point, const Vec2 &viewport);
    void leave();
    void press(const QPointF &point);
    void release(const QPointF &point) { m_stress.release(point); }
    /// A card is kept open.
    bool isKept() const { return m_stress.isKept(); }
    void close() { m_stress.close(); }

Q_SIGNALS:
    void changed();
    /// The model is shown elsewhere.
    void moved();

private:
    std::optional<Movement> movementShown() const;
    void showBearing(Scene &scene, RenderOptions &options);

    Workbench &m_bench;
    StressPicture m_stress;
    BearingPicture m_bearing;
    MovedScene m_moved;
};

} // namespace fff::ui
