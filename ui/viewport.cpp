#include "ui/viewport.h"

#include "ui/cursors.h"
#include "ui/theme.h"
#include "ui/view/overlay_painter.h"
#include "ui/workbench.h"

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kFrameTime = 12;        // ms between frames of an animation
constexpr double kNotchAngle = 120.0; // of QWheelEvent, one notch

Vec2 toVec(const QPointF &p)
{
    return {p.x(), p.y()};
}

Button toButton(Qt::MouseButton button)
{
    switch (button) {
    case Qt::LeftButton:
        return Button::Left;
    case Qt::MiddleButton:
        return Button::Middle;
    case Qt::RightButton:
        return Button::Right;
    default:
        return Button::None;
    }
}

} // namespace

Viewport::Viewport(Workbench &bench, QWidget *parent) : QOpenGLWidget(parent), m_bench(bench)
{
    setObjectName(QStringLiteral("viewport"));
    setAccessibleName(tr("View of the model"));
    setAccessibleDescription(tr("Draw with the left mouse button, turn with the right one."));
    setMinimumSize(480, 360);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);

    m_burst.setSingleShot(true);
    m_burst.setInterval(0);
    connect(&m_burst, &QTimer::timeout, this, &Viewport::flushMoves);
    m_frames.setInterval(kFrameTime);
    connect(&m_frames, &QTimer::timeout, this, &Viewport::advance);
    connect(&bench, &Workbench::viewChanged, this, &Viewport::refresh);
    connect(&bench, &Workbench::selectionChanged, this, [this] {
        markScene();
        update();
    });
    connect(&bench.session(), &Session::modelChanged, this, &Viewport::rebuildScene);
    connect(&bench.session(), &Session::analysisChanged, this, [this] {
        m_builder.setAnalysis(m_bench.session().analysis());
        rebuildScene();
    });
    m_builder.setAnalysis(bench.session().analysis());
    rebuildScene();
}

Viewport::~Viewport()
{
    if (context()) {
        // The context goes after this object's own members: nothing may be called for it then.
        disconnect(context(), nullptr, this, nullptr);
        makeCurrent();
        m_renderer.release();
        doneCurrent();
    }
}

void Viewport::initializeGL()
{
    // Moving the widget to another window makes a new context; everything of the old one goes with
    // it.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        m_renderer.release();
        doneCurrent();
    });
    m_isUsable = m_renderer.initialize();
    if (!m_isUsable)
        Q_EMIT unusable();
}

void Viewport::resizeGL(int width, int height)
{
    m_bench.setViewport({static_cast<double>(width), static_cast<double>(height)});
}

void Viewport::paintGL()
{
    ++m_paintCount;
    const Vec2 size(width(), height());
    const Interaction &interaction = m_bench.interaction();
    const ViewStyle style = theme().viewStyle();
    if (m_isUsable)
        m_renderer.render(m_scene, interaction.camera(), size, devicePixelRatioF(), style);

    QPainter painter(this);
    painter.setFont(font());
    paintOverlay(painter,
                 {interaction.overlay(), interaction.camera(), size, m_scene.sections.empty(),
                  !interaction.hasGesture()},
                 style, locale());
}

void Viewport::mousePressEvent(QMouseEvent *event)
{
    flushMoves();
    m_bench.handle(pointer(PointerEvent::Type::Press, event));
}

/// A hand's line needs every sample, but what they make needs showing once a frame only: moves are
/// gathered for as long as more of them are at hand.
void Viewport::mouseMoveEvent(QMouseEvent *event)
{
    m_moves.push_back(pointer(PointerEvent::Type::Move, event));
    if (!m_burst.isActive())
        m_burst.start();
}

void Viewport::flushMoves()
{
    m_burst.stop();
    std::vector<PointerEvent> moves = std::exchange(m_moves, {});
    for (std::size_t i = 0; i < moves.size(); ++i) {
        moves[i].isFollowed = i + 1 < moves.size();
        m_bench.handle(moves[i]);
    }
}

void Viewport::mouseReleaseEvent(QMouseEvent *event)
{
    flushMoves();
    m_bench.handle(pointer(PointerEvent::Type::Release, event));
}

void Viewport::mouseDoubleClickEvent(QMouseEvent *event)
{
    // Qt sends this in place of the second press; a stroke must not get lost in it.
    mousePressEvent(event);
}

PointerEvent Viewport::pointer(PointerEvent::Type type, QSinglePointEvent *event)
{
    PointerEvent pointer;
    pointer.type = type;
    pointer.position = toVec(event->position());
    pointer.button = toButton(event->button());
    pointer.modifiers = {event->modifiers().testFlag(Qt::ShiftModifier),
                         event->modifiers().testFlag(Qt::ControlModifier), m_isSpaceHeld};
    pointer.time = m_bench.clock().observe(event->timestamp());
    event->accept();
    return pointer;
}

void Viewport::wheelEvent(QWheelEvent *event)
{
    flushMoves();
    PointerEvent pointer;
    pointer.type = PointerEvent::Type::Wheel;
    pointer.position = toVec(event->position());
    pointer.modifiers = {event->modifiers().testFlag(Qt::ShiftModifier),
                         event->modifiers().testFlag(Qt::ControlModifier), m_isSpaceHeld};
    pointer.wheelSteps = event->angleDelta().y() / kNotchAngle;
    pointer.time = m_bench.clock().observe(event->timestamp());
    if (pointer.wheelSteps != 0.0)
        m_bench.handle(pointer);
    event->accept();
}

void Viewport::keyPressEvent(QKeyEvent *event)
{
    flushMoves();
    if (event->key() == Qt::Key_Space) {
        m_isSpaceHeld = true;
    } else if (event->key() == Qt::Key_Escape) {
        m_bench.clock().observe(event->timestamp());
        m_bench.escape();
    } else {
        QOpenGLWidget::keyPressEvent(event);
    }
}

void Viewport::keyReleaseEvent(QKeyEvent *event)
{
    flushMoves();
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        m_isSpaceHeld = false;
    else
        QOpenGLWidget::keyReleaseEvent(event);
}

bool Viewport::event(QEvent *event)
{
    if (event->type() == QEvent::Leave)
        leave();
    else if (event->type() == QEvent::FocusOut)
        m_isSpaceHeld = false;
    return QOpenGLWidget::event(event);
}

void Viewport::leave()
{
    flushMoves();
    PointerEvent pointer;
    pointer.type = PointerEvent::Type::Leave;
    pointer.time = m_bench.clock().now();
    m_bench.handle(pointer);
}

void Viewport::advance()
{
    flushMoves();
    if (!m_bench.advance())
        m_frames.stop();
}

/// Something that is seen may have changed.
void Viewport::refresh()
{
    const Interaction &interaction = m_bench.interaction();
    if (interaction.isAnimating() && !m_frames.isActive())
        m_frames.start();
    const QCursor shape = cursorFor(interaction.cursor(), devicePixelRatioF());
    if (cursor() != shape)
        setCursor(shape);
    markScene();
    update();
}

void Viewport::rebuildScene()
{
    m_scene = m_builder.build(m_bench.session().model());
    markScene();
    update();
}

/// Which sections are hovered, selected, or stand back.
void Viewport::markScene()
{
    const Interaction &interaction = m_bench.interaction();
    const Model &model = m_bench.session().model();
    if (model.sectionCount() != m_scene.sections.size())
        return; // rebuilt at once after this
    const auto &selection = interaction.selection();
    const bool isDrawing = interaction.overlay().stroke.has_value();
    // The section being drawn is the preview's last; all that is committed stands back for it.
    const std::size_t committed = m_bench.session().committed().sectionCount();
    for (std::size_t i = 0; i < m_scene.sections.size(); ++i) {
        SceneSection &section = m_scene.sections[i];
        section.isSelected =
            std::find(selection.begin(), selection.end(), model.ref(i)) != selection.end();
        section.isHovered = interaction.overlay().hovered == static_cast<int>(i);
        section.isGhost = isDrawing && i < committed;
    }
}

} // namespace fff::ui
