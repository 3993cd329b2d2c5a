#include "ui/bench/workbench.h"

#include "core/base/units.h"
#include "core/interaction/tool.h"
#include "core/session/copy_commands.h"
#include "core/session/session_commands.h"
#include "core/session/sheet_nesting.h"
#include "core/templates/flat_template.h"
#include "ui/base/naming.h"
#include "ui/bench/clipboard.h"
#include "ui/settings/settings.h"

#include <algorithm>
#include <utility>

namespace fff::ui {

namespace {

/// Where more sections than these would change, the model is seen as it would be, and no more.
constexpr std::size_t kMostTold = 24;

} // namespace

Workbench::Workbench(QObject *parent)
    : QObject(parent), m_host(m_session), m_interaction(std::make_unique<Interaction>(m_host)),
      m_nesting(new SheetNesting(m_session, this))
{
    m_hint = m_interaction->hint();
    m_host.attach(*m_interaction);
    connect(&m_host, &SessionHost::problemChosen, this, &Workbench::problemChosen);
    connect(&m_host, &SessionHost::parameterChosen, this, &Workbench::parameterChosen);
    connect(&m_session, &Session::modelChanged, this, &Workbench::announceChanges);
    registerSessionCommands(m_commands, m_session, *m_interaction);
    registerCopyCommands(m_commands, m_session, *m_interaction, systemClipboard());
    connect(&settings(), &Settings::viewChanged, this, &Workbench::followSettings);
    connect(&settings(), &Settings::drawingChanged, this, &Workbench::followSettings);
    followSettings();
    m_interaction->settings().naming = naming();
}

void Workbench::followSettings()
{
    const Settings &set = settings();
    InteractionSettings &with = m_interaction->settings();
    with.turnTime = set.animationTime(set.turnTime());
    with.turnAngle = radians(set.turnAngle());
    constexpr double kTenth = 0.1; // mm
    with.guideReach = kTenth * set.guideReach();
    with.navigation = set.navigation();
    with.mirrors = set.isOn(DrawingSwitch::Symmetry);
    with.mirrorsFirst = set.isOn(DrawingSwitch::FirstSymmetry);
    with.cutsAtGround = set.isOn(DrawingSwitch::Ground);
    with.snaps = set.isOn(DrawingSwitch::Snap);
}

Workbench::~Workbench()
{
    // The history empties itself as it goes, and would tell so of a session that is half gone.
    disconnect(m_session.history(), nullptr, nullptr, nullptr);
    delete m_nesting; // asks the session, which goes before what hangs on this
}

void Workbench::setMovement(double share)
{
    if (share == m_movement)
        return;
    m_movement = share;
    Q_EMIT movementChanged();
}

void Workbench::setViewport(const Vec2 &size)
{
    m_interaction->setViewport(size);
    if (!m_viewToShow.empty())
        showAll(std::exchange(m_viewToShow, {}));
    announceChanges();
}

void Workbench::setCovered(std::vector<Box2> covered, const std::vector<Box2> &passing)
{
    m_interaction->setCovered(std::move(covered), passing);
    announceChanges();
}

void Workbench::setSeenBesides(std::vector<Vec3> points)
{
    m_interaction->setSeenBesides(std::move(points));
}

void Workbench::handle(const PointerEvent &event)
{
    m_interaction->handle(event);
    announceChanges();
}

bool Workbench::escape()
{
    const bool went = m_interaction->escape(m_clock.now());
    announceChanges();
    return went;
}

bool Workbench::wants(ToolKey key) const
{
    return m_interaction->wants(key);
}

bool Workbench::key(ToolKey key)
{
    const bool wasUsed = m_interaction->key(key, m_clock.now());
    announceChanges();
    return wasUsed;
}

void Workbench::setNumbers(const std::vector<ToolNumber> &numbers)
{
    m_interaction->setNumbers(numbers, m_clock.now());
    announceChanges();
}

void Workbench::dropNumbers()
{
    m_interaction->dropNumbers(m_clock.now());
    announceChanges();
}

bool Workbench::advance()
{
    const bool runs = m_interaction->advance(m_clock.now());
    announceChanges();
    return runs;
}

void Workbench::setCamera(const Camera &camera)
{
    m_interaction->setCamera(camera);
    announceChanges();
}

void Workbench::showAll(std::string_view view)
{
    const Vec2 &size = m_interaction->viewport();
    if (!(size.x() > 1.0 && size.y() > 1.0)) {
        m_viewToShow = view;
        return;
    }
    Camera camera;
    camera.projection = m_interaction->camera().projection;
    orientationOfView(view, camera.orientation);
    m_interaction->fitAll(camera, m_clock.now(), 0.0);
    // What belonged to another document.
    m_interaction->forgetViews();
    ViewState state = m_interaction->view();
    state.hidden.clear();
    state.isolated.clear();
    state.problems.clear();
    state.faulty.clear();
    state.doubtful.clear();
    state.clip.reset();
    m_interaction->setView(std::move(state));
    announceChanges();
}

void Workbench::select(std::vector<SectionRef> selection)
{
    m_interaction->select(std::move(selection));
    announceChanges();
}

void Workbench::selectJoint(const JointRef &joint)
{
    m_interaction->selectJoint(joint);
    announceChanges();
}

void Workbench::selectOperation(OperationId id)
{
    m_interaction->selectOperation(id);
    announceChanges();
}

void Workbench::selectLoad(LoadId id)
{
    m_interaction->selectLoad(id);
    announceChanges();
}

void Workbench::editJoint(JointEdit edit)
{
    if (edit)
        m_host.commit(edit->step, std::move(edit->document));
    else
        m_interaction->say(edit.error(), m_clock.now());
    announceChanges();
}

void Workbench::editPoints(PointEdit edit)
{
    m_interaction->carryOut(std::move(edit), m_clock.now());
    announceChanges();
}

void Workbench::eraseHoveredPoint()
{
    const std::optional<PointTarget> target = m_interaction->hoveredPoint();
    if (!target || target->kind != PointTarget::Kind::Anchor)
        return;
    m_interaction->selectPoints({target->point});
    run(QStringLiteral("point.delete"));
}

void Workbench::editSections(SectionEdit edit)
{
    m_interaction->carryOut(std::move(edit), m_clock.now());
    announceChanges();
}

bool Workbench::nudge(const Vec2 &arrow, double distance)
{
    const bool moved = m_interaction->nudge(arrow, distance, m_clock.now());
    announceChanges();
    return moved;
}

void Workbench::setHidden(const std::vector<SectionRef> &sections, bool hidden)
{
    ViewState view = m_interaction->view();
    for (const SectionRef &ref : sections) {
        if (hidden)
            view.hidden.insert(ref);
        else
            view.hidden.erase(ref);
    }
    m_interaction->setView(std::move(view));
    announceChanges();
}

void Workbench::setProblemMarks(std::vector<ProblemMark> marks)
{
    m_marks = std::move(marks);
    showMarks();
}

void Workbench::setProblemLook(ProblemLook look, const std::vector<SectionRef> &hatched,
                               const std::vector<SectionRef> &outlined,
                               const std::vector<SectionRef> &doubtful)
{
    ViewState view = m_interaction->view();
    view.problems = {hatched.begin(), hatched.end()};
    view.faulty = {outlined.begin(), outlined.end()};
    view.doubtful = {doubtful.begin(), doubtful.end()};
    if (look == m_look && view == m_interaction->view())
        return;
    m_look = std::move(look);
    m_interaction->setView(std::move(view));
    announceChanges();
}

void Workbench::setMarksAside(bool aside)
{
    m_areMarksAside = aside;
    showMarks();
}

void Workbench::showMarks()
{
    const std::vector<ProblemMark> shown = m_areMarksAside ? std::vector<ProblemMark>() : m_marks;
    if (shown == m_interaction->marks())
        return;
    m_interaction->setMarks(shown);
    announceChanges();
}

void Workbench::pickUp(std::unique_ptr<Tool> tool)
{
    m_interaction->pickUp(std::move(tool), m_clock.now());
    announceChanges();
}

void Workbench::layDownTool()
{
    m_interaction->layDown(m_clock.now());
    announceChanges();
}

void Workbench::setLooksOnly(bool looksOnly)
{
    if (looksOnly == m_interaction->looksOnly())
        return;
    m_interaction->setLooksOnly(looksOnly);
    ViewState whole;
    whole.isXray = m_interaction->view().isXray;
    whole.hasGround = m_interaction->view().hasGround;
    m_interaction->setView(std::move(whole));
    announceChanges();
}

void Workbench::setListsJoints(bool lists)
{
    m_interaction->setListsJoints(lists);
    announceChanges();
}

void Workbench::setLitProblem(int number)
{
    if (std::exchange(m_litProblem, number) != number)
        Q_EMIT viewChanged();
}

void Workbench::setOutlined(std::vector<SectionRef> sections, std::vector<SectionPointer> ghosts)
{
    if (sections == m_outlined && ghosts == m_ghosts)
        return;
    m_outlined = std::move(sections);
    m_ghosts = std::move(ghosts);
    Q_EMIT viewChanged();
}

void Workbench::setTraced(TemplateId of, std::shared_ptr<const std::vector<Polygon>> lines)
{
    if (of == m_tracedOf && lines == m_traced)
        return;
    m_tracedOf = of;
    m_traced = std::move(lines);
    Q_EMIT viewChanged();
}

Signs Workbench::tracedSigns() const
{
    Signs signs;
    const Template *one = m_traced ? m_session.model().document.find(m_tracedOf) : nullptr;
    if (one && !one->isHidden)
        if (const auto placement = worldPlacement(*one, m_session.model()))
            signs.add(sign::Outlines{SignRole::Traced, *placement, m_traced});
    return signs;
}

void Workbench::setTried(std::shared_ptr<const Trials::Outcome> tried)
{
    if (tried == m_tried)
        return;
    m_tried = std::move(tried);
    compareTried();
    setMarksAside(m_tried != nullptr); // those are of what is there
    Q_EMIT triedChanged();
}

/// Sections that are others themselves; where there are none, those whose slits are.
void Workbench::compareTried()
{
    m_differing.clear();
    m_wasThere.clear();
    if (!m_tried)
        return;
    const Analysis &now = m_session.analysis();
    const Model &before = now.model, &after = m_tried->analysis->model;
    for (std::size_t i = 0; i < before.sectionCount(); ++i) {
        const int is = after.indexOf(before.ref(i));
        // What operations made anew is another object and may be the same.
        if (is >= 0 && *after.section(static_cast<std::size_t>(is)) == *before.section(i))
            continue;
        m_wasThere.push_back(before.section(i));
        if (is >= 0)
            m_differing.insert(before.ref(i));
    }
    for (std::size_t i = 0; i < after.sectionCount(); ++i)
        if (before.indexOf(after.ref(i)) < 0)
            m_differing.insert(after.ref(i));
    const bool areSlitsAlone = m_wasThere.empty() && m_differing.empty();
    for (std::size_t i = 0; areSlitsAlone && i < after.sectionCount(); ++i)
        if (m_tried->analysis->assembly.slits[i] != now.assembly.slits[i])
            m_differing.insert(after.ref(i));
    if (std::max(m_wasThere.size(), m_differing.size()) > kMostTold) {
        m_wasThere.clear();
        m_differing.clear();
    }
}

bool Workbench::differsInTrial(const SectionRef &ref) const
{
    return m_differing.contains(ref);
}

const Model &Workbench::shownModel() const
{
    return m_tried ? m_tried->analysis->model : m_session.model();
}

void Workbench::announceChanges()
{
    if (m_selection != m_interaction->selection() || m_joint != m_interaction->selectedJoint() ||
        m_operation != m_interaction->selectedOperation() ||
        m_load != m_interaction->selectedLoad()) {
        m_selection = m_interaction->selection();
        m_load = m_interaction->selectedLoad();
        m_operation = m_interaction->selectedOperation();
        // What is asked for is of the one that was selected.
        const Tool *held = m_interaction->tool();
        if (held && held->asksFor().operation.isValid() && held->asksFor().operation != m_operation)
            m_interaction->layDown(m_clock.now());
        m_joint = m_interaction->selectedJoint();
        Q_EMIT selectionChanged();
    }
    if (m_points != m_interaction->points().points()) {
        m_points = m_interaction->points().points();
        Q_EMIT pointsChanged();
    }
    if (!(m_hint == m_interaction->hint())) {
        m_hint = m_interaction->hint();
        Q_EMIT hintChanged();
    }
    const Projection projection = m_interaction->targetCamera().projection;
    const bool canGoBack = m_interaction->canGoBack();
    const Tool *tool = m_interaction->tool();
    const std::string toolCommand = tool ? std::string(tool->command()) : std::string();
    const Tool::Asked asked = tool ? tool->asksFor() : Tool::Asked();
    // What goes with it says what can be done with it now.
    std::vector<std::string_view> offered =
        tool ? tool->commands() : std::vector<std::string_view>();
    if (!(m_view == m_interaction->view()) || m_offered != offered || m_projection != projection ||
        m_couldGoBack != canGoBack || m_toolCommand != toolCommand || !(m_asked == asked) ||
        m_couldUndoInTool != m_interaction->canUndoInTool() ||
        m_couldRedoInTool != m_interaction->canRedoInTool() ||
        m_hadOffer != m_interaction->hasOffer()) {
        m_hadOffer = m_interaction->hasOffer();
        m_couldUndoInTool = m_interaction->canUndoInTool();
        m_couldRedoInTool = m_interaction->canRedoInTool();
        m_toolCommand = toolCommand;
        m_offered = std::move(offered);
        m_asked = asked;
        m_view = m_interaction->view();
        m_projection = projection;
        m_couldGoBack = canGoBack;
        Q_EMIT viewStateChanged();
    }
    const Hovered &over = m_interaction->hovered();
    const std::pair hoveredProblem(over.problem, over.problemPlace);
    if (std::exchange(m_hoveredProblem, hoveredProblem) != hoveredProblem)
        Q_EMIT problemHovered(over.problem);
    Q_EMIT viewChanged();
}

void Workbench::run(const QString &id, const CommandParameters &parameters)
{
    const Result<void> done = m_commands.run(id.toStdString(), parameters, m_clock.now());
    announceChanges();
    if (!done)
        Q_EMIT editFailed(done.error());
}

void Workbench::commit(const Step &step, Result<Document> document)
{
    if (document)
        m_host.commit(step, std::move(*document));
    else
        Q_EMIT editFailed(document.error());
}

void Workbench::commit(const QString &text, Result<Document> document)
{
    if (document)
        m_session.commit(text, std::move(*document));
    else
        Q_EMIT editFailed(document.error());
}

} // namespace fff::ui
