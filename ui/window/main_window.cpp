#include "ui/window/main_window.h"

#include "core/interaction/tool.h"
#include "core/io/error_text.h"
#include "core/session/check_list.h"
#include "core/session/sheet_nesting.h"
#include "ui/actions/action_set.h"
#include "ui/base/icon.h"
#include "ui/base/message_bar.h"
#include "ui/base/panes.h"
#include "ui/base/theme.h"
#include "ui/bench/first_sections.h"
#include "ui/bench/number_names.h"
#include "ui/bench/status_line.h"
#include "ui/bench/viewport.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/export_choices.h"
#include "ui/dialogs/stock_editor.h"
#include "ui/docks/checks_dock.h"
#include "ui/docks/history_dock.h"
#include "ui/docks/library_dock.h"
#include "ui/docks/outline_dock.h"
#include "ui/docks/physics_dock.h"
#include "ui/docks/properties_dock.h"
#include "ui/docks/templates_dock.h"
#include "ui/docks/values_dock.h"
#include "ui/files/document_files.h"
#include "ui/files/file_drop.h"
#include "ui/files/recent_menu.h"
#include "ui/files/unsaved_work.h"
#include "ui/help/help_key.h"
#include "ui/properties/open_editor.h"
#include "ui/settings/check_rules.h"
#include "ui/settings/settings.h"
#include "ui/sheets/sheets_dock.h"
#include "ui/steps/steps_export.h"
#include "ui/steps/steps_view.h"
#include "ui/tour/tour_guide.h"
#include "ui/window/adjust_bar.h"
#include "ui/window/badges.h"
#include "ui/window/canvas_bar.h"
#include "ui/window/context_menu.h"
#include "ui/window/main_tool_bar.h"
#include "ui/window/operation_notices.h"
#include "ui/window/spoken_selection.h"
#include "ui/window/view_chips.h"
#include "ui/window/window_layout.h"
#include "ui/window/window_scope.h"
#include "ui/window/windows.h"

#include <QCloseEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <set>

namespace fff::ui {

namespace {

/// Some platforms crash on an OpenGL widget; the rest of the window works without one.
bool hasOpenGl()
{
    const QString platform = QGuiApplication::platformName();
    return platform != QStringLiteral("offscreen") && platform != QStringLiteral("minimal") &&
           platform != QStringLiteral("vnc");
}

} // namespace

MainWindow::MainWindow(QWidget *parent) : QMainWindow(parent), m_bench(new Workbench(this))
{
    setObjectName(QStringLiteral("mainWindow"));
    setMinimumSize(QSize(1024, 640).boundedTo(screen()->availableSize()));
    // With room for the frame that the system puts round it.
    resize(QSize(1440, 900).boundedTo(screen()->availableSize() - QSize(16, 56)));
    setContextMenuPolicy(Qt::NoContextMenu); // Qt's own menu could hide the tool bar for good

    addCommands();
    m_actions = new ActionSet(*m_bench, this);
    makeView();
    m_status = new StatusLine(
        *m_bench,
        [this](const char *action) {
            return m_actions->action(action)->shortcut().toString(QKeySequence::NativeText);
        },
        this);
    setStatusBar(m_status);
    makeDocks();
    m_files = new DocumentFiles(*m_bench, *m_checkList, *m_messages, *m_status, *this);
    m_unsaved = new UnsavedWork(*m_bench, *m_files, *m_messages, this);
    m_stepsExport = new StepsExport(*m_messages, *m_status, *this);
    connect(m_steps, &StepsView::exportWanted, this, [this] {
        const QString suggestion = m_files->suggestion();
        CuttingOptions cutting = rememberedChoices().cutting();
        cutting.lying = m_bench->nesting().layoutOf(m_steps->steps()->analysis, *cutting.nesting);
        m_stepsExport->ask({m_steps->steps(), m_bench->interaction().camera(),
                            QFileInfo(suggestion).fileName(), std::move(cutting)},
                           suggestion);
    });
    new NumberNameSource(*m_bench, this);
    m_toolBar = new MainToolBar(*m_bench, *m_actions, this);
    addToolBar(m_toolBar);
    makeMenus();
    makeScope();
    makeTour();
    m_layout->restore();
    refreshTheme();

    connect(m_actions, &ActionSet::triggered, this, &MainWindow::run);
    // Wherever a tool was asked for, its keys are the view's.
    connect(m_bench, &Workbench::viewStateChanged, m_view, [this] {
        const Tool *tool = m_bench->interaction().tool();
        const bool hasTool = tool && (tool->asksFor().operation.isValid());
        if (hasTool && !m_view->hasFocus() && isActiveWindow())
            m_view->setFocus();
    });
    connect(m_files, &DocumentFiles::chosen, this, &MainWindow::openFiles);
    connect(m_files, &DocumentFiles::stocksWanted, this, [this] { showStocks({}); });
    connect(m_files, &DocumentFiles::problemWanted, m_checks,
            qOverload<const Finding &>(&ChecksDock::choose));
    connect(m_files, &DocumentFiles::sectionsWanted, this,
            [this](const std::vector<SectionRef> &sections) {
                m_bench->select(sections);
                m_bench->run(QStringLiteral("view.fitSelection"));
            });
    connect(m_files, &DocumentFiles::exported, m_actions, &ActionSet::refresh);
    auto *drop = new FileDrop(*this);
    connect(drop, &FileDrop::dropped, this, [this](const QStringList &paths) { take(paths); });
    connect(&settings(), &Settings::colourSchemeChanged, this, &MainWindow::refreshTheme);
    connect(m_files, &DocumentFiles::pathChanged, m_actions, &ActionSet::refresh);
    connect(&m_bench->session(), &Session::cleanChanged, m_actions, &ActionSet::refresh);
    connect(m_bench, &Workbench::editFailed, this, [this](const Error &error) {
        m_messages->show(MessageBar::Severity::Error, {io::errorText(error)});
    });
    m_files->begin();
}

MainWindow::~MainWindow()
{
    delete m_unsaved; // before the session that it writes
}

void MainWindow::makeView()
{
    auto *middle = new QWidget(this);
    m_messages = new MessageBar(middle);
    if (hasOpenGl()) {
        auto *viewport = new Viewport(*m_bench, middle);
        connect(viewport, &Viewport::unusable, this, [this] {
            m_messages->show(MessageBar::Severity::Error,
                             {tr("The model cannot be shown: the graphics driver offers no OpenGL "
                                 "3.3. A newer driver may help.")});
        });
        m_view = viewport;
    } else {
        auto *label = new QLabel(tr("The model cannot be shown on this display."), middle);
        label->setAlignment(Qt::AlignCenter);
        m_view = label;
    }
    m_actions->addViewShortcuts(m_view);
    m_middle = new QStackedWidget(middle);
    m_middle->addWidget(m_view);
    auto *column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_messages);
    column->addWidget(m_middle, 1);
    setCentralWidget(middle);
}

void MainWindow::makeDocks()
{
    m_checkList = new CheckList(m_bench->session(),
                                Settings::dataFolder() + QStringLiteral("/reports"), this);
    m_firstSections = new FirstSections(
        m_bench->session(), *m_checkList,
        [this] {
            return m_bench->interaction().hasGesture() ||
                   (m_tour && m_tour->tour().isWaitingForSections());
        },
        this);
    const auto followRules = [this] {
        m_bench->session().scheduler().setRules(checkRules(settings()));
    };
    connect(&settings(), &Settings::checksChanged, this, followRules);
    followRules();
    m_outline = new OutlineDock(*m_bench, *m_checkList, this);
    m_outline->addKey(m_actions->action("section.mark"));
    m_history = new HistoryDock(*m_bench, this);
    m_library = new LibraryDock(*m_bench, this);
    m_templates = new TemplatesDock(*m_bench, this);
    m_checks = new ChecksDock(*m_bench, *m_checkList, this);
    m_properties = new PropertiesDock(*m_bench, *m_checkList, this);
    m_physics = new PhysicsDock(*m_bench, this);
    m_sheets = new SheetsDock(*m_bench, this);
    connect(m_sheets, &SheetsDock::offcutWanted, this,
            [this](StockId stock) { showStocks(stock, QStringLiteral("stockOffcuts")); });
    m_values = new ValuesDock(*m_bench, this);
    m_badges = new Badges(*m_bench, *m_checkList, m_view);
    m_viewChips = new ViewChips(*m_bench, m_view, Badges::kBelow);
    m_bar = new CanvasBar(*m_bench, *m_actions, m_view);
    if (auto *viewport = qobject_cast<Viewport *>(m_view)) {
        auto *menu = new ContextMenu(*m_bench, *m_actions, m_view);
        connect(viewport, &Viewport::enterPressed, this,
                [this] { m_scope->isAdjusting() ? goInto(*m_values) : goInto(*m_properties); });
        connect(viewport, &Viewport::numberBegun, m_bar, &CanvasBar::begin);
        connect(viewport, &Viewport::menuWanted, menu, &ContextMenu::openAt);
        connect(viewport, &Viewport::menuKeyPressed, menu, &ContextMenu::openForSelection);
        connect(m_outline, &OutlineDock::menuWanted, menu, &ContextMenu::openInList);
    }
    new OperationNotices(*m_bench, *m_messages, this);
    m_steps = new StepsView(*m_bench, *m_checkList, qobject_cast<Viewport *>(m_view), this);
    m_layout = new WindowLayout(*this);
    // The order is that of the tabs in a narrow window.
    m_layout->add(m_properties, "settings", WindowLayout::Place::Right);
    m_layout->add(m_physics, "weight", WindowLayout::Place::Right);
    m_layout->add(m_values, "value", WindowLayout::Place::Right, false);
    m_layout->add(m_outline, "section", WindowLayout::Place::Left);
    m_layout->add(m_checks, "check", WindowLayout::Place::LeftBelow);
    m_layout->add(m_history, "clock", WindowLayout::Place::Left);
    m_layout->add(m_templates, "figure_polygon", WindowLayout::Place::Left, false);
    m_layout->add(m_library, "keep", WindowLayout::Place::Left, false);
    m_layout->add(m_sheets, "stocks", WindowLayout::Place::Below, false);
    connect(m_layout, &WindowLayout::hiddenChanged, m_actions, &ActionSet::refresh);
    connect(m_sheets, &QDockWidget::visibilityChanged, m_actions, &ActionSet::refresh);

    connect(m_badges, &Badges::clicked, this, [this](Subject subject, const QString &sentence) {
        if (m_scope->isAdjusting())
            m_status->say(sentence);
        else
            m_checks->choose(subject);
    });
    connect(m_checks, &ChecksDock::shown, this, [this] { m_layout->show(m_checks); });
    connect(m_actions, &ActionSet::refused, m_status, &StatusLine::say);
    connect(m_checks, &ChecksDock::said, m_status, &StatusLine::sayMarked);
    connect(m_sheets, &SheetsDock::said, m_status, &StatusLine::say);
    connect(m_sheets, &SheetsDock::hinted, m_status, &StatusLine::setElsewhere);
    connect(m_checks, &ChecksDock::viewWanted, m_view, qOverload<>(&QWidget::setFocus));
    connect(m_checks, &ChecksDock::stepsWanted, this,
            [this] { run(QStringLiteral("check.showAssembly")); });
    connect(m_steps, &StepsView::said, m_status, &StatusLine::sayMarked);
    connect(m_steps, &StepsView::waitingChanged, m_actions, &ActionSet::refresh);
    speakSelection(*m_view, *m_bench, *m_checkList);
    connectTemplates();
    connect(m_library, &LibraryDock::said, m_status, &StatusLine::say);
    connect(m_library, &LibraryDock::failed, m_messages,
            [this](const QString &text) { m_messages->show(MessageBar::Severity::Error, {text}); });
    connect(m_library, &LibraryDock::insertWanted, this, [this](const QString &path) {
        if (m_files->insertFile(path))
            showDocument();
    });
    connect(m_history, &HistoryDock::said, m_status, &StatusLine::sayMarked);
    connect(m_checks, &ChecksDock::stockWanted, this, &MainWindow::showStocks);
    connect(m_checks, &ChecksDock::chosenChanged, m_properties, &PropertiesDock::setChosen);
    connect(m_properties, &PropertiesDock::stockWanted, this,
            [this](StockId stock) { showStocks(stock); });
}

void MainWindow::showStocks(StockId stock, const QString &field)
{
    if (!m_stocks) {
        m_stocks = new StockEditor(*m_bench, *m_actions, this);
        m_stocks->refresh();
    }
    m_stocks->open(stock, field);
}

void MainWindow::makeMenus()
{
    m_actions->action("file.quit")->setMenuRole(QAction::QuitRole);
    m_actions->action("file.settings")->setMenuRole(QAction::PreferencesRole);
    m_actions->action("help.about")->setMenuRole(QAction::AboutRole);
    // A command, so that it has keys and a name in scripts: one row for both.
    QAction *sheets = m_actions->action("fabricate.sheets");
    sheets->setIconVisibleInMenu(false); // none of the other panels has one
    m_actions->fill(menuBar(), [this, sheets](const QString &id, QMenu *menu) {
        if (id == QStringLiteral("@docks")) {
            for (QDockWidget *dock : m_layout->docks())
                menu->addAction(dock == m_sheets ? sheets : dock->toggleViewAction());
        } else if (id == QStringLiteral("@recent")) {
            auto *recent = new RecentMenu(menu);
            connect(recent, &RecentMenu::chosen, this,
                    [this](const QString &path) { openFiles({path}); });
            menu->addMenu(recent);
        } else if (id == QStringLiteral("@help")) {
            addHelpPages(menu);
        }
    });
    new HelpKey(*this, [this](const HelpTopic &topic, QWidget *over) { showHelp(topic, over); });
}

void MainWindow::resetLayout()
{
    m_layout->reset();
}

void MainWindow::run(const QString &id)
{
    commitOpenEditor();
    const QUndoStack &history = *m_bench->session().history();
    const QString undone = history.undoText(), redone = history.redoText();
    const int before = history.index();
    if (m_steps->isOpen() && id == QStringLiteral("view.fitAll"))
        m_steps->fit(); // what is shown, not what is drawn
    else if (id.startsWith(QStringLiteral("section.import")))
        importDrawing(id);
    else if (id != QStringLiteral("edit.paste") || !pastePicture())
        m_bench->run(id);
    m_actions->refresh(); // what is checked says what is so, not what was clicked
    const Tool *tool = m_bench->interaction().tool();
    if (tool && tool->command() == id.toStdString())
        m_view->setFocus(); // keys are the tool's
    if (id == QStringLiteral("edit.undo") && history.index() < before)
        m_status->sayUndone(undone);
    else if (id == QStringLiteral("edit.redo") && history.index() > before)
        m_status->sayRedone(redone);
}

void MainWindow::openFiles(const QStringList &paths)
{
    ui::openFiles(*this, paths);
}

void MainWindow::showDocument()
{
    m_middle->setCurrentWidget(m_view);
    m_layout->setAway(false);
    m_status->setStanding({});
    m_scope->offerValues();
    m_view->setFocus();
}

void MainWindow::closeUnasked()
{
    m_mayClose = true;
    close();
}

void MainWindow::refreshTheme()
{
    applyTheme(this);
    // Windows of their own do not take it from their parent.
    for (QWidget *child : findChildren<QWidget *>()) {
        if (qobject_cast<QMenu *>(child) || qobject_cast<QDialog *>(child))
            child->setPalette(theme().palette());
    }
    refreshDressed(this);
    m_messages->refresh();
    m_outline->refreshColours();
    m_history->refreshColours();
    m_checks->refreshColours();
    m_physics->refreshColours();
    m_sheets->refreshColours();
    m_values->refreshColours();
    m_templates->refreshColours();
    m_badges->refreshColours();
    m_viewChips->refreshColours();
    m_tour->refreshColours();
    m_bar->update();
    m_steps->refresh();
    if (m_stocks)
        m_stocks->refresh();
    m_properties->refresh();
    m_status->refresh();
    m_toolBar->refresh();
    m_adjustBar->refresh();
    setWindowIcon(tintedPixmap(QStringLiteral("section"), 64, theme().accent, 1.0));
    m_view->update();
}

void MainWindow::changeEvent(QEvent *event)
{
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        m_actions->refresh();
}

bool MainWindow::event(QEvent *event)
{
    const bool done = QMainWindow::event(event);
    if (event->type() == QEvent::ApplicationPaletteChange)
        refreshTheme();
    // Qt makes the tabs of docks when it needs them.
    if (event->type() == QEvent::ChildPolished && m_layout)
        m_layout->takeTabs(static_cast<QChildEvent *>(event)->child());
    return done;
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    event->setAccepted(m_mayClose || m_files->mayClose());
    if (!event->isAccepted())
        return;
    m_layout->save();
    m_unsaved->discard();
}

/// Esc, where a panel has no use for it, goes back to the view: one step back here as well.
void MainWindow::keyPressEvent(QKeyEvent *event)
{
    QMainWindow::keyPressEvent(event);
    if (event->key() == Qt::Key_Escape && !event->isAccepted() && isInDock(focusWidget()))
        m_view->setFocus(Qt::OtherFocusReason);
}

/// Passes over what lies in docks behind other tabs: Qt goes there too. Some fields hand the focus
/// on as they get it, so that it may come round without passing where it began: then the view has
/// it.
bool MainWindow::focusNextPrevChild(bool next)
{
    std::set<const QWidget *> passed;
    while (QMainWindow::focusNextPrevChild(next)) {
        const QWidget *now = focusWidget();
        if (!now || isSeen(now))
            return true;
        if (!passed.insert(now).second) {
            m_view->setFocus(Qt::OtherFocusReason);
            return true;
        }
    }
    return false;
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    m_toolBar->fold(width());
    if (m_wasShown)
        m_layout->followWidth();
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (m_wasShown)
        return;
    m_wasShown = true;
    m_layout->windowShown();
    m_scope->offerValues();
    m_view->setFocus();
}

} // namespace fff::ui
