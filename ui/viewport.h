// The widget of the 3D view. Only wires: mouse and keys to the interaction, frames to the renderer.
// The clock is that of the events.
#pragma once

#include "core/interaction/interaction.h"
#include "ui/view/renderer.h"
#include "ui/view/scene.h"

#include <QOpenGLWidget>
#include <QSinglePointEvent>
#include <QTimer>

namespace fff::ui {

class Workbench;

class Viewport : public QOpenGLWidget
{
    Q_OBJECT
public:
    explicit Viewport(Workbench &bench, QWidget *parent = nullptr);
    ~Viewport() override;

    /// Frames painted so far: a test sees that nothing is painted when nothing changed.
    int paintCount() const { return m_paintCount; }

Q_SIGNALS:
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
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;

private:
    PointerEvent pointer(PointerEvent::Type type, QSinglePointEvent *event);
    void flushMoves();
    void leave();
    void advance();
    void refresh();
    void rebuildScene();
    void markScene();

    Workbench &m_bench;
    Renderer m_renderer;
    SceneBuilder m_builder;
    Scene m_scene;
    bool m_isUsable = false;
    bool m_isSpaceHeld = false;
    std::vector<PointerEvent> m_moves; // of the burst that is coming in
    QTimer m_burst;                    // ends when nothing more is at hand
    QTimer m_frames;
    int m_paintCount = 0;
};

} // namespace fff::ui
