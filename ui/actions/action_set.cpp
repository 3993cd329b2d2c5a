#include "ui/actions/action_set.h"

#include "core/geometry/figure.h"
#include "core/interaction/measure_tool.h"
#include "core/interaction/tool.h"
#include "ui/actions/action_table.h"
#include "ui/base/icon.h"
#include "ui/bench/workbench.h"
#include "ui/settings/settings.h"

#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

namespace fff::ui {

namespace {

constexpr char kSentence[] = "sentence"; // of the tooltip, without the shortcut

/// Checked while their tool is in the hand.
constexpr const char *kTools[] = {
    "section.planeGround", "section.planeFront", "section.planeSide", "section.planeParallel",
    "section.redraw",      "section.addHole",    "section.pen",       "check.showAssembly",
    "operation.linear",    "operation.revolve",  "operation.blend",   "operation.branch",
    "operation.grid",      "operation.radial",   "operation.mirror",  "operation.rotational",
    "operation.array",     "section.transform",  "section.putOn",     "edit.mirrorCopySection",
    "section.addShape",    "section.mark",       "measure.ruler",     "measure.dimension"};

const ActionRow &rowOf(const QString &id)
{
    for (const ActionRow &row : actionTable()) {
        if (id == QLatin1String(row.id))
            return row;
    }
    Q_UNREACHABLE();
}

QStringList words(const char *text)
{
    return QString::fromLatin1(text).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}

} // namespace

ActionSet::ActionSet(Workbench &bench, QObject *parent) : QObject(parent), m_bench(bench)
{
    for (const ActionRow &row : actionTable()) {
        auto *action = new QAction(tr(row.text), this);
        action->setObjectName(QLatin1String(row.id));
        action->setIconText(tr(row.shortText));
        action->setIcon(themedIcon(QLatin1String(row.icon)));
        action->setCheckable(row.isCheckable);
        action->setWhatsThis(tr(row.tip)); // also while the tooltip says why it cannot be done
        if (row.isForView)
            action->setShortcutContext(Qt::WidgetShortcut);
        const QString id = action->objectName();
        connect(action, &QAction::triggered, this, [this, id] { Q_EMIT triggered(id); });
        m_actions.insert(id, action);
        setTip(action, tr(row.tip));
    }
    action("file.quit")->setMenuRole(QAction::QuitRole);
    action("file.settings")->setMenuRole(QAction::PreferencesRole);
    action("help.about")->setMenuRole(QAction::AboutRole);

    connect(&settings(), &Settings::shortcutsChanged, this, &ActionSet::applyShortcuts);
    connect(&settings(), &Settings::drawingChanged, this, &ActionSet::refresh);
    connect(&bench, &Workbench::selectionChanged, this, &ActionSet::refresh);
    connect(&bench, &Workbench::viewStateChanged, this, &ActionSet::refresh);
    connect(&bench.session(), &Session::modelChanged, this, [this] {
        if (!m_bench.session().hasPreview()) // in a drag nothing else can be done
            refresh();
    });
    connect(bench.session().history(), &QUndoStack::indexChanged, this, &ActionSet::refresh);
    applyShortcuts();
    refresh();
}

QAction *ActionSet::action(const char *id) const
{
    return m_actions.value(QLatin1String(id));
}

void ActionSet::fill(QMenu *menu, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            menu->addAction(action(id));
        else
            menu->addSeparator();
    }
}

void ActionSet::fill(QToolBar *bar, std::initializer_list<const char *> ids) const
{
    for (const char *id : ids) {
        if (*id)
            bar->addAction(action(id));
        else
            bar->addSeparator();
    }
}

void ActionSet::fill(QMenuBar *bar, const std::function<void(const QString &, QMenu *)> &own) const
{
    for (const MenuRow &row : menuTable())
        if (!row.key)
            fill(bar->addMenu(tr(row.title)), row, own);
}

void ActionSet::fill(QMenu *menu, const MenuRow &row,
                     const std::function<void(const QString &, QMenu *)> &own) const
{
    menu->setToolTipsVisible(true); // greyed entries say why
    for (const QString &id : words(row.ids)) {
        if (id == QStringLiteral("|"))
            menu->addSeparator();
        else if (id.startsWith(u'@'))
            own(id, menu);
        else if (!id.startsWith(u'>'))
            menu->addAction(m_actions.value(id));
        else
            for (const MenuRow &beside : menuTable())
                if (beside.key && id.mid(1) == QLatin1String(beside.key))
                    fill(menu->addMenu(tr(beside.title)), beside, own);
    }
}

void ActionSet::fill(QMenu *menu, const char *key) const
{
    for (const MenuRow &row : menuTable())
        if (row.key && QLatin1String(key) == QLatin1String(row.key))
            fill(menu, row, {});
    for (QAction *action : menu->actions())
        if (!action->isSeparator() && !action->menu() &&
            !(action->isEnabled() &&
              m_bench.commands().isEnabled(action->objectName().toStdString())))
            menu->removeAction(action);
}

void ActionSet::addViewShortcuts(QWidget *view) const
{
    for (const ActionRow &row : actionTable()) {
        if (row.isForView)
            view->addAction(action(row.id));
    }
}

QList<QKeySequence> ActionSet::ownShortcuts(const QString &id)
{
    QList<QKeySequence> shortcuts;
    for (const QString &keys : words(rowOf(id).shortcuts))
        shortcuts += QKeySequence(keys, QKeySequence::PortableText);
    return shortcuts;
}

QList<QKeySequence> ActionSet::shortcuts(const QString &id)
{
    return settings().shortcuts(id).value_or(ownShortcuts(id));
}

void ActionSet::applyShortcuts()
{
    for (QAction *action : qAsConst(m_actions)) {
        const QList<QKeySequence> keys = shortcuts(action->objectName());
        if (action->shortcuts() != keys)
            action->setShortcuts(keys);
        setTip(action, action->property(kSentence).toString());
    }
}

void ActionSet::setTip(QAction *action, const QString &sentence)
{
    action->setProperty(kSentence, sentence);
    const QString keys = action->shortcut().toString(QKeySequence::NativeText);
    action->setToolTip(keys.isEmpty() ? sentence : QStringLiteral("%1 (%2)").arg(sentence, keys));
}

QString ActionSet::sentence(const QAction *action)
{
    return action->property(kSentence).toString();
}

void ActionSet::setAble(const char *id, bool able, const QString &whyNot)
{
    QAction *a = action(id);
    a->setEnabled(able);
    setTip(a, able ? tr(rowOf(a->objectName()).tip) : whyNot);
}

void ActionSet::setWaiting(const char *id, bool waits)
{
    if (waits)
        m_waiting.insert(QLatin1String(id));
    else
        m_waiting.remove(QLatin1String(id));
    refresh();
}

void ActionSet::refresh()
{
    const QUndoStack &history = *m_bench.session().history();
    const bool hasSections = m_bench.session().model().sectionCount() > 0;
    const bool hasSelection = !m_bench.interaction().sectionsInFocus().empty();

    // Points of an open path go first.
    const Interaction &interaction = m_bench.interaction();
    const auto setStep = [this](const char *id, bool isInTool, bool isInHistory,
                                const QString &step, const QString &what, const QString &named,
                                const QString &whyNot) {
        const QString name = isInTool ? tr("Set a point") : step;
        const bool can = isInTool || isInHistory;
        QAction *a = action(id);
        a->setEnabled(can);
        a->setText(can ? named.arg(name) : what);
        a->setIconText(QString(what).remove(u'&'));
        setTip(a, can ? QString(named.arg(name)).remove(u'&') : whyNot);
    };
    setStep("edit.undo", interaction.canUndoInTool(), history.canUndo(), history.undoText(),
            tr("&Undo"), tr("&Undo \u201c%1\u201d"), tr("There is no step to take back"));
    setStep("edit.redo", interaction.canRedoInTool(), history.canRedo(), history.redoText(),
            tr("&Redo"), tr("&Redo \u201c%1\u201d"), tr("No step was taken back"));

    const QString nothingThere = tr("There is no section yet");
    const QString nothingSelected = tr("No section is selected");
    setAble("file.export", hasSections, nothingThere);
    setAble("edit.selectAll", hasSections, nothingThere);
    const bool hasJoint = interaction.selectedJoint().has_value();
    const OperationId inFocus = interaction.operationInFocus();
    setAble("edit.delete",
            !interaction.selection().empty() || hasJoint ||
                interaction.selectedOperation().isValid(),
            nothingSelected);
    const auto &operations = m_bench.session().committed().document.operations;
    const QString noOperation = tr("No operation is selected");
    for (const char *id : {"operation.switch", "operation.bake"})
        setAble(id, inFocus.isValid(), noOperation);
    setAble("operation.moveUp", inFocus.isValid() && operations.front()->id != inFocus,
            inFocus.isValid() ? tr("It is the first one") : noOperation);
    setAble("operation.moveDown", inFocus.isValid() && operations.back()->id != inFocus,
            inFocus.isValid() ? tr("It is the last one") : noOperation);
    setAble("operation.symmetric", hasSections, nothingThere);
    setAble("view.faceSelection", hasSelection, nothingSelected);
    setAble("view.fitSelection", hasSelection || hasJoint, nothingSelected);
    const QString noJoint = tr("No joint is selected: select a section, then one of its joints");
    setAble("joint.flip", hasJoint, noJoint);
    setAble("joint.reset", m_bench.commands().isEnabled("joint.reset"),
            hasJoint ? tr("Nothing of this joint is set by hand") : noJoint);

    const ViewState &view = interaction.view();
    const bool isIsolated = !view.isolated.empty();
    setAble("view.previous", interaction.canGoBack(), tr("There is no view before this one"));
    setAble("view.isolate", hasSelection || isIsolated, nothingSelected);
    setAble("view.hide", hasSelection, nothingSelected);
    setAble("view.showAll", isIsolated || !view.hidden.empty(), tr("No section is hidden"));
    setAble("view.clip", hasSections, nothingThere);
    setAble("check.showAssembly", hasSections, nothingThere);
    action("view.perspective")->setChecked(interaction.targetCamera().isPerspective());
    action("view.xray")->setChecked(view.isXray);
    action("view.isolate")->setChecked(isIsolated);
    action("view.clip")->setChecked(view.clip.has_value());
    action("view.shadow")->setChecked(view.hasGround);

    const Tool *tool = interaction.tool();
    const std::string_view held = tool ? tool->command() : std::string_view();
    const bool hasOne = m_bench.interaction().selection().size() == 1;
    const QString selectOne = tr("Select one section first");
    for (const char *id : {"section.redraw", "section.addHole", "section.planeParallel"})
        setAble(id, hasOne || held == id, selectOne);
    for (const char *id : {"edit.cut", "edit.copy", "edit.duplicate", "edit.mirrorCopyX",
                           "edit.mirrorCopyY", "edit.mirrorCopyZ", "edit.mirrorCopySection",
                           "edit.selectConnected", "edit.selectParallel", "edit.selectSameStock"})
        setAble(id, hasSelection || held == id, nothingSelected);
    for (const char *id :
         {"section.transform", "section.mark", "measure.ruler", "measure.dimension"})
        setAble(id, hasSections || held == id, nothingThere);
    for (const char *id : {"section.importContour", "section.importHoles", "section.importMarks"})
        setAble(id, hasOne, selectOne);
    const auto *measuring = dynamic_cast<const MeasureTool *>(tool);
    setAble("measure.keep", measuring && measuring->line(), tr("Nothing is measured"));
    setAble("measure.remove", measuring && measuring->dimension().isValid(),
            tr("No dimension is picked: click one with the tool that measures"));
    const bool drawsShapes = held == "section.addShape";
    for (const FigureKind &kind : figureKinds()) {
        QString id = QString::fromLatin1(kind.key);
        id = QStringLiteral("section.add") + id.front().toUpper() + id.mid(1);
        QAction *of = action(id.toLatin1().constData());
        of->setCheckable(drawsShapes); // of the tool, which one it draws
        of->setChecked(drawsShapes && interaction.settings().figure == kind.key);
    }
    action("mark.engrave")->setChecked(!interaction.settings().scores);
    action("mark.score")->setChecked(interaction.settings().scores);
    setAble("section.putOn", hasOne || held == "section.putOn", selectOne);
    const auto setAsCommand = [this](const char *id, const QString &whyNot) {
        setAble(id, m_bench.commands().isEnabled(id), whyNot);
    };
    const QString onNothing =
        hasSelection ? tr("What is selected is on no other section") : nothingSelected;
    setAsCommand("section.free", onNothing);
    setAsCommand("section.makeOrthogonal", onNothing);
    const QString noDrawn =
        hasSelection ? tr("What is selected is made by an operation") : nothingSelected;
    setAsCommand("section.snapNormal", noDrawn);
    setAsCommand("section.lock", noDrawn);
    setAsCommand("section.removeHoles",
                 hasSelection ? tr("What is selected has no holes") : nothingSelected);
    const QString noMade = hasSelection ? tr("What is selected is drawn") : nothingSelected;
    setAsCommand("operation.editSource", noMade);
    setAsCommand("operation.detach", noMade);
    setAsCommand("operation.leaveOut", noMade);
    setAble("section.dropToGround", m_bench.commands().isEnabled("section.dropToGround"),
            hasSections ? tr("The model stands on the ground") : nothingThere);
    for (const char *id : kTools)
        action(id)->setChecked(held == id || m_waiting.contains(QLatin1String(id)));
    const std::vector<SectionRef> inFocusNow = interaction.sectionsInFocus();
    const Model &model = m_bench.session().model();
    const auto areAll = [&](const auto &is) {
        return !inFocusNow.empty() &&
               std::all_of(inFocusNow.begin(), inFocusNow.end(), [&](const SectionRef &ref) {
                   const Section *section = model.find(ref);
                   return section && is(*section);
               });
    };
    action("section.free")->setChecked(areAll([](const Section &s) {
        return s.parent && s.parent->isFree;
    }));
    action("section.lock")->setChecked(areAll([](const Section &s) { return s.isLocked; }));
    action("transform.inSpace")->setChecked(interaction.settings().movesInSpace);
    action("transform.withChildren")->setChecked(interaction.settings().takesChildren);
    action("section.symmetry")->setChecked(settings().isOn(DrawingSwitch::Symmetry));
    action("section.ground")->setChecked(settings().isOn(DrawingSwitch::Ground));
    action("section.snap")->setChecked(settings().isOn(DrawingSwitch::Snap));
}

} // namespace fff::ui
