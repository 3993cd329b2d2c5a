#include "ui/window/main_tool_bar.h"

#include "ui/actions/action_set.h"
#include "ui/base/icon.h"
#include "ui/bench/workbench.h"
#include "ui/properties/stock_box.h"
#include "ui/window/export_button.h"

#include <QMenu>
#include <QStyle>
#include <QToolButton>

#include <algorithm>

namespace fff::ui {

namespace {

constexpr int kBetweenButtons = 1; // px, as in the style sheet
// px; what a narrower window has not
constexpr int kToolLabels = 1400, kWholeStock = 1240, kOperationButtons = 1160;

constexpr const char *kOperations[] = {"operation.linear", "operation.revolve", "operation.blend",
                                       "operation.branch", "operation.grid",    "operation.radial",
                                       "edit.mirror"};

} // namespace

MainToolBar::MainToolBar(Workbench &bench, const ActionSet &actions, QWidget *parent)
    : QToolBar(tr("Tool bar"), parent), m_bench(bench)
{
    setObjectName(QStringLiteral("mainToolBar"));
    setMovable(false);
    toggleViewAction()->setVisible(false);
    setIconSize({20, 20});
    actions.fill(this, {"file.new", "file.open", "file.save", "", "edit.undo", "edit.redo", "",
                        "section.symmetry", "section.ground", "section.snap", "section.pen", "",
                        "section.addShape"});
    m_ofDrawing = actions.action("section.addShape");
    m_ofSection = {actions.action("section.redraw"), actions.action("section.addHole")};
    addSeparator();
    for (const char *id : kOperations)
        m_operations.push_back(actions.action(id));
    m_rotational = actions.action("operation.rotational");
    makeRepeat();
    m_afterOperations = addSeparator();
    actions.fill(this, {"physics.addWeight", "check.stress", "measure.ruler"});

    for (QAction *action : this->actions()) {
        if (QWidget *button = widgetForAction(action); button && !action->isSeparator())
            button->setFocusPolicy(Qt::TabFocus); // a click leaves it where it was
    }

    auto *stretch = new QWidget(this);
    stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_stretch = addWidget(stretch);
    m_stock = new StockBox(m_bench, this);
    m_stock->setEditorAction(actions.action("fabricate.stocks"));
    connect(m_stock, &StockBox::editorWanted, actions.action("fabricate.stocks"),
            &QAction::trigger);
    addWidget(m_stock);
    auto *gap = new QWidget(this);
    gap->setFixedWidth(6);
    addWidget(gap);
    m_export = new ExportButton(actions.action("file.export"), this);
    m_export->setObjectName(QStringLiteral("exportButton"));
    addWidget(m_export);
    connect(&bench, &Workbench::selectionChanged, this, &MainToolBar::followSelection);
}

void MainToolBar::place(const std::vector<QAction *> &actions, bool isThere, QAction *before)
{
    for (QAction *action : actions) {
        if (!isThere) {
            removeAction(action);
            continue;
        }
        insertAction(before, action);
        widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
    }
}

/// Their buttons, or the one that stands for all.
void MainToolBar::placeOperations(bool hasButtons)
{
    const auto isThere = [](const QAction *action) { return action->isVisible(); };
    m_repeatAction->setVisible(!hasButtons && std::ranges::any_of(m_operations, isThere));
    if (hasButtons != actions().contains(m_operations.front()))
        place(m_operations, hasButtons, m_afterOperations);
}

/// What is done to a section has its buttons while there is one to do it to: behind all others,
/// which stay where they are.
void MainToolBar::followSelection()
{
    const bool isThere = m_bench.interaction().selection().size() == 1;
    if (isThere == actions().contains(m_ofSection.front()))
        return;
    place(m_ofSection, isThere, m_stretch);
    fold(window()->width());
}

/// What stands for the operations where there is no room for all.
void MainToolBar::makeRepeat()
{
    m_repeat = new QToolButton(this);
    m_repeat->setObjectName(QStringLiteral("repeatButton"));
    m_repeat->setText(tr("Repeat"));
    m_repeat->setIcon(themedIcon(QStringLiteral("linear")));
    m_repeat->setToolTip(tr("Repeat and blend sections"));
    m_repeat->setPopupMode(QToolButton::InstantPopup);
    m_repeat->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    auto *menu = new QMenu(m_repeat);
    for (QAction *action : m_operations)
        menu->addAction(action);
    menu->addAction(m_rotational);
    m_repeat->setMenu(menu);
    m_repeatAction = addWidget(m_repeat);
}

/// Where all between two of them is away, one is enough.
void MainToolBar::showUsedSeparators()
{
    bool isWanted = false; // there is something before it
    QAction *last = nullptr;
    for (QAction *action : actions()) {
        if (action->isSeparator()) {
            action->setVisible(isWanted);
            last = isWanted ? action : last;
            isWanted = false;
        } else if (action->isVisible() && action != m_stretch) {
            isWanted = true;
        } else if (action == m_stretch && last && !isWanted) {
            last->setVisible(false); // nothing behind it but the room
        }
    }
}

void MainToolBar::fold(int windowWidth)
{
    showUsedSeparators();
    placeOperations(windowWidth >= kOperationButtons);
    // Whole words or none: how long they are is the language's.
    const bool hadLabels = toolButtonStyle() == Qt::ToolButtonTextUnderIcon;
    bool labels = windowWidth >= kToolLabels;
    if (labels && !hadLabels) {
        setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
        setFolded(false);
    }
    // The buttons for a section may come and go without anything else: they have their room.
    const int room = actions().contains(m_ofSection.front()) ? 0 : roomOfSection();
    m_stock->setShort(windowWidth < kWholeStock);
    if (labels && sizeHint().width() + room > windowWidth) {
        m_stock->setShort(true);
        layout()->invalidate(); // it is asked at once
    }
    labels = labels && sizeHint().width() + room <= windowWidth;
    if (!labels) {
        setToolButtonStyle(Qt::ToolButtonIconOnly);
        setFolded(true);
    }
    // Its word is whole, too, or not there.
    m_repeat->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    if (sizeHint().width() > windowWidth)
        m_repeat->setToolButtonStyle(Qt::ToolButtonIconOnly);
    setFixedHeight(labels ? 56 : 44);
}

/// px, that the buttons for a section will take: their words are others than those that are there.
int MainToolBar::roomOfSection() const
{
    const QWidget *like = widgetForAction(m_ofDrawing);
    const auto wordOf = [like](const QAction *action) {
        return like->fontMetrics().size(Qt::TextShowMnemonic, action->iconText()).width();
    };
    int room = 0;
    for (const QAction *action : m_ofSection)
        room += like->sizeHint().width() + kBetweenButtons +
                std::max(0, wordOf(action) - wordOf(m_ofDrawing));
    return room;
}

/// Signs alone stand closer together than words.
void MainToolBar::setFolded(bool isFolded)
{
    if (property("isFolded").toBool() == isFolded)
        return;
    setProperty("isFolded", isFolded);
    for (QToolButton *button : findChildren<QToolButton *>()) {
        style()->unpolish(button);
        style()->polish(button);
        button->updateGeometry();
    }
}

void MainToolBar::refresh()
{
    m_export->refresh();
}

} // namespace fff::ui
