#include "ui/window/adjusting.h"

#include "core/interaction/value_editing.h"
#include "ui/actions/action_set.h"
#include "ui/bench/workbench.h"
#include "ui/docks/values_dock.h"
#include "ui/window/adjust_bar.h"
#include "ui/window/window_layout.h"

#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr Text kOnlyAdjusted =
    FFF_TEXT("Command", "The model is here to be adjusted; “Edit the design” brings all back");

constexpr std::string_view kLetThrough[] = {
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

Adjusting::Adjusting(Workbench &bench, ActionSet &actions, WindowLayout &layout, ValuesDock &values,
                     AdjustBar &bar, const QMenuBar &menus, QObject *parent)
    : QObject(parent), m_bench(bench), m_actions(actions), m_layout(layout), m_values(values),
      m_bar(bar)
{
    for (const QAction *action : menus.actions())
        if (action->menu() && action->isVisible())
            m_menus.push_back(action->menu());
    m_layout.setOnly(nullptr, &m_bar);
    connect(&bench.session(), &Session::modelChanged, this, &Adjusting::follow);
    connect(&bench.session(), &Session::committedChanged, this, &Adjusting::follow);
    connect(&bench.session(), &Session::replaced, this, [this] { m_isOpened = true; });
    follow();
}

void Adjusting::offerValues()
{
    if (!m_isOpened || !m_values.window()->isVisible())
        return;
    m_isOpened = false;
    const bool hasShown = hasShownValue(m_bench.session().committed().document.values);
    if (hasShown && !m_isOn && !m_layout.isHidden())
        m_layout.show(&m_values);
}

bool Adjusting::lets(std::string_view command)
{
    return std::ranges::find(kLetThrough, command) != std::end(kLetThrough);
}

void Adjusting::follow()
{
    const bool isOn = m_bench.session().committed().document.opensForAdjusting;
    if (isOn == m_isOn)
        return;
    m_isOn = isOn;
    m_bench.commands().limit(isOn ? lets : nullptr, kOnlyAdjusted);
    m_bench.setLooksOnly(isOn);
    m_values.setAdjustsOnly(isOn);
    m_layout.setOnly(isOn ? &m_values : nullptr, &m_bar);
    m_actions.refresh();
    showUsedMenus();
    Q_EMIT changed();
}

void Adjusting::showUsedMenus()
{
    for (QDockWidget *dock : m_layout.docks())
        dock->toggleViewAction()->setVisible(!m_isOn);
    for (QMenu *menu : m_menus)
        menu->menuAction()->setVisible(showUsed(*menu));
}

} // namespace fff::ui
