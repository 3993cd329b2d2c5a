// The commands that need a window or ask a question; the rest are the session's.
#include "core/session/command_rules.h"
#include "ui/actions/action_finder.h"
#include "ui/base/panes.h"
#include "ui/bench/first_sections.h"
#include "ui/bench/workbench.h"
#include "ui/dialogs/about_dialog.h"
#include "ui/dialogs/command_search.h"
#include "ui/dialogs/settings_dialog.h"
#include "ui/docks/checks_dock.h"
#include "ui/docks/library_dock.h"
#include "ui/docks/properties_dock.h"
#include "ui/docks/values_dock.h"
#include "ui/files/document_files.h"
#include "ui/help/help_pages.h"
#include "ui/settings/settings.h"
#include "ui/sheets/sheets_dock.h"
#include "ui/steps/steps_view.h"
#include "ui/window/adjust_bar.h"
#include "ui/window/main_tool_bar.h"
#include "ui/window/main_window.h"
#include "ui/window/window_layout.h"
#include "ui/window/window_scope.h"
#include "ui/window/windows.h"

#include <QMenuBar>

#include <functional>

namespace fff::ui {

namespace {

constexpr CommandWords kWords[] = {
    {"file.open", FFF_TEXT("Command", "&Open…"), FFF_TEXT("Command", "Open"), "Ctrl+O", "open",
     FFF_TEXT("Command", "Open a model, also from FlatFab")},
    {"file.insert", FFF_TEXT("Command", "&Insert model…"), FFF_TEXT("Command", "Insert"),
     "Ctrl+Shift+I", "insert_model",
     FFF_TEXT("Command", "Add the sections of another model to this one")},
    {"template.addMesh", FFF_TEXT("Command", "Te&mplate to draw over…"),
     FFF_TEXT("Command", "Template"), "", "figure_polygon",
     FFF_TEXT("Command", "Read a mesh, a picture or a drawing to draw sections over")},
    {"file.addToLibrary", FFF_TEXT("Command", "Add to the &library"),
     FFF_TEXT("Command", "To library"), "", "keep",
     FFF_TEXT("Command", "Keep the selection in the library, for other models")},
    {"file.save", FFF_TEXT("Command", "&Save"), FFF_TEXT("Command", "Save"), "Ctrl+S", "save",
     FFF_TEXT("Command", "Save the model")},
    {"file.saveAs", FFF_TEXT("Command", "Save &as…"), FFF_TEXT("Command", "Save as"),
     "Ctrl+Shift+S", "save_as", FFF_TEXT("Command", "Save the model under another name")},
    {"file.export", FFF_TEXT("Command", "&Export cutting files…"), FFF_TEXT("Command", "Export…"),
     "Ctrl+Shift+E", "export",
     FFF_TEXT("Command", "Write the parts to a file for the laser cutter")},
    {"file.exportAgain", FFF_TEXT("Command", "Export a&gain"), FFF_TEXT("Command", "Export again"),
     "Ctrl+Shift+X", "export_again",
     FFF_TEXT("Command", "Write the same file again, with the same choices")},
    {"file.revert", FFF_TEXT("Command", "Re&vert to saved"), FFF_TEXT("Command", "Revert"), "",
     "revert",
     FFF_TEXT("Command",
              "Go back to the model as it is in its file; Undo brings the changes back")},
    {"file.settings", FFF_TEXT("Command", "Se&ttings…"), FFF_TEXT("Command", "Settings"), "Ctrl+,",
     "settings", FFF_TEXT("Command", "Units, colours, language, files and shortcuts")},
    {"file.shortcuts", FFF_TEXT("Command", "&Keyboard shortcuts…"),
     FFF_TEXT("Command", "Shortcuts"), "", "keyboard",
     FFF_TEXT("Command", "See which keys do what, and choose your own")},
    {"file.close", FFF_TEXT("Command", "&Close window"), FFF_TEXT("Command", "Close"), "Ctrl+W",
     "close_window", FFF_TEXT("Command", "Close this window; others stay open")},
    {"file.quit", FFF_TEXT("Command", "&Quit"), FFF_TEXT("Command", "Quit"), "Ctrl+Q", "quit",
     FFF_TEXT("Command", "Close all windows and the program")},
    {"view.properties", FFF_TEXT("Command", "Go to Properties"), FFF_TEXT("Command", "Properties"),
     "", "settings",
     FFF_TEXT("Command",
              "Go to the first field of the selection; in the view, Enter does the same")},
    {"view.docks", FFF_TEXT("Command", "Hide all panels"), FFF_TEXT("Command", "Hide panels"), "F9",
     "docks", FFF_TEXT("Command", "Hide or show the panels at the sides")},
    {"view.fullScreen", FFF_TEXT("Command", "F&ull screen"), FFF_TEXT("Command", "Full screen"),
     "F11", "full_screen", FFF_TEXT("Command", "Fill the screen with the window")},
    {"view.resetWindow", FFF_TEXT("Command", "Reset &window"), FFF_TEXT("Command", "Reset window"),
     "", "reset_window", FFF_TEXT("Command", "Put all panels back in their original places")},
    {"view.nextPane", FFF_TEXT("Command", "&Next part of the window"),
     FFF_TEXT("Command", "Next part"), "F6", "next_pane",
     FFF_TEXT("Command", "Go to the next part of the window: tool bar, left, view, right")},
    {"view.previousPane", FFF_TEXT("Command", "Previous part of the win&dow"),
     FFF_TEXT("Command", "Previous part"), "Shift+F6", "previous_pane",
     FFF_TEXT("Command", "Go back to the part of the window before this one")},
    {"check.nextProblem", FFF_TEXT("Command", "&Next problem"), FFF_TEXT("Command", "Next problem"),
     "F8", "next_problem",
     FFF_TEXT("Command", "Select the sections of the next problem and show them")},
    {"check.previousProblem", FFF_TEXT("Command", "&Previous problem"),
     FFF_TEXT("Command", "Previous problem"), "Shift+F8", "previous_problem",
     FFF_TEXT("Command", "Select the sections of the problem before this one")},
    {"check.showAssembly", FFF_TEXT("Command", "Show the &steps"), FFF_TEXT("Command", "Steps"),
     "A", "steps", FFF_TEXT("Command", "Show step by step how the model is put together"), true},
    {"fabricate.stocks", FFF_TEXT("Command", "Stoc&ks…"), FFF_TEXT("Command", "Stocks"), "",
     "stocks", FFF_TEXT("Command", "Sheet materials: thickness, strength, kerf and sheet size")},
    {"fabricate.coupon", FFF_TEXT("Command", "&Fit coupon…"), FFF_TEXT("Command", "Fit coupon"), "",
     "stocks",
     FFF_TEXT("Command", "Write a test piece that tells which slits fit and how wide the machine "
                         "cuts")},
    {"fabricate.sheets", FFF_TEXT("Command", "S&heets"), FFF_TEXT("Command", "Sheets"), "",
     "stocks", FFF_TEXT("Command", "Show the parts on their sheets, as they will be cut"), true},
    {"view.values", FFF_TEXT("Command", "Go to the values"), FFF_TEXT("Command", "Values"), "",
     "value", FFF_TEXT("Command", "Adjust the values that numbers of the model are made of")},
    {"view.newValue", FFF_TEXT("Command", "New value"), FFF_TEXT("Command", "New value"), "",
     "plus", FFF_TEXT("Command", "A number with a name, which number fields take")},
    {"edit.find", FFF_TEXT("Command", "&Find a command…"), FFF_TEXT("Command", "Find"), "Ctrl+K",
     "search", FFF_TEXT("Command", "Type to find anything that the program can do")},
    {"help.firstSteps", FFF_TEXT("Command", "First ste&ps"), FFF_TEXT("Command", "First steps"), "",
     "help", FFF_TEXT("Command", "How a model is made, step by step, with pictures")},
    {"help.here", FFF_TEXT("Command", "Help on what is under the cursor"),
     FFF_TEXT("Command", "Help"), "F1", "help",
     FFF_TEXT("Command", "Open the help where it tells about this part of the window")},
    {"help.tour", FFF_TEXT("Command", "Your first model in 3 &minutes"),
     FFF_TEXT("Command", "Tour"), "", "play",
     FFF_TEXT("Command", "Draw, check and cut a model step by step, in an empty window")},
    {"help.start", FFF_TEXT("Command", "&Start page"), FFF_TEXT("Command", "Start page"), "",
     "start", FFF_TEXT("Command", "Recent models and samples")},
    {"help.about", FFF_TEXT("Command", "&About FlatFitFab"), FFF_TEXT("Command", "About"), "",
     "about", FFF_TEXT("Command", "What this program is, its version and its licences")},
};

} // namespace

/// Before there are actions of them: rules and switches are asked while the rest is not there yet.
void MainWindow::addCommands()
{
    CommandRegistry &commands = m_bench->commands();
    const auto add = [&commands](const char *id, std::function<void()> act, CommandRule rule = {},
                                 std::function<bool()> isOn = {}) {
        commands.add(id, {[act = std::move(act)](const CommandParameters &, double) {
                              act();
                              return Result<void>();
                          },
                          std::move(rule), std::move(isOn)});
    };
    add("file.new", [this] { startNewDocument(*this); });
    add("file.open", [this] { m_files->open(); });
    add("file.insert", [this] {
        if (m_files->insert())
            showDocument();
    });
    add("file.addToLibrary", [this] { m_library->addSelection(); });
    add("template.addMesh", [this] { addMesh(); });
    add("file.save", [this] { m_files->save(); });
    add("file.saveAs", [this] { m_files->saveAs(); });
    add(
        "file.export",
        [this] {
            m_firstSections->takeAsIs();
            m_files->exportCuttingFile();
        },
        needsSections(m_bench->session()));
    add(
        "file.exportAgain", [this] { m_files->exportAgain(); },
        [this,
         needs = needsSections(m_bench->session())](const CommandParameters &parameters) -> WhyNot {
            if (WhyNot why = needs(parameters))
                return why;
            if (m_files && m_files->canExportAgain())
                return {};
            return FFF_TEXT("Command", "It has not been exported yet");
        });
    add(
        "file.revert", [this] { m_files->revert(); },
        [this](const CommandParameters &) -> WhyNot {
            if (m_files && m_files->canRevert())
                return {};
            if (!m_files || m_files->path().isEmpty())
                return FFF_TEXT("Command", "It has never been saved");
            return FFF_TEXT("Command", "Nothing has changed since it was saved");
        });
    add("file.settings", [this] { SettingsDialog(listedActions(*menuBar()), this).exec(); });
    add("file.shortcuts", [this] {
        SettingsDialog dialog(listedActions(*menuBar()), this);
        dialog.showPage(SettingsDialog::Page::Keyboard);
        dialog.exec();
    });
    add("file.close", [this] { close(); });
    add("file.quit", [] { closeAllWindows(); });
    add("edit.find", [this] { (new CommandSearch(*menuBar(), this))->show(); });
    add("help.firstSteps", [this] { showHelp({QStringLiteral("first_steps")}); });
    add("help.here", [this] { showHelpHere(); });
    add("help.tour", [this] { startTour(); });
    add("help.start", [this] { showStartPage(); });
    add(
        "view.docks", [this] { m_layout->setHidden(!m_layout->isHidden()); }, {},
        [this] { return m_layout && m_layout->isHidden(); });
    add(
        "view.fullScreen", [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); }, {},
        [this] { return isFullScreen(); });
    add("view.resetWindow", [this] { resetLayout(); });
    add("help.about", [this] { AboutDialog(this).exec(); });
    const auto goBy = [this](int step) {
        QToolBar *bar = m_toolBar;
        if (m_scope->isAdjusting())
            bar = m_adjustBar;
        goToPane(*this, bar, m_view, step);
    };
    add("view.nextPane", [goBy] { goBy(1); });
    add("view.previousPane", [goBy] { goBy(-1); });
    add("view.properties", [this] { goInto(*m_properties); });
    const CommandRule checked = needsSections(m_bench->session());
    add(
        "check.nextProblem", [this] { m_checks->goToProblem(1); }, checked);
    add(
        "check.previousProblem", [this] { m_checks->goToProblem(-1); }, checked);
    // What was asked for and is not there yet is on, too: asking again takes it back.
    add(
        "check.showAssembly", [this] { m_steps->toggle(); }, needsSections(m_bench->session()),
        [this] {
            const bool isHeld = *inHand(m_bench->interaction(), "check.showAssembly")();
            return isHeld || (m_steps && m_steps->isWaiting());
        });
    const auto addSwitch = [&commands](const char *id, DrawingSwitch what) {
        commands.add(id, {[what](const CommandParameters &parameters, double) -> Result<void> {
                              settings().setOn(what, switched(parameters, settings().isOn(what)));
                              return {};
                          },
                          {},
                          [what] { return settings().isOn(what); }});
    };
    addSwitch("section.symmetry", DrawingSwitch::Symmetry);
    addSwitch("section.ground", DrawingSwitch::Ground);
    addSwitch("section.snap", DrawingSwitch::Snap);
    add("fabricate.stocks", [this] { showStocks({}); });
    add("fabricate.coupon", [this] { m_files->exportCoupon(); });
    add(
        "fabricate.sheets",
        [this] {
            if (m_sheets->isVisible())
                m_sheets->close();
            else
                m_layout->show(m_sheets);
        },
        {}, [this] { return m_sheets && m_sheets->isVisible(); });
    add("view.values", [this] { m_layout->show(m_values); });
    add("view.newValue", [this] {
        m_layout->show(m_values);
        m_values->addNew();
    });
    commands.offer(kWords);
}

} // namespace fff::ui
