#include "ui/viewport.h"

#include "core/interaction/tool.h"
#include "ui/cursors.h"
#include "ui/focus_frame.h"
#include "ui/settings/settings.h"
#include "ui/theme.h"
#include "ui/view/overlay_painter.h"
#include "ui/workbench.h"

#include <QFocusEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kFrameTime = 12;        // ms between frames of an animation
constexpr double kNotchAngle = 120.0; // of QWheelEvent, one notch
constexpr int kBusyDelay = 500;       // ms before work is said to be going on
constexpr int kBusyFrame = 80;        // ms between steps of its mark
constexpr double kBusyStep = 0.08;    // of a turn

Vec2 toVec(const QPointF &p)
{
    return {p.x(), p.y()};
}

bool isOfKeys(Qt::FocusReason reason)
{
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
           reason == Qt::ShortcutFocusReason;
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

std::optional<ToolKey> toolKey(const QKeyEvent *event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return ToolKey::Enter;
    case Qt::Key_Backspace:
        return ToolKey::Backspace;
    default:
        return std::nullopt;
    }
}

/// What a number can begin with, where the tool in the hand takes some.
bool beginsNumber(const QKeyEvent *event)
{
    const auto others = event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if (others != Qt::NoModifier || event->text().size() != 1)
        return false;
    const QChar c = event->text().front();
    return c.isDigit() || QStringLiteral("-\u2212.,@").contains(c);
}

/// A path is begun: as with a stroke, the rest stands back.
bool hasPath(const Overlay &overlay)
{
    return overlay.pen && !overlay.pen->points.empty();
}

} // namespace

bool Viewport::Seen::isSamePicture(const Seen &other) const
{
    return camera == other.camera && view == other.view && isGhosted == other.isGhosted;
}

Viewport::Viewport(Workbench &bench, QWidget *parent) : QOpenGLWidget(parent), m_bench(bench)
{
    // The renderer smooths edges by itself, and marks are painted smoothly.
    QSurfaceFormat plain = QSurfaceFormat::defaultFormat();
    plain.setSamples(0);
    setFormat(plain);
    m_sinceStart.start();
    m_frameClock = [this] { return static_cast<double>(m_sinceStart.nsecsElapsed()) * 1e-6; };

    setObjectName(QStringLiteral("viewport"));
    setAccessibleName(tr("View of the model"));
    setAccessibleDescription(tr("Draw with the left mouse button, turn with the right one."));
    setMinimumSize(480, 360);
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    FocusFrame::leaveTo(this);

    m_burst.setSingleShot(true);
    m_burst.setInterval(0);
    connect(&m_burst, &QTimer::timeout, this, &Viewport::flushMoves);
    m_frames.setInterval(kFrameTime);
    connect(&m_frames, &QTimer::timeout, this, &Viewport::advance);
    const auto once = [this](QTimer &timer, auto act) {
        timer.setSingleShot(true);
        connect(&timer, &QTimer::timeout, this, act);
    };
    once(m_wake, [this] { m_bench.advance(); });
    once(m_rest, [this] { update(); });
    once(m_busyWait, [this] { m_busyTurn.start(kBusyFrame); });
    connect(&m_busyTurn, &QTimer::timeout, this, [this] {
        m_busyTurns += kBusyStep;
        update();
    });
    connect(&bench, &Workbench::viewChanged, this, &Viewport::refresh);
    connect(&settings(), &Settings::unitChanged, this, qOverload<>(&QWidget::update));
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        watchAnalysis();
        rebuildScene();
    });
    connect(&bench.session(), &Session::analysisChanged, this, [this] {
        watchAnalysis();
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
    const Interaction &interaction = m_bench.interaction();
    if (m_isUsable) {
        RenderOptions options;
        options.quality = m_pace.begin(m_frameClock(), std::exchange(m_isPictureChanged, false));
        options.isXray = interaction.view().isXray;
        options.hasGround = interaction.view().hasGround;
        options.clip = interaction.view().clip;
        m_renderer.render(m_scene, interaction.camera(), Vec2(width(), height()),
                          devicePixelRatioF(), theme().viewStyle(), options);
        context()->functions()->glFinish(); // the time is that of the picture, not of asking for it
        m_pace.end(m_frameClock());
        if (const std::optional<double> rest = m_pace.restTime())
            m_rest.start(std::max(1, static_cast<int>(std::ceil(*rest - m_frameClock()))));
        else
            m_rest.stop();
    }
    paintMarks();
    QPainter painter(this);
    if (!m_isUsable)
        painter.fillRect(rect(), theme().viewStyle().bottom);
    painter.drawImage(QPointF(0.0, 0.0), m_marks);
}

void Viewport::paintMarks()
{
    const QSize pixels = size() * devicePixelRatioF();
    if (m_marks.size() != pixels)
        m_marks = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    m_marks.setDevicePixelRatio(devicePixelRatioF());
    m_marks.fill(Qt::transparent);
    const Interaction &interaction = m_bench.interaction();
    const Overlay &overlay = interaction.overlay();
    const Model &model = m_bench.session().model();
    OverlayScene scene{overlay, interaction.camera(), Vec2(width(), height()),
                       m_scene.sections.empty(), !interaction.hasGesture() && !overlay.pen};
    scene.view = interaction.view();
    scene.unit = settings().unit();
    const bool isDrawing = overlay.slit || overlay.stroke || hasPath(overlay);
    if (!isDrawing)
        scene.marks =
            placeMarks(interaction.marks(), interaction.camera(), scene.viewport, scene.view);
    scene.litMark = litMark();
    if (!isDrawing)
        scene.ghosts = m_bench.ghosts();
    scene.bounds = m_bench.session().committed().bounds();
    const auto hovered = static_cast<std::size_t>(std::max(overlay.hovered, 0));
    if (overlay.hovered >= 0 && hovered < model.sectionCount())
        scene.hovered = QString::fromStdString(model.section(hovered)->name);
    if (overlay.points && static_cast<std::size_t>(overlay.points->section) < model.sectionCount())
        scene.edited = model.section(static_cast<std::size_t>(overlay.points->section)).get();
    if (m_busyTurn.isActive())
        scene.busy = m_busyTurns;
    QPainter painter(&m_marks);
    painter.setFont(font());
    paintOverlay(painter, scene, theme().viewStyle(), locale());
    if (!m_showsFocus)
        return;
    const QRectF inside = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
    painter.setBrush(Qt::NoBrush);
    for (const QPen &pen : {QPen(theme().panel, 4.0), QPen(theme().accent, 2.0)}) {
        painter.setPen(pen);
        painter.drawRect(inside);
    }
}

/// Its mark appears when it takes longer than one waits for.
void Viewport::watchAnalysis()
{
    const Session &session = m_bench.session();
    if (session.analysedRevision() < session.revision()) {
        if (!m_busyWait.isActive() && !m_busyTurn.isActive())
            m_busyWait.start(kBusyDelay);
        return;
    }
    m_busyWait.stop();
    if (m_busyTurn.isActive())
        update();
    m_busyTurn.stop();
}

/// A frame for those who came by keys; whoever has the mouse here knows.
void Viewport::showFocus(bool shows)
{
    if (std::exchange(m_showsFocus, shows) != shows)
        update();
}

void Viewport::mousePressEvent(QMouseEvent *event)
{
    showFocus(false);
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

PointerEvent Viewport::pointer(PointerEvent::Type type, const QPointF &place,
                               Qt::KeyboardModifiers keys, quint64 time)
{
    PointerEvent pointer;
    pointer.type = type;
    pointer.position = toVec(place);
    pointer.modifiers = {keys.testFlag(Qt::ShiftModifier), keys.testFlag(Qt::ControlModifier),
                         m_isSpaceHeld};
    pointer.time = m_bench.clock().observe(time);
    return pointer;
}

PointerEvent Viewport::pointer(PointerEvent::Type type, QSinglePointEvent *event)
{
    m_cursor = toVec(event->position());
    PointerEvent pointer =
        this->pointer(type, event->position(), event->modifiers(), event->timestamp());
    pointer.button = toButton(event->button());
    event->accept();
    return pointer;
}

void Viewport::wheelEvent(QWheelEvent *event)
{
    flushMoves();
    event->accept();
    // Two fingers on a trackpad push the picture; a wheel, and fingers with Ctrl, zoom.
    const bool isTrackpad = event->device()->type() == QInputDevice::DeviceType::TouchPad ||
                            event->phase() != Qt::NoScrollPhase;
    const bool pushes = isTrackpad && !event->modifiers().testFlag(Qt::ControlModifier);
    PointerEvent moved = pointer(pushes ? PointerEvent::Type::Scroll : PointerEvent::Type::Wheel,
                                 event->position(), event->modifiers(), event->timestamp());
    if (pushes) {
        const QPoint way =
            event->pixelDelta().isNull() ? event->angleDelta() / 2 : event->pixelDelta();
        moved.scroll = Vec2(way.x(), way.y());
        if (!way.isNull())
            m_bench.handle(moved);
        return;
    }
    moved.wheelSteps = event->angleDelta().y() / kNotchAngle;
    if (moved.wheelSteps != 0.0)
        m_bench.handle(moved);
}

/// Two fingers apart or together zoom, two fingers sideways push the picture.
bool Viewport::pinch(QNativeGestureEvent *event)
{
    const bool zooms = event->gestureType() == Qt::ZoomNativeGesture;
    if (!zooms && event->gestureType() != Qt::PanNativeGesture)
        return false;
    flushMoves();
    PointerEvent moved = pointer(zooms ? PointerEvent::Type::Zoom : PointerEvent::Type::Scroll,
                                 event->position(), event->modifiers(), event->timestamp());
    moved.zoomFactor = std::max(0.1, 1.0 + event->value());
    moved.scroll = toVec(event->delta());
    m_bench.handle(moved);
    event->accept();
    return true;
}

void Viewport::keyPressEvent(QKeyEvent *event)
{
    flushMoves();
    if (event->key() == Qt::Key_Space) {
        m_isSpaceHeld = true;
    } else if (event->key() == Qt::Key_Escape) {
        m_bench.clock().observe(event->timestamp());
        m_bench.escape();
    } else if (const auto key = toolKey(event); key && m_bench.wants(*key)) {
        m_bench.clock().observe(event->timestamp());
        m_bench.key(*key);
    } else if (beginsNumber(event) && !m_bench.interaction().numbers().empty()) {
        Q_EMIT numberBegun(event->text());
    } else if (!nudge(event) && !tellOfModifiers(event)) {
        QOpenGLWidget::keyPressEvent(event);
    }
}

/// Arrow keys move what is selected by 1 mm, finely with Ctrl, coarsely with Shift.
bool Viewport::nudge(QKeyEvent *event)
{
    Vec2 arrow = Vec2::Zero();
    switch (event->key()) {
    case Qt::Key_Left:
        arrow = -Vec2::UnitX();
        break;
    case Qt::Key_Right:
        arrow = Vec2::UnitX();
        break;
    case Qt::Key_Up:
        arrow = Vec2::UnitY();
        break;
    case Qt::Key_Down:
        arrow = -Vec2::UnitY();
        break;
    default:
        return false;
    }
    const Qt::KeyboardModifiers keys = event->modifiers() & ~Qt::KeypadModifier;
    const double distance = keys == Qt::ControlModifier ? 0.1
                            : keys == Qt::ShiftModifier ? 10.0
                                                        : 1.0;
    if (keys != Qt::NoModifier && distance == 1.0)
        return false; // Alt and the like are someone else's
    m_bench.clock().observe(event->timestamp());
    return m_bench.nudge(arrow, distance);
}

/// A gesture may do something else while Shift or Ctrl is held, also when the mouse rests.
bool Viewport::tellOfModifiers(QKeyEvent *event)
{
    if ((event->key() != Qt::Key_Shift && event->key() != Qt::Key_Control) || event->isAutoRepeat())
        return false;
    PointerEvent told = pointer(PointerEvent::Type::Modifiers, QPointF(m_cursor.x(), m_cursor.y()),
                                event->modifiers(), event->timestamp());
    // Qt's modifiers of the key itself are those from before it on some platforms.
    (event->key() == Qt::Key_Shift ? told.modifiers.shift : told.modifiers.control) =
        event->type() == QEvent::KeyPress;
    m_bench.handle(told);
    return true;
}

void Viewport::keyReleaseEvent(QKeyEvent *event)
{
    flushMoves();
    if (event->key() == Qt::Key_Space && !event->isAutoRepeat())
        m_isSpaceHeld = false;
    else if (!tellOfModifiers(event))
        QOpenGLWidget::keyReleaseEvent(event);
}

bool Viewport::event(QEvent *event)
{
    // Keys of the tool in the hand before shortcuts of the same keys.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *pressed = static_cast<QKeyEvent *>(event);
        const auto key = toolKey(pressed);
        if ((key && m_bench.wants(*key)) ||
            (beginsNumber(pressed) && !m_bench.interaction().numbers().empty())) {
            event->accept();
            return true;
        }
    }
    if (event->type() == QEvent::NativeGesture && pinch(static_cast<QNativeGestureEvent *>(event)))
        return true;
    if (event->type() == QEvent::Leave)
        leave();
    else if (event->type() == QEvent::FocusIn)
        showFocus(m_showsFocus || isOfKeys(static_cast<QFocusEvent *>(event)->reason()));
    else if (event->type() == QEvent::FocusOut) {
        m_isSpaceHeld = false;
        // Back in this window, or behind a menu, it is where it was.
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason)
            showFocus(false);
    }
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

/// Under the cursor, or with the cursor on its row.
int Viewport::litMark() const
{
    const int hovered = m_bench.interaction().overlay().mark;
    return hovered > 0 ? hovered : m_bench.litProblem();
}

/// Of those that are to be outlined, the ones that are in the model: others change nothing that is
/// seen.
std::vector<SectionRef> Viewport::presentlyOutlined() const
{
    std::vector<SectionRef> present;
    const Model &model = m_bench.session().model();
    const std::vector<SectionRef> &wanted = m_bench.outlined();
    for (std::size_t i = 0; !wanted.empty() && i < model.sectionCount(); ++i) {
        const SectionRef ref = model.ref(i);
        if (std::binary_search(wanted.begin(), wanted.end(), ref))
            present.push_back(ref);
    }
    return present;
}

Viewport::Seen Viewport::seen() const
{
    const Interaction &interaction = m_bench.interaction();
    const Overlay &overlay = interaction.overlay();
    return {interaction.camera(),
            interaction.view(),
            interaction.selection(),
            presentlyOutlined(),
            m_bench.ghosts(),
            overlay.hovered,
            overlay.namePlace,
            overlay.cubePart,
            overlay.points,
            overlay.isHandleHovered,
            interaction.hasGesture(),
            overlay.stroke.has_value() || hasPath(overlay),
            overlay.band.has_value(),
            interaction.marks(),
            litMark(),
            overlay.pen,
            overlay.plane ? std::optional(overlay.plane->canvas) : std::nullopt};
}

/// Something that is seen may have changed: paints only if it has.
void Viewport::refresh()
{
    const Interaction &interaction = m_bench.interaction();
    if (interaction.isAnimating() && !m_frames.isActive())
        m_frames.start();
    if (const std::optional<double> wake = interaction.wakeTime())
        m_wake.start(std::max(1, static_cast<int>(std::ceil(*wake - m_bench.clock().now()))));
    else
        m_wake.stop();
    const QCursor shape = cursorFor(interaction.cursor(), devicePixelRatioF());
    if (cursor() != shape)
        setCursor(shape);

    const Overlay &overlay = interaction.overlay();
    Seen now = seen();
    // What the pen shows is compared.
    const bool drawsMarks =
        (overlay.slit && !overlay.pen) || overlay.deadZone || overlay.stroke || overlay.band;
    if (now == m_seen && !drawsMarks)
        return;
    if (!now.isSamePicture(m_seen))
        m_isPictureChanged = true;
    m_seen = std::move(now);
    markScene();
    update();
}

void Viewport::rebuildScene()
{
    m_scene = m_builder.build(m_bench.session().model());
    markScene();
    m_isPictureChanged = true;
    update();
}

/// Which sections are hovered, selected, or stand back.
void Viewport::markScene()
{
    const Interaction &interaction = m_bench.interaction();
    const Model &model = m_bench.session().model();
    if (model.sectionCount() != m_scene.sections.size())
        return; // rebuilt at once after this
    const std::set<SectionRef> selected(interaction.selection().begin(),
                                        interaction.selection().end());
    const auto &outlined = m_bench.outlined();
    applyView(m_scene, model, interaction.view());
    const bool isDrawing =
        interaction.overlay().stroke.has_value() || hasPath(interaction.overlay());
    // All stand back for the section that is being drawn: the one that is not as it was.
    const Model &committed = m_bench.session().committed();
    const auto isAsItWas = [&](std::size_t i) {
        return i < committed.sectionCount() && committed.section(i) == model.section(i);
    };
    for (std::size_t i = 0; i < m_scene.sections.size(); ++i) {
        SceneSection &section = m_scene.sections[i];
        section.isSelected = !selected.empty() && selected.contains(model.ref(i));
        section.isHovered = interaction.overlay().hovered == static_cast<int>(i) ||
                            std::binary_search(outlined.begin(), outlined.end(), model.ref(i));
        section.isGhost = isDrawing ? isAsItWas(i) : section.isGhost;
    }
}

} // namespace fff::ui
