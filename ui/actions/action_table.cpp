#include "ui/actions/action_table.h"

#include <QtGlobal>

namespace fff::ui {

namespace {

// Texts for lupdate.
#define TEXT(text) QT_TRANSLATE_NOOP("fff::ui::ActionSet", text)

const ActionRow kActions[] = {
    {"file.new", TEXT("&New"), TEXT("New"), "Ctrl+N", "new", TEXT("Start a new model")},
    {"file.open", TEXT("&Open…"), TEXT("Open"), "Ctrl+O", "open",
     TEXT("Open a model, also one of FlatFab")},
    {"file.save", TEXT("&Save"), TEXT("Save"), "Ctrl+S", "save", TEXT("Save the model")},
    {"file.saveAs", TEXT("Save &as…"), TEXT("Save as"), "Ctrl+Shift+S", "save_as",
     TEXT("Save the model under another name")},
    {"file.export", TEXT("&Export cutting files…"), TEXT("Export…"), "Ctrl+Shift+E", "export",
     TEXT("Write the parts to a file for the laser cutter")},
    {"file.revert", TEXT("&Revert to saved"), TEXT("Revert"), "", "revert",
     TEXT("Go back to the model as it is in its file; Undo brings the changes back")},
    {"file.settings", TEXT("Se&ttings…"), TEXT("Settings"), "Ctrl+,", "settings",
     TEXT("Units, colours, language, files and shortcuts")},
    {"file.close", TEXT("&Close window"), TEXT("Close"), "Ctrl+W", "close_window",
     TEXT("Close this window; others stay open")},
    {"file.quit", TEXT("&Quit"), TEXT("Quit"), "Ctrl+Q", "quit",
     TEXT("Close all windows and the program")},
    {"edit.undo", TEXT("&Undo"), TEXT("Undo"), "Ctrl+Z", "undo", TEXT("Take the last step back")},
    {"edit.redo", TEXT("&Redo"), TEXT("Redo"), "Ctrl+Shift+Z Ctrl+Y", "redo",
     TEXT("Do the step again that was taken back")},
    {"edit.delete", TEXT("&Delete"), TEXT("Delete"), "Del", "trash",
     TEXT("Delete the selected sections")},
    {"edit.selectAll", TEXT("Select &all"), TEXT("Select all"), "Ctrl+A", "select_all",
     TEXT("Select all sections")},
    {"view.front", TEXT("&Front"), TEXT("Front"), "1", "view_front", TEXT("Look from the front"),
     true},
    {"view.top", TEXT("&Top"), TEXT("Top"), "2", "view_top", TEXT("Look from the top"), true},
    {"view.right", TEXT("&Right"), TEXT("Right"), "3", "view_right", TEXT("Look from the right"),
     true},
    {"view.back", TEXT("&Back"), TEXT("Back"), "4", "view_back", TEXT("Look from the back"), true},
    {"view.bottom", TEXT("Botto&m"), TEXT("Bottom"), "5", "view_bottom", TEXT("Look from below"),
     true},
    {"view.left", TEXT("&Left"), TEXT("Left"), "6", "view_left", TEXT("Look from the left"), true},
    {"view.iso", TEXT("Next &corner"), TEXT("Corner"), "0", "view_iso",
     TEXT("Look from the next corner"), true},
    {"view.faceSelection", TEXT("Face the &section"), TEXT("Face"), "N", "face_section",
     TEXT("Look straight at the selected section"), true},
    {"view.fitAll", TEXT("Fit &everything"), TEXT("Fit"), "Home", "fit",
     TEXT("Show the whole model"), true},
    {"view.fitSelection", TEXT("Fit se&lection"), TEXT("Fit selection"), "F", "fit_selection",
     TEXT("Show the selected sections as large as possible"), true},
    {"view.previous", TEXT("&Previous view"), TEXT("Previous"), "Alt+Left", "view_previous",
     TEXT("Go back to the view before this one")},
    {"view.perspective", TEXT("Pers&pective"), TEXT("Perspective"), "V", "perspective",
     TEXT("Show what is farther away smaller, as the eye sees it"), true, true},
    {"view.xray", TEXT("&X-ray"), TEXT("X-ray"), "X", "xray",
     TEXT("See through all sections, down to their slits"), true, true},
    {"view.isolate", TEXT("&Only the selection"), TEXT("Isolate"), "I", "isolate",
     TEXT("Let all other sections stand back"), true, true},
    {"view.hide", TEXT("&Hide"), TEXT("Hide"), "H", "hide", TEXT("Hide the selected sections"),
     true},
    {"view.showAll", TEXT("Show &all"), TEXT("Show all"), "Shift+H", "show_all",
     TEXT("Show the hidden sections again"), true},
    {"view.clip", TEXT("&Cut view open"), TEXT("Cut open"), "C", "cut_open",
     TEXT("Cut the model open with a plane, to look inside"), true, true},
    {"view.shadow", TEXT("&Ground and shadow"), TEXT("Ground"), "", "ground_shadow",
     TEXT("Show the ground with its grid and the model's shadow"), false, true},
    {"view.docks", TEXT("&Hide all docks"), TEXT("Hide docks"), "F9", "docks",
     TEXT("Hide or show the panels at the sides"), false, true},
    {"view.fullScreen", TEXT("F&ull screen"), TEXT("Full screen"), "F11", "full_screen",
     TEXT("Fill the screen with the window"), false, true},
    {"view.resetWindow", TEXT("Reset &window"), TEXT("Reset window"), "", "reset_window",
     TEXT("Put all panels back where they were at first")},
    {"view.nextPane", TEXT("&Next part of the window"), TEXT("Next part"), "F6", "next_pane",
     TEXT("Go to the next part of the window: tool bar, left, view, right")},
    {"view.previousPane", TEXT("&Previous part of the window"), TEXT("Previous part"), "Shift+F6",
     "previous_pane", TEXT("Go back to the part of the window before this one")},
    {"check.nextProblem", TEXT("&Next problem"), TEXT("Next problem"), "F8", "next_problem",
     TEXT("Select the sections of the next problem and show them")},
    {"check.previousProblem", TEXT("&Previous problem"), TEXT("Previous problem"), "Shift+F8",
     "previous_problem", TEXT("Select the sections of the problem before this one")},
    {"fabricate.stocks", TEXT("&Stocks…"), TEXT("Stocks"), "", "stocks",
     TEXT("Sheet materials: thickness, strength, kerf and sheet size")},
    {"edit.find", TEXT("&Find an action…"), TEXT("Find"), "Ctrl+K", "search",
     TEXT("Type to find anything that the program can do")},
    {"help.start", TEXT("&Start page"), TEXT("Start page"), "", "start",
     TEXT("Recent models and samples")},
    {"help.about", TEXT("&About FlatFitFab"), TEXT("About"), "", "about",
     TEXT("What this program is, its version and its licences")},
};

const MenuRow kMenus[] = {
    {TEXT("&File"),
     "file.new file.open @recent | file.save file.saveAs file.revert | file.export | "
     "file.settings | file.close file.quit"},
    {TEXT("&Edit"), "edit.undo edit.redo | edit.delete | edit.selectAll"},
    {TEXT("&View"), "view.front view.top view.right view.back view.bottom view.left view.iso "
                    "view.faceSelection | view.fitAll view.fitSelection "
                    "view.previous | view.perspective view.xray view.clip view.shadow | "
                    "view.isolate view.hide view.showAll | "
                    "@docks view.docks view.resetWindow | view.nextPane view.previousPane | "
                    "view.fullScreen"},
    {TEXT("&Checks"), "check.nextProblem check.previousProblem"},
    {TEXT("F&abricate"), "fabricate.stocks | file.export"},
    {TEXT("&Help"), "edit.find help.start | help.about"},
};

#undef TEXT

} // namespace

std::span<const ActionRow> actionTable()
{
    return kActions;
}

std::span<const MenuRow> menuTable()
{
    return kMenus;
}

} // namespace fff::ui
