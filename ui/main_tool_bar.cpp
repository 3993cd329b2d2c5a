#include "ui/main_tool_bar.h"

#include "ui/actions/action_set.h"
#include "ui/icon.h"
#include "ui/properties/stock_box.h"
#include "ui/theme.h"
#include "ui/workbench.h"

#include <QPushButton>

namespace fff::ui {

namespace {

// px; what a narrower window has not
constexpr int kToolLabels = 1400, kWholeStock = 1240;

} // namespace

MainToolBar::MainToolBar(Workbench &bench, const ActionSet &actions, QWidget *parent)
    : QToolBar(tr("Tool bar"), parent), m_bench(bench)
{
    setObjectName(QStringLiteral("mainToolBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setIconSize({20, 20});
    actions.fill(this,
                 {"file.new", "file.open", "file.save", "", "edit.undo", "edit.redo", "",
                  "section.symmetry", "section.ground", "section.snap", "section.pen", "",
                  "section.redraw", "section.addHole", "section.planeGround", "", "view.fitAll"});

    for (QAction *action : this->actions()) {
        if (QWidget *button = widgetForAction(action); button && !action->isSeparator())
            button->setFocusPolicy(Qt::TabFocus); // a click leaves it where it was
    }

    auto *stretch = new QWidget(this);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(stretch);
    m_stock = new StockBox(m_bench, this);
    connect(m_stock, &StockBox::editorWanted, actions.action("fabricate.stocks"),
            &QAction::trigger);
    addWidget(m_stock);
    auto *gap = new QWidget(this);
    gap->setFixedWidth(8);
    addWidget(gap);
    makeExport(actions.action("file.export"));
}

void MainToolBar::makeExport(QAction *exporting)
{
    m_export = new QPushButton(exporting->iconText(), this);
    m_export->setObjectName(QStringLiteral("exportButton"));
    m_export->setIconSize({18, 18});
    const auto follow = [this, exporting] {
        m_export->setEnabled(exporting->isEnabled());
        m_export->setToolTip(exporting->toolTip());
    };
    follow();
    connect(exporting, &QAction::changed, m_export, follow);
    connect(m_export, &QPushButton::clicked, exporting, &QAction::trigger);
    addWidget(m_export);
}

void MainToolBar::fold(int windowWidth)
{
    const bool labels = windowWidth >= kToolLabels;
    setToolButtonStyle(labels ? Qt::ToolButtonTextUnderIcon : Qt::ToolButtonIconOnly);
    setFixedHeight(labels ? 56 : 44);
    m_stock->setShort(windowWidth < kWholeStock);
}

void MainToolBar::refresh()
{
    const auto mask = [this](const QColor &colour) {
        return tintedPixmap(QStringLiteral("export"), 18, colour, devicePixelRatioF());
    };
    QIcon exporting(mask(theme().onAccent));
    exporting.addPixmap(mask(theme().muted), QIcon::Disabled);
    m_export->setIcon(exporting);
}

} // namespace fff::ui
