#include "ui/window/window_scope.h"

#include "core/interaction/value_editing.h"
#include "ui/actions/action_set.h"
#include "ui/bench/workbench.h"
#include "ui/docks/dock_title.h"
#include "ui/docks/values_dock.h"
#include "ui/settings/settings.h"
#include "ui/window/window_layout.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr Text kOnlyAdjusted =
    FFF_TEXT("Command", "The model is here to be adjusted; “Edit the design” brings all back");
constexpr Text kOnlySimple =
    FFF_TEXT("Command", "The simple window does without it; Settings have the whole one");

constexpr std::string_view kOfAdjusting[] = {
    "file.new",          "file.open",   "file.save",       "file.saveAs",
    "file.revert",       "file.export", "file.settings",   "file.exportAgain",
    "file.shortcuts",    "file.close",  "file.quit",       "edit.undo",
    "edit.redo",         "edit.find",   "view.front",      "view.top",
    "view.right",        "view.back",   "view.bottom",     "view.left",
    "view.iso",          "view.fitAll", "view.previous",   "view.nextPane",
    "view.previousPane", "view.xray",   "view.shadow",     "view.perspective",
    "view.fullScreen",   "view.values", "help.firstSteps", "help.start",
    "help.about",        "value.set",   "value.handOn",    "preset.take",
    "check.showAssembly"};

/// The simple window has what draws, changes and looks at what was drawn; it does without what
/// repeats, weighs, measures, imports and marks.
constexpr std::string_view kKindsOfSimple[] = {"value.set", "preset.take", "file.",  "edit.",
                                               "view.",     "section.",    "point.", "joint.",
                                               "check.",    "transform.",  "help."};
constexpr std::string_view kNotSimple[] = {"file.insert",
                                           "file.addToLibrary",
                                           "edit.mirror",
                                           "edit.mirrorCopyX",
                                           "edit.mirrorCopyY",
                                           "edit.mirrorCopyZ",
                                           "edit.mirrorCopySection",
                                           "view.clip",
                                           "view.skin",
                                           "view.values",
                                           "view.newValue",
                                           "view.properties",
                                           "view.docks",
                                           "view.resetWindow",
                                           "check.stress",
                                           "section.mark",
                                           "section.importContour",
                                           "section.importHoles",
                                           "section.importMarks",
                                           "section.importSections",
                                           "section.lock",
                                           "section.holdTo",
                                           "section.putOn",
                                           "section.free",
                                           "section.makeOrthogonal",
                                           "section.snapNormal",
                                           "edit.selectParallel",
                                           "edit.selectSameStock",
                                           "edit.selectConnected"};

/// Whether anything is left of it; what opens beside it goes with all that is in there.
bool showUsed(QMenu &menu)
{
    bool isUsed = false;
    for (QAction *action : menu.actions()) {
        if (action->isSeparator())
            continue;
        QMenu *beside = action->menu();
        if (beside && beside->objectName() != QStringLiteral("recentMenu"))
            action->setVisible(showUsed(*beside));
        isUsed = isUsed || action->isVisible();
    }
    return isUsed;
}

} // namespace

WindowScope::WindowScope(Workbench &bench, ActionSet &actions, WindowLayout &layout,
                         const Parts &parts, const QMenuBar &menus, QObject *parent)
    : QObject(parent), m_bench(bench), m_actions(actions), m_layout(layout), m_parts(parts)
{
    for (const QAction *action : menus.actions())
        if (action->menu() && action->isVisible())
            m_menus.push_back(action->menu());
    m_layout.setOwnBar(m_parts.adjustBar);
    connect(&bench.session(), &Session::modelChanged, this, &WindowScope::follow);
    connect(&bench.session(), &Session::committedChanged, this, &WindowScope::follow);
    connect(&bench.session(), &Session::replaced, this, [this] { m_isOpened = true; });
    connect(&settings(), &Settings::simpleWindowChanged, this, &WindowScope::follow);
    follow();
}

void WindowScope::offerValues()
{
    if (!m_isOpened || !m_parts.values->window()->isVisible())
        return;
    m_isOpened = false;
    const bool hasShown = hasShownValue(m_bench.session().committed().document.values);
    if (hasShown && m_scope == Scope::Whole && !m_layout.isHidden())
        m_layout.show(m_parts.values);
}

bool WindowScope::lets(Scope scope, std::string_view command)
{
    if (scope == Scope::Adjusting)
        return std::ranges::find(kOfAdjusting, command) != std::end(kOfAdjusting);
    return scope == Scope::Whole ||
           (std::ranges::any_of(
                kKindsOfSimple,
                [command](std::string_view kind) { return command.starts_with(kind); }) &&
            std::ranges::find(kNotSimple, command) == std::end(kNotSimple));
}

WindowScope::Scope WindowScope::wanted() const
{
    if (m_bench.session().committed().document.opensForAdjusting)
        return Scope::Adjusting;
    return settings().hasSimpleWindow() ? Scope::Simple : Scope::Whole;
}

void WindowScope::follow()
{
    const Scope scope = wanted();
    const bool hasValues =
        scope != Scope::Whole && hasShownValue(m_bench.session().committed().document.values);
    if (scope == m_scope && hasValues == m_hasValues)
        return;
    m_scope = scope;
    m_hasValues = hasValues;
    const bool isWhole = scope == Scope::Whole;
    m_bench.commands().limit(
        isWhole ? std::function<bool(std::string_view)>()
                : [scope](std::string_view command) { return lets(scope, command); },
        isAdjusting() ? kOnlyAdjusted : kOnlySimple);
    m_bench.setLooksOnly(isAdjusting());
    m_parts.values->setAdjustsOnly(!isWhole);
    setDockFixed(*m_parts.simple, scope == Scope::Simple);
    WindowLayout::Only only;
    only.hasOwnBar = isAdjusting();
    if (scope == Scope::Simple)
        only.docks.emplace_back(m_parts.simple, Qt::LeftDockWidgetArea);
    if (isAdjusting() || hasValues) // what can be set is for whoever has the simple window, too
        only.docks.emplace_back(m_parts.values, Qt::RightDockWidgetArea);
    m_layout.setOnly(only);
    m_actions.refresh();
    showUsedMenus();
    Q_EMIT changed();
}

void WindowScope::showUsedMenus()
{
    for (QDockWidget *dock : m_layout.docks())
        dock->toggleViewAction()->setVisible(m_scope == Scope::Whole);
    for (QMenu *menu : m_menus)
        menu->menuAction()->setVisible(showUsed(*menu));
}

} // namespace fff::ui
