#include "ui/bench/viewport.h"

#include "core/analysis/pulling.h"
#include "core/base/tolerances.h"
#include "core/session/scheduler.h"
#include "ui/base/cursors.h"
#include "ui/base/focus_frame.h"
#include "ui/base/spare_memory.h"
#include "ui/base/theme.h"
#include "ui/bench/marked_scene.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/view/legend.h"
#include "ui/view/steps_scene.h"
#include "ui/view/thing.h"

#include <QContextMenuEvent>
#include <QFocusEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace fff::ui {

namespace {

constexpr int kFrameTime = 12;     // ms between frames of an animation
constexpr int kTidyDelay = 2000;   // ms without a new picture or finding
constexpr int kBusyDelay = 500;    // ms before work is said to be going on
constexpr int kBusyFrame = 80;     // ms between steps of its mark
constexpr double kBusyStep = 0.08; // of a turn

bool isOfKeys(Qt::FocusReason reason)
{
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
           reason == Qt::ShortcutFocusReason;
}

/// px. What is below it in the least window, such as the sheets, leaves it no more.
constexpr QSize kLeastSize{480, 200};

bool isTouch(QEvent::Type type)
{
    return type == QEvent::TouchBegin || type == QEvent::TouchUpdate || type == QEvent::TouchEnd ||
           type == QEvent::TouchCancel;
}

std::vector<Box2> boxesOf(const std::vector<QRectF> &rects)
{
    std::vector<Box2> boxes;
    for (const QRectF &rect : rects)
        boxes.push_back({{rect.left(), rect.top()}, {rect.right(), rect.bottom()}});
    return boxes;
}

bool isBelowGround(const Scene &scene)
{
    return std::any_of(
        scene.sections.begin(), scene.sections.end(),
        [](const SceneSection &section) { return section.bounds.min.y() < -kGroundSunk; });
}

} // namespace

Viewport::Viewport(Workbench &bench, QWidget *parent)
    : QOpenGLWidget(parent), m_bench(bench), m_input(bench, nullptr), m_touch(bench, nullptr),
      m_strained(bench), m_skin(bench)
{
    // The renderer smooths edges by itself, and marks are painted smoothly.
    QSurfaceFormat plain = QSurfaceFormat::defaultFormat();
    plain.setSamples(0);
    setFormat(plain);
    m_sinceStart.start();

    setObjectName(QStringLiteral("viewport"));
    setAccessibleName(tr("View of the model"));
    setAccessibleDescription(tr("Draw with the left mouse button, turn with the right one."));
    setMinimumSize(kLeastSize);
    setMouseTracking(true);
    setAttribute(Qt::WA_AcceptTouchEvents);
    setTabletTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    FocusFrame::leaveTo(this);

    connect(&m_input, &ViewInput::numberBegun, this, &Viewport::numberBegun);
    connect(&m_input, &ViewInput::enterPressed, this, &Viewport::enterPressed);
    connect(&m_input, &ViewInput::menuWanted, this, &Viewport::menuWanted);
    connect(&m_touch, &TouchInput::menuWanted, this, &Viewport::menuWanted);
    m_frames.setInterval(kFrameTime);
    connect(&m_frames, &QTimer::timeout, this, &Viewport::advance);
    const auto once = [this](QTimer &timer, auto act) {
        timer.setSingleShot(true);
        connect(&timer, &QTimer::timeout, this, act);
    };
    once(m_wake, [this] { m_bench.advance(); });
    once(m_rest, [this] { update(); });
    m_tidy.setInterval(kTidyDelay);
    once(m_tidy, [this] {
        if (m_isUsable && isValid()) {
            makeCurrent();
            m_renderer.tidy();
            doneCurrent();
        }
        m_bench.session().scheduler().tidy();
        giveBackSpareMemory();
    });
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
        m_builder.setAnalysis(m_bench.session().analysisPointer());
        rebuildScene();
    });
    connect(&bench.session().scheduler(), &Scheduler::published, this,
            [this](std::string_view stage) {
                m_tidy.start();
                if (stage != kPulled.name)
                    return;
                m_builder.setPulled(m_bench.session().scheduler().result(kPulled));
                rebuildScene();
            });
    connect(&bench, &Workbench::triedChanged, this, [this] {
        m_triedBuilder = {};
        m_triedBuilder.setPulled(m_bench.session().scheduler().result(kPulled));
        if (m_bench.tried())
            m_triedBuilder.setAnalysis(m_bench.tried());
        rebuildScene();
    });
    connect(&m_strained, &StrainedView::changed, this, [this] {
        lookForCovers();
        update();
    });
    connect(&m_skin, &SkinPicture::changed, this, &Viewport::rebuildScene);
    connect(&m_strained, &StrainedView::moved, this, [this] {
        m_isPictureChanged = true;
        update();
    });
    m_builder.setAnalysis(bench.session().analysisPointer());
    m_builder.setPulled(bench.session().scheduler().result(kPulled));
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
        const bool isChanged = std::exchange(m_isPictureChanged, false);
        options.quality = m_pace.begin(frameTime(), isChanged);
        options.isXray = interaction.view().isXray;
        options.hasGround = interaction.view().hasGround && !m_areStepsBelow;
        options.clip = interaction.view().clip;
        const Scene &shown = m_steps ? m_steps->scene : m_strained.shown(m_scene, options);
        m_renderer.render(shown, interaction.camera(), Vec2(width(), height()), devicePixelRatioF(),
                          theme().viewStyle(), options);
        context()->functions()->glFinish(); // the time is that of the picture, not of asking for it
        m_pace.end(frameTime());
        if (const std::optional<double> rest = m_pace.restTime())
            m_rest.start(std::max(1, static_cast<int>(std::ceil(*rest - frameTime()))));
        else
            m_rest.stop();
        m_tidy.start();
    }
    paintMarks();
    if (m_isUsable) {
        m_renderer.drawOver(m_marks);
        return;
    }
    QPainter painter(this);
    painter.fillRect(rect(), theme().viewStyle().bottom);
    painter.drawImage(QPointF(0.0, 0.0), m_marks);
}

/// Badges, chips and bars are widgets of their own over the view.
void Viewport::lookForCovers()
{
    std::vector<QRectF> covered, passing;
    for (const QWidget *above : findChildren<QWidget *>(Qt::FindDirectChildrenOnly))
        if (!above->isHidden() && !above->geometry().isEmpty())
            (above->property(kPassingCover).toBool() ? passing : covered)
                .emplace_back(above->geometry());
    const StressMarks *stress = m_steps ? nullptr : m_strained.stress();
    const BearingMarks *bearing = m_steps ? nullptr : m_strained.bearing();
    if ((stress && worstShown(*stress) > 0.0) || (bearing && bearing->map))
        covered.push_back(legendRoom(Vec2(width(), height())));
    std::vector<QRectF> all = covered;
    all.insert(all.end(), passing.begin(), passing.end());
    if (std::exchange(m_covered, all) == all)
        return;
    m_bench.setCovered(boxesOf(covered), boxesOf(passing));
}

bool Viewport::eventFilter(QObject *object, QEvent *event)
{
    switch (event->type()) {
    case QEvent::Show:
    case QEvent::Hide:
    case QEvent::Move:
    case QEvent::Resize:
        lookForCovers();
        break;
    default:
        break;
    }
    return QOpenGLWidget::eventFilter(object, event);
}

void Viewport::showSteps(std::shared_ptr<const StepsPicture> picture)
{
    if (!picture && !m_steps)
        return;
    // Parts that come from below would come out of the ground: then none is shown.
    m_areStepsBelow = picture && (m_areStepsBelow || isBelowGround(picture->scene));
    m_steps = std::move(picture);
    m_isPictureChanged = true;
    update();
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
    m_strained.press(event->position());
    m_isOfferPressed = event->button() == Qt::LeftButton && isOnOffer(event->position());
    if (m_isOfferPressed)
        m_bench.run(QStringLiteral("section.takeOffer"));
    else
        m_input.press(event);
}

void Viewport::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isOfferPressed)
        return;
    setOnOffer(isOnOffer(event->position()));
    m_input.move(event);
    m_strained.hover(event->position(), Vec2(width(), height()));
}

void Viewport::mouseReleaseEvent(QMouseEvent *event)
{
    if (std::exchange(m_isOfferPressed, false))
        return;
    m_input.release(event);
    if (event->button() == Qt::LeftButton)
        m_strained.release(event->position());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent *event)
{
    // Qt sends this in place of the second press; a stroke must not get lost in it.
    mousePressEvent(event);
}

void Viewport::wheelEvent(QWheelEvent *event)
{
    m_input.wheel(event);
}

#if QT_CONFIG(tabletevent)
void Viewport::tabletEvent(QTabletEvent *event)
{
    showFocus(false);
    if (event->type() == QEvent::TabletPress)
        setFocus(Qt::MouseFocusReason);
    m_touch.penIsNear(event->timestamp());
    m_input.tablet(event);
}
#endif

void Viewport::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_strained.isKept())
        m_strained.close();
    else if (!m_input.keyPress(event))
        QOpenGLWidget::keyPressEvent(event);
}

/// That of the mouse comes with its press, which may become a drag.
void Viewport::contextMenuEvent(QContextMenuEvent *event)
{
    if (event->reason() == QContextMenuEvent::Keyboard)
        Q_EMIT menuKeyPressed();
    event->accept();
}

void Viewport::keyReleaseEvent(QKeyEvent *event)
{
    if (!m_input.keyRelease(event))
        QOpenGLWidget::keyReleaseEvent(event);
}

bool Viewport::event(QEvent *event)
{
    const auto isBeforeShortcuts = [this](const QKeyEvent *key) {
        return m_input.isBeforeShortcuts(key) ||
               (key->key() == Qt::Key_Escape && m_strained.isKept());
    };
    if (event->type() == QEvent::ShortcutOverride &&
        isBeforeShortcuts(static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::NativeGesture &&
        m_input.pinch(static_cast<QNativeGestureEvent *>(event)))
        return true;
    if (isTouch(event->type())) {
        showFocus(false);
        if (event->type() == QEvent::TouchBegin)
            setFocus(Qt::MouseFocusReason);
        m_input.flush();
        m_touch.handle(static_cast<QTouchEvent *>(event));
        return true;
    }
    if (event->type() == QEvent::ChildAdded) {
        if (QObject *child = static_cast<QChildEvent *>(event)->child(); child->isWidgetType())
            child->installEventFilter(this);
    } else if (event->type() == QEvent::ChildRemoved) {
        lookForCovers();
    } else if (event->type() == QEvent::Leave) {
        setOnOffer(false);
        m_input.leave();
        m_strained.leave();
    } else if (event->type() == QEvent::WindowBlocked)
        m_input.letGo();
    else if (event->type() == QEvent::FocusIn)
        showFocus(m_showsFocus || isOfKeys(static_cast<QFocusEvent *>(event)->reason()));
    else if (event->type() == QEvent::FocusOut) {
        m_input.forgetKeys();
        // Back in this window, or behind a menu, it is where it was.
        const Qt::FocusReason reason = static_cast<QFocusEvent *>(event)->reason();
        if (reason != Qt::ActiveWindowFocusReason && reason != Qt::PopupFocusReason)
            showFocus(false);
    }
    return QOpenGLWidget::event(event);
}

void Viewport::advance()
{
    m_input.flush();
    if (!m_bench.advance())
        m_frames.stop();
}

/// Something that is seen may have changed: paints only if it has.
void Viewport::refresh()
{
    lookForCovers();
    const Interaction &interaction = m_bench.interaction();
    if (interaction.isAnimating() && !m_frames.isActive())
        m_frames.start();
    if (const std::optional<double> wake = interaction.wakeTime())
        m_wake.start(std::max(1, static_cast<int>(std::ceil(*wake - m_bench.clock().now()))));
    else
        m_wake.stop();
    m_isOnOffer = m_isOnOffer && interaction.hasOffer();
    const QCursor shape = m_isOnOffer ? QCursor(Qt::PointingHandCursor)
                                      : cursorFor(interaction.cursor(), devicePixelRatioF());
    if (cursor() != shape)
        setCursor(shape);

    Seen now = seenOn(m_bench);
    if (now == m_seen && !now.isDrawn)
        return;
    if (!now.isSamePicture(m_seen))
        m_isPictureChanged = true;
    m_seen = std::move(now);
    markScene(m_scene, m_bench);
    update();
}

void Viewport::rebuildScene()
{
    const SceneBuilder &builder = m_bench.tried() ? m_triedBuilder : m_builder;
    m_scene = builder.build(m_bench.shownModel());
    if (const std::optional<SceneTemplate> skin = m_skin.shown())
        m_scene.templates.push_back(*skin);
    m_bench.setSeenBesides(cornersOf(m_scene.things));
    markScene(m_scene, m_bench);
    m_isPictureChanged = true;
    update();
}

} // namespace fff::ui
