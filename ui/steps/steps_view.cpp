#include "ui/steps/steps_view.h"

#include "core/interaction/steps_tool.h"
#include "core/io/error_text.h"
#include "core/session/check_list.h"
#include "ui/bench/viewport.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"
#include "ui/steps/steps_bar.h"
#include "ui/view/offscreen_image.h"
#include "ui/view/steps_scene.h"

#include <QApplication>
#include <QKeyEvent>

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

constexpr double kLongestFrame = 500.0; // ms

/// Of the keys that the view has another use for.
bool isOfSteps(int key)
{
    return key == Qt::Key_Space || key == Qt::Key_Left || key == Qt::Key_Right ||
           key == Qt::Key_Home || key == Qt::Key_End;
}

bool isPlain(const QKeyEvent *event)
{
    return (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
}

/// In a field, a menu or a question: what takes the focus now takes the next keys as well.
bool isElsewhere()
{
    const QWidget *focus = QApplication::focusWidget();
    return QApplication::activeModalWidget() || QApplication::activePopupWidget() ||
           (focus && focus->testAttribute(Qt::WA_InputMethodEnabled));
}

} // namespace

StepsView::StepsView(Workbench &bench, const CheckList &list, Viewport *viewport, QObject *parent)
    : QObject(parent), m_bench(bench), m_list(list), m_viewport(viewport)
{
    if (!viewport)
        return;
    m_bar = new StepsBar(viewport);
    viewport->installEventFilter(this);
    viewport->window()->installEventFilter(this); // Esc, wherever nobody else has a use for it
    connect(m_bar, &StepsBar::playWanted, this, [this] { act(Qt::Key_Space); });
    connect(m_bar, &StepsBar::previousWanted, this, [this] { act(Qt::Key_Left); });
    connect(m_bar, &StepsBar::nextWanted, this, [this] { act(Qt::Key_Right); });
    connect(m_bar, &StepsBar::timeChosen, this, [this](double time) {
        if (!isOpen())
            return;
        m_player->jumpTo(time);
        follow();
    });
    connect(m_bar, &StepsBar::drawnApartChanged, this, [this] {
        if (!isOpen())
            return;
        bringIntoSight();
        follow();
    });
    connect(m_bar, &StepsBar::closeWanted, this, [this] { m_bench.layDownTool(); });
    connect(m_bar, &StepsBar::exportWanted, this, &StepsView::exportWanted);
    connect(&bench, &Workbench::viewStateChanged, this, [this] {
        const Tool *tool = m_bench.interaction().tool();
        if (isOpen() && !(tool && tool->command() == StepsTool::kCommand))
            close();
    });
    connect(&bench, &Workbench::viewChanged, this, &StepsView::follow);
    connect(&bench, &Workbench::viewChanged, this, &StepsView::followWork);
    connect(&list, &CheckList::changed, this, &StepsView::followWork);
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        if (m_isWaiting)
            giveUp(tr("The model has changed, so its steps are not shown."));
    });
}

StepsView::~StepsView() = default;

AssemblyStepsPointer StepsView::steps() const
{
    return m_scene ? m_scene->pointer() : nullptr;
}

double StepsView::time() const
{
    return m_player ? m_player->time() : 0.0;
}

void StepsView::refresh()
{
    if (m_bar)
        m_bar->refresh();
}

void StepsView::fit()
{
    if (isOpen() && m_viewport->steps() && !m_viewport->steps()->scene.sections.empty())
        m_bench.setCamera(fitted(m_viewport->steps()->scene, m_bench.interaction().targetCamera()));
}

/// Above the bar.
Camera StepsView::fitted(const Scene &scene, const Camera &from) const
{
    const Vec2 size = m_bench.interaction().viewport();
    const Vec2 below(0.0, size.y() - m_bar->y());
    return panned(cameraFor(scene, from, size - below), 0.5 * below, Vec2::Zero(), size);
}

/// Above the bar, too.
bool StepsView::isInSight(const Scene &scene, const Camera &camera) const
{
    const Vec2 size = m_bench.interaction().viewport();
    const Box2 room{Vec2::Zero(), Vec2(size.x(), m_bar->y())};
    return std::all_of(
        scene.sections.begin(), scene.sections.end(), [&](const SceneSection &section) {
            const std::vector<Vec2> &outer = section.shape->region().outer;
            return std::all_of(outer.begin(), outer.end(), [&](const Vec2 &p) {
                return room.contains(camera.toScreen(section.frame.toWorld(p), size));
            });
        });
}

/// The view stays as somebody has it where the finished model, drawn apart as it is, can be seen in
/// it; else nobody would see what comes to lie under the bar, or beside the view. It goes back
/// there when the parts come together again, unless it was moved meanwhile.
void StepsView::bringIntoSight()
{
    const Scene whole = m_scene->sceneAt(m_player->stepCount(), m_bar->drawnApart());
    if (whole.sections.empty())
        return;
    const Camera now = m_bench.interaction().targetCamera();
    if (!m_brought || !(m_brought->to == now))
        m_brought = Brought{now, now};
    const Camera &from = m_brought->from;
    m_brought->to = isInSight(whole, from) ? from : fitted(whole, from);
    if (!(m_brought->to == now))
        m_bench.setCamera(m_brought->to);
}

void StepsView::toggle()
{
    if (isOpen()) {
        m_bench.layDownTool();
        return;
    }
    if (!m_viewport) {
        Q_EMIT said(tr("The steps cannot be shown on this display."));
        return;
    }
    if (m_isWaiting) {
        giveUp(tr("The steps will not be shown."));
        return;
    }
    if (m_bench.session().hasPreview())
        m_bench.escape(); // what is still being drawn has no steps
    if (isPlanned()) {
        openPlanned();
        return;
    }
    m_heldTool = m_bench.interaction().tool();
    setWaiting(true);
    Q_EMIT said(tr("Working out the order of assembly; the steps are shown as soon as it is "
                   "known."));
    followWork(); // it may have come to nothing already
}

/// What is waited for will not come.
std::optional<Error> StepsView::whyNotPlanned() const
{
    const Scheduler &scheduler = m_list.scheduler();
    return scheduler.isSettled(kPlanned.name) ? scheduler.whyNot(kPlanned.name) : std::nullopt;
}

void StepsView::setWaiting(bool waits)
{
    if (std::exchange(m_isWaiting, waits) != waits)
        Q_EMIT waitingChanged(waits);
}

void StepsView::giveUp(const QString &why)
{
    setWaiting(false);
    Q_EMIT said(why);
}

void StepsView::followWork()
{
    if (!m_isWaiting)
        return;
    if (const auto why = whyNotPlanned()) {
        //: %1 is a sentence
        giveUp(tr("The steps cannot be shown: %1.").arg(io::errorSentence(*why).toHtmlEscaped()));
        return;
    }
    const Interaction &interaction = m_bench.interaction();
    const bool hasGesture = interaction.hasGesture();
    if (interaction.tool() != m_heldTool || (hasGesture && !interaction.hint().isOfView))
        giveUp(tr("The steps will not be shown."));
    else if (!hasGesture && isPlanned()) // else they come when it is over
        openPlanned(isElsewhere());
}

/// The plan may be older than the drawing: then the next one is waited for.
bool StepsView::isPlanned() const
{
    const Session &session = m_bench.session();
    const auto &planned = m_list.plan();
    return session.model().sectionCount() == 0 ||
           (!session.hasPreview() && session.analysedRevision() == session.revision() && planned &&
            planned->analysis == session.analysisPointer());
}

void StepsView::openPlanned(bool isElsewhere)
{
    setWaiting(false);
    const Session &session = m_bench.session();
    if (session.model().sectionCount() == 0) {
        Q_EMIT said(whyNoSteps(session.analysis(), {}).toHtmlEscaped());
        return;
    }
    const PlannedAnalysis &planned = *m_list.plan();
    AssemblyStepsPointer steps = assemblySteps(planned.analysis, planned.plan);
    if (!steps)
        Q_EMIT said(whyNoSteps(*planned.analysis, planned.plan).toHtmlEscaped());
    else if (isElsewhere)
        Q_EMIT said(tr("The order of assembly is known now; \u201cShow the steps\u201d shows it."));
    else
        open(std::move(steps));
}

void StepsView::open(AssemblyStepsPointer steps)
{
    const bool jumps = settings().reducesMotion();
    m_player = std::make_shared<StepsPlayer>(steps->playback.stepCount(), jumps);
    m_shown.reset();
    m_brought.reset();
    m_bench.setMarksAside(true);
    m_bar->setStepCount(steps->playback.stepCount());
    m_bar->resetDrawnApart();
    m_scene = std::make_unique<StepsScene>(std::move(steps));
    m_bench.pickUp(std::make_unique<StepsTool>(m_player));
    if (jumps)
        m_player->jumpTo(1.0);
    else
        m_player->play(now());
    show();
    m_bar->show();
    m_bar->raise();
    bringIntoSight();
    m_viewport->setFocus();
    m_bench.advance(); // frames from now on
}

void StepsView::close()
{
    m_scene.reset();
    m_player->pause();
    m_bar->hide();
    m_viewport->showSteps(nullptr);
    m_bench.setMarksAside(false);
    // Who only looked at the steps finds the view as it was.
    if (m_brought && m_brought->to == m_bench.interaction().targetCamera())
        m_bench.setCamera(m_brought->from);
    m_brought.reset();
    m_viewport->setFocus();
}

/// ms. Where no frame came for long, the program was busy or the clock was set by its first event:
/// no step is left out for that.
double StepsView::now()
{
    const double now = m_bench.clock().now();
    m_leftOut += std::max(0.0, now - std::exchange(m_lastFrame, now) - kLongestFrame);
    return now - m_leftOut;
}

void StepsView::follow()
{
    if (!isOpen())
        return;
    m_player->advance(now());
    const Interaction &interaction = m_bench.interaction();
    const bool isSame =
        m_shown && m_shown->time == m_player->time() &&
        m_shown->drawnApart == m_bar->drawnApart() && m_shown->camera == interaction.camera() &&
        m_shown->viewport == interaction.viewport() && m_shown->isPlaying == m_player->isPlaying();
    if (isSame)
        return;
    // As long as nobody has moved the view, all of it stays in sight.
    const bool hasOtherRoom = m_shown && m_shown->viewport != interaction.viewport() && m_brought &&
                             m_brought->to == m_shown->camera;
    show();
    if (hasOtherRoom)
        bringIntoSight();
}

void StepsView::show()
{
    const Interaction &interaction = m_bench.interaction();
    const AssemblySteps &steps = m_scene->steps();
    m_shown = Shown{m_player->time(), m_bar->drawnApart(), interaction.camera(),
                    interaction.viewport(), m_player->isPlaying()};
    m_viewport->showSteps(std::make_shared<StepsPicture>(
        m_scene->at(m_shown->time, m_shown->drawnApart, m_shown->camera, m_shown->viewport)));
    const int step = steps.playback.stepAt(m_shown->time);
    const QString sentence =
        step < 0
            ? tr("<b>Nothing is there yet.</b> Step 1: %1").arg(stepText(steps, 0).toHtmlEscaped())
            //: %1 is "Step 4 of 38", %2 what is done in it
            : tr("<b>%1:</b> %2")
                  .arg(stepTitle(steps, step).toHtmlEscaped(),
                       stepText(steps, step).toHtmlEscaped());
    m_bar->show(m_shown->time, sentence, m_player->isPlaying());
}

/// What a key does, or the button that stands for it.
bool StepsView::act(int key)
{
    if (!isOpen())
        return false;
    const double now = this->now();
    m_player->advance(now);
    switch (key) {
    case Qt::Key_Space:
        if (m_player->isPlaying())
            m_player->pause();
        else
            m_player->play(now);
        break;
    case Qt::Key_Left:
        m_player->previous(now);
        break;
    case Qt::Key_Right:
        m_player->next(now);
        break;
    case Qt::Key_Home:
        m_player->jumpTo(0.0);
        break;
    case Qt::Key_End:
        m_player->jumpTo(m_player->stepCount());
        break;
    default:
        return false;
    }
    m_bench.advance(); // asks for frames, and what is shown follows
    return true;
}

bool StepsView::eventFilter(QObject *object, QEvent *event)
{
    if (m_isWaiting && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent *>(event)->key() == Qt::Key_Escape &&
        !m_bench.interaction().hasGesture()) {
        giveUp(tr("The steps will not be shown."));
        return true;
    }
    if (!isOpen() || object != m_viewport)
        return QObject::eventFilter(object, event);
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        auto *key = static_cast<QKeyEvent *>(event);
        if (isPlain(key) && isOfSteps(key->key())) {
            key->accept();
            if (event->type() == QEvent::KeyPress &&
                !(key->isAutoRepeat() && key->key() == Qt::Key_Space)) {
                m_bench.clock().observe(key->timestamp());
                act(key->key());
            }
            return true;
        }
    }
    return QObject::eventFilter(object, event);
}

} // namespace fff::ui
