// The widget of the 3D view. Only wires: mouse and keys to the interaction, frames to the renderer.
// The clock is that of the events.
#pragma once

#include "ui/bench/seen.h"
#include "ui/bench/skin_picture.h"
#include "ui/bench/strained_view.h"
#include "ui/bench/touch_input.h"
#include "ui/bench/view_input.h"
#include "ui/view/frame_pace.h"
#include "ui/view/renderer.h"
#include "ui/view/scene.h"

#include <QElapsedTimer>
#include <QImage>
#include <QOpenGLWidget>
#include <QTimer>

#include <memory>

namespace fff::ui {

class Workbench;
struct OverlayScene;
struct StepsPicture;

/// A property of what stands over the view for as long as a tool is in the hand: the model keeps
/// its place under it.
inline constexpr char kPassingCover[] = "isPassingCover";

class Viewport : public QOpenGLWidget
{
    Q_OBJECT
public:
    explicit Viewport(Workbench &bench, QWidget *parent = nullptr);
    ~Viewport() override;

    /// Frames painted so far: a test sees that nothing is painted when nothing changed.
    int paintCount() const { return m_paintCount; }
    const Renderer &renderer() const { return m_renderer; }

    /// Drawn in place of the model; null: the model again.
    void showSteps(std::shared_ptr<const StepsPicture> picture);
    const StepsPicture *steps() const { return m_steps.get(); }

Q_SIGNALS:
    /// The first key of a number, while the tool in the hand takes some.
    void numberBegun(const QString &text);
    void enterPressed();
    /// A menu of what lies there is asked for; and of what is selected, by a key.
    void menuWanted(const QPoint &inView);
    void menuKeyPressed();
    /// The driver offers no OpenGL 3.3: nothing can be drawn.
    void unusable();

protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
#if QT_CONFIG(tabletevent)
    void tabletEvent(QTabletEvent *event) override;
#endif
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    bool event(QEvent *event) override;
    bool eventFilter(QObject *object, QEvent *event) override;

private:
    void showFocus(bool shows);
    void advance();
    void refresh();
    void rebuildScene();
    void watchAnalysis();
    bool isOnOffer(const QPointF &place) const;
    void setOnOffer(bool isOn);
    void paintMarks();
    void lookForCovers();

    /// ms; by it frames are timed, and drawn the simpler the longer they take.
    double frameTime() const
    {
        return static_cast<double>(m_sinceStart.nsecsElapsed()) * 1e-6;
    }

    Workbench &m_bench;
    ViewInput m_input;
    TouchInput m_touch;
    Renderer m_renderer;
    SceneBuilder m_builder, m_triedBuilder; // of the session's analysis, and of what is tried
    Scene m_scene;
    std::shared_ptr<const StepsPicture> m_steps; // shown instead
    bool m_areStepsBelow = false;                // parts of them come from under the ground
    StrainedView m_strained;
    SkinPicture m_skin;
    bool m_isUsable = false;
    bool m_showsFocus = false; // a frame says that keys go here
    QTimer m_frames;
    QTimer m_wake;     // something changes that no event brings
    QTimer m_rest;     // the picture has rested: draw it in full
    QTimer m_tidy;     // nothing has changed for long: what only work needs is given back
    QTimer m_busyWait; // the analysis takes longer than one notices
    QTimer m_busyTurn; // its mark goes round
    double m_busyTurns = 0.0;
    Seen m_seen; // when it was painted or asked to be
    FramePace m_pace;
    QElapsedTimer m_sinceStart;
    bool m_isPictureChanged = false;
    std::vector<QRectF> m_covered; // by what stands over the view, px
    QImage m_marks;                // what is painted over the picture
    QRectF m_offer;                // where the words of an offer are, px; empty: there is none
    bool m_isOnOffer = false;      // the cursor is
    bool m_isOfferPressed = false; // until the button is let go
    int m_paintCount = 0;
};

} // namespace fff::ui
