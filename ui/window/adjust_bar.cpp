#include "ui/window/adjust_bar.h"

#include "ui/actions/action_set.h"
#include "ui/window/export_button.h"

#include <QAction>
#include <QSizePolicy>
#include <QWidget>

namespace fff::ui {

AdjustBar::AdjustBar(const ActionSet &actions, QWidget *parent)
    : QToolBar(tr("Tool bar for adjusting"), parent)
{
    setObjectName(QStringLiteral("adjustBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setIconSize({20, 20});
    setFixedHeight(44);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    actions.fill(this, {"edit.undo", "edit.redo", "", "view.fitAll", "check.showAssembly"});
    for (QAction *action : this->actions())
        if (QWidget *button = widgetForAction(action); button && !action->isSeparator())
            button->setFocusPolicy(Qt::TabFocus); // a click leaves it where it was
    auto *stretch = new QWidget(this);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(stretch);
    m_export = new ExportButton(actions.action("file.export"), this);
    m_export->setObjectName(QStringLiteral("adjustExport"));
    addWidget(m_export);
}

void AdjustBar::refresh()
{
    m_export->refresh();
}

} // namespace fff::ui
